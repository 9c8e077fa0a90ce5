//! One pixel: its samples, and their weighted sum.

use super::sampled::Sampled;
use super::whitted::Tracer;
use crate::math::Rgb;
use crate::probe::{Probe, Silent};
use crate::scene::{Settings, World};

/// A traced pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    /// Its linear colour: the weighted sum of its samples' radiances, added in their order.
    pub color: Rgb,
    /// Rays that it cost.
    pub rays: u64,
    /// What it spent of its budget besides eye rays: rays, and questions to lights that needed none.
    pub spent: u64,
    /// True if a limit cut it short, so that its colour is not all that was asked for.
    pub cut: bool,
    /// Samples that it has.
    pub samples: u32,
    /// The estimated standard error of its luminance (see [`super::spread`]); infinite if nothing is known of it.
    pub error: f64,
    /// Samples whose radiance was no finite number, and the first of them. They count as black.
    pub spoiled: u32,
    /// The number of the first of them.
    pub first_spoiled: Option<u32>,
}

/// What a sample that brought this radiance counts: a number that is none does not spread into the pixel.
pub fn counted(radiance: Rgb) -> Rgb {
    if radiance.is_finite() {
        radiance
    } else {
        Rgb::BLACK
    }
}

impl Default for Pixel {
    /// No sample yet.
    fn default() -> Self {
        Self {
            color: Rgb::BLACK,
            rays: 0,
            spent: 0,
            cut: false,
            samples: 0,
            error: f64::INFINITY,
            spoiled: 0,
            first_spoiled: None,
        }
    }
}

/// Traces pixel (x, y) and tells `probe` of everything that happens. With any probe, on any thread, its colour is the
/// same bit for bit.
pub fn pixel<P: Probe>(world: &World, settings: &Settings, at: (u32, u32), probe: &mut P) -> Pixel {
    sampled(&mut Tracer::new(world, settings, probe), at)
}

/// The same with a tracer that is there already.
///
/// Where samples decide how many there are to be, their weights are known only after the last. A probe that listens
/// is told the truth from the first on: the pixel is traced silently before.
#[inline]
pub fn sampled<P: Probe>(tracer: &mut Tracer<P>, at: (u32, u32)) -> Pixel {
    let (settings, budget) = (tracer.settings, tracer.budget);
    if P::LISTENS && settings.adaptive.is_some() {
        let mut silent = Silent;
        let mut ahead = Tracer::new(tracer.world, settings, &mut silent);
        let found = follow(&mut ahead, Sampled::new(settings, budget, at));
        let known = Sampled::with(settings, budget, at, Some(found.samples));
        let told = follow(tracer, known);
        return Pixel {
            error: found.error,
            ..told
        };
    }
    follow(tracer, Sampled::new(settings, budget, at))
}

/// The same in silence, given up between two samples as soon as `stopped` says so.
pub fn pixel_unless(
    world: &World,
    settings: &Settings,
    at: (u32, u32),
    stopped: &dyn Fn() -> bool,
) -> Option<Pixel> {
    let mut silent = Silent;
    let mut tracer = Tracer::new(world, settings, &mut silent);
    let mut sampled = Sampled::new(settings, tracer.budget, at);
    while sampled.is_open(settings) {
        if stopped() {
            return None;
        }
        sampled.next(&mut tracer);
    }
    Some(*sampled.finish(settings))
}

/// Takes sample after sample.
fn follow<P: Probe>(tracer: &mut Tracer<P>, mut sampled: Sampled) -> Pixel {
    let settings = tracer.settings;
    while sampled.is_open(settings) {
        sampled.next(tracer);
    }
    *sampled.finish(settings)
}
