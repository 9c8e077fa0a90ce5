//! The first two axes of Sobol's sequence, scrambled as by Owen.
//!
//! The points are those of the crate `sobol_burley` (Burley 2020, "Practical hash-based Owen scrambling"), bit for bit.
//! It reads the axes from tables, one entry for each bit of a point's number, since it has 256 of them. The first two
//! need no tables: Sobol's matrix is the identity for one, and Pascal's triangle modulo 2 for the other.

use sobol_burley::parts::{hash, owen_scramble_rev, u32_to_f32_norm};

/// The length of a sequence, before its points repeat.
pub const POINTS: u32 = 1 << 16;

/// Salts of the hashes of `sobol_burley`: for the points' order, and for each axis.
const ORDER: u32 = 0x79c6_8e4a;
const AXES: [u32; 2] = [0x912f_69ba, 0x174f_18ab];
const SPREAD: u32 = 0x9c8f_2d3b;

/// An Owen scramble of the sequence: what all its points share.
#[derive(Clone, Copy, Debug)]
pub struct Scramble {
    order: u32,
    axes: [u32; 2],
}

impl Scramble {
    /// The scramble that `seed` chooses.
    pub fn new(seed: u32) -> Self {
        Self {
            order: hash(seed ^ ORDER),
            axes: AXES.map(|axis| hash(seed.wrapping_mul(SPREAD) ^ axis)),
        }
    }

    /// Point number `index`, below [`POINTS`], of the sequence, in [0, 1)^2.
    ///
    /// A scramble flips each digit by what the digits before it are. Here the first digit stands lowest, so that adding
    /// and multiplying carry from digits to those after them, and to no others.
    #[inline]
    pub fn point(self, index: u32) -> [f64; 2] {
        let shuffled = owen_scramble_rev(index.reverse_bits(), self.order).reverse_bits();
        let number = shuffled % POINTS;
        let at = |axis: u32, flips: u32| {
            let digits = owen_scramble_rev(axis, flips);
            f64::from(u32_to_f32_norm(digits.reverse_bits()))
        };
        [at(number, self.axes[0]), at(pascal(number), self.axes[1])]
    }
}

/// Pascal's triangle modulo 2 times the lower 16 bits of `x`.
///
/// As a polynomial over the bits, x becomes that of x + 1: and since (x + 1)^(2^k) is x^(2^k) + 1, one step for each k.
fn pascal(mut x: u32) -> u32 {
    x ^= (x & 0xaaaa) >> 1;
    x ^= (x & 0xcccc) >> 2;
    x ^= (x & 0xf0f0) >> 4;
    x ^ ((x & 0xff00) >> 8)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::stream::splitmix64;

    #[test]
    fn the_points_are_those_of_the_tables() {
        for i in 0..20_000 {
            let chance = splitmix64(i);
            let (index, seed) = ((chance as u32) >> (chance >> 60), (chance >> 32) as u32);
            let index = index % POINTS;
            let [x, y, ..] = sobol_burley::sample_4d(index, 0, seed);
            assert_eq!(
                Scramble::new(seed).point(index),
                [x, y].map(f64::from),
                "{index} {seed}"
            );
        }
    }
}
