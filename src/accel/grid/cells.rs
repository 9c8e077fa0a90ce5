//! What part of space a grid and its cells take up.

use super::Grid;
use crate::geometry::Aabb;
use crate::math::DVec3;

impl Grid {
    /// The box around all cells; `None` if there are none.
    pub fn bounds(&self) -> Option<Aabb> {
        (!self.starts.is_empty()).then_some(self.bounds)
    }

    /// The box of a cell; `None` if there is none of that number.
    pub fn cell(&self, id: u32) -> Option<Aabb> {
        let (id, [nx, ny, _]) = (id as usize, self.size);
        if id + 1 >= self.starts.len() {
            return None;
        }
        let place = [id % nx, id / nx % ny, id / (nx * ny)].map(|k| k as f64);
        let min = self.bounds.min + self.edge * DVec3::from_array(place);
        Some(Aabb {
            min,
            max: min + self.edge,
        })
    }

    /// Shapes without a sharp bound, in order.
    pub fn unbounded(&self) -> &[u32] {
        &self.unbounded
    }
}
