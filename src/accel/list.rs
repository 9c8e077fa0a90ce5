//! No acceleration: every ray is tested against every shape. O(n) a ray, and obviously right.

use super::Query;
use crate::geometry::{Hit, Shape};
use crate::probe::Probe;

/// The slow twin.
#[derive(Clone, Debug)]
pub struct List {
    count: u32,
}

impl List {
    /// Nothing to build but the number of shapes.
    pub fn build(shapes: &[Shape]) -> Self {
        Self {
            count: shapes.len() as u32,
        }
    }

    /// The closest hit.
    pub fn closest<P: Probe>(&self, query: &Query, probe: &mut P) -> Option<Hit> {
        let mut best = None;
        for primitive in 0..self.count {
            query.test(primitive, &mut best, probe);
        }
        best
    }

    /// The first hit in the list.
    pub fn any<P: Probe>(&self, query: &Query, probe: &mut P) -> Option<Hit> {
        let mut best = None;
        (0..self.count).find_map(|primitive| {
            query.test(primitive, &mut best, probe);
            best
        })
    }
}
