//! Leaves: a surface's Bezier patches, halved until each is nearly flat, with seams that agree to the bit.
//!
//! Where two patches share an edge, both must cut it at the same places. So opposite edges of a patch are halved equally often,
//! and patches that share an edge form strips, all halved as often as the most bent of them needs.

use std::collections::HashMap;

use glam::DVec4;
use smallvec::SmallVec;

use super::grid::MAX_DEGREE;
use super::knots::mix;
use super::{Ball, SurfacePatch};
use crate::math::DVec3;
use crate::math::rounding::gamma;

/// The most halvings of a patch along u, and along v: 16 x 16 leaves. What bends more is halved by the search, ray by ray.
const MAX_HALVINGS: u32 = 4;

/// The square of the cosine of 45 degrees: steps between the control points of a leaf, along one row, turn less than that.
const STRAIGHT: f64 = 0.5;

/// A boundary curve's control points, as bits, in the sense that is the smaller of both.
type EdgeKey = Vec<[u64; 4]>;

/// Patches and leaves of one surface at most: all of them are kept in memory.
const MAX_PATCHES: usize = 2_000;
const MAX_LEAVES: u64 = 200_000;

/// Steps between control points along a row.
type Steps = SmallVec<[DVec3; MAX_DEGREE + 1]>;

/// The leaves of the patches of one surface; an error if there are too many.
pub fn cut(patches: &[SurfacePatch]) -> Result<Vec<SurfacePatch>, String> {
    let count = patches.len();
    if count > MAX_PATCHES {
        return Err(format!(
            "it has {count} patches: at most {MAX_PATCHES} are possible in one object"
        ));
    }
    let needed: Vec<[u32; 2]> = patches.iter().map(needed_halvings).collect();
    let halvings = along_strips(patches, &needed);
    let leaves: u64 = halvings.iter().map(|[m, n]| 1 << (m + n)).sum();
    if leaves > MAX_LEAVES {
        return Err(format!(
            "it is so bent that {leaves} leaves are needed: at most {MAX_LEAVES} are possible in one object"
        ));
    }
    let cut = patches.iter().zip(halvings).map(|(patch, n)| patch.cut(n));
    Ok(cut.flatten().collect())
}

/// The number of edges of leaves that are not joined to exactly one other edge, running the other way. A surface without
/// such edges is closed, and its normals agree on which side is outside. Edges that are a point need no partner.
pub fn open_edges(leaves: &[SurfacePatch]) -> usize {
    let mut balance: HashMap<EdgeKey, (i32, i32)> = HashMap::new();
    for leaf in leaves {
        for (edge, backwards) in leaf.edges().into_iter().zip([false, false, true, true]) {
            if let Some((key, turned)) = key(&edge) {
                let (count, sum) = balance.entry(key).or_default();
                *count += 1;
                *sum += if turned == backwards { 1 } else { -1 };
            }
        }
    }
    let open = balance
        .values()
        .filter(|(count, sum)| (*count, *sum) != (2, 0));
    open.map(|(count, _)| *count as usize).sum()
}

/// The key of an edge, and whether it is turned against the edge; `None` for an edge that is a point.
fn key(edge: &[DVec4]) -> Option<(EdgeKey, bool)> {
    if edge.iter().all(|p| p.truncate() == edge[0].truncate()) {
        return None;
    }
    // Adding 0 makes -0 the same as 0.
    let forwards: EdgeKey = edge
        .iter()
        .map(|p| (*p + DVec4::ZERO).to_array().map(f64::to_bits))
        .collect();
    let backwards: EdgeKey = forwards.iter().rev().copied().collect();
    let turned = backwards < forwards;
    Some((if turned { backwards } else { forwards }, turned))
}

/// How often each patch is halved along u and v if patches with a common edge agree on it.
fn along_strips(patches: &[SurfacePatch], needed: &[[u32; 2]]) -> Vec<[u32; 2]> {
    // Each patch has two numbers, along u (2 i) and along v (2 i + 1). Those of one strip form a tree that leads to one of
    // them: `parent`.
    let mut parent: Vec<usize> = (0..2 * patches.len()).collect();
    let mut seen: HashMap<EdgeKey, usize> = HashMap::new();
    for (i, patch) in patches.iter().enumerate() {
        for (edge, axis) in patch.edges().iter().zip([0, 1, 0, 1]) {
            if let Some((key, _)) = key(edge) {
                let number = 2 * i + axis;
                let other = *seen.entry(key).or_insert(number);
                let (a, b) = (root(&parent, number), root(&parent, other));
                parent[a] = b;
            }
        }
    }
    let mut most = vec![0; parent.len()];
    for (number, halvings) in needed.iter().flatten().enumerate() {
        let strip = root(&parent, number);
        most[strip] = most[strip].max(*halvings);
    }
    let of = |number| most[root(&parent, number)];
    (0..patches.len())
        .map(|i| [of(2 * i), of(2 * i + 1)])
        .collect()
}

fn root(parent: &[usize], mut number: usize) -> usize {
    while parent[number] != number {
        number = parent[number];
    }
    number
}

/// How often a patch has to be halved along u and v until no leaf bends by 45 degrees along either.
fn needed_halvings(patch: &SurfacePatch) -> [u32; 2] {
    let mut halvings = [0, 0];
    let mut leaves = vec![patch.clone()];
    loop {
        let bends = |axis: usize| leaves.iter().any(|leaf| leaf.bends_along(axis));
        let more = [0, 1].map(|axis| halvings[axis] < MAX_HALVINGS && bends(axis));
        if more == [false; 2] {
            return halvings;
        }
        for axis in [0, 1].into_iter().filter(|axis| more[*axis]) {
            halvings[axis] += 1;
            leaves = leaves.iter().flat_map(|leaf| leaf.halves(axis)).collect();
        }
    }
}

impl SurfacePatch {
    /// Its leaves if it is halved so often along u and along v.
    fn cut(&self, halvings: [u32; 2]) -> Vec<Self> {
        let mut leaves = vec![self.clone()];
        for (axis, n) in halvings.into_iter().enumerate() {
            for _ in 0..n {
                leaves = leaves.iter().flat_map(|leaf| leaf.halves(axis)).collect();
            }
        }
        leaves
    }

    /// Both halves along an axis. What is shared gets the same bits in both, and also from a neighbour that runs the other
    /// way.
    fn halves(&self, axis: usize) -> [Self; 2] {
        let (mut low, mut high) = (self.clone(), self.clone());
        let count = self.size[axis];
        for across in 0..self.size[1 - axis] {
            let index = |k: usize| self.index(axis, k, across);
            let mut points = [DVec4::ZERO; MAX_DEGREE + 1];
            for (k, point) in points.iter_mut().enumerate().take(count) {
                *point = self.control[index(k)];
            }
            for last in (0..count).rev() {
                low.control[index(count - 1 - last)] = points[0];
                high.control[index(last)] = points[last];
                for k in 0..last {
                    points[k] = mix(points[k], points[k + 1], 0.5);
                }
            }
        }
        let middle = 0.5 * (self.low[axis] + self.high[axis]);
        low.high[axis] = middle;
        high.low[axis] = middle;
        for half in [&mut low, &mut high] {
            half.ball = Ball::around(&half.control);
        }
        [low, high]
    }

    /// The index of the control point number `k` along an axis and `across` along the other.
    fn index(&self, axis: usize, k: usize, across: usize) -> usize {
        let [i, j] = if axis == 0 { [k, across] } else { [across, k] };
        j * self.size[0] + i
    }

    /// The boundary curves v = 0, u = 1, v = 1 and u = 0, each along its parameter.
    fn edges(&self) -> [Vec<DVec4>; 4] {
        let [m, n] = self.size;
        [(0, 0), (1, m - 1), (0, n - 1), (1, 0)].map(|(axis, across)| {
            let points = 0..self.size[axis];
            points
                .map(|k| self.control[self.index(axis, k, across)])
                .collect()
        })
    }

    /// True if walking along an axis turns the steps between control points by more than 45 degrees: those along the axis
    /// themselves, or those across it.
    fn bends_along(&self, axis: usize) -> bool {
        let point = |k, across| self.control[self.index(axis, k, across)].truncate();
        let (count, rows) = (self.size[axis], self.size[1 - axis]);
        let largest = self
            .control
            .iter()
            .map(|p| p.truncate().abs().max_element());
        // Shorter steps are rounding, and point anywhere.
        let noise = gamma(64) * largest.fold(0.0, f64::max);
        let turns = |mut steps: Steps| {
            steps.retain(|s| s.length() > noise);
            let mut pairs = steps
                .iter()
                .enumerate()
                .flat_map(|(i, a)| steps[..i].iter().map(move |b| (*a, *b)));
            pairs.any(|(a, b)| {
                let (dot, lengths) = (a.dot(b), a.length_squared() * b.length_squared());
                dot <= 0.0 || dot * dot < STRAIGHT * lengths
            })
        };
        let along = |row| {
            (1..count)
                .map(|k| point(k, row) - point(k - 1, row))
                .collect()
        };
        let across = |row| {
            (0..count)
                .map(|k| point(k, row) - point(k, row - 1))
                .collect()
        };
        (0..rows).any(|row| turns(along(row))) || (1..rows).any(|row| turns(across(row)))
    }
}
