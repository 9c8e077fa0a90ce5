//! The samples of a pixel: where each lies on the film, who asks for it, and how much it counts.

use super::path_id::PathId;
use crate::math::Sampler;
use crate::math::points::Run;
use crate::math::sampler::{Dimension, film_run};
use crate::scene::Settings;

/// Where the paths of a pilot's samples start to be numbered: far from those that count, so that they share no random
/// number with them.
const PILOT_PATH: u64 = 1 << 63;

/// A sample before its ray is sent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// On the film, in pixels from the top left corner.
    pub film: [f64; 2],
    /// 1, or -1 where the filter is below 0.
    pub sign: f64,
    /// Who asks.
    pub asker: PathId,
}

/// Sample number `index` of a pixel.
pub fn place(settings: &Settings, pixel: (u32, u32), index: u32) -> Place {
    let pilot = settings.pixel.pilot();
    let (dimension, index, path) = if index < pilot {
        (Dimension::Pilot, index, PILOT_PATH)
    } else {
        (Dimension::Film, index - pilot, 0)
    };
    let [u, v] = point(settings, pixel, dimension, index);
    let (filter, radius) = (settings.pixel.filter, settings.pixel.filter_radius);
    let (x, y) = (filter.place(u), filter.place(v));
    let sign = if filter.has_negative_lobes() {
        filter.value(x).signum() * filter.value(y).signum()
    } else {
        1.0
    };
    Place {
        film: [
            f64::from(pixel.0) + 0.5 + radius * x,
            f64::from(pixel.1) + 0.5 + radius * y,
        ],
        sign,
        asker: PathId {
            path,
            ..PathId::eye(pixel, index)
        },
    }
}

/// A point in [0, 1)^2. Sobol's sequence goes on from set to set; of the others each set has points of its own.
fn point(settings: &Settings, pixel: (u32, u32), dimension: Dimension, index: u32) -> [f64; 2] {
    let count = settings.pixel.set_size();
    let (set, index) = match settings.pixel.sampler {
        Sampler::Sobol => (0, index),
        _ => (index / count, index % count),
    };
    let key = match settings.pixel.sampler {
        // No chance in it.
        Sampler::Grid => 0,
        _ => film_run(settings.seed, pixel, dimension, set),
    };
    let run = Run { key, count };
    settings.pixel.sampler.point(run, index)
}

/// How much each sample of a pixel counts in its sum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weights {
    /// The first samples that do not count.
    pilot: u32,
    /// The weight of a sample, but for its sign.
    scale: f64,
    /// Whether signs count.
    signed: bool,
}

impl Weights {
    /// Those of a pixel with `count` samples in all. They add up to 1: where the filter is below 0 for some, the scale
    /// is one over the sum of all signs. Should more than half of them be negative, which only happens to very few
    /// samples, the signs are left out.
    #[inline]
    pub fn new(settings: &Settings, pixel: (u32, u32), count: u32) -> Self {
        let pilot = settings.pixel.pilot();
        let all = f64::from(count.saturating_sub(pilot).max(1));
        let signs: f64 = if settings.pixel.filter.has_negative_lobes() {
            (pilot..count)
                .map(|index| place(settings, pixel, index).sign)
                .sum()
        } else {
            all
        };
        let signed = signs > 0.0;
        let scale = 1.0 / if signed { signs } else { all };
        Self {
            pilot,
            scale,
            signed,
        }
    }

    /// That of sample number `index`.
    pub fn of(self, index: u32, sign: f64) -> f64 {
        if index < self.pilot {
            0.0
        } else if self.signed {
            sign * self.scale
        } else {
            self.scale
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Filter;

    fn at(settings: &Settings) -> Vec<[f64; 2]> {
        (0..settings.pixel.samples)
            .map(|i| place(settings, (10, 20), i).film)
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
        assert_eq!(at(&settings), regular);
        for sampling in [Sampler::Stratified, Sampler::Sobol] {
            settings.pixel.sampler = sampling;
            let places = at(&settings);
            for middle in regular {
                let near = |p: &&[f64; 2]| {
                    (p[0] - middle[0]).abs() <= 0.25 && (p[1] - middle[1]).abs() <= 0.25
                };
                assert_eq!(places.iter().filter(near).count(), 1, "{sampling:?}");
            }
        }
    }

    #[test]
    fn sets_of_jittered_samples_have_points_of_their_own_and_sobol_goes_on() {
        let one = Settings::default().with(|s| {
            s.pixel.samples = 8;
            s.pixel.sampler = Sampler::Stratified;
        });
        let two = one.with(|s| {
            s.pixel.samples = 16;
            s.pixel.sets = 2;
        });
        let (first, both) = (at(&one), at(&two));
        assert_eq!(first, both[..8]);
        assert!(first.iter().all(|place| !both[8..].contains(place)));
        let sobol = |settings: Settings| settings.with(|s| s.pixel.sampler = Sampler::Sobol);
        let whole = two.with(|s| s.pixel.sets = 1);
        assert_eq!(at(&sobol(whole)), at(&sobol(two)));
    }

    #[test]
    fn weights_add_up_to_one_and_places_stay_within_the_radius() {
        for filter in Filter::ALL {
            for sampling in Sampler::ALL {
                for samples in [1, 2, 3, 7, 64] {
                    let settings = Settings::default().with(|s| {
                        s.pixel.samples = samples;
                        s.pixel.sampler = sampling;
                        s.pixel.filter = filter;
                        s.pixel.filter_radius = 0.75;
                    });
                    for x in 0..50 {
                        let weights = Weights::new(&settings, (x, 3), samples);
                        let sum: f64 = (0..samples)
                            .map(|i| {
                                let place = place(&settings, (x, 3), i);
                                let off = place.film[0] - f64::from(x) - 0.5;
                                assert!(off.abs() <= 0.75);
                                weights.of(i, place.sign)
                            })
                            .sum();
                        assert!(
                            (sum - 1.0).abs() < 1e-12,
                            "{filter:?} {sampling:?} {samples}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn a_pilot_shares_no_place_with_the_samples_that_count() {
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
        let films: Vec<[f64; 2]> = (0..16).map(|i| place(&settings, (1, 2), i).film).collect();
        assert!(films[..8].iter().all(|place| !films[8..].contains(place)));
        let weights = Weights::new(&settings, (1, 2), 16);
        assert_eq!((weights.of(7, 1.0), weights.of(8, 1.0)), (0.0, 0.125));
    }
}
