//! Points in the unit square: where on a light, or in a pixel, the samples lie.
//!
//! An integral is the mean of its integrand over such points. How fast the mean nears the integral depends on how
//! evenly they lie: for n points the error of [`Sampler::Random`] falls as n^-1/2 whatever the integrand; that of
//! [`Sampler::Stratified`] as n^-1 and of [`Sampler::Sobol`] as n^-3/2 where the integrand is smooth, both more slowly
//! across an edge (Mitchell 1996, "Consequences of stratified sampling in graphics"; Owen 1997, "Scrambled net variance
//! for integrals of smooth functions"). [`Sampler::Grid`] has no chance in it: its error is the same in every pixel and
//! shows as bands.

use serde::{Deserialize, Serialize};

use super::sampler::{mix, unit};
use super::sobol::{self, Scramble};

/// How points are chosen.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema,
)]
#[serde(rename_all = "kebab-case")]
pub enum Sampler {
    /// The middles of a grid's cells: the lecture's regular point lights.
    Grid,
    /// Anywhere, each point independent of all others.
    Random,
    /// One point in each cell of a grid, anywhere in it.
    Stratified,
    /// Sobol's sequence, scrambled as by Owen: evenly spread at every scale.
    #[default]
    Sobol,
}

/// How a place on a light is chosen with two numbers.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema,
)]
#[serde(rename_all = "kebab-case")]
pub enum LightSampling {
    /// Even on the light's area (on a sphere, in the cone that is seen): each sample brings what it brings.
    #[default]
    Area,
    /// On matt surfaces, in proportion to what a place of a rectangle or triangle brings: all samples bring the same,
    /// and the only noise is that of what stands in the way. Elsewhere as `area`.
    Projected,
}

/// A run of points that belong together: those of one pixel for one use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Run {
    /// Which run: another key, other points.
    pub key: u64,
    /// How many points it has.
    pub count: u32,
}

/// A run's points by their sampler, and what they have in common.
#[derive(Clone, Copy, Debug)]
pub enum Points {
    /// The cells of a grid.
    Grid {
        /// How many.
        count: u32,
    },
    /// Independent ones.
    Random {
        /// Which run.
        key: u64,
    },
    /// One in each cell.
    Stratified(Run),
    /// A sequence, and after its end others.
    Sobol {
        /// Which run.
        key: u64,
        /// That of the first sequence.
        scramble: Scramble,
    },
}

impl LightSampling {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Area, Self::Projected];

    /// The name that users write.
    pub fn name(self) -> &'static str {
        match self {
            Self::Area => "area",
            Self::Projected => "projected",
        }
    }
}

impl Sampler {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Grid, Self::Random, Self::Stratified, Self::Sobol];

    /// The name that users write.
    pub fn name(self) -> &'static str {
        match self {
            Self::Grid => "grid",
            Self::Random => "random",
            Self::Stratified => "stratified",
            Self::Sobol => "sobol",
        }
    }

    /// Point number `index` of a run, in [0, 1)^2.
    pub fn point(self, run: Run, index: u32) -> [f64; 2] {
        Points::new(self, run).at(index)
    }
}

impl Points {
    /// The points of a run.
    #[inline]
    pub fn new(sampler: Sampler, run: Run) -> Self {
        match sampler {
            Sampler::Grid => Self::Grid { count: run.count },
            Sampler::Random => Self::Random { key: run.key },
            Sampler::Stratified => Self::Stratified(run),
            Sampler::Sobol => Self::Sobol {
                key: run.key,
                scramble: scramble(run.key, 0),
            },
        }
    }

    /// Point number `index`, in [0, 1)^2. (Always inlined: both places that ask, on the film and on lights, are called for
    /// every sample.)
    #[inline(always)]
    pub fn at(&self, index: u32) -> [f64; 2] {
        match *self {
            Self::Grid { count } => in_cell(index % count.max(1), count, [0.5, 0.5]),
            Self::Random { key } => chance(key, index),
            // The cells come in an order of chance, so that any part of the run is spread over the whole square.
            Self::Stratified(Run { key, count }) => {
                in_cell(shuffled(index, count, key), count, chance(key, index))
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

/// Two numbers by chance, from the run and the point's own number.
fn chance(key: u64, index: u32) -> [f64; 2] {
    let x = mix(key ^ mix(u64::from(index)));
    [unit(x), unit(mix(x))]
}

/// The scramble of the sequence that comes after `sequence` others of a run are used up.
#[inline]
fn scramble(key: u64, sequence: u32) -> Scramble {
    Scramble::new(mix(key ^ u64::from(sequence)) as u32)
}

/// The place (dx, dy) in cell number `cell` of the squarest grid of `count` cells.
pub fn in_cell(cell: u32, count: u32, [dx, dy]: [f64; 2]) -> [f64; 2] {
    let rows = grid_rows(count);
    let columns = count.max(1) / rows;
    let (column, row) = (f64::from(cell % columns), f64::from(cell / columns));
    [
        (column + dx) / f64::from(columns),
        (row + dy) / f64::from(rows),
    ]
}

/// The rows of the squarest grid with exactly `count` cells: the largest divisor up to the square root.
pub fn grid_rows(count: u32) -> u32 {
    (1..=count.isqrt())
        .rev()
        .find(|rows| count.is_multiple_of(*rows))
        .unwrap_or(1)
}

/// Where `index` goes in the permutation `key` of 0..count.
///
/// A few rounds of steps that can be undone permute the numbers below a power of two; a number that lands at or above
/// `count` goes round again until it does not (cycle walking: Black and Rogaway 2002, "Ciphers with arbitrary finite
/// domains"), which is a permutation of the rest.
fn shuffled(index: u32, count: u32, key: u64) -> u32 {
    if count < 2 {
        return 0;
    }
    let mask = u32::MAX >> (count - 1).leading_zeros();
    let shift = mask.count_ones().div_ceil(2);
    let mut x = index % count;
    loop {
        for round in 0..4u64 {
            let k = mix(key.wrapping_add(round));
            // Adding and multiplying by an odd number permute modulo a power of two; so does x ^ (x >> shift).
            x = (x.wrapping_add(k as u32).wrapping_mul((k >> 32) as u32 | 1)) & mask;
            x ^= x >> shift;
        }
        if x < count {
            return x;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grids_are_as_square_as_can_be() {
        for (count, rows) in [(1, 1), (4, 2), (6, 2), (7, 1), (16, 4), (64, 8)] {
            assert_eq!(grid_rows(count), rows);
        }
    }

    #[test]
    fn a_shuffle_leaves_nothing_out_and_depends_on_its_key() {
        for count in [1, 2, 3, 7, 64, 100, 1000] {
            let mut seen = vec![false; count as usize];
            for index in 0..count {
                seen[shuffled(index, count, 5) as usize] = true;
            }
            assert!(seen.iter().all(|s| *s), "{count}");
        }
        let order = |key| (0..100).map(|i| shuffled(i, 100, key)).collect::<Vec<_>>();
        assert_ne!(order(1), order(2));
    }

    #[test]
    fn every_cell_of_a_stratified_run_has_one_point() {
        let run = Run { key: 9, count: 64 };
        let mut cells = [0; 64];
        for index in 0..64 {
            let [x, y] = Sampler::Stratified.point(run, index);
            cells[(y * 8.0) as usize * 8 + (x * 8.0) as usize] += 1;
        }
        assert_eq!(cells, [1; 64]);
    }

    #[test]
    fn sobols_points_are_a_net() {
        // 64 points of a (0, 2)-sequence in base 2: one in each cell of 64x1, 32x2, 16x4, 8x8, ...
        let run = Run { key: 3, count: 64 };
        for bits in 0..=6 {
            let (columns, rows) = (1 << bits, 64 >> bits);
            let mut cells = [0; 64];
            for index in 0..64 {
                let [x, y] = Sampler::Sobol.point(run, index);
                let (column, row) = (x * f64::from(columns), y * f64::from(rows));
                cells[row as usize * columns as usize + column as usize] += 1;
            }
            assert_eq!(cells, [1; 64], "{columns} x {rows}");
        }
    }

    #[test]
    fn after_the_end_of_a_sequence_another_begins() {
        let run = Run {
            key: 3,
            count: 2 * sobol::POINTS,
        };
        let points = Points::new(Sampler::Sobol, run);
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
        // Chi-square over 8 x 8 cells of 64,000 points in 1,000 runs of 64: 63 degrees of freedom, 99.99 % under 113.
        for sampler in Sampler::ALL {
            let mut cells = [0.0; 64];
            for key in 0..1000 {
                for index in 0..64 {
                    let run = Run { key, count: 64 };
                    let [x, y] = sampler.point(run, index);
                    assert!((0.0..1.0).contains(&x) && (0.0..1.0).contains(&y));
                    cells[(y * 8.0) as usize * 8 + (x * 8.0) as usize] += 1.0;
                }
            }
            let chi: f64 = cells.iter().map(|n| (n - 1000.0f64).powi(2) / 1000.0).sum();
            assert!(chi < 113.0, "{sampler:?}: {chi}");
        }
    }
}
