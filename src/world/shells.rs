//! Shells: the parts of a mesh that hang together by their corners.

use std::collections::BTreeMap;

use super::closed::bits;
use crate::geometry::{Aabb, Shape};
use crate::math::DVec3;

/// A part of a mesh that hangs together.
#[derive(Clone, Copy, Debug)]
pub struct Shell {
    /// Its volume, if it is closed; negative if its triangles run clockwise, seen from outside.
    pub volume: f64,
    /// A box around it.
    pub bounds: Aabb,
    /// A corner with the largest x.
    pub foremost: DVec3,
}

/// The shells of the triangles among the shapes.
pub fn shells(shapes: &[Shape]) -> Vec<Shell> {
    let triangles = || {
        shapes.iter().filter_map(|shape| match shape.plain() {
            Shape::Triangle(triangle) => Some(triangle.corners),
            _ => None,
        })
    };
    let mut points: Vec<[u64; 3]> = triangles().flatten().map(bits).collect();
    points.sort_unstable();
    points.dedup();
    // In the list, since every corner is.
    let index = |p: DVec3| points.binary_search(&bits(p)).unwrap_or_default();
    let mut sets = Sets::new(points.len());
    for corners in triangles() {
        let [a, b, c] = corners.map(index);
        sets.join(a, b);
        sets.join(a, c);
    }
    let mut shells = BTreeMap::<usize, Shell>::new();
    for corners in triangles() {
        let shell = shells.entry(sets.root(index(corners[0]))).or_insert(Shell {
            volume: 0.0,
            bounds: Aabb::EMPTY,
            foremost: corners[0],
        });
        shell.bounds = shell.bounds.union(Aabb::around(corners));
        for corner in corners {
            if corner.x > shell.foremost.x {
                shell.foremost = corner;
            }
        }
    }
    // The tetrahedra that the triangles span with its middle (divergence theorem): near, so that little is rounded.
    for corners in triangles() {
        if let Some(shell) = shells.get_mut(&sets.root(index(corners[0]))) {
            let base = shell.bounds.center();
            let [a, b, c] = corners.map(|corner| corner - base);
            shell.volume += a.dot(b.cross(c)) / 6.0;
        }
    }
    shells.into_values().collect()
}

/// Sets of numbers that are joined one after the other. Source: Tarjan and van Leeuwen 1984, "Worst-case analysis of set
/// union algorithms": path halving.
struct Sets(Vec<usize>);

impl Sets {
    fn new(count: usize) -> Self {
        Self((0..count).collect())
    }

    fn root(&mut self, mut n: usize) -> usize {
        while self.0[n] != n {
            self.0[n] = self.0[self.0[n]];
            n = self.0[n];
        }
        n
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b)] = a.min(b);
    }
}
