//! Numbers of single or double precision, and vectors of them: so that a formula stands here once for both.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::math::{DVec3, Ray};

/// A floating point number.
pub trait Real:
    Copy
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Rounded to this precision.
    fn of(value: f64) -> Self;
    /// The number in double precision.
    fn wide(self) -> f64;
    /// The square root.
    fn root(self) -> Self;
}

impl Real for f32 {
    #[inline]
    fn of(value: f64) -> Self {
        value as f32
    }

    #[inline]
    fn wide(self) -> f64 {
        f64::from(self)
    }

    #[inline]
    fn root(self) -> Self {
        self.sqrt()
    }
}

impl Real for f64 {
    #[inline]
    fn of(value: f64) -> Self {
        value
    }

    #[inline]
    fn wide(self) -> f64 {
        self
    }

    #[inline]
    fn root(self) -> Self {
        self.sqrt()
    }
}

/// A vector.
pub type Vector3<R> = [R; 3];

/// A vector, rounded.
#[inline]
pub fn vector<R: Real>(v: DVec3) -> Vector3<R> {
    [R::of(v.x), R::of(v.y), R::of(v.z)]
}

/// a - b.
#[inline]
pub fn sub<R: Real>(a: Vector3<R>, b: Vector3<R>) -> Vector3<R> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// a + s b.
#[inline]
pub fn along<R: Real>(a: Vector3<R>, s: R, b: Vector3<R>) -> Vector3<R> {
    [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]]
}

/// a . b.
#[inline]
pub fn dot<R: Real>(a: Vector3<R>, b: Vector3<R>) -> R {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// a x b.
#[inline]
pub fn cross<R: Real>(a: Vector3<R>, b: Vector3<R>) -> Vector3<R> {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// The point o + t d, computed in this precision.
pub fn at<R: Real>(ray: &Ray, t: f64) -> DVec3 {
    let [x, y, z] = along(vector(ray.origin), R::of(t), vector(ray.direction));
    DVec3::new(x.wide(), y.wide(), z.wide())
}

/// A point, rounded to this precision.
pub fn rounded<R: Real>(p: DVec3) -> DVec3 {
    let [x, y, z] = vector::<R>(p);
    DVec3::new(x.wide(), y.wide(), z.wide())
}
