//! The rendering of one tile, by one of three strategies.

use super::buffer::Film;
use crate::probe::{Probe, Silent, counting};
use crate::scene::Settings;
use crate::tracer::pixel::{CameraSamples, PixelEstimator, pixel};
use crate::tracer::state::Tracer;
use crate::tracer::tile::Tile;
use crate::tracer::tile_batch::TileBatch;
use crate::world::World;

/// A tile that was rendered, or left out.
pub struct RenderedTile<P> {
    /// The tile.
    pub tile: Tile,
    /// Its own pixels; none if it was left out.
    pub film: Film,
    /// The probe of its rays.
    pub probe: P,
}

impl<P: Probe + Default> RenderedTile<P> {
    /// A tile that is left out: its pixels stay black.
    pub fn blank(tile: Tile) -> Self {
        Self {
            tile,
            film: Film {
                truncated: true,
                ..Film::default()
            },
            probe: P::default(),
        }
    }

    /// Renders a tile: its pixels together if the probe is silent, else one after the other, so that it hears of a pixel's
    /// rays in their order. (A function of its own in every program, so that its instructions can be counted.)
    #[inline(never)]
    pub fn render(tile: Tile, world: &World, settings: &Settings) -> Self {
        let mut probe = P::default();
        let mut film = Film::black(tile.size(), settings);
        if counting::BENDS && !settings.bends.is_empty() {
            bent(tile, (world, settings), &mut film, &mut probe);
            return Self { tile, film, probe };
        }
        let mut tracer = Tracer::new(world, settings, &mut probe);
        if !P::LISTENS {
            together(&mut tracer, tile, &mut film);
        } else if settings.pixel.asks_around() {
            one_by_one_after_pilot(&mut tracer, tile, &mut film);
        } else {
            one_by_one(&mut tracer, tile, &mut film);
        }
        Self { tile, film, probe }
    }
}

/// Pixel after pixel where a law is bent. (Never inlined, so that right pictures pay nothing.)
#[inline(never)]
fn bent<P: Probe>(
    tile: Tile,
    (world, settings): (&World, &Settings),
    film: &mut Film,
    probe: &mut P,
) {
    for at in tile.pixels() {
        let pixel = pixel(world, settings, at, probe);
        film.put(tile.index(at), at, &pixel);
    }
}

/// All pixels together, sample after sample.
fn together<P: Probe>(tracer: &mut Tracer<P>, tile: Tile, film: &mut Film) {
    let settings = tracer.settings;
    let mut pixels = begin(tracer, tile);
    run_all(tracer, &mut pixels);
    for estimator in &mut pixels {
        let at = estimator.at();
        film.put(tile.index(at), at, estimator.finish(settings));
    }
}

/// Pixel after pixel, each by itself.
fn one_by_one<P: Probe>(tracer: &mut Tracer<P>, tile: Tile, film: &mut Film) {
    for at in tile.pixels() {
        let pixel = PixelEstimator::trace(tracer, at);
        film.put(tile.index(at), at, &pixel);
    }
}

/// Pixel after pixel, after a silent pilot of all of them has decided how many samples each has.
fn one_by_one_after_pilot<P: Probe>(tracer: &mut Tracer<P>, tile: Tile, film: &mut Film) {
    let mut silent = Silent;
    let mut pilot = Tracer::new(tracer.world, tracer.settings, &mut silent);
    for decided in begin(&mut pilot, tile) {
        let at = decided.at();
        let pixel = PixelEstimator::trace_samples(tracer, at, decided.target());
        film.put(tile.index(at), at, &pixel);
    }
}

/// The tile's pixels without samples; where they decide for one another, with those that decide, and decided.
fn begin<P: Probe>(tracer: &mut Tracer<P>, tile: Tile) -> Vec<PixelEstimator> {
    let (settings, budget) = (tracer.settings, tracer.budget);
    let mut pixels: Vec<_> = tile
        .pixels_in_blocks()
        .into_iter()
        .map(|at| PixelEstimator::new(settings, budget, at))
        .collect();
    if settings.pixel.asks_around() {
        run_all(tracer, &mut pixels);
        PixelEstimator::settle_tile(settings, tile, &mut pixels);
    }
    pixels
}

/// Takes the samples that some pixels need, which have equally many so far, sample after sample: their rays are traced together
/// if that is quicker.
fn run_all<P: Probe>(tracer: &mut Tracer<P>, pixels: &mut [PixelEstimator]) {
    let first = pixels.first().map_or(0, PixelEstimator::samples);
    if tracer.world.accel.gains_from_packets() {
        run_together(tracer, pixels, first);
    } else {
        run_each(tracer, pixels, first);
    }
}

/// Takes the samples from number `first` on, one pixel's ray after the other.
fn run_each<P: Probe>(tracer: &mut Tracer<P>, pixels: &mut [PixelEstimator], first: u32) {
    let (settings, camera) = (tracer.settings, &tracer.world.scene.camera);
    let mut open: Vec<&mut PixelEstimator> = pixels.iter_mut().collect();
    for index in first.. {
        open.retain_mut(|pixel| pixel.is_open(settings));
        if open.is_empty() {
            break;
        }
        let samples = CameraSamples::new(settings, index);
        for pixel in &mut open {
            let sample = samples.of(pixel.at());
            let ray = camera.ray(sample.film, settings.size());
            pixel.add(tracer, (&sample, ray), None);
        }
    }
}

/// Takes the samples from number `first` on, the rays of all pixels in packets.
fn run_together<P: Probe>(tracer: &mut Tracer<P>, pixels: &mut [PixelEstimator], first: u32) {
    let (world, settings) = (tracer.world, tracer.settings);
    let mut batch = TileBatch::default();
    for index in first.. {
        let open = pixels.iter_mut();
        let open = open.filter_map(|p| p.is_open(settings).then(|| p.at()));
        if !batch.trace(world, settings, open, index) {
            break;
        }
        let open = pixels.iter_mut();
        let open = open.filter_map(|p| p.is_open(settings).then_some(p));
        for (estimator, (sample, ray, prefetched)) in open.zip(batch.pixels()) {
            estimator.add(tracer, (sample, ray), Some(prefetched));
        }
    }
}
