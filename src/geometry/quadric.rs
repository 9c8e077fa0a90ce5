//! The quadric of revolution: cylinder, cone, paraboloid and hyperboloid, by one equation.
//!
//! Each stands in its own frame: the middle is the origin, the axis is y, and the shape lies between y = -h and y = +h. It is
//! all points with F = x^2 + z^2 - R(y)^2 <= 0, where the radius R depends on the kind (`profile`). A point o + t d of a ray
//! makes of F a quadratic in t (`on_line`); where that is negative the line is inside; the two planes cut this to the shape.
//!
//! Three decisions keep the answers right at any distance. (1) The ray's origin is first moved along the ray to where it comes
//! closest to the shape, so numbers are as large as the shape there, not as the way to it (`moved`). (2) The roots are taken
//! without subtracting numbers that nearly agree (`on_line`). (3) Wall and caps are never tested one by one: spans are cut with
//! spans, so a line crosses a rim evenly, whatever is rounded (Roth 1982, "Ray casting for modeling solids").
//!
//! What a wrong answer takes: A, B and C are off by a few u of their terms, e.g. C by gamma_5 (p.p + R^2). F grows by |grad F|
//! a length, so that is as if the shape had been moved by a few u of its size. A line that passes farther from tangency, from
//! the rim and from the apex than that is told right, from any distance. Each t is then rounded to u |t|, twice at most; so
//! pieces of line about as short as the spacing of the floats at t are lost: they have no two different t.

mod boxed;
mod form;
mod moved;
mod on_line;
mod point;
mod profile;
mod school;
mod steps;

pub use boxed::BoxedQuadric;
pub use form::QuadricForm;
pub use steps::QuadricSteps;

use self::moved::Moved;
use self::on_line::clipped;
use self::profile::Profile;
use super::{Aabb, Cut, Intersection, Span, Spans};
use crate::math::rounding::gamma;
use crate::math::{DVec3, Interval, Ray};

/// The number of the wall among the parts of a quadric.
const WALL: u32 = 0;
/// The cap at y = -h.
const BASE: u32 = 1;
/// The cap at y = +h.
const TOP: u32 = 2;

/// How many pieces a hyperboloid is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sheets {
    /// One, with a waist: a cooling tower.
    One,
    /// Two bowls with a gap between their vertices.
    Two,
}

/// The kind of a quadric of revolution, with the lengths that make it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum QuadricKind {
    /// A cylinder.
    Cylinder {
        /// The radius.
        radius: f64,
    },
    /// A cone.
    Cone {
        /// The radius at y = -h.
        radius: f64,
        /// The radius at y = +h.
        top_radius: f64,
    },
    /// A paraboloid.
    Paraboloid {
        /// The radius at y = +h.
        radius: f64,
    },
    /// A hyperboloid.
    Hyperboloid {
        /// The radius at y = 0, or half the gap between two sheets.
        waist: f64,
        /// The radius at both ends.
        radius: f64,
        /// One or two.
        sheets: Sheets,
    },
}

/// A cylinder, cone, paraboloid or hyperboloid around the y axis, from y = -h to y = +h. Outwards is away from the inside.
///
/// The wall's u runs once around, v from the base (0) to the top (1); a cap's v from its centre (0) to its rim (1). Its parts
/// are the wall (0), the base (1) and the top (2). All lengths are above 0 and finite; others give misses, or nonsense.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadric {
    profile: Profile,
    half_height: f64,
    /// 1/r^2 and 1/h^2, to measure in multiples of the size.
    weights: DVec3,
    /// The largest radius: that of a rim, or of the middle of a barrel.
    max_radius: f64,
    closed: bool,
    kind: QuadricKind,
}

impl Quadric {
    fn new(kind: QuadricKind, profile: Profile, half_height: f64) -> Self {
        let radius = |y| profile.radius(y);
        let max_radius = radius(-half_height)
            .max(radius(0.0))
            .max(radius(half_height));
        Self {
            profile,
            half_height,
            max_radius,
            weights: Moved::weights(DVec3::new(max_radius, half_height, max_radius)),
            closed: true,
            kind,
        }
    }

    /// The closed cylinder of a radius.
    pub fn cylinder(radius: f64, half_height: f64) -> Self {
        let profile = Profile::straight(radius, radius, half_height);
        Self::new(QuadricKind::Cylinder { radius }, profile, half_height)
    }

    /// The closed cone whose radius changes evenly from the bottom to the top. One of the two may be 0.
    pub fn cone(bottom_radius: f64, top_radius: f64, half_height: f64) -> Self {
        let profile = Profile::straight(bottom_radius, top_radius, half_height);
        let kind = QuadricKind::Cone {
            radius: bottom_radius,
            top_radius,
        };
        Self::new(kind, profile, half_height)
    }

    /// The closed paraboloid with its vertex at y = -h and a rim of `radius` at y = +h: x^2 + z^2 = radius^2 (y + h) / 2h.
    pub fn paraboloid(radius: f64, half_height: f64) -> Self {
        let profile = Profile::paraboloid(radius, half_height);
        Self::new(QuadricKind::Paraboloid { radius }, profile, half_height)
    }

    /// The closed hyperboloid with rims of `radius` at y = -h and y = +h.
    ///
    /// One sheet: `waist` is the radius at y = 0 (above `radius` it makes a barrel, a zone of an ellipsoid). Two sheets:
    /// `waist` is half the gap between the vertices, from 0 (a double cone) to less than `half_height`.
    pub fn hyperboloid(waist: f64, radius: f64, half_height: f64, sheets: Sheets) -> Self {
        let profile = match sheets {
            Sheets::One => Profile::one_sheet(waist, radius, half_height),
            Sheets::Two => Profile::two_sheets(waist, radius, half_height),
        };
        let kind = QuadricKind::Hyperboloid {
            waist,
            radius,
            sheets,
        };
        Self::new(kind, profile, half_height)
    }

    /// The wall without caps: a surface, no solid.
    #[must_use]
    pub fn open(self) -> Self {
        Self {
            closed: false,
            ..self
        }
    }

    /// True if it bounds a part of space: if it has its caps.
    pub fn is_solid(&self) -> bool {
        self.closed
    }

    /// Its kind, with the lengths that it was made of.
    pub fn given(&self) -> QuadricKind {
        self.kind
    }

    /// Half the distance of its ends.
    pub fn half_height(&self) -> f64 {
        self.half_height
    }

    /// The radius at a height y; 0 where there is no surface.
    pub fn radius_at(&self, y: f64) -> f64 {
        self.profile.radius(y)
    }

    /// The word for its kind.
    pub fn kind(&self) -> &'static str {
        match self.kind {
            QuadricKind::Cylinder { .. } => "cylinder",
            QuadricKind::Cone { .. } => "cone",
            QuadricKind::Paraboloid { .. } => "paraboloid",
            QuadricKind::Hyperboloid { .. } => "hyperboloid",
        }
    }

    /// The word for a part.
    pub fn part_name(part: u32) -> &'static str {
        match part {
            WALL => "wall",
            BASE => "base",
            _ => "top",
        }
    }

    /// The spans of the ray's line inside; none if it has no caps.
    pub fn spans(&self, ray: &Ray) -> Spans {
        if self.closed {
            self.spans_if_closed(ray)
        } else {
            Spans::none()
        }
    }

    /// The first crossing inside the interval.
    #[inline]
    pub fn intersect(&self, ray: &Ray, interval: Interval) -> Intersection {
        self.first(&self.spans_if_closed(ray), interval)
    }

    /// The first cut of these spans that is one of the shape's.
    fn first(&self, spans: &Spans, interval: Interval) -> Intersection {
        if self.closed {
            return spans.first(interval);
        }
        // Without caps only the cuts at the wall remain. A cut at the very rim belongs to the wall (`Span::and`), and only if
        // a piece of line inside has an end there, so of two that stand on one another just one is crossed at their rim.
        let mut found = Intersection::Miss;
        for (cut, _) in spans.cuts().filter(|(cut, _)| cut.part == WALL) {
            match cut.classify(interval) {
                behind @ Intersection::Behind(_) => found = behind,
                other => return other,
            }
        }
        found
    }

    /// Whether the ray goes in at a crossing at `t` (without caps: comes nearer to the axis than the wall); `None` if there is
    /// no crossing there.
    pub fn enters(&self, ray: &Ray, t: f64) -> Option<bool> {
        let spans = self.spans_if_closed(ray);
        let mut cuts = spans.cuts().filter(|(cut, _)| self.has(cut.part));
        cuts.find_map(|(cut, enters)| (cut.t == t).then_some(enters))
    }

    fn has(&self, part: u32) -> bool {
        self.closed || part == WALL
    }

    /// The pieces of the line where F < 0, cut with the slab between the two planes.
    fn spans_if_closed(&self, ray: &Ray) -> Spans {
        let moved = self.moved(ray);
        let pieces = self.profile.on_line(&moved).inside();
        if pieces == [None; 2] {
            return Spans::none();
        }
        let Some(slab) = self.slab(&moved) else {
            return Spans::none();
        };
        clipped(pieces, slab, |cut| moved.unmoved(cut, self.plane(cut.part)))
    }

    /// The ray moved to where it comes closest to the narrowest place of the shape: the smaller end of a cone, the middle of
    /// others. What is rounded there is as small as the shape is there, so the apex of a cone is as sharp as its rim.
    fn moved(&self, ray: &Ray) -> Moved {
        let narrow = DVec3::new(0.0, self.profile.narrow_end() * self.half_height, 0.0);
        Moved::to_closest(ray, narrow, self.weights)
    }

    /// Where the line lies between the planes y = -h and y = +h. A line in one of them only touches: it misses.
    fn slab(&self, line: &Moved) -> Option<Span> {
        let (h, d) = (self.half_height, line.direction.y);
        if d == 0.0 {
            let inside = line.origin.y.abs() < h;
            return inside.then(|| Span::between(f64::NEG_INFINITY, f64::INFINITY));
        }
        let cut = |part, plane: f64| Cut {
            t: line.at_plane(1, plane),
            part,
        };
        let (base, top) = (cut(BASE, -h), cut(TOP, h));
        let (enter, leave) = if d > 0.0 { (base, top) } else { (top, base) };
        (enter.t < leave.t).then_some(Span { enter, leave })
    }

    /// The axis and the height of a cap's plane; `None` for the wall.
    fn plane(&self, part: u32) -> Option<(usize, f64)> {
        match part {
            BASE => Some((1, -self.half_height)),
            TOP => Some((1, self.half_height)),
            _ => None,
        }
    }

    /// Its volume; 0 without caps.
    pub fn volume(&self) -> f64 {
        if self.closed {
            self.profile.volume(self.half_height)
        } else {
            0.0
        }
    }

    /// The box around it, a little wider than computed.
    pub fn bounds(&self) -> Aabb {
        let (r, h) = (self.max_radius, self.half_height);
        let max = DVec3::new(r, h, r);
        Aabb { min: -max, max }.padded(DVec3::splat(gamma(16) * (r + h)))
    }
}

#[cfg(test)]
mod tests;
