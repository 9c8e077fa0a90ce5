//! The picture: tiles of pixels, shared out to all cores.

use rayon::prelude::*;

use super::pixel::pixel;
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
struct Tile {
    x: [u32; 2],
    y: [u32; 2],
}

/// Renders the whole picture on all threads of the current pool. Each pixel depends on nothing but the scene and the
/// settings, so the picture is the same for any number of threads.
///
/// Each tile is told to a probe of its own; they come back in the order of the tiles. After each tile `watch` hears
/// how many pixels and rays it had.
pub fn render<P: Probe + Default + Send>(
    world: &World,
    settings: &Settings,
    watch: &(dyn Fn(u64, u64) -> Flow + Sync),
) -> (Film, Vec<P>) {
    let stopped = std::sync::atomic::AtomicBool::new(false);
    let order = std::sync::atomic::Ordering::Relaxed;
    let results: Vec<_> = tiles(settings)
        .into_par_iter()
        .map(|tile| {
            let mut probe = P::default();
            if stopped.load(order) {
                return (tile, Vec::new(), 0, true, probe);
            }
            let (mut colors, mut rays, mut cut) = (Vec::new(), 0, false);
            for y in tile.y[0]..tile.y[1] {
                for x in tile.x[0]..tile.x[1] {
                    let pixel = pixel(world, settings, (x, y), &mut probe);
                    colors.push(pixel.color);
                    rays += pixel.rays;
                    cut |= pixel.cut;
                }
            }
            if watch(colors.len() as u64, rays) == Flow::Stop {
                stopped.store(true, order);
            }
            (tile, colors, rays, cut, probe)
        })
        .collect();

    let mut film = Film {
        width: settings.width,
        height: settings.height,
        pixels: vec![Rgb::BLACK; settings.width as usize * settings.height as usize],
        rays: 0,
        cut: false,
    };
    let mut probes = Vec::with_capacity(results.len());
    for (tile, colors, rays, cut, probe) in results {
        film.place(tile, &colors);
        film.rays += rays;
        film.cut |= cut;
        probes.push(probe);
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
