//! Camera samples: where each sample of a pixel lies on the film, and the path that it begins.

use crate::sampling::stream::{self, Dimension};
use crate::sampling::{SampleSet, Sampler};
use crate::scene::Settings;
use crate::tracer::path_id::PathId;

/// The path number of a pilot sample's camera ray: far from those of samples that count, so that they share no random
/// number.
const PILOT_PATH: u64 = 1 << 63;

/// A sample of a pixel before its camera ray is traced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraSample {
    /// The position on the film, in pixels from the top left corner.
    pub film: [f64; 2],
    /// The sign of the filter there: 1, or -1 where it is below 0.
    pub sign: f64,
    /// The camera ray's path, for the points on area lights.
    pub path: PathId,
}

/// Sample number `index` of a pixel.
pub fn camera_sample(settings: &Settings, pixel: (u32, u32), index: u32) -> CameraSample {
    PlaceInPixel::new(settings, pixel, index).of(pixel)
}

/// Samples of one number, one in each pixel that is asked for. A grid is the same in all pixels: its place is computed once.
pub struct CameraSamples<'a> {
    settings: &'a Settings,
    index: u32,
    shared: Option<PlaceInPixel>,
}

impl<'a> CameraSamples<'a> {
    /// The samples number `index`.
    pub fn new(settings: &'a Settings, index: u32) -> Self {
        let is_grid = settings.pixel.sampler == Sampler::Grid;
        Self {
            settings,
            index,
            shared: is_grid.then(|| PlaceInPixel::new(settings, (0, 0), index)),
        }
    }

    /// The sample of a pixel.
    #[inline]
    pub fn of(&self, pixel: (u32, u32)) -> CameraSample {
        let place = self.shared;
        let place = place.unwrap_or_else(|| PlaceInPixel::new(self.settings, pixel, self.index));
        place.of(pixel)
    }
}

/// Place of a sample in its pixel.
#[derive(Clone, Copy)]
struct PlaceInPixel {
    /// From the pixel's middle, in pixels.
    offset: [f64; 2],
    sign: f64,
    path: u64,
    index: u32,
}

impl PlaceInPixel {
    fn new(settings: &Settings, pixel: (u32, u32), index: u32) -> Self {
        let pilot = settings.pixel.pilot();
        let (dimension, index, path) = if index < pilot {
            (Dimension::Pilot, index, PILOT_PATH)
        } else {
            (Dimension::Film, index - pilot, 0)
        };
        let [u, v] = point(settings, pixel, dimension, index);
        let (filter, radius) = (settings.pixel.filter, settings.pixel.filter_radius);
        let (x, y) = (filter.sample(u), filter.sample(v));
        let sign = if filter.has_negative_lobes() {
            filter.value(x).signum() * filter.value(y).signum()
        } else {
            1.0
        };
        Self {
            offset: [radius * x, radius * y],
            sign,
            path,
            index,
        }
    }

    #[inline(always)]
    fn of(self, pixel: (u32, u32)) -> CameraSample {
        let [x, y] = self.offset;
        CameraSample {
            film: [f64::from(pixel.0) + 0.5 + x, f64::from(pixel.1) + 0.5 + y],
            sign: self.sign,
            path: PathId {
                path: self.path,
                ..PathId::eye(pixel, self.index)
            },
        }
    }
}

/// The point in [0, 1)^2 of a sample. Each set has points of its own, independent of all others. Where there is one set and a
/// pixel needs more samples than it has, Sobol's sequence goes on; of the others a further set begins.
fn point(settings: &Settings, pixel: (u32, u32), dimension: Dimension, index: u32) -> [f64; 2] {
    let count = settings.pixel.set_size();
    let (set, index) = match settings.pixel.sampler {
        Sampler::Sobol => settings.pixel.set_of(index),
        _ => (index / count, index % count),
    };
    let key = match settings.pixel.sampler {
        // No chance in it.
        Sampler::Grid => 0,
        _ => stream::film_key(settings.seed, pixel, dimension, set),
    };
    let set = SampleSet { key, count };
    settings.pixel.sampler.point(set, index)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn films(settings: &Settings) -> Vec<[f64; 2]> {
        (0..settings.pixel.samples)
            .map(|i| camera_sample(settings, (10, 20), i).film)
            .collect()
    }

    #[test]
    fn samples_fill_their_pixel_evenly() {
        let mut settings = Settings::default().with(|s| s.pixel.samples = 4);
        let regular = [
            [10.25, 20.25],
            [10.75, 20.25],
            [10.25, 20.75],
            [10.75, 20.75],
        ];
        assert_eq!(films(&settings), regular);
        for sampler in [Sampler::Stratified, Sampler::Sobol] {
            settings.pixel.sampler = sampler;
            let films = films(&settings);
            for middle in regular {
                let near = |p: &&[f64; 2]| {
                    (p[0] - middle[0]).abs() <= 0.25 && (p[1] - middle[1]).abs() <= 0.25
                };
                assert_eq!(films.iter().filter(near).count(), 1, "{sampler:?}");
            }
        }
    }

    #[test]
    fn each_set_has_points_of_its_own() {
        for sampler in [Sampler::Random, Sampler::Stratified, Sampler::Sobol] {
            let one = Settings::default().with(|s| {
                s.pixel.samples = 8;
                s.pixel.sampler = sampler;
            });
            let two = one.with(|s| {
                s.pixel.samples = 16;
                s.pixel.sets = 2;
            });
            let (first, both) = (films(&one), films(&two));
            assert_eq!(first, both[..8], "{sampler:?}");
            assert!(
                first.iter().all(|film| !both[8..].contains(film)),
                "{sampler:?}"
            );
            let whole = films(&two.with(|s| s.pixel.sets = 1));
            assert_ne!(whole, both, "{sampler:?}");
        }
    }

    #[test]
    fn a_pilot_shares_no_point_with_the_samples_that_count() {
        use crate::scene::{Adaptive, Pilot};
        let settings = Settings::default().with(|s| {
            s.pixel.samples = 8;
            s.pixel.sampler = Sampler::Random;
            s.pixel.adaptive = Some(Adaptive {
                threshold: 0.1,
                most: 64,
                pilot: Pilot::Apart,
            });
        });
        let film = |i| camera_sample(&settings, (1, 2), i).film;
        let films: Vec<[f64; 2]> = (0..16).map(film).collect();
        assert!(films[..8].iter().all(|film| !films[8..].contains(film)));
    }
}
