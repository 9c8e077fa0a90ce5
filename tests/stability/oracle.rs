//! Exact answers, in rational numbers: every `f64` is one, so nothing is rounded and nothing is guessed.

use num_rational::BigRational;
use raytree::math::{DVec3, Ray};

type Vector = [BigRational; 3];

/// The number itself.
pub fn exact(x: f64) -> BigRational {
    BigRational::from_float(x).expect("a finite number")
}

fn vector(v: DVec3) -> Vector {
    v.to_array().map(exact)
}

fn minus(a: &Vector, b: &Vector) -> Vector {
    [0, 1, 2].map(|i| &a[i] - &b[i])
}

fn dot(a: &Vector, b: &Vector) -> BigRational {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    let part = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
    [part(1, 2), part(2, 0), part(0, 1)]
}

fn zero() -> BigRational {
    exact(0.0)
}

/// True if the ray's line comes nearer to the centre than the radius, so that it crosses the sphere: the discriminant
/// (f.d)^2 - d.d (f.f - r^2), with its exact sign.
pub fn line_meets_sphere(ray: &Ray, center: DVec3, radius: f64) -> bool {
    let d = vector(ray.direction);
    let f = minus(&vector(ray.origin), &vector(center));
    let (fd, r) = (dot(&f, &d), exact(radius));
    &fd * &fd - dot(&d, &d) * (dot(&f, &f) - &r * &r) >= zero()
}

/// True if the ray's line crosses the sphere within `allowed` of `t`: |f + t d|^2 - r^2 changes its exact sign there, or
/// the point nearest to the centre lies there.
pub fn crossing_within(ray: &Ray, center: DVec3, radius: f64, t: f64, allowed: f64) -> bool {
    let d = vector(ray.direction);
    let f = minus(&vector(ray.origin), &vector(center));
    let r = exact(radius);
    let (dd, fd, c) = (dot(&d, &d), dot(&f, &d), dot(&f, &f) - &r * &r);
    let (low, high) = (exact(t) - exact(allowed), exact(t) + exact(allowed));
    let outside = |t: &BigRational| (&dd * t + &fd + &fd) * t + &c >= zero();
    let turns = &dd * &low + &fd <= zero() && &dd * &high + &fd >= zero();
    turns || outside(&low) != outside(&high)
}

/// Where the ray's line passes a triangle: inside, outside, or exactly on its border (or it lies in the plane).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    Inside,
    Outside,
    Border,
}

/// The exact signs of the three volumes that the line makes with the triangle's edges.
pub fn line_in_triangle(ray: &Ray, corners: [DVec3; 3]) -> Side {
    let (o, d) = (vector(ray.origin), vector(ray.direction));
    let [a, b, c] = corners.map(|p| minus(&vector(p), &o));
    let volumes = [(&b, &c), (&c, &a), (&a, &b)].map(|(p, q)| dot(&d, &cross(p, q)));
    let zero = zero();
    if volumes.iter().all(|v| *v > zero) || volumes.iter().all(|v| *v < zero) {
        Side::Inside
    } else if volumes.iter().any(|v| *v > zero) && volumes.iter().any(|v| *v < zero) {
        Side::Outside
    } else {
        Side::Border
    }
}

#[test]
fn the_oracle_knows_its_paper() {
    use num_rational::BigRational as R;
    let ray = |x: f64| Ray::new(DVec3::new(x, 0.0, 9.0), DVec3::NEG_Z);
    assert!(line_meets_sphere(&ray(1.0), DVec3::ZERO, 1.0));
    assert!(!line_meets_sphere(
        &ray(1.0_f64.next_up()),
        DVec3::ZERO,
        1.0
    ));
    let corners = [DVec3::ZERO, DVec3::X, DVec3::Y];
    let at = |x: f64, y: f64| Ray::new(DVec3::new(x, y, 1.0), DVec3::NEG_Z);
    assert_eq!(line_in_triangle(&at(0.2, 0.2), corners), Side::Inside);
    assert_eq!(line_in_triangle(&at(0.5, 0.5), corners), Side::Border);
    let above = 0.5_f64.next_up();
    assert_eq!(line_in_triangle(&at(0.5, above), corners), Side::Outside);
    assert_eq!(exact(0.75), R::new(3.into(), 4.into()));
}
