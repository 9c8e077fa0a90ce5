//! The rendering of one tile, by one of three strategies.

use super::buffer::Film;
use crate::probe::{Probe, Silent, counting};
use crate::scene::Settings;
use crate::tracer::pixel::{CameraSamples, PixelEstimator, pixel};
use crate::tracer::state::Tracer;
use crate::tracer::tile::Tile;
use crate::tracer::tile_batch::TileBatch;
use crate::world::World;

/// Memory that is used again for one tile after another.
#[derive(Default)]
pub struct TileMemory {
    pixels: Vec<PixelEstimator>,
    batch: TileBatch,
}

/// A tile that was rendered, or left out.
pub struct RenderedTile<P> {
    /// Its own pixels; none if it was left out.
    pub film: Film,
    /// The probe of its rays.
    pub probe: P,
}

impl<P: Probe + Default> RenderedTile<P> {
    /// A tile that is left out: its pixels stay black.
    pub fn blank() -> Self {
        Self {
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
    pub fn render(tile: Tile, world: &World, settings: &Settings, memory: &mut TileMemory) -> Self {
        let mut probe = P::default();
        let mut film = Film::black(tile.size(), settings);
        if counting::BENDS && !settings.bends.is_empty() {
            bent(tile, (world, settings), &mut film, &mut probe);
            return Self { film, probe };
        }
        let mut tracer = Tracer::new(world, settings, &mut probe);
        if !P::LISTENS {
            together(&mut tracer, tile, &mut film, memory);
        } else if settings.pixel.asks_around() {
            one_by_one_after_pilot(&mut tracer, tile, &mut film, memory);
        } else {
            one_by_one(&mut tracer, tile, &mut film);
        }
        Self { film, probe }
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
fn together<P: Probe>(
    tracer: &mut Tracer<P>,
    tile: Tile,
    film: &mut Film,
    memory: &mut TileMemory,
) {
    let settings = tracer.settings;
    begin(tracer, tile, memory);
    run_all(tracer, memory);
    for estimator in &mut memory.pixels {
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
fn one_by_one_after_pilot<P: Probe>(
    tracer: &mut Tracer<P>,
    tile: Tile,
    film: &mut Film,
    memory: &mut TileMemory,
) {
    let mut silent = Silent;
    let mut pilot = Tracer::new(tracer.world, tracer.settings, &mut silent);
    begin(&mut pilot, tile, memory);
    for decided in &memory.pixels {
        let at = decided.at();
        let pixel = PixelEstimator::trace_samples(tracer, at, decided.target());
        film.put(tile.index(at), at, &pixel);
    }
}

/// The tile's pixels without samples; where they decide for one another, with those that decide, and decided.
fn begin<P: Probe>(tracer: &mut Tracer<P>, tile: Tile, memory: &mut TileMemory) {
    let (settings, budget) = (tracer.settings, tracer.budget);
    memory.pixels.clear();
    let new = |at| PixelEstimator::new(settings, budget, at);
    memory
        .pixels
        .extend(tile.pixels_in_blocks().into_iter().map(new));
    if settings.pixel.asks_around() {
        run_all(tracer, memory);
        PixelEstimator::settle_tile(settings, tile, &mut memory.pixels);
    }
}

/// Takes the samples that some pixels need, which have equally many so far, sample after sample: their rays are traced in packets
/// if that is quicker.
fn run_all<P: Probe>(tracer: &mut Tracer<P>, memory: &mut TileMemory) {
    let (world, settings) = (tracer.world, tracer.settings);
    let TileMemory { pixels, batch } = memory;
    let first = pixels.first().map_or(0, PixelEstimator::samples);
    let mut open: Vec<&mut PixelEstimator> = pixels.iter_mut().collect();
    for index in first.. {
        open.retain_mut(|pixel| pixel.is_open(settings));
        if open.is_empty() {
            break;
        }
        let samples = CameraSamples::new(settings, index);
        if world.accel.gains_from_packets() {
            batch.trace(
                world,
                settings,
                &samples,
                open.iter().map(|pixel| pixel.at()),
            );
            for (pixel, (sample, ray, prefetched)) in open.iter_mut().zip(batch.pixels()) {
                pixel.add(tracer, (sample, ray), Some(prefetched));
            }
            continue;
        }
        for pixel in &mut open {
            let sample = samples.of(pixel.at());
            let ray = world.scene.camera.ray(sample.film, settings.size());
            pixel.add(tracer, (&sample, ray), None);
        }
    }
}
