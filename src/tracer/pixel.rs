//! One pixel: its samples, and their weighted sum.
//!
//! [`camera_sample()`] says where a sample lies and [`weights`] how much it counts; [`PixelEstimator`] takes sample after
//! sample, as many as the rules in [`adaptive`] ask for, and ends with an estimate, a [`Pixel`].

pub mod adaptive;
pub mod camera_sample;
pub mod estimate;
pub mod estimator;
pub mod weights;

use super::laws::Bent;
use super::state::Tracer;
use crate::probe::{Probe, counting};
use crate::scene::Settings;
use crate::world::World;

pub use camera_sample::{CameraSample, CameraSamples, camera_sample};
pub use estimate::Pixel;
pub use estimator::PixelEstimator;
pub use weights::Weights;

/// Traces pixel (x, y) and tells `probe` of everything that happens. With any probe, on any thread, its colour is the
/// same bit for bit.
pub fn pixel<P: Probe>(world: &World, settings: &Settings, at: (u32, u32), probe: &mut P) -> Pixel {
    if !counting::BENDS || settings.bends.is_empty() {
        return PixelEstimator::trace(&mut Tracer::new(world, settings, probe), at);
    }
    let laws = Bent(settings.bends);
    let tracer = &mut Tracer::by_laws(world, settings, probe, laws);
    let pixel = PixelEstimator::trace(tracer, at);
    Pixel {
        color: settings.bends.color(pixel.color, pixel.samples),
        ..pixel
    }
}
