//! Reflected and transmitted rays gone wrong.

use crate::math::{DVec3, Rgb};
use crate::probe::{Absence, highlight};
use crate::scene::Bend;
use crate::shading::{Fresnel, FresnelSplit, Secondary, ShadingPoint, Side, reflect, refract};

/// Split of the light at a boundary.
pub fn split(
    bends: impl Iterator<Item = Bend>,
    point: &ShadingPoint,
    model: Fresnel,
    [n1, n2]: [f64; 2],
) -> FresnelSplit {
    let at = point.at;
    let (normal, incident) = (at.normal, -at.to_viewer);
    bends.fold(point.split(model, [n1, n2]), |split, bend| match bend {
        // The glass is taken for the medium behind the surface on both sides of it.
        Bend::MediumNotTracked if at.side == Side::Back => point.split(model, [n2, n1]),
        Bend::EtaInverted => {
            let refracted = refract(incident, normal, n2, n1);
            FresnelSplit {
                refracted,
                reflectance: share(model, refracted, point, [n1, n2]),
                ..split
            }
        }
        Bend::RefractNoNormal => FresnelSplit {
            refracted: split.refracted.map(|_| incident),
            ..split
        },
        Bend::TirStraight => match split.refracted {
            Err(_) => FresnelSplit {
                refracted: Ok(incident),
                reflectance: 0.0,
                ..split
            },
            Ok(_) => split,
        },
        Bend::FresnelNone if split.refracted.is_ok() => FresnelSplit {
            reflectance: 0.0,
            ..split
        },
        Bend::SchlickInside => match split.refracted {
            Ok(t) => {
                let cosine = if n1 > n2 {
                    normal.dot(at.to_viewer)
                } else {
                    -normal.dot(t)
                };
                FresnelSplit {
                    reflectance: Fresnel::Schlick.reflectance(cosine, cosine, n1, n2),
                    ..split
                }
            }
            Err(_) => split,
        },
        Bend::TirBlack if split.refracted.is_err() => FresnelSplit {
            reflectance: 0.0,
            ..split
        },
        _ => split,
    })
}

/// The reflected share with a refracted direction.
fn share(
    model: Fresnel,
    refracted: Result<DVec3, f64>,
    point: &ShadingPoint,
    [n1, n2]: [f64; 2],
) -> f64 {
    let (normal, to_viewer) = (point.at.normal, point.at.to_viewer);
    refracted.map_or(1.0, |t| {
        model.reflectance(normal.dot(to_viewer), -normal.dot(t), n1, n2)
    })
}

/// Direction and weight of R.
pub fn reflected(
    bends: impl Iterator<Item = Bend>,
    point: &ShadingPoint,
    split: Option<&FresnelSplit>,
) -> Result<Secondary, Absence> {
    let (incident, n) = (-point.at.to_viewer, point.at.normal);
    bends.fold(point.reflected(split), |ray, bend| {
        let direction = match bend {
            Bend::ReflectPlus => incident + 2.0 * n.dot(incident) * n,
            Bend::ReflectNo2 => incident - n.dot(incident) * n,
            Bend::ReflectLongNormal => reflect(incident, 2.0 * n),
            // Of glass it is a share of the light that is left out, not Kr.
            Bend::MirrorOne if split.is_none() => {
                return ray.map(|ray| Secondary {
                    weight: Rgb::WHITE,
                    ..ray
                });
            }
            Bend::MirrorPhong => {
                return ray.map(|ray| {
                    let cosine = ray.direction.dot(incident);
                    let weight = Rgb::grey(highlight(cosine, point.shininess()));
                    Secondary { weight, ..ray }
                });
            }
            _ => return ray,
        };
        // No test of the side: a tracer that makes this mistake makes none.
        ray.map(|ray| Secondary { direction, ..ray })
    })
}
