//! One pixel: its samples, and their weighted sum.

use super::foresight::Foreseen;
use super::lights::Asker;
use super::whitted::Tracer;
use crate::math::points::in_cell;
use crate::math::sampler::{Dimension, uniform};
use crate::math::{Ray, Rgb};
use crate::probe::{Event, Probe};
use crate::scene::{Sampling, Settings, World};

/// A traced pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    /// Its linear colour: the weighted sum of its samples' radiances.
    pub color: Rgb,
    /// Rays that it cost.
    pub rays: u64,
    /// True if a limit cut it short, so that its colour is not all that was asked for.
    pub cut: bool,
}

impl Pixel {
    /// No sample yet.
    pub const NEW: Self = Self {
        color: Rgb::BLACK,
        rays: 0,
        cut: false,
    };

    /// Adds what a sample of this weight brings along its eye ray. Rays are counted over all samples, since the
    /// budget is the pixel's.
    #[inline]
    pub fn add<P: Probe>(
        &mut self,
        world: &World,
        settings: &Settings,
        asker: Asker,
        ray: Ray,
        foreseen: Option<Foreseen>,
        probe: &mut P,
    ) {
        let mut tracer = Tracer::new(world, settings, probe).continuing(self.rays);
        self.color += tracer.eye(asker, ray, foreseen) * weight(settings);
        self.rays = tracer.rays;
        self.cut |= tracer.cut;
    }
}

/// The weight of each sample in its pixel's sum.
fn weight(settings: &Settings) -> f64 {
    1.0 / f64::from(settings.samples)
}

/// Traces pixel (x, y) and tells `probe` of everything that happens. With any probe, on any thread, its colour is the
/// same bit for bit.
#[inline]
pub fn pixel<P: Probe>(
    world: &World,
    settings: &Settings,
    (x, y): (u32, u32),
    probe: &mut P,
) -> Pixel {
    let mut pixel = Pixel::NEW;
    for index in 0..settings.samples {
        let film = film_position(settings, (x, y), index);
        probe.event(Event::Sample {
            index,
            film,
            weight: weight(settings),
        });
        let ray = world.scene.camera.ray(film, settings.size());
        let asker = Asker::eye((x, y), index);
        pixel.add(world, settings, asker, ray, None, probe);
    }
    pixel
}

/// Where on the film a sample lies: in its cell of a grid over the pixel, in the middle or by chance.
pub fn film_position(settings: &Settings, (x, y): (u32, u32), index: u32) -> [f64; 2] {
    let place = match settings.sampling {
        Sampling::Regular => [0.5, 0.5],
        Sampling::Jittered => [Dimension::FilmX, Dimension::FilmY]
            .map(|dimension| uniform(settings.seed, (x, y), index, dimension)),
    };
    let [u, v] = in_cell(index, settings.samples, place);
    [f64::from(x) + u, f64::from(y) + v]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_fill_their_pixel_evenly() {
        let mut settings = Settings {
            samples: 4,
            ..Settings::default()
        };
        let at = |s: &Settings| [0, 1, 2, 3].map(|i| film_position(s, (10, 20), i));
        let regular = [
            [10.25, 20.25],
            [10.75, 20.25],
            [10.25, 20.75],
            [10.75, 20.75],
        ];
        assert_eq!(at(&settings), regular);
        settings.sampling = Sampling::Jittered;
        for (jittered, middle) in at(&settings).iter().zip(regular) {
            assert!((jittered[0] - middle[0]).abs() <= 0.25);
            assert!((jittered[1] - middle[1]).abs() <= 0.25);
        }
    }
}
