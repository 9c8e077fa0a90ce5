//! Colours of a triangle's pixels: computed once, at the corners, or at every pixel.

use super::ScreenFace;
use crate::math::{Ray, Rgb};
use crate::scene::{Effect, Scene, Settings};
use crate::shading::{Interaction, ShadingModel, ShadingPoint};
use crate::tracer::corners::seen_from;
use crate::tracer::laws::Ours;
use crate::tracer::light_sampler::{AreaSampler, LightSampler, PointSampler, ShadowRay};
use crate::tracer::path_id::PathId;

/// Colours of one triangle's pixels.
pub struct Shade<'a> {
    scene: &'a Scene,
    settings: &'a Settings,
    face: &'a ScreenFace,
    known: Known,
}

/// Colours that are computed before the first pixel.
enum Known {
    /// One for all pixels.
    All(Rgb),
    /// Those at the corners.
    Corners([Rgb; 3]),
    /// None.
    Nothing,
}

impl<'a> Shade<'a> {
    /// Colours of a triangle; those at its corners are computed now, if the model blends them.
    pub fn new(
        (scene, settings): (&'a Scene, &'a Settings),
        model: ShadingModel,
        face: &'a ScreenFace,
    ) -> Self {
        let mut shade = Self {
            scene,
            settings,
            face,
            known: Known::Nothing,
        };
        shade.known = match model {
            ShadingModel::Flat => Known::All(shade.computed([1.0 / 3.0; 3], true)),
            ShadingModel::Gouraud => {
                let corner = |i: usize| std::array::from_fn(|j| f64::from(i == j));
                Known::Corners(std::array::from_fn(|i| shade.computed(corner(i), false)))
            }
            ShadingModel::Phong => Known::Nothing,
        };
        shade
    }

    /// The colour at a point that is given by the weights of the corners, seen along `ray`.
    pub fn color(&self, ray: &Ray, weights: [f64; 3]) -> Rgb {
        match self.known {
            Known::All(color) => color,
            Known::Corners([a, b, c]) => {
                let [u, v, w] = weights;
                a * u + b * v + c * w
            }
            Known::Nothing => self.at_pixel(ray, weights),
        }
    }

    /// The colour at a point as the eye sees it.
    fn computed(&self, weights: [f64; 3], flat: bool) -> Rgb {
        let of = (self.scene, self.settings.effects);
        let seen = (self.face.point(weights), self.face.hit(0.0, weights));
        let at = seen_from(Ours, of, self.scene.camera.eye, seen);
        self.lit(&if flat { at.flat() } else { at })
    }

    /// The colour at a pixel.
    fn at_pixel(&self, ray: &Ray, weights: [f64; 3]) -> Rgb {
        let hit = self.face.hit_at(ray, weights);
        let at = self.scene.interaction(ray, &hit);
        let effects = self.settings.effects;
        self.lit(self.scene.shaded((&hit, &at), effects, &mut None))
    }

    /// Le + Ka Ia + the sum over all lights, of which nothing is hidden; of an area light its middle stands for all.
    fn lit(&self, at: &Interaction) -> Rgb {
        let (scene, settings) = (self.scene, self.settings);
        let material = scene.material_of(self.face.primitive);
        let point = ShadingPoint::new(at, material, settings.effects);
        let mut sum = Rgb::BLACK;
        for term in [point.emitted(), point.ambient(scene.ambient)] {
            sum += term.map_or(Rgb::BLACK, |term| term.value());
        }
        let hard = settings.with(|s| s.effects = s.effects.without(Effect::SoftShadows));
        for (light, number) in scene.lights.iter().zip(0..) {
            let kind = &light.kind;
            let arrival = match kind.area() {
                Some(area) => {
                    let path = (PathId::eye((0, 0), 0), number);
                    AreaSampler::new(&hard, &point, area, path).shadow_ray(0)
                }
                None => PointSampler::new(settings, &point, kind).shadow_ray(0),
            };
            if let Ok(ShadowRay { light, n_dot_l, .. }) = arrival {
                point.eval(&light, n_dot_l, |term| sum += term.value());
            }
        }
        sum
    }
}
