//! Rounds of clustering, estimated by a sample of the boxes.
//!
//! In each round of clustering the boxes that are nearest to each other become one: of most scenes a third of all. Of boxes
//! around each other, or the slices of a fan, each is nearest to the next smaller one and only the two smallest find each other:
//! the rounds are as many as the boxes, and the time grows with their square. A sample shows which it is.
//! Source: Meister and Bittner 2018, "Parallel locally-ordered clustering", section 4.

use glam::DVec3;
use obvhs::aabb::Aabb as Box32;
use obvhs::ploc::morton::morton_encode_u64_unorm;

/// Boxes of the sample.
const SAMPLE: usize = 128;

/// Rounds that a sample may take. (Triangles and spheres at random take 7 to 12.)
const FEW: usize = 24;

/// How far away in the list the nearest box is looked for, as clustering does.
const REACH: usize = 14;

/// True if clustering these boxes would take many more rounds than the logarithm of their number.
pub fn takes_many_rounds(boxes: &[Box32]) -> bool {
    let mut sample = in_morton_order(boxes);
    for _ in 0..FEW {
        if sample.len() <= 1 {
            return false;
        }
        sample = merge(&sample);
    }
    sample.len() > 1
}

/// A sample of the boxes, sorted along a space-filling curve.
fn in_morton_order(boxes: &[Box32]) -> Vec<Box32> {
    let step = boxes.len().div_ceil(SAMPLE).max(1);
    let mut sample: Vec<Box32> = boxes.iter().step_by(step).copied().collect();
    let all = sample.iter().fold(Box32::INVALID, |a, b| a.union(b));
    let size = all.diagonal().max_element().max(f32::MIN_POSITIVE);
    sample.sort_by_key(|b| {
        let center: DVec3 = ((b.center() - all.min) / size).as_dvec3();
        morton_encode_u64_unorm(center)
    });
    sample
}

/// The boxes after a round: those that are nearest to each other are one.
fn merge(boxes: &[Box32]) -> Vec<Box32> {
    let nearest: Vec<usize> = (0..boxes.len()).map(|i| nearest(boxes, i)).collect();
    (0..boxes.len())
        .filter_map(|i| match nearest[i] {
            other if nearest[other] != i => Some(boxes[i]),
            other => (i < other).then(|| boxes[i].union(&boxes[other])),
        })
        .collect()
}

/// The box, of those near by in the list, that makes the smallest box together with box `i`.
fn nearest(boxes: &[Box32], i: usize) -> usize {
    let area = |other: &usize| boxes[i].union(&boxes[*other]).half_area();
    let (first, end) = (i.saturating_sub(REACH), (i + REACH + 1).min(boxes.len()));
    let others = (first..end).filter(|other| *other != i);
    others
        .min_by(|a, b| area(a).total_cmp(&area(b)))
        .unwrap_or(i)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::fast::packet::tests::Random;
    use glam::Vec3A;

    fn cube(center: Vec3A, radius: f32) -> Box32 {
        Box32::new(center - radius, center + radius)
    }

    #[test]
    fn boxes_around_each_other_take_many_rounds() {
        let around = |center: fn(f32) -> Vec3A| -> Vec<Box32> {
            let boxes = (0..5000).map(|i| i as f32);
            boxes.map(|i| cube(center(i), 0.1 + i * 1e-4)).collect()
        };
        assert!(takes_many_rounds(&around(|_| Vec3A::ZERO)));
        assert!(takes_many_rounds(&around(|i| Vec3A::X * i * 1e-4)));
    }

    #[test]
    fn boxes_beside_each_other_take_few() {
        let mut random = Random(3);
        let mut boxes = Vec::new();
        for count in [0, 1, 2, 3, 127, 128, 129, 5000] {
            boxes.resize_with(count, || {
                let center = Vec3A::from_array(std::array::from_fn(|_| random.unit() as f32));
                cube(center, 0.01)
            });
            assert!(!takes_many_rounds(&boxes), "{count}");
        }
    }
}
