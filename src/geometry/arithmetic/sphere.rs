//! Other tests of a sphere.

use super::real::{Real, along, dot, sub, vector};
use crate::geometry::{Intersection, Sphere};
use crate::math::{Interval, Ray};

/// The school formula: with f = o - c, t = (-B +- sqrt(B^2 - 4 A C)) / 2A, where A = d.d, B = 2 f.d, C = f.f - r^2.
/// B^2 and 4 A C agree in nearly all digits if the sphere is small and far, f.f and r^2 if the origin is near it.
#[inline]
pub fn school<R: Real>(sphere: &Sphere, ray: &Ray, interval: Interval) -> Intersection {
    let (two, four) = (R::of(2.0), R::of(4.0));
    let d = vector::<R>(ray.direction);
    let f = sub(vector(ray.origin), vector(sphere.center));
    let r = R::of(sphere.radius);
    let (a, b, c) = (dot(d, d), two * dot(f, d), dot(f, f) - r * r);
    let discriminant = b * b - four * a * c;
    if discriminant < R::of(0.0) {
        return Intersection::Miss;
    }
    let root = discriminant.root();
    let (t0, t1) = ((-b - root) / (two * a), (-b + root) / (two * a));
    Intersection::first_of(t0.wide(), t1.wide(), interval)
}

/// Our own formula, in any precision: see [`Sphere::intersect`].
#[inline]
pub fn stable<R: Real>(sphere: &Sphere, ray: &Ray, interval: Interval) -> Intersection {
    let zero = R::of(0.0);
    let d = vector::<R>(ray.direction);
    let f = sub(vector(ray.origin), vector(sphere.center));
    let r = R::of(sphere.radius);
    let (a, b) = (dot(d, d), -dot(f, d));
    let l = along(f, b / a, d);
    let discriminant = a * (r * r - dot(l, l));
    if discriminant < zero {
        return Intersection::Miss;
    }
    let root = discriminant.root();
    let q = b + if b < zero { -root } else { root };
    let distance = dot(f, f).root();
    let c = (distance - r) * (distance + r);
    let (t0, t1) = ((c / q).wide(), (q / a).wide());
    Intersection::first_of(t0.min(t1), t0.max(t1), interval)
}
