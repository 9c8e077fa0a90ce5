//! Light sampler: the shadow rays from one point to one light.
//!
//! A light without area has one sample. An area light has many: each is a point light of its own with its share of the mean
//! (Cook, Porter and Carpenter 1984). What all of them have in common is computed once.

use super::path_id::PathId;
use crate::math::{DVec3, Ray};
use crate::probe::{Absence, ProjectedShare};
use crate::sampling::{LightSampling, Points, SampleSet, Sampler, stream};
use crate::scene::{Effect, Scene, Settings};
use crate::shading::{Area, LightKind, LightSample, ProjectedPolygon, ShadingPoint};

/// Shadow ray, and the light that it brings if nothing is in its way.
#[derive(Clone, Copy, Debug)]
pub struct ShadowRay {
    /// From the surface to the light, whose distance is that of `light`.
    pub ray: Ray,
    /// The light at the surface; of an area light, the share of this sample.
    pub light: LightSample,
    /// N.L, positive.
    pub n_dot_l: f64,
}

/// Shadow ray of a sample, or why none is sent.
pub type SampledRay = Result<ShadowRay, Absence>;

/// Samples of one light at one point.
pub trait LightSampler {
    /// Number of samples.
    fn samples(&self) -> u32;

    /// The light at the point, sample number `sample`, whatever stands in between and whichever side it is on.
    fn light(&self, sample: u32) -> Option<LightSample>;

    /// Shadow ray to such a light, or why none is sent.
    fn to_light(&self, light: Option<LightSample>) -> SampledRay;

    /// Shadow ray number `sample`, or why none is sent.
    fn shadow_ray(&self, sample: u32) -> SampledRay;

    /// Shadow ray number `sample` wherever the light is before the plane of the surface, on whichever side of N and however dark: it
    /// asks whether the light is seen.
    fn sight(&self, sample: u32) -> SampledRay;
}

/// Sampler of a light without area: it has one sample.
pub struct PointSampler<'a> {
    settings: &'a Settings,
    point: &'a ShadingPoint<'a>,
    kind: &'a LightKind,
}

/// Sampler of an area light.
pub struct AreaSampler<'a> {
    settings: &'a Settings,
    point: &'a ShadingPoint<'a>,
    area: &'a Area,
    /// The light's polygon as the surface sees it, if points are chosen by that. (Boxed: it is large, and nearly always none.)
    projected: Option<Box<ProjectedPolygon>>,
    /// Points on the light, and the number of the first one here; none if its middle stands for all.
    points: Option<(Points, u32)>,
    origin: ShadowOrigin,
}

/// Origin of all shadow rays from a point: clear of its surface, on the outer side.
#[derive(Clone, Copy, Debug)]
struct ShadowOrigin {
    origin: DVec3,
    /// Distance from the point.
    offset: f64,
}

/// Number of shadow rays from a point to a light.
#[inline]
pub fn count(scene: &Scene, settings: &Settings, light: u32) -> u32 {
    if scene.lights[light as usize].kind.is_area() {
        settings.rays_to_area()
    } else {
        1
    }
}

impl<'a> PointSampler<'a> {
    /// Sampler of a light without area at `point`.
    #[inline]
    pub fn new(settings: &'a Settings, point: &'a ShadingPoint<'a>, kind: &'a LightKind) -> Self {
        Self {
            settings,
            point,
            kind,
        }
    }
}

impl LightSampler for PointSampler<'_> {
    #[inline]
    fn samples(&self) -> u32 {
        1
    }

    #[inline]
    fn light(&self, _: u32) -> Option<LightSample> {
        self.kind.sample(self.point.at.point)
    }

    fn to_light(&self, light: Option<LightSample>) -> SampledRay {
        let origin = || ShadowOrigin::of(self.point);
        shadow_ray(self.settings, self.point, || light, origin)
    }

    // Always, or it depends on what else the program has: a copy of what comes back costs one part in a hundred of a picture.
    #[inline(always)]
    fn shadow_ray(&self, _: u32) -> SampledRay {
        let origin = || ShadowOrigin::of(self.point);
        shadow_ray(self.settings, self.point, || self.light(0), origin)
    }

    fn sight(&self, _: u32) -> SampledRay {
        sight(self.settings, self.point, self.light(0))
    }
}

impl<'a> AreaSampler<'a> {
    /// Sampler of light number `light`, with this `area`, at `point`, for the ray of a path.
    pub fn new(
        settings: &'a Settings,
        point: &'a ShadingPoint<'a>,
        area: &'a Area,
        (id, light): (PathId, u32),
    ) -> Self {
        let soft = settings.effects.has(Effect::SoftShadows);
        Self {
            settings,
            point,
            area,
            projected: projected(area, settings, point),
            points: soft.then(|| points(settings, id, light)),
            origin: ShadowOrigin::of(point),
        }
    }

    /// P, the projected solid angle of the light, if its samples are chosen in proportion to what they bring.
    pub fn projected_solid_angle(&self) -> Option<f64> {
        self.projected.as_ref().map(|polygon| polygon.area)
    }
}

impl LightSampler for AreaSampler<'_> {
    #[inline]
    fn samples(&self) -> u32 {
        self.settings.rays_to_area()
    }

    /// As a share of the mean.
    #[inline(never)]
    fn light(&self, sample: u32) -> Option<LightSample> {
        let points = self.points.as_ref();
        let u = points.map_or([0.5; 2], |(points, first)| points.at(first + sample));
        let at = self.point.at;
        let light = match &self.projected {
            Some(polygon) => self
                .area
                .sample_projected((at.point, at.normal), polygon, u)?,
            None => self.area.sample(at.point, u)?,
        };
        let share = 1.0 / f64::from(self.samples());
        Some(LightSample {
            intensity: light.intensity * share,
            projected: light.projected.map(|p| ProjectedShare { share, ..p }),
            ..light
        })
    }

    fn to_light(&self, light: Option<LightSample>) -> SampledRay {
        shadow_ray(self.settings, self.point, || light, || self.origin)
    }

    // Always, for the reason above.
    #[inline(always)]
    fn shadow_ray(&self, sample: u32) -> SampledRay {
        let light = || self.light(sample);
        shadow_ray(self.settings, self.point, light, || self.origin)
    }

    fn sight(&self, sample: u32) -> SampledRay {
        sight(self.settings, self.point, self.light(sample))
    }
}

/// Shadow ray from a point to a sample of a light, or why none is sent.
#[inline(always)]
fn shadow_ray(
    settings: &Settings,
    point: &ShadingPoint,
    light: impl FnOnce() -> Option<LightSample>,
    origin: impl FnOnce() -> ShadowOrigin,
) -> SampledRay {
    point.shows_lights()?;
    let Some(light) = light() else {
        return Err(Absence::FacingAway { n_dot_l: 0.0 });
    };
    // The light must be before the surface by both normals, or it would leak through the back of a smooth mesh.
    let at = point.at;
    let n_dot_l = at.normal.dot(light.direction);
    let lowest = n_dot_l.min(at.geometric_normal.dot(light.direction));
    if lowest <= 0.0 {
        return Err(Absence::FacingAway { n_dot_l: lowest });
    }
    if light.intensity.is_black() {
        let cos_angle = light.cos_angle;
        return Err(Absence::OutsideCone { cos_angle });
    }
    Ok(ray_to(settings, point, (light, n_dot_l), origin()))
}

/// Shadow ray to a light that is before the surface.
#[inline(always)]
fn ray_to(
    settings: &Settings,
    point: &ShadingPoint,
    (light, n_dot_l): (LightSample, f64),
    ShadowOrigin { origin, offset }: ShadowOrigin,
) -> ShadowRay {
    let arrival = (light.distance, light.cos_angle);
    let gap = settings
        .arithmetic
        .short_of_light(point.at.point, offset, arrival);
    ShadowRay {
        ray: Ray::new(origin, light.direction),
        light: LightSample {
            distance: light.distance - gap,
            ..light
        },
        n_dot_l,
    }
}

/// Shadow ray to a light that is before the plane of the surface.
fn sight(settings: &Settings, point: &ShadingPoint, light: Option<LightSample>) -> SampledRay {
    let Some(light) = light else {
        return Err(Absence::FacingAway { n_dot_l: 0.0 });
    };
    let at = point.at;
    let before = at.geometric_normal.dot(light.direction);
    if before <= 0.0 {
        return Err(Absence::FacingAway { n_dot_l: before });
    }
    let arrival = (light, at.normal.dot(light.direction));
    Ok(ray_to(settings, point, arrival, ShadowOrigin::of(point)))
}

impl ShadowOrigin {
    #[inline]
    fn of(point: &ShadingPoint) -> Self {
        let origin = point.at.origin_towards(point.at.geometric_normal);
        let offset = (origin - point.at.point).length();
        Self { origin, offset }
    }
}

/// Points on a light for a path, and the number of the first one of this sample of the pixel. The points of all samples of
/// a set, at the end of the same path, complete each other; only a grid is a whole one at each hit.
fn points(settings: &Settings, id: PathId, light: u32) -> (Points, u32) {
    let here = settings.light.samples;
    let (set, sample) = settings.pixel.set_of(id.sample);
    let set = SampleSet {
        key: stream::light_key(settings.seed, id.pixel, id.path, [light, set]),
        count: match settings.light.sampler {
            Sampler::Grid => here,
            _ => here * settings.pixel.set_size(),
        },
    };
    (Points::new(settings.light.sampler, set), sample * here)
}

/// The light's polygon as the surface sees it, if points on it are chosen in proportion to what they bring.
///
/// Not where there are highlights, which do not fall with the cosine that the polygon is weighed by; nor for the grid, which
/// is the lecture's: points on the light, side by side.
fn projected(
    area: &Area,
    settings: &Settings,
    point: &ShadingPoint,
) -> Option<Box<ProjectedPolygon>> {
    let wanted = settings.light.density == LightSampling::Projected
        && settings.light.sampler != Sampler::Grid
        && settings.effects.has(Effect::SoftShadows);
    if !wanted || !point.is_matt() {
        return None;
    }
    area.projected(point.at.point, point.at.normal)
        .map(Box::new)
}
