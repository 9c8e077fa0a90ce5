//! The tests of planes, discs and boxes in any precision: those of the shapes themselves, step by step.

use super::real::{Real, Vector3, along, dot, sub, vector};
use crate::geometry::{Cuboid, Disc, Intersection, Plane};
use crate::math::{Interval, Ray};

/// See [`Plane::intersect`].
pub fn plane<R: Real>(plane: &Plane, ray: &Ray, interval: Interval) -> Intersection {
    let n = vector::<R>(plane.normal());
    let (o, d) = (vector(ray.origin), vector(ray.direction));
    let t = (dot(n, vector(plane.origin())) - dot(n, o)) / dot(n, d);
    if t.wide().is_finite() {
        Intersection::classify(t.wide(), [0.0; 3], interval)
    } else {
        Intersection::Miss
    }
}

/// See [`Disc::intersect`].
pub fn disc<R: Real>(disc: &Disc, ray: &Ray, interval: Interval) -> Intersection {
    let n = vector::<R>(disc.frame.w);
    let d = vector(ray.direction);
    let from_center = sub(vector(ray.origin), vector(disc.center));
    let t = -dot(n, from_center) / dot(n, d);
    let p = along(from_center, t, d);
    let radius = R::of(disc.radius);
    if dot(p, p) <= radius * radius {
        Intersection::classify(t.wide(), [0.0; 3], interval)
    } else {
        Intersection::Miss
    }
}

/// See [`Cuboid::intersect`].
pub fn cuboid<R: Real>(cuboid: &Cuboid, ray: &Ray, interval: Interval) -> Intersection {
    let (min, max): (Vector3<R>, Vector3<R>) =
        (vector(cuboid.bounds.min), vector(cuboid.bounds.max));
    let (o, d): (Vector3<R>, Vector3<R>) = (vector(ray.origin), vector(ray.direction));
    let (mut enter, mut exit) = (f64::NEG_INFINITY, f64::INFINITY);
    for axis in 0..3 {
        let (o, d, min, max) = (o[axis], d[axis], min[axis], max[axis]);
        if d == R::of(0.0) {
            if o < min || max < o {
                return Intersection::Miss;
            }
            continue;
        }
        let (t0, t1) = (((min - o) / d).wide(), ((max - o) / d).wide());
        enter = enter.max(t0.min(t1));
        exit = exit.min(t0.max(t1));
    }
    if enter <= exit {
        Intersection::first_of(enter, exit, interval)
    } else {
        Intersection::Miss
    }
}
