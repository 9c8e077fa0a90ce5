//! The cells of the squarest grid over the unit square, and a random permutation of them (stratified sampling).

use super::stream::splitmix64;

/// The point (dx, dy), in [0, 1)^2, of cell number `cell` in the squarest grid of `count` cells.
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

/// The image of `index` under the random permutation `key` of 0..count.
///
/// A few rounds of steps that can be undone permute the numbers below a power of two; a number that lands at or above
/// `count` goes round again until it does not (cycle walking: Black and Rogaway 2002, "Ciphers with arbitrary finite
/// domains"), which is a permutation of the rest.
pub fn permuted(index: u32, count: u32, key: u64) -> u32 {
    if count < 2 {
        return 0;
    }
    let mask = u32::MAX >> (count - 1).leading_zeros();
    let shift = mask.count_ones().div_ceil(2);
    let mut x = index % count;
    loop {
        for round in 0..4u64 {
            let k = splitmix64(key.wrapping_add(round));
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
                seen[permuted(index, count, 5) as usize] = true;
            }
            assert!(seen.iter().all(|s| *s), "{count}");
        }
        let order = |key| (0..100).map(|i| permuted(i, 100, key)).collect::<Vec<_>>();
        assert_ne!(order(1), order(2));
    }
}
