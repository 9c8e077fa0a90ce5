//! Light that arrives, gone wrong.

use std::f64::consts::PI;

use crate::geometry::Hit;
use crate::math::Ray;
use crate::scene::{Bend, Settings};
use crate::shading::{Area, LightKind, LightSample, ShadingPoint};
use crate::tracer::light_sampler::{LightSampler, PointSampler, SampledRay, ShadowRay};
use crate::world::World;

/// Shadow ray to a sample of a light.
pub fn shadow_ray<S: LightSampler>(
    bend: Bend,
    sampler: &S,
    light: Option<LightSample>,
    point: &ShadingPoint,
    kind: &LightKind,
) -> SampledRay {
    let Some(light) = light else {
        return sampler.to_light(None);
    };
    if shines_from_behind(bend) {
        return from_both_sides(sampler, light, point);
    }
    let light = match bend {
        Bend::LReversed => reversed(light),
        Bend::DirectionalReversed if matches!(kind, LightKind::Directional { .. }) => {
            reversed(light)
        }
        Bend::AttenuationNone if !kind.is_area() => attenuated(light, 1.0),
        Bend::AttenuationLinear => match *kind {
            LightKind::Point { attenuation, .. } | LightKind::Spot { attenuation, .. } => {
                let [a, b, _] = attenuation;
                attenuated(light, 1.0 / (a + b * light.distance))
            }
            _ => light,
        },
        _ => kind
            .area()
            .map_or(light, |area| area_sample(bend, light, point, area)),
    };
    let ray = sampler.to_light(Some(light));
    if bend == Bend::LNotUnit && light.distance.is_finite() && !kind.is_area() {
        let n_dot_l = |ray: ShadowRay| ray.n_dot_l * light.distance;
        return ray.map(|ray| ShadowRay {
            n_dot_l: n_dot_l(ray),
            ..ray
        });
    }
    ray
}

/// True if a light behind the surface is asked as well.
pub fn shines_from_behind(bend: Bend) -> bool {
    matches!(
        bend,
        Bend::CosAbsolute | Bend::CosUnclamped | Bend::SpecularUnlit
    )
}

fn reversed(light: LightSample) -> LightSample {
    LightSample {
        direction: -light.direction,
        ..light
    }
}

/// The light with another attenuation.
fn attenuated(light: LightSample, attenuation: f64) -> LightSample {
    LightSample {
        intensity: light.intensity * (attenuation / light.attenuation),
        attenuation,
        ..light
    }
}

/// A sample of an area light, Le A cos' / (pi r^2) / samples, with a factor gone.
fn area_sample(bend: Bend, light: LightSample, point: &ShadingPoint, area: &Area) -> LightSample {
    let times = |factor: f64| LightSample {
        intensity: light.intensity * factor,
        projected: light.projected.map(|share| crate::probe::ProjectedShare {
            share: share.share * factor,
            ..share
        }),
        ..light
    };
    let share = light.intensity.max_channel() / (area.radiance.max_channel() * light.attenuation);
    match bend {
        Bend::LightSum if share > 0.0 => times(1.0 / share),
        Bend::CosLightMissing => times(1.0 / light.cos_angle),
        Bend::AreaMissing => times(1.0 / area.area),
        Bend::DistanceMissing => times(light.distance * light.distance),
        Bend::PiMissing => times(PI),
        Bend::MiddleOnly => {
            let middle = area.sample(point.at.point, [0.5; 2]);
            middle.map_or(light, |middle| LightSample {
                intensity: middle.intensity * share,
                ..middle
            })
        }
        _ => light,
    }
}

/// The shadow ray whichever side of the surface the light is on.
fn from_both_sides<S: LightSampler>(
    sampler: &S,
    light: LightSample,
    point: &ShadingPoint,
) -> SampledRay {
    let ray = sampler.to_light(Some(light));
    if ray.is_ok() || point.shows_lights().is_err() || light.intensity.is_black() {
        return ray;
    }
    let origin = point.at.origin_towards(light.direction);
    Ok(ShadowRay {
        ray: Ray::new(origin, light.direction),
        light,
        n_dot_l: point.at.normal.dot(light.direction),
    })
}

/// The way from a point to the first light, and its distance.
pub fn to_first_light(
    world: &World,
    settings: &Settings,
    point: &ShadingPoint,
) -> Option<(Ray, f64)> {
    let kind = &world.scene.lights.first()?.kind;
    let light = PointSampler::new(settings, point, kind).light(0)?;
    let origin = point.at.origin_towards(point.at.geometric_normal);
    Some((Ray::new(origin, light.direction), light.distance))
}

/// Stands for what blocks a light where nothing does.
pub fn nothing_hit() -> Hit {
    Hit {
        t: 1.0,
        primitive: 0,
        part: 0,
        place: [1.0, 0.0, 0.0],
    }
}
