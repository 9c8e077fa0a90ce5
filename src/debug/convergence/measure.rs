//! Tracing of a pixel with more and more samples.

use super::sampling::with_samples;
use crate::scene::{Settings, limits};
use crate::tracer::{Pixel, PixelEstimator};
use crate::world::World;

/// Rays that one point may cost.
const MOST_RAYS: u64 = 1 << 20;

/// The largest number of samples, as a power of 2.
pub const LAST_POWER: u32 = limits::MAX_SAMPLES.ilog2();

/// Traces a pixel with 1, 2, 4 and so on samples until that costs too much; the reason why it ended.
pub fn measure(
    world: &World,
    settings: &Settings,
    at: (u32, u32),
    stopped: &dyn Fn() -> bool,
    tell: &dyn Fn(Pixel),
) -> &'static str {
    for power in 0..=LAST_POWER {
        let settings = with_samples(settings, 1 << power);
        let Some(pixel) = PixelEstimator::trace_unless(world, &settings, at, stopped) else {
            return "given up";
        };
        if pixel.truncated {
            return "the pixel's share of --max-rays ends here";
        }
        tell(pixel);
        if 2 * pixel.rays > MOST_RAYS {
            return "more would take long";
        }
    }
    "no more samples are tried"
}
