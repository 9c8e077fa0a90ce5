//! Parametric patches: pieces of Bezier and NURBS surfaces, tested as they are, without triangles.
//!
//! A [`SurfacePatch`] is one leaf of a surface, tensor-product Bezier of degree 1 to 5 along u and v, rational or not. The test looks
//! along the ray ([`Shear`], as for triangles), where the patch is a map of the square (u, v) to the plane and the ray is a
//! point:
//! - `winding.rs` says from the four boundary curves alone how often the ray crosses, so that neighbours agree to the bit;
//! - `search.rs` finds the places, all of them;
//! - `evaluate.rs` gives the point and the normal there.
//!
//! [`BezierSurface`] and [`NurbsSurface`] are what scenes hold; they are cut into leaves once. A transform is applied to their
//! points before that, so that what was equal stays equal.
//!
//! **Watertight by the bits alone.** Leaves need to know nothing of each other: there is no table of seams and no tolerance.
//! A boundary curve with the same control points, in either order, is decided alike wherever it occurs.
//!
//! **What is rounded.** The test is right for a patch whose points were moved by at most 64 u (|P| + |o|): seeing a control point
//! from the ray's origin o takes 4 u, and halving a boundary curve up to 5 u of what is left of it each time, which shrinks by
//! half with each halving near the ray: 10 u of its length in all. Newton's method is right within gamma_32 of the leaf's
//! size as seen, across the ray; it moves a point, never decides whether there is one.

mod evaluate;
mod grid;
mod knots;
mod leaves;
mod outline;
mod search;
mod surface;
mod volume;
mod winding;

#[cfg(test)]
mod tests;

use glam::DVec4;
use smallvec::SmallVec;

use super::aabb::passes_ball_by_far;
use super::{Aabb, Intersection, Shear};
use crate::math::rounding::gamma;
use crate::math::{DVec2, DVec3, Interval};
use grid::ControlGrid;
pub use leaves::open_edges;
pub use search::{Fate, PatchPart, SearchStep};
pub use surface::{BezierSurface, NurbsSurface};
pub use volume::enclosed_volume;

/// A leaf of a parametric surface. Outwards is S_u x S_v.
///
/// Two patches whose boundary curves have the same control points, to the bit and in either order, are watertight: a ray
/// through their seam or corner crosses exactly one of them where the surface goes on, and both or none at a fold.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfacePatch {
    /// The number of control points along u and along v, 2 to 6.
    size: [usize; 2],
    /// The control points x, y, z, and their weights, in rows along u. They are multiplied last, so that equal points stay equal
    /// whatever their weights.
    control: Box<[DVec4]>,
    /// The lowest u and v of the whole surface that belong to this leaf.
    low: [f64; 2],
    /// The highest.
    high: [f64; 2],
    ball: Ball,
}

/// Ball around the control points.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Ball {
    center: DVec3,
    radius_squared: f64,
}

/// A place where a ray's line crosses a patch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatchCrossing {
    /// The ray parameter.
    pub t: f64,
    /// u and v in the leaf, 0 to 1.
    pub place: [f64; 2],
    /// True if the ray comes from the side that the normal points to: it goes into a closed body there.
    pub enters: bool,
}

/// The crossings of a line with a patch, by t.
pub type PatchCrossings = SmallVec<[PatchCrossing; 4]>;

/// What the test of a patch did, for whoever wants to see it.
#[derive(Clone, Debug, PartialEq)]
pub struct PatchArithmetic {
    /// The steps of the search in order.
    pub steps: Vec<SearchStep>,
    /// What came of them.
    pub crossings: PatchCrossings,
}

impl Ball {
    fn around(control: &[DVec4]) -> Self {
        let points = || control.iter().map(|p| p.truncate());
        let center = Aabb::around(points()).center();
        let squares = points().map(|p| p.distance_squared(center));
        Self {
            center,
            radius_squared: squares.fold(0.0, f64::max),
        }
    }

    /// True if the ray's line misses it by far. The line runs along (s.x, s.y, 1) on the axes of its view.
    fn is_passed_by_far(&self, shear: &Shear) -> bool {
        let f = (shear.origin - self.center).to_array();
        let [x, y, z] = shear.axes.map(|axis| f[axis]);
        let a = shear.s.x * shear.s.x + shear.s.y * shear.s.y + 1.0;
        let b = x * shear.s.x + y * shear.s.y + z;
        passes_ball_by_far([a, b, x * x + y * y + z * z], self.radius_squared)
    }
}

impl SurfacePatch {
    /// A leaf with `size` control points along u and v, over the part of the whole surface's u and v from `low` to `high`.
    fn new(size: [usize; 2], control: Box<[DVec4]>, [low, high]: [[f64; 2]; 2]) -> Self {
        let ball = Ball::around(&control);
        Self {
            size,
            control,
            low,
            high,
            ball,
        }
    }

    /// The first crossing inside the interval. Its place is [u, v, 0] in the leaf. Most rays that are asked here miss the ball around
    /// the control points, and need no view of them.
    #[inline(never)]
    pub fn intersect(&self, shear: &Shear, interval: Interval) -> Intersection {
        let mut found = Intersection::Miss;
        if self.ball.is_passed_by_far(shear) {
            return found;
        }
        for crossing in self.crossings(shear) {
            let [u, v] = crossing.place;
            match Intersection::classify(crossing.t, [u, v, 0.0], interval) {
                behind @ Intersection::Behind(_) => found = behind,
                other => return other,
            }
        }
        found
    }

    /// All crossings of the ray's line, before its origin as well, by t.
    #[inline(never)]
    pub fn crossings(&self, shear: &Shear) -> PatchCrossings {
        self.search(shear, |_| ())
    }

    /// The crossings, and each step of the search for them.
    pub fn arithmetic(&self, shear: &Shear) -> PatchArithmetic {
        let mut steps = Vec::new();
        let crossings = self.search(shear, |step| steps.push(step));
        PatchArithmetic { steps, crossings }
    }

    fn search(&self, shear: &Shear, note: impl FnMut(SearchStep)) -> PatchCrossings {
        let Some(view) = self.view(shear) else {
            return PatchCrossings::new();
        };
        let roots = search::roots(&view, note);
        if roots.is_empty() {
            return PatchCrossings::new();
        }
        let depths = self.depths(shear);
        let mut found: PatchCrossings = roots
            .iter()
            .map(|root| {
                let at = depths.at(root.place).value;
                PatchCrossing {
                    t: at.x / at.y,
                    place: root.place,
                    enters: root.in_front,
                }
            })
            .filter(|crossing| crossing.t.is_finite())
            .collect();
        found.sort_by(|a, b| a.t.total_cmp(&b.t));
        found
    }

    /// The control points as the ray sees them: w x' and w y' of the view in which the ray is the origin. Where both are 0,
    /// x' and y' are 0, so that a rational patch needs no division here. `None` if a number is not finite.
    ///
    /// A control point gets the same bits in every patch that has it. It is rounded as if it had been moved by 4 u of its
    /// distance from the ray's origin.
    fn view(&self, shear: &Shear) -> Option<ControlGrid<DVec2>> {
        let [x, y, z] = shear.axes;
        let origin = shear.origin.to_array();
        let mut size = 0.0f64;
        let mut sum = 0.0;
        let grid = ControlGrid::of(
            self.size,
            self.control.iter().map(|point| {
                let point = point.to_array();
                let from_origin = |axis: usize| point[axis] - origin[axis];
                let depth = from_origin(z);
                let seen = DVec2::new(
                    from_origin(x) - shear.s.x * depth,
                    from_origin(y) - shear.s.y * depth,
                );
                seen * point[3]
            }),
        );
        for p in grid.points() {
            size = size.max(p.x.abs()).max(p.y.abs());
            sum += p.x + p.y;
        }
        if !f64::is_finite(sum) {
            return None;
        }
        // Products of such numbers would overflow, or vanish. A power of two changes no other bit.
        if size > 1e100 {
            return Some(grid.map(|p| p * 0.5f64.powi(700)));
        }
        if size < 1e-100 {
            return Some(grid.map(|p| p * 2f64.powi(700)));
        }
        Some(grid)
    }

    /// The ray parameters of the control points times w, and w.
    fn depths(&self, shear: &Shear) -> ControlGrid<DVec2> {
        let z = shear.axes[2];
        let origin = shear.origin.to_array()[z];
        let seen = self.control.iter().map(DVec4::to_array);
        let seen = seen.map(|p| DVec2::new(shear.s.z * (p[z] - origin), 1.0) * p[3]);
        ControlGrid::of(self.size, seen)
    }

    /// A box around the patch: that of its control points, a little wider, since they are rounded.
    pub fn bounds(&self) -> Aabb {
        let bounds = Aabb::around(self.control.iter().map(|p| p.truncate()));
        bounds.padded(gamma(64) * bounds.min.abs().max(bounds.max.abs()))
    }

    /// The part of the whole surface's u and v that this leaf covers: its lowest and highest corner.
    pub fn range(&self) -> [[f64; 2]; 2] {
        [self.low, self.high]
    }

    /// The degrees along u and along v.
    pub fn degree(&self) -> [usize; 2] {
        self.size.map(|n| n - 1)
    }

    /// The control points and their weights, in rows along u.
    pub fn control_points(&self) -> impl Iterator<Item = (DVec3, f64)> + '_ {
        self.control.iter().map(|p| (p.truncate(), p.w))
    }
}
