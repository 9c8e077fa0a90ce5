//! How many samples a pixel has where the pixels around it decide.
//!
//! In a faint penumbra the few first samples of a pixel mostly agree, and it seems to be right. But a penumbra spans many
//! pixels, and all their first samples together see it. A pixel's own have no say, so how many there are to be does not
//! depend on what they bring: all of them count, and there is no bias (Kirk and Arvo 1991).
//!
//! Samples are in proportion to the standard deviation, which for independent samples brings the picture's mean square
//! error down with the fewest (Neyman 1934, "On the two different aspects of the representative method"). It is that of
//! halves: what evenly spread samples make up for among themselves is no noise.
//!
//! Pixels of another tile are not asked: so a tile needs no other, and no first sample is taken twice.

use super::sampled::Sampled;
use super::tile::TILE;
use super::whitted::Tracer;
use crate::probe::Silent;
use crate::scene::Settings;
use crate::world::World;

/// How far away the pixels are that are asked, along both axes: 24 of them inside a tile.
const NEAR: u32 = 2;

/// Decides for all pixels of a tile, which have their first samples.
pub fn decide(settings: &Settings, pixels: &mut [Sampled]) {
    let index = |(x, y): (u32, u32)| (y % TILE * TILE + x % TILE) as usize;
    let mut noises = [0.0; (TILE * TILE) as usize];
    for pixel in pixels.iter() {
        noises[index(pixel.at())] = pixel.noise(settings);
    }
    for pixel in pixels {
        let around = neighbours(settings, pixel.at());
        let count = count(settings, around.map(|at| noises[index(at)]));
        pixel.settle(settings, count);
    }
}

/// Decides for a pixel that is traced alone: those around it are sampled in silence.
pub fn of_one(world: &World, settings: &Settings, at: (u32, u32)) -> u32 {
    let mut silent = Silent;
    let mut tracer = Tracer::new(world, settings, &mut silent);
    let budget = tracer.budget;
    let noises = neighbours(settings, at).map(|at| {
        let mut pixel = Sampled::new(settings, budget, at);
        pixel.follow(&mut tracer);
        pixel.noise(settings)
    });
    count(settings, noises)
}

/// The pixels around a pixel that are in its tile, row after row.
fn neighbours(settings: &Settings, at: (u32, u32)) -> impl Iterator<Item = (u32, u32)> {
    let near = |place: u32, end: u32| {
        let tile = place - place % TILE;
        let first = place.saturating_sub(NEAR).max(tile);
        first..(place + NEAR + 1).min(tile + TILE).min(end)
    };
    let (columns, rows) = (
        near(at.0, settings.image.width),
        near(at.1, settings.image.height),
    );
    rows.flat_map(move |y| columns.clone().map(move |x| (x, y)))
        .filter(move |other| *other != at)
}

/// The number of samples of a pixel, from the variances of the means of its neighbours' first samples: one for each
/// threshold that the standard deviation of a sample is large, to the nearest doubling of the first ones, since evenly
/// spread points are best then. Without neighbours nothing is known: all that it may have.
fn count(settings: &Settings, noises: impl Iterator<Item = f64>) -> u32 {
    let (sum, neighbours) = noises.fold((0.0, 0.0), |(sum, n), noise| (sum + noise, n + 1.0));
    let variance = sum / neighbours * f64::from(settings.pixel.samples);
    let threshold = settings
        .pixel
        .adaptive
        .map_or(f64::INFINITY, |a| a.threshold);
    let wanted = variance.sqrt() / threshold;
    let is_enough = |count: u32| wanted < std::f64::consts::SQRT_2 * f64::from(count);
    let most = settings.samples_afforded();
    let mut count = settings.pixel.samples;
    while count < most && !is_enough(count) {
        count = count.saturating_mul(2);
    }
    count.min(most)
}
