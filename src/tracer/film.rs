//! The picture: tiles of pixels, shared out to all cores.

use std::ops::Range;

use rayon::prelude::*;

use super::pixel::Pixel;
use super::stack::on_threads;
use super::tile::{Tile, tiles};
use crate::math::Rgb;
use crate::probe::Probe;
use crate::scene::Settings;
use crate::world::World;

/// A rendered picture in linear radiance.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Film {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Row after row from the top.
    pub pixels: Vec<Rgb>,
    /// Rays that it cost.
    pub rays: u64,
    /// True if a limit cut a pixel short.
    pub cut: bool,
    /// Samples of each pixel, in the order of `pixels`; empty if all have as many as were asked for.
    pub samples: Vec<u32>,
    /// The estimated standard error of each pixel's luminance; empty if nobody wanted to know.
    pub errors: Vec<f64>,
    /// Samples that were no finite numbers.
    pub spoiled: Spoiled,
}

/// Samples whose radiance was no finite number; they count as black.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Spoiled {
    /// How many.
    pub count: u64,
    /// The pixel of the first, and its number there.
    pub first: Option<((u32, u32), u32)>,
}

/// What the watcher of a render wants.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flow {
    /// Go on.
    Continue,
    /// Leave the tiles that have not begun black.
    Stop,
}

/// Renders the whole picture on `threads` threads (0: one a core). Each pixel depends on nothing but the scene and
/// the settings, so the picture is the same for any number of threads.
///
/// Each tile is told to a probe of its own; they come back in the order of the tiles. After each tile `watch` hears
/// how many pixels and rays it had.
pub fn render<P: Probe + Default + Send>(
    world: &World,
    settings: &Settings,
    threads: usize,
    watch: &(dyn Fn(u64, u64) -> Flow + Sync),
) -> (Film, Vec<P>) {
    let stopped = std::sync::atomic::AtomicBool::new(false);
    let order = std::sync::atomic::Ordering::Relaxed;
    let results: Vec<_> = on_threads(threads, || {
        tiles(settings)
            .into_par_iter()
            .map(|tile| {
                if stopped.load(order) {
                    return tile.blank();
                }
                let done = tile.render(world, settings);
                if watch(done.film.pixels.len() as u64, done.film.rays) == Flow::Stop {
                    stopped.store(true, order);
                }
                done
            })
            .collect()
    });

    let mut film = Film::black(settings.size(), settings);
    let mut probes = Vec::with_capacity(results.len());
    for done in results {
        film.paste(done.tile, &done.film);
        probes.push(done.probe);
    }
    (film, probes)
}

impl Film {
    /// The colour of a pixel.
    pub fn at(&self, x: u32, y: u32) -> Rgb {
        self.pixels[y as usize * self.width as usize + x as usize]
    }

    /// The root of the mean square of the pixels' estimated standard errors; `None` if nobody wanted to know them.
    pub fn error(&self) -> Option<f64> {
        let squares: f64 = self.errors.iter().map(|error| error * error).sum();
        let count = self.errors.len();
        (count > 0).then(|| (squares / count as f64).sqrt())
    }

    /// A picture that nothing was put into.
    pub fn black((width, height): (u32, u32), settings: &Settings) -> Self {
        let count = width as usize * height as usize;
        let if_wanted = |wanted: bool| if wanted { count } else { 0 };
        Self {
            width,
            height,
            pixels: vec![Rgb::BLACK; count],
            samples: vec![0; if_wanted(settings.pixel.adaptive.is_some())],
            errors: vec![f64::INFINITY; if_wanted(settings.pixel.errors)],
            ..Self::default()
        }
    }

    /// Puts in pixel number `index`, which is the one `at` this place of the whole picture.
    pub fn put(&mut self, index: usize, at: (u32, u32), pixel: &Pixel) {
        self.pixels[index] = pixel.color;
        if let Some(samples) = self.samples.get_mut(index) {
            *samples = pixel.samples;
        }
        if let Some(error) = self.errors.get_mut(index) {
            *error = pixel.error;
        }
        self.rays += pixel.rays;
        self.cut |= pixel.cut;
        if pixel.spoiled > 0 {
            self.spoiled = self.spoiled.plus(Spoiled {
                count: u64::from(pixel.spoiled),
                first: pixel.first_spoiled.map(|sample| (at, sample)),
            });
        }
    }

    /// Puts in a tile.
    fn paste(&mut self, tile: Tile, film: &Self) {
        let (columns, rows) = tile.size();
        let columns = columns as usize;
        for row in 0..rows as usize {
            let from = row * columns..(row + 1) * columns;
            let start = (tile.y[0] as usize + row) * self.width as usize + tile.x[0] as usize;
            let to = start..start + columns;
            copy(&mut self.pixels, to.clone(), &film.pixels, from.clone());
            copy(&mut self.samples, to.clone(), &film.samples, from.clone());
            copy(&mut self.errors, to, &film.errors, from);
        }
        self.rays += film.rays;
        self.cut |= film.cut;
        self.spoiled = self.spoiled.plus(film.spoiled);
    }
}

/// Copies a range, if there is anything to copy and to copy to.
fn copy<T: Copy>(to: &mut [T], there: Range<usize>, from: &[T], here: Range<usize>) {
    if let (Some(to), Some(from)) = (to.get_mut(there), from.get(here)) {
        to.copy_from_slice(from);
    }
}

impl Spoiled {
    /// Both, those of `self` first.
    fn plus(self, other: Self) -> Self {
        Self {
            count: self.count + other.count,
            first: self.first.or(other.first),
        }
    }
}
