//! What follows from a student's own numbers: each law applied to the inputs that the student's tree gives.
//!
//! A tracer that bends one law gets most of what comes after it wrong as well. Here each quantity is computed from those before
//! it *as the student has them* ([`expected`]): the hit from the student's own ray, R from the student's own normal. What agrees
//! with that is right in itself. By bent laws the same function says what a mistake would give, which names it.
//!
//! What the student does not tell is taken from what comes before it by the laws.

use std::collections::HashMap;

use super::believed::{Believed, BelievedVertex, believed_hit, believed_ray};
use crate::math::{DVec3, Rgb};
use crate::probe::{Absence, RayKind, Silent, Term, TermKind};
use crate::scene::{AIR_IOR, Bends, Settings};
use crate::shading::{FresnelSplit, Secondary, ShadingPoint, Side};
use crate::trace::facts::{Fact, FactName, PixelFacts, RayFacts, Step, TreePath, sorted};
use crate::tracer::laws::{Bent, Laws};
use crate::tracer::light_sampler::{PointSampler, ShadowRay};
use crate::tracer::pixel::camera_sample;
use crate::world::World;

/// Directions nearer than this count as equal.
const SAME_DIRECTION: f64 = 1e-4;

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
pub type FollowedFacts = Vec<Vec<(FactName, Fact)>>;

/// The facts that follow for each ray of our tree, in its order, from the numbers of `given` by these laws. What cannot be
/// computed is left out.
pub fn expected(of: PixelReference, given: &PixelFacts, bends: Bends) -> FollowedFacts {
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
    /// For each ray so far, where it ends, by the student's own numbers.
    vertices: Vec<Option<BelievedVertex>>,
    facts: Vec<Vec<(FactName, Fact)>>,
}

impl<'a> Walk<'a> {
    fn visit(&mut self, ours: &'a RayFacts) {
        let theirs = self.theirs.get(&ours.path).copied();
        let believed = Believed { ours, theirs };
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
                Some((ray.origin, ray.direction))
            }
            (kind, Some(parent)) => self.secondary(kind, parent).map(|(origin, secondary)| {
                facts.push((FactName::Weight, Fact::Color(secondary.weight)));
                (origin, secondary.direction)
            }),
            _ => None,
        };
        if let Some((origin, direction)) = sent {
            facts.push((FactName::Origin, vector(origin)));
            facts.push((FactName::Direction, vector(direction)));
        }
        let (ray, length) = believed_ray(believed, sent)?;
        let traced = self.laws.closest_point(world, &ray, &mut Silent);
        let word = if traced.is_some() { "hit" } else { "miss" };
        facts.push((FactName::Outcome, Fact::Word(word.to_owned())));
        if let Some((hit, _)) = &traced {
            let object = &world.scene.object_of(hit.primitive).name;
            facts.push((FactName::Object, Fact::Word(object.clone())));
            let index = world.scene.local_index(hit.primitive);
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
        let hit = believed_hit(world, believed, (&ray, length), traced.map(|(hit, _)| hit))?;
        let computed = self.laws.interaction(&world.scene, &ray, &hit);
        facts.push((FactName::Point, vector(computed.point)));
        facts.push((FactName::GeometricNormal, vector(computed.geometric_normal)));
        facts.push((FactName::Normal, vector(computed.normal)));
        Some(BelievedVertex {
            primitive: hit.primitive,
            at: believed.interaction(computed),
        })
    }

    /// The origin, the direction and the weight of a secondary ray of a hit.
    fn secondary(&self, kind: RayKind, parent: usize) -> Option<(DVec3, Secondary)> {
        let vertex = self.vertices[parent].as_ref()?;
        let point = self.point(vertex);
        let split = self.split(parent, vertex, &point);
        let ray = self.wanted(kind, &point, split.as_ref()).ok()?;
        let start = self.laws.start(&vertex.at, ray.direction);
        Some((start.origin, ray))
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

    /// The indices of refraction on both sides of where a ray ends: ours if it is on the same object, else those of its object
    /// and of air.
    fn media(&self, ray: usize, vertex: &BelievedVertex) -> Option<[f64; 2]> {
        let (ours, scene) = (&self.of.facts.rays[ray], &self.world.scene);
        let object = &scene.object_of(vertex.primitive).name;
        if ours.word(&FactName::Object) == Some(object) {
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
        add(self.laws.ambient(&point, scene.ambient, scene.lights.len()));
        for light in 0..scene.lights.len() as u32 {
            self.light(believed, &point, light, facts);
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
            let wanted = self.wanted(kind, &point, split.as_ref()).is_ok();
            // Whether its weight is too small depends on all before it: there ours decides.
            let too_small = ours
                .absent
                .iter()
                .any(|(k, _, why)| *k == kind && why == "min-weight");
            let sent = wanted && !too_small && (ours.path.depth() as u32) < limit;
            facts.push((FactName::Sends(kind), yes_or_no(sent)));
        }
    }

    /// The terms of a light without area at a hit point, by the student's own shadow ray.
    fn light(
        &self,
        believed: Believed,
        point: &ShadingPoint,
        light: u32,
        facts: &mut Vec<(FactName, Fact)>,
    ) {
        let scene = &self.world.scene;
        let named = &scene.lights[light as usize];
        if named.kind.is_area() {
            return;
        }
        let path = believed.ours.path.then(Step::Light(named.name.clone(), 0));
        let theirs = self.theirs.get(&path).copied();
        let shines = FactName::Shines(named.name.clone());
        let Some(sent) = self.sent_to(point, light) else {
            return facts.push((shines, yes_or_no(false)));
        };
        let direction = theirs.and_then(|ray| ray.vector(&FactName::Direction));
        let direction = direction.map(DVec3::from_array);
        // What is told as it is sent stays as the laws have it.
        let other = direction.filter(|d| (*d - sent.light.direction).length() > SAME_DIRECTION);
        let shadow = other.map_or(sent, |direction| ShadowRay {
            n_dot_l: point.at.normal.dot(direction),
            light: crate::shading::LightSample {
                direction,
                ..sent.light
            },
            ..sent
        });
        let told = theirs.and_then(|ray| ray.word(&FactName::Outcome));
        let occluded = told.map_or_else(
            || self.is_occluded(point, light, &shadow),
            |word| word != "lit",
        );
        facts.push((shines, yes_or_no(!self.is_occluded(point, light, &sent))));
        self.laws.eval(point, &shadow, occluded, |term| {
            let (name, value) = (named.name.clone(), term.value());
            let factor = match term {
                Term::Specular { r_dot_v, .. } => {
                    (FactName::RDotV(name.clone(), 0), r_dot_v.max(0.0))
                }
                _ => (FactName::NDotL(name.clone(), 0), shadow.n_dot_l),
            };
            facts.push((factor.0, Fact::Number(factor.1)));
            facts.push((
                FactName::Term(term.kind(), Some(name), 0),
                Fact::Color(value),
            ));
        });
    }

    /// The shadow ray that the laws send to a light.
    fn sent_to(&self, point: &ShadingPoint, light: u32) -> Option<ShadowRay> {
        let kind = &self.world.scene.lights.get(light as usize)?.kind;
        let sampler = PointSampler::new(self.settings, point, kind);
        self.laws.shadow_ray(&sampler, 0, point, kind).ok()
    }

    fn is_occluded(&self, point: &ShadingPoint, light: u32, shadow: &ShadowRay) -> bool {
        let (world, settings) = (self.world, self.settings);
        let occluder = self
            .laws
            .occluder((world, settings), (point, light), shadow, &mut Silent);
        occluder.is_some()
    }

    /// An L ray: where it goes, and whether its light is seen.
    fn shadow_ray(&self, believed: Believed, facts: &mut Vec<(FactName, Fact)>) {
        let scene = &self.world.scene;
        let (Some(Step::Light(name, _)), Some(parent)) =
            (believed.ours.path.steps.last(), believed.ours.parent)
        else {
            return;
        };
        let light = scene.lights.iter().position(|light| light.name == *name);
        let (Some(light), Some(vertex)) = (light, self.vertices[parent].as_ref()) else {
            return;
        };
        if scene.lights[light].kind.is_area() {
            return;
        }
        let point = self.point(vertex);
        let Some(sent) = self.sent_to(&point, light as u32) else {
            // No ray: no light.
            facts.push((FactName::Outcome, Fact::Word("blocked".to_owned())));
            return;
        };
        facts.push((FactName::Origin, vector(sent.ray.origin)));
        facts.push((FactName::Direction, vector(sent.light.direction)));
        if sent.light.distance.is_finite() {
            facts.push((FactName::Distance, Fact::Number(sent.light.distance)));
        }
        let start = (sent.ray.origin, sent.ray.direction);
        let Some((ray, _)) = believed_ray(believed, Some(start)) else {
            return;
        };
        let occluded = self.is_occluded(&point, light as u32, &ShadowRay { ray, ..sent });
        let word = if occluded { "blocked" } else { "lit" };
        facts.push((FactName::Outcome, Fact::Word(word.to_owned())));
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
