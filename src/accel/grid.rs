//! Uniform grid: cells of one size; a ray visits those on its way, one after the other.
//!
//! Source: Fujimoto, Tanaka and Iwata 1986, "ARTS"; Amanatides and Woo 1987, "A fast voxel traversal algorithm for ray
//! tracing"; the number of cells after Cleary and Wyvill 1988.
//!
//! No hit is lost: where a ray crosses a cell's border is wrong by less than the tolerance (see `tolerance`), so at t the ray
//! is within the tolerance of the cell that is visited for t, and a hit at t is within the tolerance of its shape. Shapes are
//! put into all cells that their boxes reach when they are grown by several times that.

mod cells;

use super::bounded::{Primitives, bounds_of};
use super::collect::Collect;
use super::inspect::{AccelStats, NodeView};
use super::query::Query;
use super::tolerance::Tolerance;
use super::volume::Volume;
use crate::geometry::{Aabb, Shape};
use crate::math::{DVec3, Interval};
use crate::probe::{Choice, Probe, Visit, tell};

/// Cells for each primitive.
const DENSITY: f64 = 4.0;

/// How many references there are at most, for each primitive; with more, the cells are made larger.
const MAX_REFERENCES: usize = 8;

/// Shapes are grown by this part of a cell's edge. Rays from so far away that their tolerance is not smaller are tested
/// against everything.
const GROWN: f64 = 1e-3;

/// A grid of cells over a scene's primitives.
#[derive(Clone, Debug)]
pub struct Grid {
    bounds: Aabb,
    /// How many cells there are along each axis; no cells at all if there is nothing in them.
    size: [usize; 3],
    /// A cell's edges.
    edge: DVec3,
    /// Where each cell's references begin, x first, and where the last one's end.
    starts: Vec<u32>,
    references: Vec<u32>,
    /// Shapes without a sharp bound, which are tested first.
    unbounded: Vec<u32>,
    tolerance: Tolerance,
    /// The most tolerance that a ray may have, in metres.
    most: f64,
}

impl Grid {
    /// Sorts `shapes` into cells.
    pub fn build(shapes: &[Shape]) -> Self {
        let Primitives {
            bounded,
            unbounded,
            bounds,
            tolerance,
        } = Primitives::new(shapes, Tolerance::MAX_COORDINATE);
        let mut grid = Self {
            bounds,
            size: [0; 3],
            edge: DVec3::ZERO,
            starts: Vec::new(),
            references: Vec::new(),
            unbounded,
            tolerance,
            most: 0.0,
        };
        let with_bounds = |id| (id, bounds_of(shapes, id));
        let items: Vec<(u32, Aabb)> = bounded.into_iter().map(with_bounds).collect();
        let mut cells = DENSITY * items.len() as f64;
        while !items.is_empty() && !grid.sort(&items, cells) {
            cells /= 4.0;
        }
        grid
    }

    /// Sorts the items into about so many cells; false if the references would be too many. One cell always does.
    fn sort(&mut self, items: &[(u32, Aabb)], cells: f64) -> bool {
        let extent = self.bounds.size();
        // No edge is shorter than the tolerance of a ray from nearby is thick, by far.
        let near = 2.0 * self.tolerance.for_origin(DVec3::ZERO);
        let least = near / GROWN;
        let longest = extent.max_element().max(least);
        let flat = extent.max(DVec3::splat(1e-3 * longest));
        // Cubes of about the volume of all by the number of cells. Scaled, so that it cannot overflow.
        let part = flat / longest;
        let edge = longest * libm::cbrt(part.x * part.y * part.z / cells.max(1.0));
        self.size = extent.to_array().map(|length| {
            let count = length / edge.max(least);
            if cells < 1.0 {
                1
            } else {
                (count as usize).clamp(1, 1024)
            }
        });
        self.edge = extent / DVec3::from_array(self.size.map(|n| n as f64));
        let shortest = self.edge.max(DVec3::splat(least)).min_element();
        self.most = 0.5 * GROWN * shortest;
        let cell_count: usize = self.size.iter().product();
        if cell_count > 8 * items.len() {
            return false;
        }

        // Count, sum up, fill in: a counting sort.
        let reached: Vec<_> = items
            .iter()
            .map(|(_, b)| self.reached(b, GROWN * shortest))
            .collect();
        let volume =
            |[from, to]: &[[usize; 3]; 2]| (0..3).map(|k| to[k] - from[k] + 1).product::<usize>();
        let total: usize = reached.iter().map(volume).sum();
        if total > MAX_REFERENCES * items.len() {
            return false;
        }
        self.starts = vec![0; cell_count + 1];
        for range in &reached {
            self.for_each_cell(range, |starts, _, cell| starts[cell + 1] += 1);
        }
        for cell in 0..cell_count {
            self.starts[cell + 1] += self.starts[cell];
        }
        self.references = vec![0; total];
        for ((primitive, _), range) in items.iter().zip(&reached).rev() {
            self.for_each_cell(range, |starts, references, cell| {
                starts[cell + 1] -= 1;
                references[starts[cell + 1] as usize] = *primitive;
            });
        }
        // Each start now stands one place too far to the right.
        self.starts.rotate_left(1);
        self.starts[cell_count] = total as u32;
        true
    }

    /// The first and last cells that a box reaches, axis by axis, if it is grown.
    fn reached(&self, b: &Aabb, grown: f64) -> [[usize; 3]; 2] {
        let grown = DVec3::splat(grown);
        [self.cell_of(b.min - grown), self.cell_of(b.max + grown)]
    }

    /// The cell of a point, or the one closest to it.
    fn cell_of(&self, p: DVec3) -> [usize; 3] {
        let cell = ((p - self.bounds.min) / self.edge).to_array();
        // Below 0 and NaN become 0.
        std::array::from_fn(|k| (cell[k] as usize).min(self.size[k] - 1))
    }

    /// Calls for each cell of a range.
    fn for_each_cell(
        &mut self,
        [from, to]: &[[usize; 3]; 2],
        mut call: impl FnMut(&mut [u32], &mut [u32], usize),
    ) {
        for z in from[2]..=to[2] {
            for y in from[1]..=to[1] {
                for x in from[0]..=to[0] {
                    let cell = (z * self.size[1] + y) * self.size[0] + x;
                    call(&mut self.starts, &mut self.references, cell);
                }
            }
        }
    }

    /// Walks from cell to cell along the ray, and tests what is in them.
    #[inline(never)]
    pub fn search<C: Collect, P: Probe>(&self, query: &Query, found: &mut C, probe: &mut P) {
        let root = (!self.starts.is_empty()).then_some(Volume::Box(self.bounds));
        let entry = query.enter(&self.unbounded, root, &self.tolerance, found, probe);
        let Some((tolerance, inside)) = entry else {
            return;
        };
        let near = tolerance <= self.most;
        if !near {
            query.test_all(&self.references, found, probe);
            return;
        }
        let mut walk = Walk::new(self, query, inside);
        loop {
            let (axis, leave) = walk.next_border();
            let id = (walk.cell[2] * self.size[1] + walk.cell[1]) * self.size[0] + walk.cell[0];
            if P::TRAVERSAL {
                let part = Interval::new(walk.enter, leave.min(inside.max));
                tell!(probe, Visit::end(id as u32, part, Choice::Cell));
            }
            if query.test_all(self.primitives(id), found, probe) {
                return;
            }
            // A hit at the very border does not count: one beyond it may be as close and have the smaller id.
            let is_over = leave > inside.max
                || leave == f64::INFINITY
                || found.closest().is_some_and(|hit| hit.t < leave);
            if is_over || !walk.step(axis, leave) {
                return;
            }
        }
    }

    /// What can be read of a cell; `None` if there is none of that number.
    pub fn node(&self, id: u32) -> Option<NodeView<'_>> {
        let cells = self.starts.len().saturating_sub(1);
        ((id as usize) < cells).then(|| NodeView::without_plane(self.primitives(id as usize)))
    }

    /// How large the grid is.
    pub fn stats(&self) -> AccelStats {
        let cells = self.starts.len().saturating_sub(1);
        AccelStats {
            nodes: cells,
            leaves: cells,
            depth: u32::from(cells > 0),
            references: self.references.len() + self.unbounded.len(),
            bytes: size_of_val(&self.starts[..])
                + size_of_val(&self.references[..])
                + size_of_val(&self.unbounded[..]),
            ..AccelStats::default()
        }
    }

    fn primitives(&self, cell: usize) -> &[u32] {
        &self.references[self.starts[cell] as usize..self.starts[cell + 1] as usize]
    }
}

/// A ray on its way through the cells. Source: Amanatides and Woo 1987.
struct Walk<'a> {
    grid: &'a Grid,
    origin: [f64; 3],
    direction: [f64; 3],
    cell: [usize; 3],
    /// Where the ray enters the cell, and where it leaves it along each axis.
    enter: f64,
    ends: [f64; 3],
}

impl<'a> Walk<'a> {
    /// The start, in the cell where the ray enters the grid.
    #[inline(always)]
    fn new(grid: &'a Grid, query: &Query, inside: Interval) -> Self {
        let mut walk = Self {
            grid,
            origin: query.ray.origin.to_array(),
            direction: query.ray.direction.to_array(),
            cell: grid.cell_of(query.ray.at(inside.min)),
            enter: inside.min,
            ends: [0.0; 3],
        };
        walk.ends = [0, 1, 2].map(|axis| walk.end(axis));
        walk
    }

    /// Where the ray leaves its cell along an axis. Each border is computed anew, so that errors do not add up. Cells at
    /// the rim are endless: the ray was cut to the grid before.
    #[inline(always)]
    fn end(&self, axis: usize) -> f64 {
        let Self {
            grid,
            origin,
            direction,
            ..
        } = self;
        let border = self.cell[axis] + usize::from(direction[axis] > 0.0);
        if direction[axis] == 0.0 || border == 0 || border == grid.size[axis] {
            return f64::INFINITY;
        }
        let border = grid.bounds.min[axis] + grid.edge[axis] * border as f64;
        (border - origin[axis]) / direction[axis]
    }

    /// The axis of the first border that the ray crosses, and where.
    #[inline(always)]
    fn next_border(&self) -> (usize, f64) {
        let ends = &self.ends;
        let axis = if ends[0] <= ends[1] && ends[0] <= ends[2] {
            0
        } else if ends[1] <= ends[2] {
            1
        } else {
            2
        };
        (axis, ends[axis].max(self.enter))
    }

    /// Goes on to the next cell along an axis; false if there is none.
    #[inline(always)]
    fn step(&mut self, axis: usize, leave: f64) -> bool {
        let next = if self.direction[axis] > 0.0 {
            Some(self.cell[axis] + 1).filter(|&next| next < self.grid.size[axis])
        } else {
            self.cell[axis].checked_sub(1)
        };
        let Some(next) = next else {
            return false;
        };
        self.cell[axis] = next;
        self.ends[axis] = self.end(axis);
        self.enter = leave;
        true
    }
}
