//! Search for the splitting plane of a cell, at any angle.

use super::cell::Cell;
use crate::accel::bsp::classify::{Item, PlaneSide, Splitter};
use crate::accel::kd::{STEP, TEST};
use crate::geometry::{Shape, Triangle};
use crate::math::rounding::UNIT_ROUNDOFF;

/// What a step at a plane of any angle costs: two dot products and a division, against one multiplication.
const OBLIQUE_STEP: f64 = 1.7 * STEP;

/// Planes along an axis that are tried at most.
const MAX_AXIS_PLANES: usize = 1024;

/// In cells of at most so many items the planes of the triangles are tried.
const SOME: usize = 512;

/// In cells of so many also those through their edges, at right angles to the triangles.
const FEW: usize = 32;

/// Points closer to a plane than this are on it: coordinates are at most 1, and n.p - d is right to 8 u.
const TOLERANCE: f64 = 32.0 * UNIT_ROUNDOFF;

/// A plane that parts a cell.
pub struct Split {
    pub plane: Splitter,
    /// Whether what lies on it goes to the front.
    pub on_to_front: bool,
    /// How many items it cuts.
    pub cut: usize,
}

/// The plane that promises least cost, if it promises less than testing all items in one leaf. `triangles` are those of
/// the whole scene.
pub fn choose(items: &[Item], cell: &Cell, triangles: &[Option<Triangle>]) -> Option<Split> {
    let mut search = Search {
        items,
        cell,
        best: None,
        least: TEST * items.len() as f64,
    };
    for axis in 0..3 {
        search.along(axis);
    }
    if items.len() <= SOME {
        for item in items {
            if let Some(triangle) = &triangles[item.primitive as usize] {
                search.of_triangle(item.primitive, triangle);
            }
        }
    }
    search.best
}

/// Search for the best plane, one after the other.
struct Search<'a> {
    items: &'a [Item],
    cell: &'a Cell,
    best: Option<Split>,
    least: f64,
}

impl Search<'_> {
    /// Tries the planes where items begin or end along an axis.
    fn along(&mut self, axis: usize) {
        let sorted = |mut all: Vec<f64>| {
            all.sort_unstable_by(f64::total_cmp);
            all
        };
        let bounds = || self.items.iter().map(|item| item.bounds);
        let begins = sorted(bounds().map(|b| b.min[axis]).collect());
        let ends = sorted(bounds().map(|b| b.max[axis]).collect());
        let flat = bounds().filter(|b| b.min[axis] == b.max[axis]);
        let flat = sorted(flat.map(|b| b.min[axis]).collect());
        let mut positions = sorted([&begins[..], &ends[..]].concat());
        positions.dedup();
        let below = |list: &[f64], d: f64| list.partition_point(|&x| x < d);
        let up_to = |list: &[f64], d: f64| list.partition_point(|&x| x <= d);
        let stride = positions.len().div_ceil(MAX_AXIS_PLANES).max(1);
        for &d in positions.iter().step_by(stride).chain(positions.last()) {
            // What begins before d reaches behind it, what does not end at or before d reaches in front.
            let on = up_to(&flat, d) - below(&flat, d);
            let counts = [below(&begins, d), on, self.items.len() - up_to(&ends, d)];
            self.try_plane(Splitter::along(axis, d), counts, STEP);
        }
    }

    /// Tries the plane of a triangle, and those through its edges if items are few.
    fn of_triangle(&mut self, primitive: u32, triangle: &Triangle) {
        // Of a sliver rounding leaves no normal that its corners is_coherent on.
        let shape = Shape::Triangle(*triangle);
        let Some(own) = Splitter::of_triangle(primitive, &shape, TOLERANCE) else {
            return;
        };
        self.oblique(own);
        if self.items.len() <= FEW {
            let [a, b, c] = triangle.corners;
            for (p, q) in [(a, b), (b, c), (c, a)] {
                if let Some(normal) = own.normal.cross(q - p).try_normalize() {
                    self.oblique(Splitter {
                        normal,
                        d: normal.dot(p),
                        source: None,
                        ..own
                    });
                }
            }
        }
    }

    /// Tries a plane at any angle, unless it is one along an axis, which is tried anyway.
    fn oblique(&mut self, plane: Splitter) {
        if plane.normal.abs().max_element() > 1.0 - 1e-9 {
            return;
        }
        let mut counts = [0; 3];
        for item in self.items {
            let [behind, on, front] = match plane.side(item) {
                PlaneSide::Back => [1, 0, 0],
                PlaneSide::On => [0, 1, 0],
                PlaneSide::Front => [0, 0, 1],
                PlaneSide::Both => [1, 0, 1],
            };
            counts = [counts[0] + behind, counts[1] + on, counts[2] + front];
        }
        self.try_plane(plane, counts, OBLIQUE_STEP);
    }

    /// Keeps a plane if it promises less than all before: the step, and the tests behind it and in front by the
    /// probabilities that a ray gets there. Source: MacDonald and Booth 1990.
    fn try_plane(&mut self, plane: Splitter, [behind, on, front]: [usize; 3], step: f64) {
        // The parts' areas are together no smaller than the whole's, so this is the least that it may cost.
        if step + TEST * behind.min(front) as f64 >= self.least {
            return;
        }
        let Some([in_front, behind_it]) = self.cell.shares(plane.normal, plane.d) else {
            return;
        };
        // What lies on it goes where fewer rays come.
        let on_to_front = in_front < behind_it;
        let (f, b) = if on_to_front { (on, 0) } else { (0, on) };
        let tests = behind_it * (behind + b) as f64 + in_front * (front + f) as f64;
        let cost = step + TEST * tests;
        if cost < self.least {
            self.least = cost;
            self.best = Some(Split {
                plane,
                on_to_front,
                cut: behind + on + front - self.items.len(),
            });
        }
    }
}
