//! A general quadric inside a box.
//!
//! The solid is where F <= 0 inside the box; the box's faces close it. As with the quadrics of revolution the ray is moved to
//! its closest approach, here to the middle of the box, and spans are cut with spans. The coefficients stay as they were
//! given: what they mean is known only to u times the size of their terms, and so is the surface: by that over |grad F|.

use super::moved::{Moved, on_ray};
use super::on_line::clipped;
use super::point::around;
use super::{QuadricForm, WALL};
use crate::geometry::{Aabb, Cut, Intersection, Span, Spans, SurfacePoint};
use crate::math::rounding::gamma;
use crate::math::{DVec2, DVec3, Interval, Ray};

/// All points of a box in which a form is not above 0. Outwards is where the form grows, and away from the box.
///
/// Its parts are the wall (0) and the faces of the box: low x (1), high x (2), low y (3), and so on. On the wall u runs once
/// around the vertical through the middle of the box, v from the box's bottom (0) to its top (1); on a face both run from 0
/// to 1, as on a [`crate::geometry::Cuboid`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxedQuadric {
    pub(super) form: QuadricForm,
    bounds: Aabb,
    weights: DVec3,
    /// The largest sum of the sizes of the form's terms in the box.
    magnitude: f64,
}

impl BoxedQuadric {
    /// The part of the solid `form <= 0` that lies in `bounds`.
    pub fn new(form: QuadricForm, bounds: Aabb) -> Self {
        let farthest = bounds.min.abs().max(bounds.max.abs());
        Self {
            form,
            bounds,
            weights: Moved::weights(bounds.size()),
            magnitude: form.magnitude(farthest),
        }
    }

    /// The word for a part.
    pub fn part_name(part: u32) -> &'static str {
        const NAMES: [&str; 7] = [
            "wall", "low x", "high x", "low y", "high y", "low z", "high z",
        ];
        NAMES.get(part as usize).copied().unwrap_or("wall")
    }

    /// Its equation.
    pub fn form(&self) -> QuadricForm {
        self.form
    }

    /// The box that closes it.
    pub fn closed_by(&self) -> Aabb {
        self.bounds
    }

    /// The spans of the ray's line inside.
    pub fn spans(&self, ray: &Ray) -> Spans {
        let moved = self.moved(ray);
        let pieces = self.form.on_line(&moved).inside();
        if pieces == [None; 2] {
            return Spans::none();
        }
        let Some(inside_box) = self.clip(&moved) else {
            return Spans::none();
        };
        clipped(pieces, inside_box, |cut| {
            moved.unmoved(cut, self.face(cut.part))
        })
    }

    /// The first crossing inside the interval.
    pub fn intersect(&self, ray: &Ray, interval: Interval) -> Intersection {
        self.spans(ray).first(interval)
    }

    /// Whether the ray goes in at a crossing at `t`; `None` if there is no crossing there.
    pub fn enters(&self, ray: &Ray, t: f64) -> Option<bool> {
        self.spans(ray).enters(t)
    }

    /// The box itself, which holds all of the solid, a little wider.
    pub fn bounds(&self) -> Aabb {
        let Aabb { min, max } = self.bounds;
        self.bounds.padded(gamma(16) * min.abs().max(max.abs()))
    }

    pub(super) fn moved(&self, ray: &Ray) -> Moved {
        Moved::to_closest(ray, self.bounds.center(), self.weights)
    }

    /// Where the line is in the box: in all three slabs. Source: Kay and Kajiya 1986. In a face it only touches.
    pub(super) fn clip(&self, line: &Moved) -> Option<Span> {
        let all = Span::between(f64::NEG_INFINITY, f64::INFINITY);
        (0..3).try_fold(all, |clip, axis| {
            let (o, d) = (line.origin[axis], line.direction[axis]);
            let (min, max) = (self.bounds.min[axis], self.bounds.max[axis]);
            if d == 0.0 {
                return (min < o && o < max).then_some(clip);
            }
            let cut = |part: usize, plane: f64| Cut {
                t: line.at_plane(axis, plane),
                part: part as u32,
            };
            let (low, high) = (cut(2 * axis + 1, min), cut(2 * axis + 2, max));
            let (enter, leave) = if d > 0.0 { (low, high) } else { (high, low) };
            (enter.t < leave.t)
                .then_some(Span { enter, leave })?
                .and(clip)
        })
    }

    /// The axis and the place of a face of the box; `None` for the wall.
    fn face(&self, part: u32) -> Option<(usize, f64)> {
        if part == WALL || part > 6 {
            return None;
        }
        let axis = (part as usize - 1) / 2;
        let low = part % 2 == 1;
        let plane = if low {
            self.bounds.min
        } else {
            self.bounds.max
        };
        Some((axis, plane[axis]))
    }

    /// The point at `t` of a part, pulled back onto it.
    pub fn surface(&self, ray: &Ray, t: f64, part: u32) -> SurfacePoint {
        let at = on_ray(ray, t).clamp(self.bounds.min, self.bounds.max);
        match self.face(part) {
            Some((axis, plane)) => self.on_face(at, axis, plane, part),
            None => self.on_wall(at),
        }
    }

    /// Two steps along the gradient, as Newton would take: the first leaves an error of its square.
    ///
    /// The bound: F is computed within gamma_12 of the sum of its terms' sizes, and so are A, B and C of the next test, each
    /// with at most gamma_14; together below gamma_32, divided by |grad F| to make a length of it.
    fn on_wall(&self, at: DVec3) -> SurfacePoint {
        let step = |p: DVec3| {
            let gradient = self.form.gradient(p);
            let moved = p - self.form.value(p) / gradient.length_squared() * gradient;
            if moved.is_finite() { moved } else { p }
        };
        let point = step(step(at));
        let gradient = self.form.gradient(point);
        let size = self.bounds.size();
        let off = gamma(32) * self.magnitude / gradient.length();
        let middle = self.bounds.center();
        SurfacePoint {
            point,
            error: DVec3::splat(off.min(size.max_element())),
            normal: gradient.normalize_or(DVec3::Y),
            uv: DVec2::new(
                around(point - middle),
                ((point.y - self.bounds.min.y) / size.y).clamp(0.0, 1.0),
            ),
        }
    }

    /// The point on a face of the box. What is rounded moves it along the face only.
    fn on_face(&self, mut point: DVec3, axis: usize, plane: f64, part: u32) -> SurfacePoint {
        point[axis] = plane;
        let mut normal = DVec3::ZERO;
        normal[axis] = if part % 2 == 1 { -1.0 } else { 1.0 };
        let mut error = gamma(3) * point.abs();
        error[axis] = 0.0;
        let place = (point - self.bounds.min) / self.bounds.size();
        SurfacePoint {
            point,
            error,
            normal,
            uv: DVec2::new(place[(axis + 1) % 3], place[(axis + 2) % 3]),
        }
    }
}
