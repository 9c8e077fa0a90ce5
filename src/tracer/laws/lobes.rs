//! Diffuse and specular terms gone wrong.

use crate::math::{DVec3, Rgb};
use crate::probe::Term;
use crate::scene::Bend;
use crate::shading::{ShadingPoint, reflect};
use crate::tracer::light_sampler::ShadowRay;

/// The term in the place of ours; none where it is left out.
pub fn term(bend: Bend, term: Term, point: &ShadingPoint, ray: &ShadowRay) -> Option<Term> {
    match term {
        Term::Diffuse {
            kd,
            intensity,
            n_dot_l,
        } => diffuse(bend, n_dot_l).map(|factor| Term::Diffuse {
            kd,
            intensity: intensity * factor,
            n_dot_l,
        }),
        Term::Projected { kd, light, n_dot_l } => {
            diffuse(bend, n_dot_l).map(|factor| Term::Projected {
                kd,
                light: crate::probe::ProjectedShare {
                    share: light.share * factor,
                    ..light
                },
                n_dot_l,
            })
        }
        Term::Specular {
            ks,
            intensity,
            r_dot_v,
            shininess,
        } => specular(bend, point, ray, (intensity, r_dot_v, shininess)).map(
            |(intensity, r_dot_v)| Term::Specular {
                ks,
                intensity,
                r_dot_v,
                shininess,
            },
        ),
        _ => Some(term),
    }
}

/// Factor on the diffuse term; none where there is no such term.
fn diffuse(bend: Bend, n_dot_l: f64) -> Option<f64> {
    match bend {
        Bend::CosMissing => Some(1.0 / n_dot_l),
        Bend::CosAbsolute => Some(n_dot_l.signum()),
        Bend::SpecularUnlit if n_dot_l <= 0.0 => None,
        _ => Some(1.0),
    }
}

/// Intensity and R.V of the specular term; none where there is no such term.
fn specular(
    bend: Bend,
    point: &ShadingPoint,
    ray: &ShadowRay,
    (intensity, r_dot_v, shininess): (Rgb, f64, f64),
) -> Option<(Rgb, f64)> {
    let (n, l, v): (DVec3, DVec3, DVec3) =
        (point.at.normal, ray.light.direction, point.at.to_viewer);
    let is_even = (shininess / 2.0).fract() == 0.0;
    match bend {
        Bend::VNotNegated => Some((intensity, reflect(-l, n).dot(-v))),
        Bend::MirrorLHalf => Some((intensity, (n.dot(l) * n - l).dot(v))),
        Bend::Halfway => Some((intensity, n.dot((l + v).normalize_or_zero()))),
        Bend::SpecularEven if is_even => Some((intensity, r_dot_v.abs())),
        Bend::SpecularTimesCos => Some((intensity * ray.n_dot_l, r_dot_v)),
        Bend::CosAbsolute | Bend::CosUnclamped if ray.n_dot_l <= 0.0 => None,
        _ => Some((intensity, r_dot_v)),
    }
}
