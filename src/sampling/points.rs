//! Points in the unit square: where on a light, or in a pixel, the samples lie.
//!
//! An integral is the mean of its integrand over such points. How fast the mean nears the integral depends on how
//! evenly they lie: for n points the error of [`Sampler::Random`] falls as n^-1/2 whatever the integrand; that of
//! [`Sampler::Stratified`] as n^-1 and of [`Sampler::Sobol`] as n^-3/2 where the integrand is smooth, both more slowly
//! across an edge (Mitchell 1996, "Consequences of stratified sampling in graphics"; Owen 1997, "Scrambled net variance
//! for integrals of smooth functions"). [`Sampler::Grid`] has no chance in it: its error is the same in every pixel and
//! shows as bands.

use super::sampler::Sampler;
use super::sobol::{self, Scramble};
use super::stratified::{in_cell, permuted};
use super::stream::{splitmix64, uniform2};

/// A set of points that complete each other: those of one pixel for one use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SampleSet {
    /// Its random stream: another key, other points (see [`super::stream`]).
    pub key: u64,
    /// The number of its points.
    pub count: u32,
}

/// The points of a sample set by their sampler, with what all of them share.
#[derive(Clone, Copy, Debug)]
pub enum Points {
    /// The middles of a grid's cells.
    Grid {
        /// The number of cells.
        count: u32,
    },
    /// Independent ones.
    Random {
        /// The key of the set.
        key: u64,
    },
    /// One in each cell of a grid.
    Stratified(SampleSet),
    /// A scrambled Sobol sequence, and after its end others.
    Sobol {
        /// The key of the set.
        key: u64,
        /// The scramble of the first sequence.
        scramble: Scramble,
    },
}

impl Sampler {
    /// Point number `index` of a sample set, in [0, 1)^2. (Inlined in every program, so that instructions can be counted.)
    #[inline(always)]
    pub fn point(self, set: SampleSet, index: u32) -> [f64; 2] {
        Points::new(self, set).at(index)
    }
}

impl Points {
    /// The points of a sample set.
    #[inline]
    pub fn new(sampler: Sampler, set: SampleSet) -> Self {
        match sampler {
            Sampler::Grid => Self::Grid { count: set.count },
            Sampler::Random => Self::Random { key: set.key },
            Sampler::Stratified => Self::Stratified(set),
            Sampler::Sobol => Self::Sobol {
                key: set.key,
                scramble: scramble(set.key, 0),
            },
        }
    }

    /// Point number `index`, in [0, 1)^2. (Always inlined: both callers, for the film and for lights, call it for every
    /// sample.)
    #[inline(always)]
    pub fn at(&self, index: u32) -> [f64; 2] {
        match *self {
            Self::Grid { count } => in_cell(index % count.max(1), count, [0.5, 0.5]),
            Self::Random { key } => uniform2(key, index),
            // The cells come in random order, so that any part of the set is spread over the whole square.
            Self::Stratified(SampleSet { key, count }) => {
                in_cell(permuted(index, count, key), count, uniform2(key, index))
            }
            Self::Sobol {
                key,
                scramble: first,
            } => match index / sobol::POINTS {
                0 => first.point(index),
                sequence => scramble(key, sequence).point(index % sobol::POINTS),
            },
        }
    }
}

/// The scramble of sequence number `sequence` of the set `key`.
#[inline]
fn scramble(key: u64, sequence: u32) -> Scramble {
    Scramble::new(splitmix64(key ^ u64::from(sequence)) as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_cell_of_a_stratified_set_has_one_point() {
        let set = SampleSet { key: 9, count: 64 };
        let mut cells = [0; 64];
        for index in 0..64 {
            let [x, y] = Sampler::Stratified.point(set, index);
            cells[(y * 8.0) as usize * 8 + (x * 8.0) as usize] += 1;
        }
        assert_eq!(cells, [1; 64]);
    }

    #[test]
    fn sobols_points_are_a_net() {
        // 64 points of a (0, 2)-sequence in base 2: one in each cell of 64x1, 32x2, 16x4, 8x8, ...
        let set = SampleSet { key: 3, count: 64 };
        for bits in 0..=6 {
            let (columns, rows) = (1 << bits, 64 >> bits);
            let mut cells = [0; 64];
            for index in 0..64 {
                let [x, y] = Sampler::Sobol.point(set, index);
                let (column, row) = (x * f64::from(columns), y * f64::from(rows));
                cells[row as usize * columns as usize + column as usize] += 1;
            }
            assert_eq!(cells, [1; 64], "{columns} x {rows}");
        }
    }

    #[test]
    fn after_the_end_of_a_sequence_another_begins() {
        let set = SampleSet {
            key: 3,
            count: 2 * sobol::POINTS,
        };
        let points = Points::new(Sampler::Sobol, set);
        let mut cells = [0; 16];
        for index in 0..16 {
            let [x, y] = points.at(sobol::POINTS + index);
            assert_ne!([x, y], points.at(index));
            cells[(y * 4.0) as usize * 4 + (x * 4.0) as usize] += 1;
        }
        assert_eq!(cells, [1; 16]);
    }

    #[test]
    fn all_points_lie_in_the_square_and_spread_evenly() {
        // Chi-square over 8 x 8 cells of 64,000 points in 1,000 sets of 64: 63 degrees of freedom, 99.99 % under 113.
        for sampler in Sampler::ALL {
            let mut cells = [0.0; 64];
            for key in 0..1000 {
                for index in 0..64 {
                    let set = SampleSet { key, count: 64 };
                    let [x, y] = sampler.point(set, index);
                    assert!((0.0..1.0).contains(&x) && (0.0..1.0).contains(&y));
                    cells[(y * 8.0) as usize * 8 + (x * 8.0) as usize] += 1.0;
                }
            }
            let chi: f64 = cells.iter().map(|n| (n - 1000.0f64).powi(2) / 1000.0).sum();
            assert!(chi < 113.0, "{sampler:?}: {chi}");
        }
    }
}
