//! What a place on a surface asks of a light: whether anything stands on the way to it.

use super::area::AreaView;
use super::shadow::Shadow;
use crate::math::{DVec3, Ray, Rgb};
use crate::probe::{Absence, counting};
use crate::scene::{Scene, Settings};
use crate::shading::{Illumination, Interaction, Material};
use crate::world::World;

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

/// Where all shadow rays from a place start, since all go to the front.
#[derive(Clone, Copy, Debug)]
pub struct Start {
    /// Clear of the surface.
    pub origin: DVec3,
    /// How far it is from the place.
    pub moved: f64,
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

/// The light as `at` sees it; of an area, what one sample adds to the mean.
#[inline]
pub fn illumination(
    scene: &Scene,
    (at, area): (&Interaction, Option<&AreaView>),
    (light, sample): (u32, u32),
) -> Option<Illumination> {
    match area {
        Some(area) => area.sample(at, sample),
        None => scene.lights[light as usize].source.at(at.point, [0.0; 2]),
    }
}

/// The question to ask of a light with one sample of it, or the reason why none is asked.
pub fn question(
    scene: &Scene,
    settings: &Settings,
    (surface, area): (&Surface, Option<&AreaView>),
    light: (u32, u32),
) -> Result<Question, Absence> {
    let area = area.filter(|_| counting::AREAS);
    if surface.diffuse.is_black() && surface.material.specular.is_black() {
        return Err(Absence::NoLocalLight);
    }
    let at = surface.at;
    let Some(lit) = illumination(scene, (at, area), light) else {
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
    let start = area.map_or_else(|| Start::before(at), |area| area.start);
    let ray = Ray::new(start.origin, lit.direction);
    let arrival = (lit.distance, lit.cos_angle);
    let sooner = settings
        .arithmetic
        .short_of_light(at.point, start.moved, arrival);
    let distance = lit.distance - sooner;
    let lit = Illumination { distance, ..lit };
    Ok(Question { ray, lit, n_dot_l })
}

impl Start {
    /// Where they start from `at`.
    #[inline]
    pub fn before(at: &Interaction) -> Self {
        let origin = at.origin_towards(at.geometric_normal);
        let moved = (origin - at.point).length();
        Self { origin, moved }
    }
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
