//! What a place on a surface asks of a light: whether anything stands on the way to it.

use super::shadow::Shadow;
use crate::math::points::Run;
use crate::math::sampler::light_run;
use crate::math::{LightSampling, Ray, Rgb, Sampler};
use crate::probe::Absence;
use crate::scene::{Effect, Scene, Settings, World};
use crate::shading::{Area, Illumination, Interaction, Material, Projected, Source};

/// Who asks: each has points on the lights of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Asker {
    /// The pixel.
    pub pixel: (u32, u32),
    /// The sample of the pixel.
    pub sample: u32,
    /// The number of the path from the eye, by [`Asker::follow`].
    pub path: u64,
}

/// What has to be known before a light counts: whether anything stands on this ray before the light.
#[derive(Clone, Copy, Debug)]
pub struct Question {
    /// From the surface to the light.
    pub ray: Ray,
    /// The light as the surface sees it; of an area, this sample's share.
    pub lit: Illumination,
    /// N.L, positive.
    pub n_dot_l: f64,
}

/// A place on a surface, as far as lights matter there.
#[derive(Clone, Copy, Debug)]
pub struct Surface<'a> {
    /// The place.
    pub at: &'a Interaction,
    /// What it is made of.
    pub material: &'a Material,
    /// Kd there.
    pub diffuse: Rgb,
}

/// The questions of one place to one area, and the answers: room that is used again and again.
#[derive(Default)]
pub struct Bundle {
    /// Each with the number of its sample.
    pub questions: Vec<(u32, Question)>,
    shadow: Shadow,
    /// Question by question, whether something stands in the way.
    pub blocked: Vec<bool>,
}

impl Asker {
    /// The eye ray of a sample.
    pub fn eye(pixel: (u32, u32), sample: u32) -> Self {
        Self {
            pixel,
            sample,
            path: 0,
        }
    }

    /// The next ray on the path, reflected or transmitted: a path is a number to the base 3, without zeros.
    #[must_use]
    pub fn follow(self, transmitted: bool) -> Self {
        let path = self.path.wrapping_mul(3).wrapping_add(1);
        Self {
            path: path.wrapping_add(u64::from(transmitted)),
            ..self
        }
    }

    /// The place on light number `light` that sample number `sample` asks for, in [0, 1)^2. The samples of all hits of
    /// a pixel at the end of the same path are one run; only a grid is a whole one at each hit.
    pub fn point(self, settings: &Settings, light: u32, sample: u32) -> [f64; 2] {
        if !settings.effects.has(Effect::SoftShadows) {
            return [0.5, 0.5];
        }
        let here = settings.light_samples;
        let run = Run {
            key: light_run(settings.seed, self.pixel, self.path, light),
            count: match settings.sampler {
                Sampler::Grid => here,
                _ => here * settings.set_size(),
            },
        };
        settings.sampler.point(run, self.sample * here + sample)
    }
}

/// How many shadow rays a place sends to a light.
#[inline]
pub fn samples(scene: &Scene, settings: &Settings, light: u32) -> u32 {
    if scene.lights[light as usize].source.is_area() {
        settings.rays_to_area()
    } else {
        1
    }
}

/// What is the same for all samples of a light at one place: its polygon as the place sees it, if places on the light
/// are chosen by that.
///
/// Not for highlights, which do not fall with the cosine that the polygon is weighed by; nor for the grid, which is the
/// lecture's: points on the light, side by side.
#[inline]
pub fn seen(
    scene: &Scene,
    settings: &Settings,
    surface: &Surface,
    light: u32,
) -> Option<Box<Projected>> {
    match &scene.lights[light as usize].source {
        Source::Area(area) => polygon(area, settings, surface),
        _ => None,
    }
}

/// The same of an area.
#[inline(never)]
fn polygon(area: &Area, settings: &Settings, surface: &Surface) -> Option<Box<Projected>> {
    let by_what_it_brings = settings.light_sampling == LightSampling::Projected
        && settings.sampler != Sampler::Grid
        && settings.effects.has(Effect::SoftShadows)
        && surface.material.specular.is_black();
    if !by_what_it_brings || surface.diffuse.is_black() {
        return None;
    }
    let at = surface.at;
    // Boxed: it is large, and nearly always none.
    area.projected(at.point, at.normal).map(Box::new)
}

/// The light as `at` sees it; of an area, what one sample adds to the mean.
#[inline]
pub fn illumination(
    scene: &Scene,
    settings: &Settings,
    asker: Asker,
    (at, projected): (&Interaction, Option<&Projected>),
    light: (u32, u32),
) -> Option<Illumination> {
    match &scene.lights[light.0 as usize].source {
        Source::Area(area) => one_of_many(area, settings, asker, (at, projected), light),
        source => source.at(at.point, [0.0; 2]),
    }
}

/// The same of an area. (On its own, so that scenes without areas pay nothing for it.)
#[inline(never)]
fn one_of_many(
    area: &Area,
    settings: &Settings,
    asker: Asker,
    (at, projected): (&Interaction, Option<&Projected>),
    (light, sample): (u32, u32),
) -> Option<Illumination> {
    let u = asker.point(settings, light, sample);
    let seen = match projected {
        Some(polygon) => area.sample_projected((at.point, at.normal), polygon, u)?,
        None => area.sample(at.point, u)?,
    };
    let share = 1.0 / f64::from(settings.rays_to_area());
    Some(Illumination {
        intensity: seen.intensity * share,
        irradiance: seen.irradiance.map(|e: Rgb| e * share),
        ..seen
    })
}

/// The question to ask of a light with one sample of it, or the reason why none is asked.
pub fn question(
    scene: &Scene,
    settings: &Settings,
    asker: Asker,
    (surface, projected): (&Surface, Option<&Projected>),
    light: (u32, u32),
) -> Result<Question, Absence> {
    if surface.diffuse.is_black() && surface.material.specular.is_black() {
        return Err(Absence::NoLocalLight);
    }
    let at = surface.at;
    let Some(lit) = illumination(scene, settings, asker, (at, projected), light) else {
        return Err(Absence::FacingAway { n_dot_l: 0.0 });
    };
    // The light must be before the surface by both normals, or light would leak through a smooth mesh's back.
    let n_dot_l = at.normal.dot(lit.direction);
    let lowest = n_dot_l.min(at.geometric_normal.dot(lit.direction));
    if lowest <= 0.0 {
        return Err(Absence::FacingAway { n_dot_l: lowest });
    }
    if lit.intensity.is_black() {
        let cos_angle = lit.cos_angle;
        return Err(Absence::OutsideCone { cos_angle });
    }
    let ray = Ray::new(at.origin_towards(lit.direction), lit.direction);
    let arrival = (lit.distance, lit.cos_angle);
    let sooner = settings.arithmetic.short_of_light(at.point, &ray, arrival);
    let distance = lit.distance - sooner;
    let lit = Illumination { distance, ..lit };
    Ok(Question { ray, lit, n_dot_l })
}

impl<'a> Surface<'a> {
    /// The place `at` of a material.
    #[inline]
    pub fn new(at: &'a Interaction, material: &'a Material) -> Self {
        let diffuse = material.diffuse_at(at.uv);
        Self {
            at,
            material,
            diffuse,
        }
    }
}

impl Bundle {
    /// Answers all questions together.
    pub fn answer(&mut self, world: &World) {
        self.shadow.clear();
        for (i, (_, question)) in self.questions.iter().enumerate() {
            self.shadow.push(question.ray, question.lit.distance, i);
        }
        self.blocked.clear();
        self.blocked.resize(self.questions.len(), false);
        for (i, blocked) in self.shadow.answers(world, true) {
            self.blocked[i] = blocked;
        }
    }
}
