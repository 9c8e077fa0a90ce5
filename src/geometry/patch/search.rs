//! All places where a ray crosses a patch: parts that cannot be met are dropped, parts that fold are halved, and in a part that
//! maps one to one Newton's method finds the place.
//!
//! Seen along the ray, the patch is a map of (u, v) to the plane, given by its grid of control points, and the ray is the
//! origin. Who owns a place at a seam is not asked here: [`super::winding`] decides how often a part is crossed, and what is
//! computed has to agree with it. So a rounded place can be a few bits off, but it is never lost and never found twice.
//! Sources: Toth 1985, "On ray tracing parametric surfaces" (isolate, then steer); Nishita, Sederberg and Kakimoto 1990,
//! "Ray tracing trimmed rational surface patches" (lines along the net's own directions).

use smallvec::SmallVec;

use super::grid::ControlGrid;
use super::outline::{Strip, for_each_step, length, maps_one_to_one, mean_step, size};
use super::winding::winding;
use crate::math::DVec2;
use crate::math::rounding::{UNIT_ROUNDOFF, gamma};

/// How often a part is halved along u, and along v, at most: then it is smaller than the last bits of u and v.
const MAX_HALVINGS: u32 = 50;

/// How many parts are looked at, at most. A ray at random takes one or two, one along a fold about a hundred.
const MAX_PARTS: u32 = 4000;

/// A place where the ray crosses the patch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Root {
    /// u and v in the patch, 0 to 1.
    pub place: [f64; 2],
    /// True if the patch is met from the side that its normal S_u x S_v points to.
    pub in_front: bool,
}

/// The places found; a folded patch may have several.
pub type PatchRoots = SmallVec<[Root; 4]>;

/// A part of the square of u and v, by halving.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatchPart {
    /// The lowest u and v.
    pub low: [f64; 2],
    /// How often it was halved along u and along v.
    pub halvings: [u32; 2],
}

/// What became of a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
pub enum Fate {
    /// A line through the ray has all control points on one side.
    Beside,
    /// It maps one to one, and its boundary does not run around the ray.
    Outside,
    /// It is seen so thin that two crossings cannot be told from none, and its boundary does not run around the ray.
    Touched,
    /// Newton's method found the place.
    Solved,
    /// It was halved along u.
    HalvedAlongU,
    /// It was halved along v.
    HalvedAlongV,
    /// It can not be made smaller; its middle is the place, if there is one.
    Smallest,
}

/// A step of the search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SearchStep {
    /// A step of Newton's method.
    Newton {
        /// u and v.
        place: [f64; 2],
        /// How far the patch is from the ray there, in the ray's own view.
        residual: f64,
    },
    /// The end of looking at a part.
    Part(PatchPart, Fate),
}

/// All places where the origin of the view lies on `grid`; `note` is told each step.
pub fn roots(grid: &ControlGrid<DVec2>, note: impl FnMut(SearchStep)) -> PatchRoots {
    let size = size(grid);
    let mut search = Search {
        whole: grid,
        size,
        parts: 0,
        roots: PatchRoots::new(),
        note,
    };
    let whole = PatchPart {
        low: [0.0; 2],
        halvings: [0; 2],
    };
    search.part(grid, whole, gamma(4) * size);
    search.roots
}

struct Search<'a, N> {
    whole: &'a ControlGrid<DVec2>,
    /// The largest coordinate.
    size: f64,
    parts: u32,
    roots: PatchRoots,
    note: N,
}

impl<N: FnMut(SearchStep)> Search<'_, N> {
    /// Looks at a part with control points `grid`, each known within `error`.
    fn part(&mut self, grid: &ControlGrid<DVec2>, part: PatchPart, error: f64) {
        self.parts += 1;
        let fate = self.fate(grid, part, error);
        (self.note)(SearchStep::Part(part, fate));
        let axis = match fate {
            Fate::HalvedAlongU => 0,
            Fate::HalvedAlongV => 1,
            _ => return,
        };
        // Each of the up to 5 steps of a halving rounds once.
        let error = error + (grid.size[axis] - 1) as f64 * UNIT_ROUNDOFF * size(grid);
        for (half, part) in grid.halves(axis).iter().zip(part.halves(axis)) {
            self.part(half, part, error);
        }
    }

    fn fate(&mut self, grid: &ControlGrid<DVec2>, part: PatchPart, error: f64) -> Fate {
        let size = size(grid);
        let axes = [DVec2::X, DVec2::Y].map(|axis| Strip::of(grid, axis, size));
        if axes[0].is_beside() || axes[1].is_beside() {
            return Fate::Beside;
        }
        if maps_one_to_one(grid) {
            let turns = winding(grid, part.halvings);
            if turns == 0 {
                return Fate::Outside;
            }
            if let Some(place) = self.newton(part) {
                self.found(place, turns);
                return Fate::Solved;
            }
        } else {
            let own = [0, 1].map(|axis| Strip::of(grid, mean_step(grid, axis), size));
            if own[0].is_beside() || own[1].is_beside() {
                return Fate::Beside;
            }
            let thin = axes.iter().chain(&own).any(|strip| strip.is_thin(error));
            if thin && winding(grid, part.halvings) == 0 {
                return Fate::Touched;
            }
        }
        match part.longer_axis(grid) {
            Some(0) if self.parts < MAX_PARTS => Fate::HalvedAlongU,
            Some(_) if self.parts < MAX_PARTS => Fate::HalvedAlongV,
            _ => {
                self.found(part.middle(), winding(grid, part.halvings));
                Fate::Smallest
            }
        }
    }

    /// Adds a place that the boundary runs around so many times. Around a crossing from the back the map keeps the sense of
    /// (u, v), so that the boundary runs counter-clockwise.
    fn found(&mut self, place: [f64; 2], turns: i32) {
        for _ in 0..turns.unsigned_abs() {
            let in_front = turns < 0;
            self.roots.push(Root { place, in_front });
        }
    }

    /// Newton's method from the middle of the part, kept inside it. `None` if a step does not at least halve the distance while
    /// that is more than rounding: the part must then be made smaller.
    ///
    /// A value of the map takes up to 10 mixes with 3 roundings each, of numbers up to `size`.
    fn newton(&mut self, part: PatchPart) -> Option<[f64; 2]> {
        let (exact, close) = (gamma(4) * self.size, gamma(32) * self.size);
        let mut best = (f64::INFINITY, [f64::NAN; 2]);
        let mut place = part.middle();
        loop {
            let jet = self.whole.at(place);
            let residual = jet.value.abs().max_element();
            (self.note)(SearchStep::Newton { place, residual });
            let halved = residual < 0.5 * best.0;
            if residual < best.0 {
                best = (residual, place);
            }
            if best.0 <= exact || !halved {
                return (best.0 <= close).then_some(best.1);
            }
            // f + f_u du + f_v dv = 0, by Cramer's rule.
            let area = jet.du.perp_dot(jet.dv);
            let step = [
                jet.dv.perp_dot(jet.value) / area,
                jet.value.perp_dot(jet.du) / area,
            ];
            place = part.clamped([place[0] + step[0], place[1] + step[1]]);
        }
    }
}

impl PatchPart {
    fn size(self, axis: usize) -> f64 {
        0.5f64.powi(self.halvings[axis].cast_signed())
    }

    fn middle(self) -> [f64; 2] {
        [0, 1].map(|axis| self.low[axis] + 0.5 * self.size(axis))
    }

    fn clamped(self, place: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| {
            let low = self.low[axis];
            place[axis].max(low).min(low + self.size(axis))
        })
    }

    fn halves(self, axis: usize) -> [Self; 2] {
        let (mut low, mut high) = (self, self);
        low.halvings[axis] += 1;
        high.halvings[axis] += 1;
        high.low[axis] += high.size(axis);
        [low, high]
    }

    /// The axis along which the part looks longer, of those along which it may still be halved.
    fn longer_axis(self, grid: &ControlGrid<DVec2>) -> Option<usize> {
        let length = |axis| {
            let mut sum = 0.0;
            for_each_step(grid, axis, |step| sum += length(step));
            sum / grid.size[1 - axis] as f64
        };
        match self.halvings.map(|n| n < MAX_HALVINGS) {
            [true, true] => Some(usize::from(length(1) > length(0))),
            [true, false] => Some(0),
            [false, true] => Some(1),
            [false, false] => None,
        }
    }
}
