//! What follows from a student's own numbers: each law applied to the inputs that the student's tree gives.
//!
//! A tracer that bends one law gets most of what comes after it wrong as well. Here each quantity is computed from those before
//! it *as the student has them* ([`Consequences`]): the hit from the student's own ray, R from the student's own normal. What agrees
//! with that is right in itself. By bent laws the same function says what a mistake would give, which names it.
//!
//! What the student does not tell is taken from what comes before it by the laws.

mod lights;

use std::collections::HashMap;

use super::believed::{Believed, BelievedVertex, NearPoints, SentRay, believed_hit, believed_ray};
use crate::math::{DVec3, Rgb};
use crate::probe::{Absence, RayKind, Silent, Term, TermKind};
use crate::scene::{AIR_IOR, Bends, Settings};
use crate::shading::{FresnelSplit, Secondary, ShadingPoint, Side};
use crate::trace::facts::{Fact, FactName, PixelFacts, RayFacts, Step, TreePath, sorted};
use crate::tracer::corners::CornerPoints;
use crate::tracer::laws::{Bent, Laws};
use crate::tracer::pixel::camera_sample;
use crate::world::World;

/// What a pixel is compared with: the scene, the settings, and our tree.
#[derive(Clone, Copy)]
pub struct PixelReference<'a> {
    /// The scene with its accelerator and the settings, if they are known.
    pub scene: Option<(&'a World, &'a Settings)>,
    /// The pixel.
    pub pixel: (u32, u32),
    /// Our tree of the pixel.
    pub facts: &'a PixelFacts,
}

/// For each ray of ours, in its order, the facts that follow, sorted by name.
type FollowedFacts = Vec<Vec<(FactName, Fact)>>;

/// What follows, by either reading of points that are nearly as computed.
pub struct Consequences([FollowedFacts; 2]);

impl Consequences {
    /// The facts that follow for each ray of our tree, in its order, from the numbers of `given` by these laws. What cannot be
    /// computed is left out.
    pub fn new(of: PixelReference, given: &PixelFacts, bends: Bends) -> Self {
        let readings = [NearPoints::Computed, NearPoints::Told];
        Self(readings.map(|near| expected(of, given, bends, near)))
    }

    /// A fact of a ray, by both readings.
    pub fn find(&self, ray: usize, name: &FactName) -> [Option<&Fact>; 2] {
        self.0.each_ref().map(|facts| {
            let facts = &facts[ray];
            let index = facts.binary_search_by(|(n, _)| n.cmp(name)).ok()?;
            Some(&facts[index].1)
        })
    }
}

fn expected(
    of: PixelReference,
    given: &PixelFacts,
    bends: Bends,
    near: NearPoints,
) -> FollowedFacts {
    let Some((world, settings)) = of.scene else {
        return vec![Vec::new(); of.facts.rays.len()];
    };
    let theirs: HashMap<&TreePath, &RayFacts> = given.rays.iter().map(|r| (&r.path, r)).collect();
    let mut walk = Walk {
        of,
        world,
        settings,
        theirs,
        laws: Bent(bends),
        near,
        vertices: Vec::with_capacity(of.facts.rays.len()),
        facts: Vec::with_capacity(of.facts.rays.len()),
    };
    for ours in &of.facts.rays {
        walk.visit(ours);
    }
    walk.sum_up();
    walk.facts.into_iter().map(sorted).collect()
}

/// A walk over the rays, parents first.
struct Walk<'a> {
    of: PixelReference<'a>,
    world: &'a World,
    settings: &'a Settings,
    /// The student's rays by name.
    theirs: HashMap<&'a TreePath, &'a RayFacts>,
    laws: Bent,
    near: NearPoints,
    /// For each ray so far, where it ends, by the student's own numbers.
    vertices: Vec<Option<BelievedVertex>>,
    facts: Vec<Vec<(FactName, Fact)>>,
}

impl<'a> Walk<'a> {
    fn visit(&mut self, ours: &'a RayFacts) {
        let theirs = self.theirs.get(&ours.path).copied();
        let near = self.near;
        let believed = Believed { ours, theirs, near };
        let mut facts = Vec::new();
        let vertex = match ours.kind {
            RayKind::Light => {
                self.shadow_ray(believed, &mut facts);
                None
            }
            _ => self.traced_ray(believed, &mut facts),
        };
        if let Some(vertex) = &vertex {
            self.surface(believed, vertex, &mut facts);
        }
        self.vertices.push(vertex);
        self.facts.push(facts);
    }

    /// An I, R or T ray: its own facts, and where it ends.
    fn traced_ray(
        &self,
        believed: Believed,
        facts: &mut Vec<(FactName, Fact)>,
    ) -> Option<BelievedVertex> {
        let (world, settings, pixel) = (self.world, self.settings, self.of.pixel);
        let sent = match (believed.ours.kind, believed.ours.parent) {
            (RayKind::Incident, _) => {
                let film = camera_sample(settings, pixel, believed.ours.path.sample).film;
                let ray = self
                    .laws
                    .eye_ray(&world.scene.camera, film, settings.size());
                Some(SentRay {
                    origin: ray.origin,
                    direction: ray.direction,
                    surface: None,
                })
            }
            (kind, Some(parent)) => self.secondary(kind, parent).map(|(sent, weight)| {
                facts.push((FactName::Weight, Fact::Color(weight)));
                sent
            }),
            _ => None,
        };
        if let Some(sent) = sent {
            facts.push((FactName::Origin, vector(sent.origin)));
            facts.push((FactName::Direction, vector(sent.direction)));
        }
        let (ray, length) = believed_ray(believed, sent)?;
        let traced = self.laws.closest(world, &ray, &mut Silent);
        let word = if traced.is_some() { "hit" } else { "miss" };
        facts.push((FactName::Outcome, Fact::Word(word.to_owned())));
        if let Some(hit) = &traced {
            let object = &world.scene.object_of(hit.primitive).name;
            facts.push((FactName::Object, Fact::Word(object.clone())));
            let index = world.scene.face_of(hit);
            facts.push((FactName::Primitive, Fact::Number(f64::from(index))));
            facts.push((FactName::T, Fact::Number(hit.t / length)));
        }
        let outcome = believed.word(&FactName::Outcome);
        if outcome.is_some_and(|outcome| outcome == "miss")
            || (outcome.is_none() && traced.is_none())
        {
            let background = Fact::Color(world.scene.background);
            facts.push((FactName::own_term(TermKind::Background), background));
            return None;
        }
        let hit = believed_hit(world, believed, (&ray, length), traced)?;
        let computed = self.laws.interaction(&world.scene, &ray, &hit);
        let computed = world.scene.shaded_with((&hit, &computed), settings);
        facts.push((FactName::Point, vector(computed.point)));
        facts.push((FactName::GeometricNormal, vector(computed.geometric_normal)));
        facts.push((FactName::Normal, vector(computed.normal)));
        Some(BelievedVertex {
            primitive: hit.primitive,
            at: believed.interaction(computed, length),
            corners: believed.corners(self.laws, (world, settings), &ray, &hit),
        })
    }

    /// A secondary ray of a hit, and its weight.
    fn secondary(&self, kind: RayKind, parent: usize) -> Option<(SentRay, Rgb)> {
        let vertex = self.vertices[parent].as_ref()?;
        let point = self.point(vertex);
        let split = self.split(parent, vertex, &point);
        let ray = self.wanted(kind, &point, split.as_ref()).ok()?;
        let start = self.laws.start(&vertex.at, ray.direction);
        let sent = SentRay::from_surface(kind, &vertex.at, start.origin, ray.direction);
        Some((sent, ray.weight))
    }

    fn wanted(
        &self,
        kind: RayKind,
        point: &ShadingPoint,
        split: Option<&FresnelSplit>,
    ) -> Result<Secondary, Absence> {
        match (kind, split) {
            (RayKind::Reflected, split) => self.laws.reflected(point, split),
            (_, Some(split)) => self.laws.transmitted(point, split),
            _ => Err(Absence::NoTransmission),
        }
    }

    /// The corners of the triangle where a ray ends, if light is blended between them.
    fn corners<'v>(&'v self, vertex: &'v BelievedVertex) -> Option<CornerPoints<'v>> {
        let material = self.world.scene.material_of(vertex.primitive);
        let corners = vertex.corners.as_ref()?;
        Some(corners.points(material, self.settings.effects))
    }

    fn point<'v>(&'v self, vertex: &'v BelievedVertex) -> ShadingPoint<'v> {
        let material = self.world.scene.material_of(vertex.primitive);
        ShadingPoint::new(&vertex.at, material, self.settings.effects)
    }

    /// The split of light at a transparent surface, with the indices that the student has.
    fn split(
        &self,
        ray: usize,
        vertex: &BelievedVertex,
        point: &ShadingPoint,
    ) -> Option<FresnelSplit> {
        let base = self.media(ray, vertex)?;
        let theirs = self.theirs.get(&self.of.facts.rays[ray].path);
        let given = |name| theirs.and_then(|ray| ray.number(name));
        let model = self.settings.fresnel;
        let (Some(g1), Some(g2)) = (given(&FactName::N1), given(&FactName::N2)) else {
            return Some(self.laws.split(point, model, base));
        };
        // The indices are told: only what is made of them is asked.
        let others = Bent(self.laws.0.without(crate::scene::Law::Media));
        Some(others.split(point, model, [g1, g2]))
    }

    /// The indices of refraction on both sides of where a ray ends: ours if it is on the same side of the same object, else those
    /// of its object and of air.
    fn media(&self, ray: usize, vertex: &BelievedVertex) -> Option<[f64; 2]> {
        let (ours, scene) = (&self.of.facts.rays[ray], &self.world.scene);
        let object = &scene.object_of(vertex.primitive).name;
        let side = match vertex.at.side {
            Side::Front => "front",
            Side::Back => "back",
        };
        if ours.word(&FactName::Object) == Some(object) && ours.word(&FactName::Side) == Some(side)
        {
            return Some([ours.number(&FactName::N1)?, ours.number(&FactName::N2)?]);
        }
        let inside = scene.medium_ior(scene.owners[vertex.primitive as usize]);
        let is_transparent = scene.material_of(vertex.primitive).is_transmissive();
        is_transparent.then_some(match vertex.at.side {
            Side::Front => [AIR_IOR, inside],
            Side::Back => [inside, AIR_IOR],
        })
    }

    /// What a hit point gives: its terms, the media, and whether R and T are sent.
    fn surface(
        &self,
        believed: Believed,
        vertex: &BelievedVertex,
        facts: &mut Vec<(FactName, Fact)>,
    ) {
        let scene = &self.world.scene;
        let point = self.point(vertex);
        let mut add = |term: Option<Term>| {
            facts.extend(
                term.map(|term| (FactName::own_term(term.kind()), Fact::Color(term.value()))),
            );
        };
        add(point.emitted());
        let count = scene.lights.len();
        add(match self.corners(vertex) {
            Some(corners) => corners.ambient(self.laws, scene.ambient, count),
            None => self.laws.ambient(&point, scene.ambient, count),
        });
        for light in 0..count as u32 {
            self.light(believed, vertex, light, facts);
        }
        let index = self.vertices.len();
        let ours = believed.ours;
        let split = self.split(index, vertex, &point);
        if let Some(split) = &split {
            let base = self.media(index, vertex).unwrap_or([AIR_IOR; 2]);
            let media = self.laws.split(&point, self.settings.fresnel, base);
            facts.push((FactName::N1, Fact::Number(media.n1)));
            facts.push((FactName::N2, Fact::Number(media.n2)));
            facts.push((FactName::Reflectance, Fact::Number(split.reflectance)));
        }
        let limit = self.laws.depth(self.settings.recursion.depth);
        for kind in [RayKind::Reflected, RayKind::Transmitted] {
            let wanted = self.wanted(kind, &point, split.as_ref());
            let wanted = wanted.is_ok_and(|ray| ray.weight.max_channel() >= 0.0);
            // Whether its weight is too small depends on all before it: there ours decides.
            let too_small = ours
                .absent
                .iter()
                .any(|(k, _, why)| *k == kind && why == "min-weight");
            let sent = wanted && !too_small && (ours.path.depth() as u32) < limit;
            facts.push((FactName::Sends(kind), yes_or_no(sent)));
        }
    }

    /// The radiance of each ray: the sum of the student's own terms and of what comes back along the student's own R and T.
    fn sum_up(&mut self) {
        for index in 0..self.of.facts.rays.len() {
            let ours = &self.of.facts.rays[index];
            let Some(theirs) = self
                .theirs
                .get(&ours.path)
                .filter(|r| r.kind != RayKind::Light)
            else {
                continue;
            };
            let terms = theirs
                .facts
                .iter()
                .filter_map(|(name, fact)| match (name, fact) {
                    (FactName::Term(..), Fact::Color(color)) => Some(*color),
                    _ => None,
                });
            let own = terms.fold(Rgb::BLACK, |sum, term| sum + term);
            let children = [Step::Reflected, Step::Transmitted]
                .map(|step| self.theirs.get(&ours.path.then(step)));
            let sum = children.into_iter().flatten().try_fold(own, |sum, child| {
                let (weight, radiance) = (
                    child.color(&FactName::Weight)?,
                    child.color(&FactName::Radiance)?,
                );
                Some(sum + weight * radiance)
            });
            if let Some(sum) = sum {
                self.facts[index].push((FactName::Radiance, Fact::Color(self.laws.returned(sum))));
            }
        }
    }
}

fn vector(v: DVec3) -> Fact {
    Fact::Vector(v.to_array())
}

/// The fact that something is, or is not.
pub fn yes_or_no(yes: bool) -> Fact {
    Fact::Word(if yes { "yes" } else { "no" }.to_owned())
}
