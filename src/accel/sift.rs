//! Which shapes go into a tree, and which are tested apart.

use super::slack::{Slack, conditioning};
use crate::geometry::{Aabb, Shape};

/// Shapes sorted by whether a tree can bound them.
pub struct Sifted {
    /// Those that go into the tree, in order; their boxes are [`bounds_of`] them.
    pub inside: Vec<u32>,
    /// The others: without an end, too large, or placed too skew for a sharp bound.
    pub outside: Vec<u32>,
    /// Around all that is inside.
    pub bounds: Aabb,
    /// How thick planes must be taken.
    pub slack: Slack,
}

/// Sorts shapes; those with coordinates beyond `max_reach` stay outside.
pub fn sift(shapes: &[Shape], max_reach: f64) -> Sifted {
    let (mut inside, mut outside) = (Vec::with_capacity(shapes.len()), Vec::new());
    let (mut reach, mut condition, mut around) = (0.0f64, 0.0f64, Aabb::EMPTY);
    for (id, shape) in (0..).zip(shapes) {
        let (r, c) = conditioning(shape);
        match shape.bounds() {
            Some(b) if c <= Slack::MAX_CONDITION && r <= max_reach && !b.is_empty() => {
                reach = reach.max(r);
                condition = condition.max(c);
                around = around.union(b);
                inside.push(id);
            }
            _ => outside.push(id),
        }
    }
    Sifted {
        inside,
        outside,
        bounds: around,
        slack: Slack::new(reach, condition),
    }
}

/// The box around one of the shapes that go into the tree.
pub fn bounds_of(shapes: &[Shape], id: u32) -> Aabb {
    shapes[id as usize].bounds().unwrap_or(Aabb::EMPTY)
}
