//! Constructive solid geometry: solids that are cut from others by union, intersection and difference.
//!
//! A ray's line is in each leaf during some spans. All their ends are sorted; between two of them the set of leaves that the
//! line is inside of does not change, and the program of the tree says of each set whether it is inside the whole. A cut counts
//! where that answer changes. Source: Roth 1982, "Ray casting for modeling solids".
//!
//! Cuts that rounding cannot tell apart are one: there is a state before them and a state after them, and nothing between. So
//! faces that coincide leave no film, solids that touch have no gap, and the order among equals cannot matter. No epsilon is
//! chosen: how far cuts may be apart follows from the errors of both surfaces. The rule holds for two cuts of one leaf as well,
//! so a cutter that is thinner than rounding cuts nothing, and A u A is A to the bit.

mod half_space;
mod polyhedron;
mod program;
mod solid;
mod tree;
mod walk;
mod written;

pub use half_space::HalfSpace;
pub use polyhedron::Polyhedron;
pub use program::CsgOp;
pub use solid::Solid;
pub use tree::CsgTree;
pub use written::CsgNode;

use crate::geometry::{Aabb, Cut, Intersection, Span, Spans, SurfacePoint};
use crate::math::{DVec3, Interval, Ray};
use program::CsgProgram;
use tree::{Compiled, PlacedLeaf};
use walk::{CutGroup, CutList, LeafCut, Walk};

/// A solid that is cut from others.
#[derive(Clone, Debug)]
pub struct Csg {
    leaves: Vec<PlacedLeaf>,
    program: CsgProgram,
    bounds: Aabb,
}

/// A cut of a leaf, and what it does to the whole: for explaining.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CsgCut {
    /// The leaf, counted from 0 in the order of the tree.
    pub leaf: u32,
    /// The part of the whole: see [`Csg::part`].
    pub part: u32,
    /// The ray parameter.
    pub t: f64,
    /// Whether the ray goes into the leaf.
    pub enters: bool,
    /// The leaves that the ray is inside of after it: bit i for leaf i.
    pub inside: u64,
    /// Whether the ray goes into the whole, or comes out of it, by this cut.
    pub counts: bool,
    /// The number of its group: cuts of one number cannot be told apart, and are crossed as one.
    pub group: u32,
}

/// All cuts of a ray's line with the leaves: for explaining.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CsgCuts {
    /// The leaves that were asked: bit i for leaf i. The others cannot matter to this ray.
    pub asked: u64,
    /// The leaves that the line is inside of before all cuts.
    pub before: u64,
    /// The cuts, by t.
    pub cuts: Vec<CsgCut>,
}

/// Parts that a leaf may have of its own.
const PARTS_OF_A_LEAF: u32 = 8;

impl Csg {
    /// The solid that a tree describes. Errors, in words that go behind its name: more than 64 leaves, more than 32 operations
    /// inside each other, an operation of no parts, a leaf without an inside, no end.
    pub fn new(tree: CsgTree) -> Result<Self, String> {
        let (Compiled { leaves, program }, bounds) = Compiled::new(tree)?;
        Ok(Self {
            leaves,
            program,
            bounds,
        })
    }

    /// The leaves, in the order of the tree.
    pub fn leaves(&self) -> impl Iterator<Item = &Solid> {
        self.leaves.iter().map(|placed| &placed.solid)
    }

    /// True if the whole has less where this leaf is.
    pub fn is_subtracted(&self, leaf: u32) -> bool {
        let placed = self.leaves.get(leaf as usize);
        placed.is_some_and(|placed| placed.is_subtracted)
    }

    /// The number of a part of a leaf among the parts of the whole: see [`super::Hit::part`]. It is never 0, which
    /// stands for shapes without parts.
    pub fn part(leaf: u32, part_of_leaf: u32) -> u32 {
        (leaf + 1) * PARTS_OF_A_LEAF + part_of_leaf % PARTS_OF_A_LEAF
    }

    /// The leaf that a part of the whole belongs to.
    pub fn leaf_of(part: u32) -> u32 {
        (part / PARTS_OF_A_LEAF).saturating_sub(1)
    }

    /// The number that a part of the whole has in its leaf.
    pub fn part_of_leaf(part: u32) -> u32 {
        part % PARTS_OF_A_LEAF
    }

    /// Whether a point that is inside of these leaves (bit i for leaf i) is inside of the whole.
    #[inline]
    pub fn is_inside(&self, leaves: u64) -> bool {
        self.program.is_inside(leaves)
    }

    /// The first crossing inside the interval.
    pub fn intersect(&self, ray: &Ray, interval: Interval) -> Intersection {
        let mut found = Intersection::Miss;
        let mut list = CutList::default();
        self.collect(ray, &mut list);
        for group in Walk::new(self, ray, &list) {
            let Some(chosen) = group.chosen else {
                continue;
            };
            match list.cuts[chosen].of_whole().classify(interval) {
                behind @ Intersection::Behind(_) => found = behind,
                other => return other,
            }
        }
        found
    }

    /// The spans of the ray's line inside.
    pub fn spans(&self, ray: &Ray) -> Spans {
        let mut list = CutList::default();
        self.collect(ray, &mut list);
        let endless = |t| Cut { t, part: 0 };
        let starts_inside = self.is_inside(list.before);
        let mut enter = starts_inside.then(|| endless(f64::NEG_INFINITY));
        let mut spans = Spans::none();
        for chosen in Walk::new(self, ray, &list).filter_map(|group| group.chosen) {
            let cut = list.cuts[chosen].of_whole();
            match enter.take() {
                Some(enter) => spans.0.push(Span { enter, leave: cut }),
                None => enter = Some(cut),
            }
        }
        let leave = endless(f64::INFINITY);
        spans.0.extend(enter.map(|enter| Span { enter, leave }));
        spans
    }

    /// All cuts of the ray's line with the leaves, and what each does: for explaining. The hit that [`Csg::intersect`] finds is
    /// the first of those that count inside the interval.
    pub fn cuts(&self, ray: &Ray) -> CsgCuts {
        let mut list = CutList::default();
        self.collect(ray, &mut list);
        let mut told = CsgCuts {
            asked: list.asked,
            before: list.before,
            cuts: Vec::with_capacity(list.cuts.len()),
        };
        let mut inside = list.before;
        for (number, group) in (0..).zip(Walk::new(self, ray, &list)) {
            for i in group.members {
                let cut = &list.cuts[i];
                inside = cut.after(inside);
                told.cuts.push(CsgCut {
                    leaf: cut.leaf,
                    part: cut.of_whole().part,
                    t: cut.cut.t,
                    enters: cut.enters,
                    inside,
                    counts: group.chosen == Some(i),
                    group: number,
                });
            }
        }
        told
    }

    /// The cuts of the ray's line with all leaves, by t, whether they matter to the whole or not. Their parts are those of the whole.
    pub fn cuts_of_all_leaves(&self, ray: &Ray) -> Vec<Cut> {
        let mut all = Vec::new();
        for (leaf, placed) in (0..).zip(&self.leaves) {
            let spans = placed.solid.spans(ray);
            all.extend(spans.cuts().map(|(cut, _)| Cut {
                t: cut.t,
                part: Self::part(leaf, cut.part),
            }));
        }
        all.sort_by(|a, b| a.t.total_cmp(&b.t));
        all
    }

    /// Whether the ray goes into the solid at `t`, as found by [`Csg::intersect`]; `None` if there is no crossing.
    pub fn enters(&self, ray: &Ray, t: f64) -> Option<bool> {
        self.spans(ray).enters(t)
    }

    /// The point at `t`, as found by [`Csg::intersect`], on its leaf. The normal points out of the whole, so that of a leaf that
    /// is subtracted is turned. The error covers all surfaces that are crossed as one there.
    pub fn surface(&self, ray: &Ray, t: f64, part: u32) -> SurfacePoint {
        let leaf = Self::leaf_of(part).min(self.leaves.len() as u32 - 1);
        let placed = &self.leaves[leaf as usize];
        let mut surface = placed.solid.surface(ray, t, Self::part_of_leaf(part));
        let mut list = CutList::default();
        self.collect(ray, &mut list);
        let is_it = |group: &CutGroup| {
            group
                .chosen
                .is_some_and(|chosen| list.cuts[chosen].cut.t == t)
        };
        if let Some(group) = Walk::new(self, ray, &list).find(is_it) {
            self.cover(ray, &list.cuts[group.members], leaf, &mut surface);
        }
        if placed.is_subtracted {
            surface.normal = -surface.normal;
        }
        surface
    }

    /// The gradient of the equation of the part at a point, turned where the part is subtracted.
    pub fn gradient(&self, point: DVec3, part: u32) -> Option<DVec3> {
        let placed = self.leaves.get(Self::leaf_of(part) as usize)?;
        let Solid::Shape(shape) = &placed.solid else {
            return None;
        };
        let gradient = shape.gradient(point, Self::part_of_leaf(part))?;
        Some(if placed.is_subtracted {
            -gradient
        } else {
            gradient
        })
    }

    /// Widens the error of a point so that a ray that leaves it is clear of all surfaces of the group `cuts`.
    ///
    /// Surface j passes the point at the distance n_j.(p - p_j), and is itself known to within e_j, which covers what its next
    /// test may round; the point is known to within e. A ray starts |n|.error off the point along n, which is n_j or -n_j for
    /// surfaces that coincide. (At an edge surfaces of other directions are in the group as well. They are met by rays that
    /// leave the edge as any other face of a solid is.) The missing part is added along |n|, whose square is 1.
    fn cover(&self, ray: &Ray, cuts: &[LeafCut], leaf: u32, surface: &mut SurfacePoint) {
        let own = surface.normal.abs().dot(surface.error);
        let needed = |cut: &LeafCut| {
            let solid = &self.leaves[cut.leaf as usize].solid;
            let other = solid.bare_surface(ray, cut.cut.t, cut.cut.part);
            let apart = other.normal.dot(surface.point - other.point).abs();
            apart + own + other.normal.abs().dot(other.error)
        };
        let others = cuts.iter().filter(|cut| cut.leaf != leaf);
        let largest = others.map(needed).fold(own, f64::max);
        surface.error += (largest - own) * surface.normal.abs();
    }

    /// The box around the solid, a little wider than computed; empty if nothing can be left of it.
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }
}

impl LeafCut {
    /// The cut with its part's number in the whole.
    fn of_whole(&self) -> Cut {
        Cut {
            t: self.cut.t,
            part: Csg::part(self.leaf, self.cut.part),
        }
    }
}

#[cfg(test)]
mod tests;
