//! Other tests of a triangle.

use super::real::{Real, Vector3, along, cross, dot, sub, vector};
use crate::geometry::{Intersection, Triangle};
use crate::math::{Interval, Ray};

/// The lecture's test: where does the ray cross the triangle's plane, and is that point on the inner side of all edges?
///
/// With N = (b - a) x (c - a), t = N.(a - o) / N.d and p = o + t d. The plane through an edge e = Vi Vi+1 at right
/// angles to the triangle has the normal E = e x N, which points outwards, and d = -E.Vi: inside is where E.p + d <= 0.
/// p is rounded before it is tested against the edges, and neighbours test different points: rays slip through between them.
#[inline]
pub fn plane_edges<R: Real>(triangle: &Triangle, ray: &Ray, interval: Interval) -> Intersection {
    let corners @ [a, b, c] = triangle.corners.map(vector::<R>);
    let (o, d) = (vector(ray.origin), vector(ray.direction));
    let n = cross(sub(b, a), sub(c, a));
    let t = dot(n, sub(a, o)) / dot(n, d);
    let p = along(o, t, d);
    let zero = R::of(0.0);
    let mut sides = [zero; 3];
    for (i, side) in sides.iter_mut().enumerate() {
        let (from, to) = (corners[i], corners[(i + 1) % 3]);
        let outwards = cross(sub(to, from), n);
        *side = dot(outwards, p) + -dot(outwards, from);
        // Never true for NaN: a triangle without area, or one that is seen from its edge.
        let inside = *side <= zero;
        if !inside {
            return Intersection::Miss;
        }
    }
    // The distances from the edges, each as a share of the height over it: the weight of the corner opposite.
    let [of_c, of_a, of_b] = sides;
    weighted(t, [of_a, of_b, of_c], interval)
}

/// The test of Moeller and Trumbore 1997, "Fast, minimum storage ray/triangle intersection": o + t d = (1 - u - v) a +
/// u b + v c, solved for t, u and v by Cramer's rule. Nothing makes neighbours agree about the edge between them.
#[inline]
pub fn moller_trumbore<R: Real>(
    triangle: &Triangle,
    ray: &Ray,
    interval: Interval,
) -> Intersection {
    let [a, b, c] = triangle.corners.map(vector::<R>);
    let (o, d) = (vector(ray.origin), vector(ray.direction));
    let (zero, one) = (R::of(0.0), R::of(1.0));
    let (e, f) = (sub(b, a), sub(c, a));
    let p = cross(d, f);
    let determinant = dot(e, p);
    if determinant == zero {
        return Intersection::Miss;
    }
    let inverse = one / determinant;
    let s = sub(o, a);
    let u = dot(s, p) * inverse;
    if !(u >= zero && u <= one) {
        return Intersection::Miss;
    }
    let q = cross(s, e);
    let v = dot(d, q) * inverse;
    if !(v >= zero && u + v <= one) {
        return Intersection::Miss;
    }
    let t = dot(f, q) * inverse;
    Intersection::classify(
        t.wide(),
        [(one - u - v).wide(), u.wide(), v.wide()],
        interval,
    )
}

/// Our own test in single precision: the same steps, and signs that are exact by a double-precision product, as Woop,
/// Benthin and Wald 2013 have it.
pub fn watertight(triangle: &Triangle, ray: &Ray, interval: Interval) -> Intersection {
    let (o, d) = (vector::<f32>(ray.origin), vector::<f32>(ray.direction));
    let abs = d.map(f32::abs);
    let z = if abs[0] > abs[1] && abs[0] > abs[2] {
        0
    } else if abs[1] > abs[2] {
        1
    } else {
        2
    };
    let (mut x, mut y) = ((z + 1) % 3, (z + 2) % 3);
    if d[z] < 0.0 {
        std::mem::swap(&mut x, &mut y);
    }
    let shear = [d[x] / d[z], d[y] / d[z], 1.0 / d[z]];
    let [a, b, c] = triangle.corners.map(|p| {
        let p = sub(vector(p), o);
        [
            p[x] - shear[0] * p[z],
            p[y] - shear[1] * p[z],
            shear[2] * p[z],
        ]
    });
    let edges = [edge(b, c), edge(c, a), edge(a, b)];
    if edges[0].1 != edges[1].1 || edges[1].1 != edges[2].1 {
        return Intersection::Miss;
    }
    let weights @ [u, v, w] = edges.map(|(value, _)| value);
    let t = (u * a[2] + v * b[2] + w * c[2]) / (u + v + w);
    weighted(t, weights, interval)
}

/// The edge function qx py - qy px and its exact sign; products of two singles are exact in double precision.
fn edge(p: Vector3<f32>, q: Vector3<f32>) -> (f32, bool) {
    let (m, n) = (
        f64::from(q[0]) * f64::from(p[1]),
        f64::from(q[1]) * f64::from(p[0]),
    );
    let side = if m == n {
        (q[0], q[1]) > (p[0], p[1])
    } else {
        m > n
    };
    (q[0] * p[1] - q[1] * p[0], side)
}

/// A crossing whose weights are still to be divided by their sum. If that is NaN, as in a triangle without area or
/// where numbers have overflowed, the triangle is missed.
fn weighted<R: Real>(t: R, weights: Vector3<R>, interval: Interval) -> Intersection {
    let sum = weights[0] + weights[1] + weights[2];
    let barycentric = weights.map(|w| (w / sum).wide());
    if barycentric.iter().all(|w| w.is_finite()) {
        Intersection::classify(t.wide(), barycentric, interval)
    } else {
        Intersection::Miss
    }
}
