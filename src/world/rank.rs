//! Rank of the objects whose inside is a medium: which of them a point is in, where they overlap.

use std::cmp::Reverse;

use super::closed::enclosed_volume;
use crate::scene::Scene;

/// Rank of each object. It is higher for a higher priority of the material; of equal ones, for the smaller object, so that
/// what is inside of another needs no priority; of equally large ones, for the later in the file. Objects that bound no part of
/// space (`open`) count as endless.
pub fn ranks(scene: &Scene, open: &[bool]) -> Vec<u32> {
    let volumes: Vec<u64> = (0u32..)
        .zip(open)
        .map(|(object, open)| match open {
            true => f64::INFINITY,
            false => enclosed_volume(scene.shapes_of(object)),
        })
        // Positive numbers are in the order of their bits.
        .map(f64::to_bits)
        .collect();
    let mut order: Vec<u32> = (0..volumes.len() as u32).collect();
    order.sort_by_key(|&object| {
        (
            scene.medium_priority(object),
            Reverse(volumes[object as usize]),
            object,
        )
    });
    let mut ranks = vec![0; order.len()];
    for (rank, &object) in (0..).zip(&order) {
        ranks[object as usize] = rank;
    }
    ranks
}
