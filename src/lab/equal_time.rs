//! Crops side by side: what each way of turning a knob makes of the same time.

use std::time::Instant;

use super::contact_sheet::contact_sheet;
use super::cost::Lab;
use super::error::{Reference, errors};
use super::measured::Sweep;
use super::parameter::{LIGHT_SAMPLES, Parameter};
use crate::probe::Silent;
use crate::scene::Settings;
use crate::tracer::Film;

/// The edge of a crop in pixels, at most.
const EDGE: u32 = 32;

/// How many times larger they are shown.
const ZOOM: u32 = 4;

/// A way of turning a knob, with as much of it as the time allows.
#[derive(Clone, Debug)]
pub struct Tile {
    /// The way, and how far it is turned.
    pub name: String,
    /// The whole settings.
    pub settings: Settings,
    /// Seconds that the whole picture took.
    pub seconds: f64,
    /// The error of the whole picture.
    pub rmse: f64,
    film: Film,
}

/// The ways of a group of knobs.
#[derive(Clone, Debug)]
pub struct EqualTime {
    /// What is turned.
    pub group: &'static str,
    /// Seconds for each picture, as far as they could be foretold.
    pub seconds: f64,
    /// The part of the pictures that is shown, where they err most: column, row, width, height.
    pub crop: [u32; 4],
    /// Each way, in order; the reference stands behind them.
    pub tiles: Vec<Tile>,
    reference: Film,
}

impl Lab {
    /// The ways of one group that were measured, each with the time that the dearest position of the cheapest way takes.
    /// Those for which there is no time before `end` are left out. `None` if nothing can be compared.
    pub fn equal_time(
        &self,
        sweeps: &[Sweep],
        reference: &Reference,
        end: Instant,
    ) -> Option<EqualTime> {
        let variants = || sweeps.iter().filter(|s| s.parameter.variant.is_some());
        let dearest = |s: &Sweep| s.steps.iter().map(|m| m.seconds).fold(0.0, f64::max);
        let seconds = variants()
            .map(dearest)
            .filter(|s| *s > 0.0)
            .fold(f64::INFINITY, f64::min);
        let mut tiles = Vec::new();
        for sweep in variants() {
            let Some((position, settings)) = affordable(sweep, seconds) else {
                continue;
            };
            let start = Instant::now();
            let Some((film, _)) = self.film::<Silent>(&settings, end) else {
                break;
            };
            tiles.push(Tile {
                name: format!("{} {position}", sweep.parameter.variant.unwrap_or_default()),
                seconds: start.elapsed().as_secs_f64(),
                rmse: errors(&film, reference, settings.image.exposure)?.rmse,
                settings,
                film,
            });
        }
        (!tiles.is_empty()).then(|| EqualTime {
            group: sweeps[0].parameter.group,
            seconds,
            crop: worst(&tiles, reference.film()),
            tiles,
            reference: reference.film().clone(),
        })
    }
}

/// How far a way can be turned in so many seconds, by its dearest position that was measured; of positions that are not
/// samples, the one whose time is nearest.
fn affordable(sweep: &Sweep, seconds: f64) -> Option<(String, Settings)> {
    let Sweep {
        parameter, steps, ..
    } = sweep;
    let last = steps.last()?;
    if let Some(samples) = last.samples {
        let afforded = f64::from(samples) * seconds / last.seconds.max(1e-9);
        let samples = squarish((afforded.round() as u32).clamp(1, 4 * samples));
        return Some((samples.to_string(), parameter.with_samples(samples)?));
    }
    let off = |s: f64| libm::log(s / seconds).abs();
    let measured = steps.iter().zip(&parameter.steps);
    let nearest = measured.min_by(|a, b| off(a.0.seconds).total_cmp(&off(b.0.seconds)));
    nearest.map(|(measured, step)| (measured.step.clone(), step.settings))
}

/// The largest number up to `n` whose grid of cells is a square, or longer than wide by one: 59 cells are a single row of them.
fn squarish(n: u32) -> u32 {
    let edge = n.isqrt();
    if edge * (edge + 1) <= n {
        edge * (edge + 1)
    } else {
        edge * edge
    }
}

/// The part of a picture in which all together err most.
fn worst(tiles: &[Tile], reference: &Film) -> [u32; 4] {
    let (width, height) = (reference.width, reference.height);
    let (w, h) = (width.min(EDGE), height.min(EDGE));
    let starts = |end: u32, edge: u32| {
        let last = end - edge;
        (0..=last).step_by(EDGE as usize / 4).chain([last])
    };
    let error = |&(x, y): &(u32, u32)| {
        let places = (y..y + h).flat_map(|y| (x..x + w).map(move |x| (x, y)));
        places
            .flat_map(|(x, y)| {
                tiles
                    .iter()
                    .map(move |t| (t.film.at(x, y), reference.at(x, y)))
            })
            .flat_map(|(a, b)| a.channels().into_iter().zip(b.channels()))
            .map(|(a, b)| (a - b) * (a - b))
            .sum::<f64>()
    };
    let all = starts(height, h).flat_map(|y| starts(width, w).map(move |x| (x, y)));
    let found = all.max_by(|a, b| error(a).total_cmp(&error(b)));
    let (x, y) = found.unwrap_or_default();
    [x, y, w, h]
}

/// All strips below each other, on grey: in each the ways from left to right, then the reference.
pub fn picture(comparisons: &[EqualTime]) -> Film {
    let crops = |equal_time: &EqualTime| {
        let films = equal_time.tiles.iter().map(|t| &t.film);
        let all = films.chain([&equal_time.reference]);
        all.map(|film| crop(film, equal_time.crop)).collect()
    };
    let rows: Vec<Vec<Film>> = comparisons.iter().map(crops).collect();
    contact_sheet(&rows, ZOOM)
}

/// A part of a film.
fn crop(film: &Film, [x0, y0, width, height]: [u32; 4]) -> Film {
    let rows = y0..y0 + height;
    let pixels = rows.flat_map(|y| (x0..x0 + width).map(move |x| film.at(x, y)));
    Film {
        width,
        height,
        pixels: pixels.collect(),
        ..Film::default()
    }
}

impl Parameter {
    /// So many samples this way, if it is about samples.
    fn with_samples(&self, samples: u32) -> Option<Settings> {
        let any = self.steps.last()?;
        let mut settings = any.settings;
        if self.group == LIGHT_SAMPLES {
            settings.light.samples = samples;
        } else {
            settings.pixel.samples = samples;
        }
        any.samples.map(|_| settings)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_nearly_square() {
        let shown = [1, 2, 3, 5, 6, 8, 9, 59, 64, 4096].map(squarish);
        assert_eq!(shown, [1, 2, 2, 4, 6, 6, 9, 56, 64, 4096]);
    }
}
