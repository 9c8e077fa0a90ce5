//! Rays and boxes in single precision, and why no hit is lost.
//!
//! The tree's boxes are moved and scaled so that they lie in [-1, 1] (in double precision), then rounded outwards to
//! single precision. A ray is moved and scaled alike; if it starts far away it is first brought near, in double
//! precision. There t becomes t' = (t - start) rate, which is never negative inside the interval.
//!
//! In units of u = 2^-24, and with r the largest coordinate of the ray's origin, a plane's t' = plane / d - o / d is
//! as wrong as if the plane was off by: rounding o (r), rounding d (1 + r), moving d off zero (less than 1 + r),
//! rounding 1/d (1 + r), o / d (r), its sum with the pad (r + 1), plane / d (1) and the difference (2 + r); in all
//! 7 r + 8. Every plane is moved outwards by the double, 16 (1 + r), and by the tolerance that the shapes' tests need.
//! So a box that holds a hit is entered at or before that hit's t' and left at or after it, as computed.

use crate::accel::tolerance::Tolerance;
use crate::geometry::Aabb;
use crate::math::{DVec3, Interval, Ray};

/// 2^-24, the unit roundoff of `f32`.
pub const U: f64 = f32::EPSILON as f64 / 2.0;

/// Shapes with larger coordinates count as unbounded: products of four lengths must not overflow.
pub const MAX_COORDINATE: f64 = 1e60;

/// Rays that start farther away, in units of half the scene, are brought near.
pub const FAR: f64 = 16.0;

/// No direction is flatter, so its inverse stays finite: 2^-40. Over the scene that is an error of less than u.
pub const FLATTEST: f32 = 1.0 / (1u64 << 40) as f32;

/// The space in which a structure fills [-1, 1], and where it lies in the world.
#[derive(Clone, Copy, Debug)]
pub struct UnitBox {
    /// Around all that is in the tree.
    bounds: Aabb,
    pub center: DVec3,
    pub scale: f64,
    pub tolerance: Tolerance,
}

/// A ray in the tree's space.
#[derive(Clone, Copy, Debug)]
pub struct LocalRay {
    /// Where it starts, and how far every plane is moved outwards.
    pub origin: [f32; 3],
    pub pad: f32,
    /// Where it goes, moved off the axes by no less than [`FLATTEST`].
    pub direction: [f32; 3],
    /// 1 / direction; never 0, infinite or NaN.
    pub inverse: [f32; 3],
    /// Near planes are at t' = plane inverse - near, far ones at plane inverse - far.
    pub near: [f32; 3],
    pub far: [f32; 3],
    /// 1 where the direction is negative, so that the near plane is the larger one.
    pub negative: [usize; 3],
    /// t' = (t - start) rate.
    pub start: f64,
    pub rate: f64,
    /// The part of the ray that counts, rounded outwards; min is not negative.
    pub min: f32,
    pub max: f32,
}

/// A ray in the space of a structure, if it is there at all.
pub enum Localized {
    /// Nothing: it misses everything.
    Miss,
    /// It must be tested against everything: no useful bound is known.
    Unbounded,
    /// It is traced through the structure.
    Ray(LocalRay),
}

impl UnitBox {
    /// The space in which `bounds` fills [-1, 1].
    pub fn new(bounds: Aabb, tolerance: Tolerance) -> Self {
        // Not smaller than the tolerance is thick: there is nothing to tell apart.
        let half = 0.5 * bounds.size().max_element();
        let least = 16.0 * tolerance.for_origin(DVec3::ZERO);
        Self {
            bounds,
            center: bounds.center(),
            scale: 1.0 / half.max(least).max(1e-150),
            tolerance,
        }
    }

    /// A point of the world in this space.
    pub fn to_local(self, p: DVec3) -> DVec3 {
        (p - self.center) * self.scale
    }

    /// A point of this space in the world.
    pub fn to_world(self, p: [f32; 3]) -> DVec3 {
        self.center + DVec3::from(p.map(f64::from)) / self.scale
    }

    /// For the plane n.p = d of this space, the d of the same plane in world space.
    pub fn plane_to_world(&self, n: DVec3, d: f64) -> f64 {
        n.dot(self.center) + d / self.scale
    }

    /// A world space box, rounded outwards.
    pub fn outwards(&self, b: Aabb) -> ([f32; 3], [f32; 3]) {
        let inside = |p: DVec3| ((p - self.center) * self.scale).to_array();
        let (min, max) = (inside(b.min), inside(b.max));
        (min.map(round_down), max.map(round_up))
    }

    /// A point in this space, rounded.
    #[inline(always)]
    pub fn point(&self, p: DVec3) -> [f32; 3] {
        ((p - self.center) * self.scale).as_vec3().to_array()
    }

    /// True if rays of this rate neither overflow nor vanish, nor do areas: else no useful bound is known.
    #[inline(always)]
    pub fn is_usable(rate: f64) -> bool {
        rate > 1e-100 && rate < 1e100
    }

    /// A ray in this space.
    #[inline(always)]
    pub fn localize(&self, ray: &Ray, interval: Interval) -> Localized {
        if interval.min.partial_cmp(&interval.max) != Some(std::cmp::Ordering::Less) {
            return Localized::Miss;
        }
        let longest = ray.direction.abs().max_element();
        let unit = if (0.5..=1.0).contains(&longest) {
            1.0
        } else {
            longest
        };
        let rate = self.scale * unit;
        let usable = Self::is_usable(self.scale) && Self::is_usable(rate);
        if !usable || !ray.direction.is_finite() || !ray.origin.is_finite() {
            return Localized::Unbounded;
        }
        let tolerance = self.tolerance.for_origin(ray.origin);
        let (mut start, mut o) = (0.0, (ray.origin - self.center) * self.scale);
        let near = |o: DVec3| o.abs().max_element() <= FAR;
        if !near(o) || interval.min < 0.0 {
            let bounds = self.bounds.padded(DVec3::splat(tolerance));
            let Some(inside) = bounds.clip(ray, interval) else {
                return Localized::Miss;
            };
            start = inside.min;
            o = (ray.at(start) - self.center) * self.scale;
        }
        let pad = tolerance * self.scale + 16.0 * U * (1.0 + o.abs().max_element());
        let known = near(o) && pad < 1.0;
        if !known {
            return Localized::Unbounded;
        }

        let (origin, pad) = (o.as_vec3().to_array(), round_up(pad));
        let d = if unit == 1.0 {
            ray.direction
        } else {
            ray.direction / unit
        };
        let direction = d.to_array().map(|d| nonzero(d as f32));
        let inverse = direction.map(|d| 1.0 / d);
        let on = |side: f32| {
            std::array::from_fn(|k| origin[k] * inverse[k] + side * pad * inverse[k].abs())
        };
        Localized::Ray(LocalRay {
            origin,
            pad,
            direction,
            inverse,
            near: on(1.0),
            far: on(-1.0),
            negative: inverse.map(|i| usize::from(i < 0.0)),
            start,
            rate,
            min: round_down((interval.min - start) * rate).max(0.0),
            max: round_up((interval.max - start) * rate),
        })
    }
}

impl LocalRay {
    /// A t' that is not before a hit at t.
    #[inline(always)]
    pub fn not_before(&self, t: f64) -> f32 {
        round_up((t - self.start) * self.rate)
    }

    /// The t of a t', about.
    pub fn world(&self, t: f32) -> f64 {
        f64::from(t) / self.rate + self.start
    }
}

/// The number, moved away from 0 far enough to have a finite inverse.
#[inline(always)]
pub fn nonzero(x: f32) -> f32 {
    if x.abs() < FLATTEST {
        FLATTEST.copysign(x)
    } else {
        x
    }
}

/// A single-precision number that is not greater, by more than x's own rounding.
#[inline(always)]
pub fn round_down(x: f64) -> f32 {
    (x as f32).next_down()
}

/// A single-precision number that is not smaller, by more than x's own rounding.
#[inline(always)]
pub fn round_up(x: f64) -> f32 {
    (x as f32).next_up()
}

/// The larger one; one instruction, since nothing here is NaN.
#[inline(always)]
pub fn larger(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// The smaller one.
#[inline(always)]
pub fn smaller(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}
