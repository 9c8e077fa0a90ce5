//! The weights of a pixel's samples in its colour.

use super::camera_sample::camera_sample;
use crate::scene::Settings;

/// The weights of a pixel's samples; they add up to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weights {
    /// The number of pilot samples at the beginning, whose weight is 0.
    pilot: u32,
    /// The absolute weight of the other samples.
    scale: f64,
    /// Whether the filter's signs count.
    signed: bool,
}

impl Weights {
    /// The weights in a pixel with `count` samples in all. Where the filter is below 0 for some, the scale is one over
    /// the sum of all signs, so that they add up to 1. Should more than half of them be negative, which only happens to very few
    /// samples, the signs are left out.
    #[inline]
    pub fn new(settings: &Settings, pixel: (u32, u32), count: u32) -> Self {
        let pilot = settings.pixel.pilot();
        let all = f64::from(count.saturating_sub(pilot).max(1));
        let signs: f64 = if settings.pixel.filter.has_negative_lobes() {
            (pilot..count)
                .map(|index| camera_sample(settings, pixel, index).sign)
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

    /// The weight of sample number `index`, for which the filter has this sign.
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
    use crate::sampling::{Filter, Sampler};
    use crate::scene::{Adaptive, Pilot};

    #[test]
    fn weights_add_up_to_one_and_samples_stay_within_the_radius() {
        for filter in Filter::ALL {
            for sampler in Sampler::ALL {
                for samples in [1, 2, 3, 7, 64] {
                    let settings = Settings::default().with(|s| {
                        s.pixel.samples = samples;
                        s.pixel.sampler = sampler;
                        s.pixel.filter = filter;
                        s.pixel.filter_radius = 0.75;
                    });
                    for x in 0..50 {
                        let weights = Weights::new(&settings, (x, 3), samples);
                        let sum: f64 = (0..samples)
                            .map(|i| {
                                let sample = camera_sample(&settings, (x, 3), i);
                                let off = sample.film[0] - f64::from(x) - 0.5;
                                assert!(off.abs() <= 0.75);
                                weights.of(i, sample.sign)
                            })
                            .sum();
                        assert!(
                            (sum - 1.0).abs() < 1e-12,
                            "{filter:?} {sampler:?} {samples}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn pilot_samples_weigh_nothing() {
        let settings = Settings::default().with(|s| {
            s.pixel.samples = 8;
            s.pixel.adaptive = Some(Adaptive {
                threshold: 0.1,
                most: 64,
                pilot: Pilot::Apart,
            });
        });
        let weights = Weights::new(&settings, (1, 2), 16);
        assert_eq!((weights.of(7, 1.0), weights.of(8, 1.0)), (0.0, 0.125));
    }
}
