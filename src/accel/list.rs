//! No acceleration: every ray is tested against every shape. O(n) a ray, and obviously right.

use super::collect::Collect;
use super::query::Query;
use crate::geometry::Shape;
use crate::probe::Probe;

/// The list of all shapes: the reference for the other structures.
#[derive(Clone, Debug)]
pub struct List {
    count: u32,
    /// Whether a shape is tested in the ray's own view.
    pub(super) needs_view: bool,
}

impl List {
    /// The list; nothing is built but the number of shapes.
    pub fn build(shapes: &[Shape]) -> Self {
        Self {
            count: shapes.len() as u32,
            needs_view: shapes.iter().any(Shape::needs_view),
        }
    }

    /// Tests the shapes in order until the search is over.
    #[inline(always)]
    pub fn search<C: Collect, P: Probe>(&self, query: &Query, found: &mut C, probe: &mut P) {
        for primitive in 0..self.count {
            query.test(primitive, found, probe);
            if found.is_over() {
                return;
            }
        }
    }
}
