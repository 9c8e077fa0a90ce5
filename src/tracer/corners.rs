//! Light that is computed at the corners of a triangle and blended between them: Gouraud's model, and one of each corner's own.
//!
//! Source: Gouraud 1971, "Continuous shading of curved surfaces". At a corner stand its point, its normal, and the ways from there to
//! the viewer and to each light. What a light adds is the sum of the corners' values, each times the weight that the corner has at
//! the hit. Whether a light is seen is asked at the hit alone.

use super::by_laws::ByLaws;
use super::laws::Laws;
use super::light_sampler::{LightSampler, SampledRay};
use crate::geometry::Hit;
use crate::math::{DVec3, Ray, Rgb};
use crate::probe::{Absence, Term, TermKind};
use crate::scene::{Effects, Scene, Settings};
use crate::shading::{Interaction, LightKind, Material, ShadingModel, ShadingPoint};

/// Corners of the triangle of a hit, as the ray's origin sees them, in the order in which the file has them.
#[derive(Clone, Copy, Debug)]
pub struct HitCorners {
    at: [Interaction; 3],
    weights: [f64; 3],
}

/// Material at the corners, with the weights that they have at the hit.
#[derive(Clone, Copy, Debug)]
pub struct CornerPoints<'a> {
    /// The corners.
    pub points: [ShadingPoint<'a>; 3],
    /// Their weights, which add up to 1.
    pub weights: [f64; 3],
}

/// Point of a triangle as it is seen from `origin`. `hit` says which triangle, and where on it the point is.
pub fn seen_from<L: Laws>(
    laws: L,
    (scene, effects): (&Scene, Effects),
    origin: DVec3,
    (point, hit): (DVec3, Hit),
) -> Interaction {
    let way = point - origin;
    let ray = Ray::new(origin, way.normalize_or(DVec3::Z));
    let t = way.dot(ray.direction);
    let hit = Hit { t, ..hit };
    let at = laws.interaction(scene, &ray, &hit);
    *scene.shaded((&hit, &at), effects, &mut None)
}

impl HitCorners {
    /// Corners of the triangle that a ray from `origin` hits, if light is blended between them; `None` for other shapes and models.
    pub fn of<L: Laws>(
        laws: L,
        (scene, settings): (&Scene, &Settings),
        origin: DVec3,
        hit: &Hit,
    ) -> Option<Self> {
        if scene.model(hit.primitive, settings) != Some(ShadingModel::Gouraud) {
            return None;
        }
        let shape = &scene.shapes[hit.primitive as usize];
        let [a, b, c] = shape.triangle(hit.part)?.corners;
        // In the order of the hit's weights.
        let points = if shape.is_mirror_image() {
            [a, c, b]
        } else {
            [a, b, c]
        };
        let corner = |i: usize| {
            let place = std::array::from_fn(|j| f64::from(i == j));
            let of = (scene, settings.effects);
            seen_from(laws, of, origin, (points[i], Hit { place, ..*hit }))
        };
        let object = scene.object_of(hit.primitive);
        Some(Self {
            at: object.in_order_of_file([0, 1, 2]).map(corner),
            weights: object.in_order_of_file(hit.place),
        })
    }

    /// The corners with what their material is there.
    pub fn points<'a>(&'a self, material: &'a Material, effects: Effects) -> CornerPoints<'a> {
        let point = |at| ShadingPoint::new(at, material, effects);
        CornerPoints {
            points: self.at.each_ref().map(point),
            weights: self.weights,
        }
    }
}

impl CornerPoints<'_> {
    /// The ambient term: blended, if the corners have different ones.
    pub fn ambient<L: Laws>(&self, laws: L, ia: Rgb, lights: usize) -> Option<Term> {
        let terms = self
            .points
            .each_ref()
            .map(|point| laws.ambient(point, ia, lights));
        let [a, b, c] = terms;
        if a == b && b == c {
            return a;
        }
        Some(self.blended(TermKind::Ambient, terms))
    }

    /// Whether and how a sample of a light arrives at each corner, whatever stands in between. `samplers` are those at the corners.
    pub fn arrivals<L: Laws, S: LightSampler>(
        &self,
        laws: L,
        samplers: &[S; 3],
        sample: u32,
        kind: &LightKind,
    ) -> [SampledRay; 3] {
        std::array::from_fn(|i| {
            let point = &self.points[i];
            let sampler = &samplers[i];
            ByLaws {
                sampler,
                laws,
                point,
                kind,
            }
            .shadow_ray(sample)
        })
    }

    /// Terms of a sample of a light that arrives at the corners like this: one of each kind that any corner has.
    pub fn terms<L: Laws>(
        &self,
        laws: L,
        arrivals: &[SampledRay; 3],
        occluded: bool,
        mut add: impl FnMut(Term),
    ) {
        let corners: [_; 3] =
            std::array::from_fn(|i| corner_terms(laws, &self.points[i], &arrivals[i], occluded));
        for (of_kind, kind) in [TermKind::Diffuse, TermKind::Specular]
            .into_iter()
            .enumerate()
        {
            let terms = corners.map(|terms| terms[of_kind]);
            if terms.iter().any(Option::is_some) {
                add(self.blended(kind, terms));
            }
        }
    }

    /// The corners' terms of a kind, each times its weight; one that is not there is black.
    fn blended(&self, kind: TermKind, terms: [Option<Term>; 3]) -> Term {
        let value = |i: usize| terms[i].map_or(Rgb::BLACK, |term| term.value());
        Term::Blended {
            kind,
            corners: std::array::from_fn(|i| value(i) * self.weights[i]),
        }
    }
}

/// The diffuse and the specular term of a sample of a light at a corner.
pub fn corner_terms<L: Laws>(
    laws: L,
    point: &ShadingPoint,
    arrival: &SampledRay,
    occluded: bool,
) -> [Option<Term>; 2] {
    let mut terms = [None; 2];
    if let Ok(ray) = arrival {
        laws.eval(point, ray, occluded, |term| match term.kind() {
            TermKind::Specular => terms[1] = Some(term),
            _ => terms[0] = Some(term),
        });
    }
    terms
}

/// The shadow ray that asks from the hit whether a sample of a light is seen, or why none is sent: no corner shows the light.
pub fn asking_ray<L: Laws>(
    arrivals: &[SampledRay; 3],
    own: &ByLaws<impl LightSampler, L>,
    sample: u32,
) -> SampledRay {
    match arrivals {
        [Err(a), Err(b), Err(c)] => Err(reason([*a, *b, *c])),
        _ => own
            .shadow_ray(sample)
            .or_else(|_| own.sampler.sight(sample)),
    }
}

/// Why no corner shows a light: that it is behind the surface only if it is so at all of them, with the largest cosine.
fn reason(reasons: [Absence; 3]) -> Absence {
    let mut largest = f64::NEG_INFINITY;
    for reason in reasons {
        let Absence::FacingAway { n_dot_l } = reason else {
            return reason;
        };
        largest = largest.max(n_dot_l);
    }
    Absence::FacingAway { n_dot_l: largest }
}
