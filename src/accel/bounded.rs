//! Bounded and unbounded primitives: those in a structure, and the others, which every ray is tested against first.

use super::tolerance::{Tolerance, conditioning};
use crate::geometry::{Aabb, Shape};

/// Primitive ids, by whether a structure can bound the shapes.
pub struct Primitives {
    /// Those in the structure, in order; [`bounds_of`] them are their boxes.
    pub bounded: Vec<u32>,
    /// The others: endless, too large, or transformed by an ill-conditioned matrix, so that no bound is sharp.
    pub unbounded: Vec<u32>,
    /// The box around all bounded shapes.
    pub bounds: Aabb,
    /// How thick planes and volumes must be taken.
    pub tolerance: Tolerance,
}

impl Primitives {
    /// Sorts shapes; those with coordinates beyond `limit` count as unbounded.
    pub fn new(shapes: &[Shape], limit: f64) -> Self {
        let (mut bounded, mut unbounded) = (Vec::with_capacity(shapes.len()), Vec::new());
        let (mut max_coordinate, mut condition, mut bounds) = (0.0f64, 0.0f64, Aabb::EMPTY);
        for (id, shape) in (0..).zip(shapes) {
            let (largest, c) = conditioning(shape);
            match shape.bounds() {
                Some(b) if c <= Tolerance::MAX_CONDITION && largest <= limit && !b.is_empty() => {
                    max_coordinate = max_coordinate.max(largest);
                    condition = condition.max(c);
                    bounds = bounds.union(b);
                    bounded.push(id);
                }
                _ => unbounded.push(id),
            }
        }
        Self {
            bounded,
            unbounded,
            bounds,
            tolerance: Tolerance::new(max_coordinate, condition),
        }
    }
}

/// The box around a bounded shape.
pub fn bounds_of(shapes: &[Shape], id: u32) -> Aabb {
    shapes[id as usize].bounds().unwrap_or(Aabb::EMPTY)
}
