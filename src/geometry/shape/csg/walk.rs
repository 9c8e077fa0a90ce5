//! The walk along a ray through the cuts of all leaves, those that rounding cannot tell apart taken as one.
//!
//! What that does to the answer: it is right for leaves of which each is moved, at right angles, by less than the width of its
//! group. Two cuts are neighbours in a group if they are apart by no more than the sum of their errors; each error is about
//! 6 u (|o| + |t d|) and what the surface gives as its own. So groups are not wider than the thickness that accelerators give to
//! planes and boxes, unless tens of surfaces follow each other within rounding. What is left undecided are rays that run within
//! rounding inside of a common face: one leaf may be met all along it, and the other one not at all.

use std::ops::Range;

use smallvec::SmallVec;

use super::Csg;
use crate::geometry::Cut;
use crate::math::Ray;
use crate::math::rounding::gamma;

/// A cut of a leaf.
#[derive(Clone, Copy, Debug)]
pub(super) struct LeafCut {
    pub cut: Cut,
    pub leaf: u32,
    pub enters: bool,
}

/// The cuts of all leaves by t. 64 convex leaves need no memory from the heap.
#[derive(Debug, Default)]
pub(super) struct CutList {
    pub cuts: SmallVec<[LeafCut; 128]>,
    /// The leaves that the line is inside of before all cuts.
    pub before: u64,
    /// The leaves that were asked; the others cannot matter.
    pub asked: u64,
}

/// Cuts that are crossed as one.
#[derive(Clone, Debug)]
pub(super) struct CutGroup {
    /// Where they stand in the list.
    pub members: Range<usize>,
    /// The cut that stands for all, if the line goes into the whole or comes out of it here.
    pub chosen: Option<usize>,
}

/// How well the place of a cut is known.
#[derive(Clone, Copy)]
pub(super) struct Sharpness {
    /// How far the ray moves along the surface's normal in a unit of t, in metres.
    pub steepness: f64,
    /// How far the point of the ray may be off the true surface, along the normal, in metres.
    pub error: f64,
}

/// The groups of a list, one after the other.
pub(super) struct Walk<'a> {
    csg: &'a Csg,
    ray: &'a Ray,
    list: &'a CutList,
    next: usize,
    set: u64,
    is_inside: bool,
    /// That of the cut `next`, if it is known already.
    sharpness: Option<Sharpness>,
}

impl LeafCut {
    /// The set after this cut.
    #[inline]
    pub fn after(&self, set: u64) -> u64 {
        let bit = 1 << self.leaf;
        if self.enters { set | bit } else { set & !bit }
    }
}

impl CutList {
    /// Puts a cut into its place: behind those of the same t, so that the order of leaves decides.
    #[inline]
    fn insert(&mut self, new: LeafCut) {
        let is_before = |old: &LeafCut| old.cut.t <= new.cut.t;
        let place = self.cuts.iter().rposition(is_before);
        self.cuts.insert(place.map_or(0, |last| last + 1), new);
    }
}

impl Csg {
    /// Collects the cuts of all leaves that can matter, into an empty list. (The list is large, so it is not handed around.)
    pub(super) fn collect(&self, ray: &Ray, list: &mut CutList) {
        let mut met = 0u64;
        for (leaf, placed) in (0..).zip(&self.leaves) {
            if placed.needs.iter().any(|needed| needed & met == 0) {
                continue;
            }
            list.asked |= 1 << leaf;
            let spans = placed.solid.spans(ray);
            // A span whose ends are not in order, or not numbers, is none.
            for span in spans.0.iter().filter(|span| span.enter.t < span.leave.t) {
                met |= 1 << leaf;
                if span.enter.t == f64::NEG_INFINITY {
                    list.before |= 1 << leaf;
                }
                for (cut, enters) in [(span.enter, true), (span.leave, false)] {
                    if cut.t.is_finite() {
                        list.insert(LeafCut { cut, leaf, enters });
                    }
                }
            }
        }
    }

    /// How well the place of a cut is known. The ray's exact point at the rounded t is off the true surface by no more than:
    /// what is seen between the point as computed and the surface's own point, plus what may be rounded in the former, gamma_3
    /// of its summands, plus the error of the latter. All is measured along the normal. So this holds for every shape and
    /// however far the origin is, without knowing how t was computed.
    #[inline]
    pub(super) fn sharpness(&self, ray: &Ray, cut: &LeafCut) -> Sharpness {
        let t = cut.cut.t;
        let solid = &self.leaves[cut.leaf as usize].solid;
        let surface = solid.bare_surface(ray, t, cut.cut.part);
        let n = surface.normal;
        let rounded = gamma(3) * (ray.origin.abs() + (t * ray.direction).abs());
        Sharpness {
            steepness: n.dot(ray.direction).abs(),
            error: n.dot(ray.at(t) - surface.point).abs() + n.abs().dot(rounded + surface.error),
        }
    }
}

impl Sharpness {
    /// True if two cuts that are `gap` apart cannot be told apart: the gap, measured at right angles to the steeper of the two
    /// surfaces, is within the errors of both.
    #[inline]
    fn touches(self, other: Self, gap: f64) -> bool {
        gap == 0.0 || gap * self.steepness.max(other.steepness) <= self.error + other.error
    }
}

impl<'a> Walk<'a> {
    /// The walk through the cuts of `ray`, which are `list`.
    pub fn new(csg: &'a Csg, ray: &'a Ray, list: &'a CutList) -> Self {
        Self {
            csg,
            ray,
            list,
            next: 0,
            set: list.before,
            is_inside: csg.is_inside(list.before),
            sharpness: None,
        }
    }

    /// The end of the group that starts at `next`: a cut belongs to it if it cannot be told from any cut of it.
    #[inline]
    fn end_of_group(&mut self) -> usize {
        let cuts = &self.list.cuts;
        let of = |i: usize| self.csg.sharpness(self.ray, &cuts[i]);
        let (first, mut end) = (self.next, self.next + 1);
        let known = self.sharpness.take();
        if end == cuts.len() {
            return end;
        }
        let mut group: SmallVec<[Sharpness; 8]> = SmallVec::new();
        group.push(known.unwrap_or_else(|| of(first)));
        while end < cuts.len() {
            let new = of(end);
            let gap = |i: usize| cuts[end].cut.t - cuts[first + i].cut.t;
            let mut members = group.iter().enumerate();
            if !members.any(|(i, member)| member.touches(new, gap(i))) {
                self.sharpness = Some(new);
                break;
            }
            group.push(new);
            end += 1;
        }
        end
    }

    /// The cut of a group that stands for it, where the answer changes between the sets `before` and `after`.
    ///
    /// It is a cut of the leaf whose own change, from before or to after, changes the answer: of many the first leaf. If each
    /// needs others as well, the leaves that work towards the new answer are changed one by one; that which brings it about is
    /// taken. Since more of a leaf never makes less of the whole (or, if it is subtracted, never more), the chosen cut goes in
    /// where the whole is entered, or the other way round if it is subtracted: the normal is right.
    fn choose(&self, members: &Range<usize>, [before, after]: [u64; 2]) -> Option<usize> {
        let becomes = !self.is_inside;
        let flipped = |leaf: &u32| (before ^ after) >> leaf & 1 == 1;
        let leaves = (0..self.csg.leaves.len() as u32).filter(flipped);
        let decides = |leaf: &u32| {
            let bit = 1 << leaf;
            self.csg.is_inside(before ^ bit) == becomes
                || self.csg.is_inside(after ^ bit) != becomes
        };
        let mut set = before;
        let brings_about = |leaf: &u32| {
            let enters = after >> leaf & 1 == 1;
            let helps = (enters != self.csg.is_subtracted(*leaf)) == becomes;
            set ^= if helps { 1 << leaf } else { 0 };
            helps && self.csg.is_inside(set) == becomes
        };
        let leaf = leaves
            .clone()
            .find(decides)
            .or_else(|| leaves.clone().find(brings_about))?;
        let enters = after >> leaf & 1 == 1;
        let stands = |i: &usize| {
            let cut = &self.list.cuts[*i];
            cut.leaf == leaf && cut.enters == enters
        };
        members.clone().find(stands)
    }
}

impl Iterator for Walk<'_> {
    type Item = CutGroup;

    #[inline]
    fn next(&mut self) -> Option<CutGroup> {
        if self.next == self.list.cuts.len() {
            return None;
        }
        let members = self.next..self.end_of_group();
        let cuts = &self.list.cuts[members.clone()];
        let after = cuts.iter().fold(self.set, |set, cut| cut.after(set));
        let changes = self.csg.is_inside(after) != self.is_inside;
        let chosen = match cuts {
            _ if !changes => None,
            [_] => Some(members.start),
            _ => self.choose(&members, [self.set, after]),
        };
        self.next = members.end;
        self.set = after;
        self.is_inside ^= changes;
        Some(CutGroup { members, chosen })
    }
}
