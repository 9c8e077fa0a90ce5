//! Lights in what follows: shadow rays, and the terms that they bring, by the student's own hit points.

use super::{Walk, vector, yes_or_no};
use crate::grade::believed::{Believed, BelievedVertex, SentRay, believed_ray};
use crate::math::{DVec3, Rgb};
use crate::probe::{RayKind, Silent, Term, TermKind};
use crate::shading::{LightKind, LightSample, ShadingPoint};
use crate::trace::facts::{Fact, FactName, Step};
use crate::tracer::by_laws::ByLaws;
use crate::tracer::corners::{CornerPoints, asking_ray, corner_terms};
use crate::tracer::laws::Laws as _;
use crate::tracer::light_sampler::{LightSampler as _, PointSampler, SampledRay, ShadowRay};

/// Directions nearer than this count as equal.
const SAME_DIRECTION: f64 = 1e-4;

impl Walk<'_> {
    /// The terms of a light without area at a hit point, by the student's own shadow ray.
    pub(super) fn light(
        &self,
        believed: Believed,
        vertex: &BelievedVertex,
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
        let Some(sent) = self.sent_to(vertex, light) else {
            return facts.push((shines, yes_or_no(false)));
        };
        let point = &self.point(vertex);
        let direction = theirs.and_then(|ray| ray.vector(&FactName::Direction));
        let direction = direction.map(DVec3::from_array);
        // What is told as it is sent stays as the laws have it.
        let other = direction.filter(|d| (*d - sent.light.direction).length() > SAME_DIRECTION);
        let shadow = other.map_or(sent, |direction| ShadowRay {
            n_dot_l: point.at.normal.dot(direction),
            light: LightSample {
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
        if let Some(corners) = self.corners(vertex) {
            return self.blended(&corners, light, occluded, facts);
        }
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

    /// The terms of a light that are blended between corners, and what they are there. Only whether the light is seen is the
    /// student's: each corner has its own L.
    fn blended(
        &self,
        corners: &CornerPoints,
        light: u32,
        occluded: bool,
        facts: &mut Vec<(FactName, Fact)>,
    ) {
        let named = &self.world.scene.lights[light as usize];
        let name = || Some(named.name.clone());
        let arrivals = self.arrivals(corners, &named.kind);
        corners.terms(self.laws, &arrivals, occluded, |term| {
            let name = FactName::Term(term.kind(), name(), 0);
            facts.push((name, Fact::Color(term.value())));
        });
        let terms: [_; 3] = std::array::from_fn(|i| {
            corner_terms(self.laws, &corners.points[i], &arrivals[i], occluded)
        });
        for (of_kind, kind) in [TermKind::Diffuse, TermKind::Specular]
            .into_iter()
            .enumerate()
        {
            let told = terms.iter().any(|terms| terms[of_kind].is_some());
            for (terms, i) in terms.iter().zip(0..).filter(|_| told) {
                let value = terms[of_kind].map_or(Rgb::BLACK, |term| term.value());
                let name = FactName::CornerValue(kind, name(), 0, i);
                facts.push((name, Fact::Color(value)));
            }
        }
    }

    /// How a light without area arrives at the corners.
    fn arrivals(&self, corners: &CornerPoints, kind: &LightKind) -> [SampledRay; 3] {
        let points = corners.points.each_ref();
        let samplers = points.map(|point| PointSampler::new(self.settings, point, kind));
        corners.arrivals(self.laws, &samplers, 0, kind)
    }

    /// The shadow ray that the laws send to a light.
    fn sent_to(&self, vertex: &BelievedVertex, light: u32) -> Option<ShadowRay> {
        let kind = &self.world.scene.lights.get(light as usize)?.kind;
        let point = &self.point(vertex);
        let own = ByLaws {
            sampler: &PointSampler::new(self.settings, point, kind),
            laws: self.laws,
            point,
            kind,
        };
        match self.corners(vertex) {
            Some(corners) => asking_ray(&self.arrivals(&corners, kind), &own, 0).ok(),
            None => own.shadow_ray(0).ok(),
        }
    }

    fn is_occluded(&self, point: &ShadingPoint, light: u32, shadow: &ShadowRay) -> bool {
        let (world, settings) = (self.world, self.settings);
        let occluder = self
            .laws
            .occluder((world, settings), (point, light), shadow, &mut Silent);
        occluder.is_some()
    }

    /// An L ray: where it goes, and whether its light is seen.
    pub(super) fn shadow_ray(&self, believed: Believed, facts: &mut Vec<(FactName, Fact)>) {
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
        let Some(sent) = self.sent_to(vertex, light as u32) else {
            // No ray: no light.
            facts.push((FactName::Outcome, Fact::Word("blocked".to_owned())));
            return;
        };
        facts.push((FactName::Origin, vector(sent.ray.origin)));
        facts.push((FactName::Direction, vector(sent.light.direction)));
        if sent.light.distance.is_finite() {
            facts.push((FactName::Distance, Fact::Number(sent.light.distance)));
        }
        let start = SentRay::from_surface(
            RayKind::Light,
            &vertex.at,
            sent.ray.origin,
            sent.ray.direction,
        );
        let Some((ray, _)) = believed_ray(believed, Some(start)) else {
            return;
        };
        let occluded = self.is_occluded(&point, light as u32, &ShadowRay { ray, ..sent });
        let word = if occluded { "blocked" } else { "lit" };
        facts.push((FactName::Outcome, Fact::Word(word.to_owned())));
    }
}
