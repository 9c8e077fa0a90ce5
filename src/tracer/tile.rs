//! A tile of the picture: pixels that are rendered together.

use super::film::Film;
use super::foresight::{Foresight, in_blocks};
use super::pixel::sampled;
use super::sampled::Sampled;
use super::whitted::Tracer;
use crate::probe::Probe;
use crate::scene::{Settings, World};

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

    /// The tile's pixels, row after row: asked for in bundles if that is quicker and nobody listens, else one
    /// by one.
    pub fn render<P: Probe + Default>(self, world: &World, settings: &Settings) -> Done<P> {
        let mut probe = P::default();
        let mut film = Film::black(self.size(), settings);
        let mut tracer = Tracer::new(world, settings, &mut probe);
        if P::LISTENS || !world.accel.gains_from_bundles() {
            for (index, at) in self.pixels().enumerate() {
                film.put(index, at, &sampled(&mut tracer, at));
            }
        } else {
            self.render_in_bundles(&mut tracer, &mut film);
        }
        Done {
            tile: self,
            film,
            probe,
        }
    }

    /// The same with what the pixels ask answered together, sample after sample.
    fn render_in_bundles<P: Probe>(self, tracer: &mut Tracer<P>, film: &mut Film) {
        let (world, settings, budget) = (tracer.world, tracer.settings, tracer.budget);
        let mut pixels: Vec<_> = in_blocks(self)
            .into_iter()
            .map(|at| Sampled::new(settings, budget, at))
            .collect();
        let mut foresight = Foresight::default();
        for sample in 0.. {
            let open = pixels.iter_mut();
            let places = open.filter_map(|p| p.is_open(settings).then(|| p.at()));
            if !foresight.ask(world, settings, places, sample) {
                break;
            }
            let open = pixels.iter_mut();
            let open = open.filter_map(|p| p.is_open(settings).then_some(p));
            for (sampled, (place, ray, foreseen)) in open.zip(foresight.samples()) {
                sampled.add(tracer, (place, ray), Some(foreseen));
            }
        }
        let (columns, _) = self.size();
        for sampled in &mut pixels {
            let (x, y) = sampled.at();
            let index = (y - self.y[0]) * columns + (x - self.x[0]);
            film.put(index as usize, (x, y), sampled.finish(settings));
        }
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

/// The picture cut into tiles, row after row.
pub fn tiles(settings: &Settings) -> Vec<Tile> {
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
