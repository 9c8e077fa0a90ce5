//! Adaptive sampling: the rules for how many samples a pixel has, as functions of numbers alone.
//!
//! With [`Pilot::Kept`] and [`Pilot::Apart`] a pixel's own samples decide ([`further_samples`]). With [`Pilot::Around`]
//! the first samples of its neighbours do ([`samples_by_neighbours`]): in a faint penumbra the few first samples of a
//! pixel mostly agree, and it seems to be right; but a penumbra spans many pixels, and all their first samples together
//! see it. A pixel's own have no say, so how many there are to be does not depend on what they bring: all of them count,
//! and there is no bias (Kirk and Arvo 1991, "Unbiased sampling techniques for image synthesis").
//!
//! Samples are in proportion to the standard deviation, which for independent samples brings the picture's mean square
//! error down with the fewest (Neyman 1934, "On the two different aspects of the representative method"). It is that of
//! halves: what evenly spread samples make up for among themselves is no noise.

use super::estimate::Pixel;
use crate::scene::{Adaptive, Pilot, Settings};
use crate::tracer::tile::Tile;

/// The largest distance of a neighbour along both axes: 24 neighbours inside a tile.
const RADIUS: u32 = 2;

/// The number of samples that a pixel needs besides those that it has, whose standard error is `error`.
pub fn further_samples(settings: &Settings, adaptive: Adaptive, pixel: &Pixel, error: f64) -> u32 {
    match adaptive.pilot {
        // As many again, until the error is small enough.
        Pilot::Kept if error > adaptive.threshold && !pixel.truncated => pixel.samples,
        // The error falls as n^-1/2 if the samples are independent, and faster if they are not.
        Pilot::Apart if pixel.samples == settings.pixel.pilot() => {
            let times = (error / adaptive.threshold).powi(2).clamp(1.0, 1e6);
            let times = (times.ceil() as u32).next_power_of_two();
            pixel.samples.saturating_mul(times)
        }
        _ => 0,
    }
}

/// The neighbours of a pixel, row after row. They are in its tile, so that a tile needs no other, and no first sample is
/// taken twice.
pub fn neighbours(tile: Tile, at: (u32, u32)) -> impl Iterator<Item = (u32, u32)> {
    let near = |pixel: u32, [start, end]: [u32; 2]| {
        let first = pixel.saturating_sub(RADIUS).max(start);
        first..(pixel + RADIUS + 1).min(end)
    };
    let (columns, rows) = (near(at.0, tile.x), near(at.1, tile.y));
    rows.flat_map(move |y| columns.clone().map(move |x| (x, y)))
        .filter(move |other| *other != at)
}

/// The number of samples of a pixel, from the variances of the means of its neighbours' first samples: the standard
/// deviation of a sample in units of the threshold, to the nearest doubling of the first samples, since evenly spread
/// points are best then. Without neighbours nothing is known: all that the pixel may have.
pub fn samples_by_neighbours(settings: &Settings, variances: impl Iterator<Item = f64>) -> u32 {
    let (sum, neighbours) = variances.fold((0.0, 0.0), |(sum, n), one| (sum + one, n + 1.0));
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
