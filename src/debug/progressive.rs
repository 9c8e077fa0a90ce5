//! Progressive rendering of a window of the image: coarse blocks first, each pixel once.

use rayon::prelude::*;

use super::window::Window;
use crate::lab::show::{ShowMode, ShownValue};
use crate::probe::Silent;
use crate::scene::Settings;
use crate::tracer::{Pixel, pixel, thread_pool};
use crate::world::World;

/// The sides of the blocks of the passes, in pixels.
pub const BLOCKS: [u32; 5] = [16, 8, 4, 2, 1];

/// Pixels that are reported at once.
const BATCH: usize = 32;

/// A pixel that is drawn: its colour with all that is known of it, or what is shown in its place.
#[derive(Clone, Debug)]
pub enum DrawnPixel {
    /// Its colour.
    Pixel(Pixel),
    /// What is shown.
    Shown(ShownValue),
}

/// Rendered pixels.
pub type Pixels = Vec<((u32, u32), DrawnPixel)>;

/// The part of an image that is to be rendered.
#[derive(Clone, Debug)]
pub struct Missing {
    /// The window.
    pub window: Window,
    /// Which of its pixels are known, row after row; those are skipped.
    pub known: Vec<bool>,
}

/// Renders all missing pixels on `threads` threads (0: one a core), until `stopped`; with a mode what that shows. True if all are
/// done.
pub fn render(
    (world, settings): (&World, &Settings),
    mode: Option<ShowMode>,
    missing: &Missing,
    threads: usize,
    stopped: &(dyn Fn() -> bool + Sync),
    tell: &(dyn Fn(Pixels) + Sync),
) -> bool {
    let is_missing = |at: &(u32, u32)| missing.known.get(missing.window.index(*at)) == Some(&false);
    for (pass, block) in BLOCKS.into_iter().enumerate() {
        let pixels: Vec<(u32, u32)> = corners(missing.window, pass, block)
            .filter(is_missing)
            .collect();
        thread_pool::install(threads, || {
            pixels.par_chunks(BATCH).for_each(|batch| {
                let mut done = Vec::with_capacity(batch.len());
                for at in batch {
                    if stopped() {
                        return;
                    }
                    let drawn = match mode {
                        Some(mode) => DrawnPixel::Shown(mode.of(world, settings, *at)),
                        None => DrawnPixel::Pixel(pixel(world, settings, *at, &mut Silent)),
                    };
                    done.push((*at, drawn));
                }
                tell(done);
            });
        });
        if stopped() {
            return false;
        }
    }
    true
}

/// The pixels of a pass: the first corners of all blocks that were not first corners of larger ones.
fn corners(window: Window, pass: usize, block: u32) -> impl Iterator<Item = (u32, u32)> {
    let step = block as usize;
    let rows = (0..window.height).step_by(step);
    rows.flat_map(move |y| {
        (0..window.width)
            .step_by(step)
            .filter(move |x| pass == 0 || x % (2 * block) != 0 || y % (2 * block) != 0)
            .map(move |x| (window.x + x, window.y + y))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_passes_cover_every_pixel_once() {
        let window = Window {
            x: 3,
            y: 5,
            width: 37,
            height: 21,
        };
        let mut all: Vec<_> = BLOCKS
            .into_iter()
            .enumerate()
            .flat_map(|(pass, block)| corners(window, pass, block))
            .collect();
        assert_eq!(all.len(), 37 * 21);
        all.sort_unstable();
        all.dedup();
        assert_eq!(all.len(), 37 * 21);
    }
}
