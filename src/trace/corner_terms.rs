//! Terms that are blended between the corners of a triangle, computed again with the tracer's own functions.

use super::View;
use crate::math::{DVec3, Ray, Rgb};
use crate::probe::{Absence, Term, TermKind};
use crate::shading::Interaction;
use crate::tracer::corners::{CornerPoints, HitCorners, corner_terms};
use crate::tracer::laws::Laws as _;
use crate::tracer::light_sampler::{AreaSampler, LightSampler, PointSampler};

/// Term at a corner of a triangle.
#[derive(Clone, Copy, Debug)]
pub struct CornerTerm {
    /// Weight of the corner at the hit.
    pub weight: f64,
    /// The corner, as the ray's origin sees it.
    pub at: Interaction,
    /// L, the direction to the sample of the light, if it has one there.
    pub to_light: Option<DVec3>,
    /// The term with its factors, or why there is none.
    pub term: Result<Term, Absence>,
}

impl CornerTerm {
    /// The term's value; black if there is none.
    pub fn value(&self) -> Rgb {
        self.term.map_or(Rgb::BLACK, |term| term.value())
    }

    /// N.L, of a light.
    pub fn n_dot_l(&self) -> Option<f64> {
        self.to_light.map(|l| self.at.normal.dot(l))
    }

    /// R.V of a specular term, at least 0.
    pub fn r_dot_v(&self) -> Option<f64> {
        match self.term {
            Ok(Term::Specular { r_dot_v, .. }) => Some(r_dot_v.max(0.0)),
            _ => None,
        }
    }
}

impl View<'_> {
    /// The three terms that a term of this kind at the hit of a node is blended from; `None` if it is not blended. Corners
    /// stand in the order in which the file has them.
    pub fn corner_terms(
        self,
        node: u32,
        kind: TermKind,
        (light, sample): (u32, u32),
    ) -> Option<[CornerTerm; 3]> {
        let (scene, settings) = (&self.world.scene, self.settings);
        let hit = self.surface_hit(node)?;
        let sent = &self.trace.tree.node(node).ray;
        let ray = Ray::new(sent.origin, sent.direction);
        let corners = HitCorners::of(self.laws(), (scene, settings), ray.origin, &hit.hit)?;
        let corners = corners.points(hit.material, settings.effects);
        if kind == TermKind::Ambient {
            let count = scene.lights.len();
            return Some(std::array::from_fn(|i| {
                let term = self
                    .laws()
                    .ambient(&corners.points[i], scene.ambient, count);
                let to_light = None;
                corner(&corners, i, to_light, term.ok_or(Absence::EffectOff))
            }));
        }
        let light_kind = &scene.lights.get(light as usize)?.kind;
        let points = corners.points.each_ref();
        if let Some(area) = light_kind.area() {
            let id = self.laws().light_points(self.path_id(node));
            let samplers = points.map(|point| AreaSampler::new(settings, point, area, (id, light)));
            return Some(self.of_light(&corners, &samplers, (light, sample), kind));
        }
        let samplers = points.map(|point| PointSampler::new(settings, point, light_kind));
        Some(self.of_light(&corners, &samplers, (light, sample), kind))
    }

    /// The corners' terms of a sample of a light.
    fn of_light<S: LightSampler>(
        self,
        corners: &CornerPoints,
        samplers: &[S; 3],
        (light, sample): (u32, u32),
        kind: TermKind,
    ) -> [CornerTerm; 3] {
        let light = &self.world.scene.lights[light as usize].kind;
        let arrivals = corners.arrivals(self.laws(), samplers, sample, light);
        std::array::from_fn(|i| {
            let terms = corner_terms(self.laws(), &corners.points[i], &arrivals[i], false);
            let term = terms[usize::from(kind == TermKind::Specular)];
            let why = arrivals[i].err().unwrap_or(Absence::EffectOff);
            let seen = arrivals[i].ok().map(|ray| ray.light);
            let seen = seen.or_else(|| samplers[i].light(sample));
            let to_light = seen.map(|light| light.direction);
            corner(corners, i, to_light, term.ok_or(why))
        })
    }
}

fn corner(
    corners: &CornerPoints,
    i: usize,
    to_light: Option<DVec3>,
    term: Result<Term, Absence>,
) -> CornerTerm {
    CornerTerm {
        weight: corners.weights[i],
        at: *corners.points[i].at,
        to_light,
        term,
    }
}
