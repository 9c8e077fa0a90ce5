//! A tile of the picture: pixels that are rendered together.

use super::around;
use super::film::Film;

use super::pixel::{of_count, sampled};
use super::sampled::Sampled;
use super::tile_batch::{TileBatch, in_blocks};
use super::whitted::Tracer;
use crate::probe::{Probe, Silent};
use crate::scene::Settings;
use crate::world::World;

/// The edge of a tile in pixels: rays that are neighbours in the picture are neighbours in the scene.
pub const TILE: u32 = 16;

/// A tile of the picture: pixels x0..x1, y0..y1.
#[derive(Clone, Copy, Debug)]
pub struct Tile {
    /// First column, and the one behind the last.
    pub x: [u32; 2],
    /// First row, and the one behind the last.
    pub y: [u32; 2],
}

/// A rendered tile, or one that was left out.
pub struct Done<P> {
    /// The tile.
    pub tile: Tile,
    /// Its own pixels; none if it was left out.
    pub film: Film,
    /// What heard of them.
    pub probe: P,
}

impl Tile {
    /// The tile left out: its pixels stay black.
    pub fn blank<P: Default>(self) -> Done<P> {
        Done {
            tile: self,
            film: Film {
                cut: true,
                ..Film::default()
            },
            probe: P::default(),
        }
    }

    /// The tile's pixels: one after the other if somebody listens, else all together.
    pub fn render<P: Probe + Default>(self, world: &World, settings: &Settings) -> Done<P> {
        let mut probe = P::default();
        let mut film = Film::black(self.size(), settings);
        let mut tracer = Tracer::new(world, settings, &mut probe);
        if P::LISTENS && settings.pixel.asks_around() {
            let mut silent = Silent;
            let decided = self.begin(&mut Tracer::new(world, settings, &mut silent));
            for (at, count) in decided.iter().map(|p| (p.at(), p.target())) {
                film.put(self.index(at), at, &of_count(&mut tracer, at, count));
            }
        } else if P::LISTENS {
            for at in self.pixels() {
                film.put(self.index(at), at, &sampled(&mut tracer, at));
            }
        } else {
            let mut pixels = self.begin(&mut tracer);
            take(&mut tracer, &mut pixels);
            for sampled in &mut pixels {
                let at = sampled.at();
                film.put(self.index(at), at, sampled.finish(settings));
            }
        }
        Done {
            tile: self,
            film,
            probe,
        }
    }

    /// The tile's pixels without samples; where they decide for one another, with those that decide, and decided.
    fn begin<P: Probe>(self, tracer: &mut Tracer<P>) -> Vec<Sampled> {
        let (settings, budget) = (tracer.settings, tracer.budget);
        let pixels = in_blocks(self).into_iter();
        let mut pixels: Vec<_> = pixels
            .map(|at| Sampled::new(settings, budget, at))
            .collect();
        if settings.pixel.asks_around() {
            take(tracer, &mut pixels);
            around::decide(settings, &mut pixels);
        }
        pixels
    }

    /// The place of a pixel among the tile's, row after row.
    fn index(self, (x, y): (u32, u32)) -> usize {
        ((y - self.y[0]) * self.size().0 + (x - self.x[0])) as usize
    }

    /// How many columns and rows it has.
    pub fn size(self) -> (u32, u32) {
        (self.x[1] - self.x[0], self.y[1] - self.y[0])
    }

    /// Its pixels, row after row.
    fn pixels(self) -> impl Iterator<Item = (u32, u32)> {
        let [first, end] = self.x;
        (self.y[0]..self.y[1]).flat_map(move |y| (first..end).map(move |x| (x, y)))
    }
}

/// Takes the samples that some pixels need, which have equally many so far: what they ask is answered together, sample
/// after sample, if that is quicker.
fn take<P: Probe>(tracer: &mut Tracer<P>, pixels: &mut [Sampled]) {
    let (world, settings) = (tracer.world, tracer.settings);
    if !world.accel.gains_from_bundles() {
        return pixels.iter_mut().for_each(|pixel| pixel.follow(tracer));
    }
    let mut batch = TileBatch::default();
    for sample in pixels.first().map_or(0, Sampled::samples).. {
        let open = pixels.iter_mut();
        let places = open.filter_map(|p| p.is_open(settings).then(|| p.at()));
        if !batch.trace(world, settings, places, sample) {
            break;
        }
        let open = pixels.iter_mut();
        let open = open.filter_map(|p| p.is_open(settings).then_some(p));
        for (sampled, (place, ray, prefetched)) in open.zip(batch.pixels()) {
            sampled.add(tracer, (place, ray), Some(prefetched));
        }
    }
}

/// The picture cut into tiles, row after row.
pub fn tiles(settings: &Settings) -> Vec<Tile> {
    let starts = |end: u32| (0..end).step_by(TILE as usize);
    let range = |start: u32, end: u32| [start, (start + TILE).min(end)];
    starts(settings.image.height)
        .flat_map(|y| {
            starts(settings.image.width).map(move |x| Tile {
                x: range(x, settings.image.width),
                y: range(y, settings.image.height),
            })
        })
        .collect()
}
