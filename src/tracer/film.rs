//! The picture: tiles of pixels, shared out to all cores.

use rayon::prelude::*;

use super::foresight::Foresight;
use super::lights::Asker;
use super::pixel::{Pixel, pixel};
use super::stack::on_threads;
use crate::math::Rgb;
use crate::probe::Probe;
use crate::scene::{Settings, World};

/// The edge of a tile in pixels: rays that are neighbours in the picture are neighbours in the scene.
pub const TILE: u32 = 16;

/// A rendered picture in linear radiance.
#[derive(Clone, Debug, PartialEq)]
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
}

/// What the watcher of a render wants.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flow {
    /// Go on.
    Continue,
    /// Leave the tiles that have not begun black.
    Stop,
}

/// A tile of the picture: pixels x0..x1, y0..y1.
#[derive(Clone, Copy, Debug)]
pub struct Tile {
    /// First column, and the one behind the last.
    pub x: [u32; 2],
    /// First row, and the one behind the last.
    pub y: [u32; 2],
}

/// A rendered tile, or one that was left out.
struct Done<P> {
    tile: Tile,
    colors: Vec<Rgb>,
    rays: u64,
    cut: bool,
    probe: P,
}

impl Tile {
    /// The tile left out: its pixels stay black.
    fn blank<P: Default>(self) -> Done<P> {
        Done {
            tile: self,
            colors: Vec::new(),
            rays: 0,
            cut: true,
            probe: P::default(),
        }
    }

    /// The tile's pixels, row after row: asked for in bundles if that is quicker and nobody listens, else one
    /// by one.
    fn render<P: Probe + Default>(self, world: &World, settings: &Settings) -> Done<P> {
        let mut probe = P::default();
        let columns = self.x[1] - self.x[0];
        let count = (columns * (self.y[1] - self.y[0])) as usize;
        let mut pixels = vec![Pixel::NEW; count];
        let place = |(x, y): (u32, u32)| ((y - self.y[0]) * columns + (x - self.x[0])) as usize;
        if P::LISTENS || !world.accel.gains_from_bundles() {
            for at in
                (self.y[0]..self.y[1]).flat_map(|y| (self.x[0]..self.x[1]).map(move |x| (x, y)))
            {
                pixels[place(at)] = pixel(world, settings, at, &mut probe);
            }
        } else {
            let mut foresight = Foresight::default();
            for sample in 0..settings.samples {
                foresight.ask(world, settings, self, sample);
                for (at, ray, foreseen) in foresight.pixels() {
                    let asker = Asker::eye(at, sample);
                    pixels[place(at)].add(world, settings, asker, ray, Some(foreseen), &mut probe);
                }
            }
        }
        Done {
            tile: self,
            colors: pixels.iter().map(|p| p.color).collect(),
            rays: pixels.iter().map(|p| p.rays).sum(),
            cut: pixels.iter().any(|p| p.cut),
            probe,
        }
    }
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
                if watch(done.colors.len() as u64, done.rays) == Flow::Stop {
                    stopped.store(true, order);
                }
                done
            })
            .collect()
    });

    let mut film = Film {
        width: settings.width,
        height: settings.height,
        pixels: vec![Rgb::BLACK; settings.width as usize * settings.height as usize],
        rays: 0,
        cut: false,
    };
    let mut probes = Vec::with_capacity(results.len());
    for done in results {
        film.place(done.tile, &done.colors);
        film.rays += done.rays;
        film.cut |= done.cut;
        probes.push(done.probe);
    }
    (film, probes)
}

/// The picture cut into tiles, row after row.
fn tiles(settings: &Settings) -> Vec<Tile> {
    let starts = |end: u32| (0..end).step_by(TILE as usize);
    let range = |start: u32, end: u32| [start, (start + TILE).min(end)];
    starts(settings.height)
        .flat_map(|y| {
            starts(settings.width).map(move |x| Tile {
                x: range(x, settings.width),
                y: range(y, settings.height),
            })
        })
        .collect()
}

impl Film {
    /// The colour of a pixel.
    pub fn at(&self, x: u32, y: u32) -> Rgb {
        self.pixels[y as usize * self.width as usize + x as usize]
    }

    fn place(&mut self, tile: Tile, colors: &[Rgb]) {
        let columns = (tile.x[1] - tile.x[0]) as usize;
        for (y, row) in (tile.y[0]..).zip(colors.chunks(columns)) {
            let start = y as usize * self.width as usize + tile.x[0] as usize;
            self.pixels[start..start + columns].copy_from_slice(row);
        }
    }
}
