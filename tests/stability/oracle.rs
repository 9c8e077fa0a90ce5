//! Exact answers, in rational numbers: every `f64` is one, so nothing is rounded and nothing is guessed.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Sub};

use num_rational::BigRational;
use raytree::math::{DVec3, Ray};

/// A number as a fraction whose denominator is a power of two. It is never brought to lowest terms: only signs are asked for, and
/// looking for common factors would take most of the time.
#[derive(Clone, Debug)]
pub struct Exact(BigRational);

type Vector = [Exact; 3];

/// The number itself.
pub fn exact(x: f64) -> Exact {
    Exact(BigRational::from_float(x).expect("a finite number"))
}

impl Exact {
    fn is_positive(&self) -> bool {
        self.0.numer() > exact(0.0).0.numer()
    }

    fn is_negative(&self) -> bool {
        self.0.numer() < exact(0.0).0.numer()
    }

    /// Two numbers over one denominator, joined by `join` of their numerators.
    fn over_one(
        &self,
        other: &Self,
        join: impl Fn(BigRational, BigRational) -> BigRational,
    ) -> Self {
        let (a, b) = (&self.0, &other.0);
        let denominator = a.denom().max(b.denom());
        // Powers of two: the larger is a multiple of the smaller.
        let raised = |x: &BigRational| {
            let times = denominator / x.denom();
            BigRational::from_integer(x.numer() * times)
        };
        let sum = join(raised(a), raised(b));
        Self(BigRational::new_raw(
            sum.numer().clone(),
            denominator.clone(),
        ))
    }
}

impl Add for &Exact {
    type Output = Exact;

    fn add(self, other: Self) -> Exact {
        self.over_one(other, |a, b| a + b)
    }
}

impl Sub for &Exact {
    type Output = Exact;

    fn sub(self, other: Self) -> Exact {
        self.over_one(other, |a, b| a - b)
    }
}

impl Mul for &Exact {
    type Output = Exact;

    fn mul(self, other: Self) -> Exact {
        let (a, b) = (&self.0, &other.0);
        let product = BigRational::new_raw(a.numer() * b.numer(), a.denom() * b.denom());
        Exact(product)
    }
}

fn vector(v: DVec3) -> Vector {
    v.to_array().map(exact)
}

fn minus(a: &Vector, b: &Vector) -> Vector {
    [0, 1, 2].map(|i| &a[i] - &b[i])
}

fn dot(a: &Vector, b: &Vector) -> Exact {
    let [x, y, z] = [0, 1, 2].map(|i| &a[i] * &b[i]);
    &(&x + &y) + &z
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    let part = |i: usize, j: usize| &(&a[i] * &b[j]) - &(&a[j] * &b[i]);
    [part(1, 2), part(2, 0), part(0, 1)]
}

/// True if the ray's line comes nearer to the centre than the radius, so that it crosses the sphere: the discriminant
/// (f.d)^2 - d.d (f.f - r^2), with its exact sign.
pub fn line_meets_sphere(ray: &Ray, center: DVec3, radius: f64) -> bool {
    let d = vector(ray.direction);
    let f = minus(&vector(ray.origin), &vector(center));
    let (fd, r) = (dot(&f, &d), exact(radius));
    let outside = &dot(&f, &f) - &(&r * &r);
    let discriminant = &(&fd * &fd) - &(&dot(&d, &d) * &outside);
    !discriminant.is_negative()
}

/// True if the ray's line crosses the sphere within `allowed` of `t`: |f + t d|^2 - r^2 changes its exact sign there, or
/// the point nearest to the centre lies there.
pub fn crossing_within(ray: &Ray, center: DVec3, radius: f64, t: f64, allowed: f64) -> bool {
    let d = vector(ray.direction);
    let f = minus(&vector(ray.origin), &vector(center));
    let r = exact(radius);
    let (dd, fd) = (dot(&d, &d), dot(&f, &d));
    let c = &dot(&f, &f) - &(&r * &r);
    let (t, allowed) = (exact(t), exact(allowed));
    let (low, high) = (&t - &allowed, &t + &allowed);
    let twice = &fd + &fd;
    let outside = |t: &Exact| !(&(&(&(&dd * t) + &twice) * t) + &c).is_negative();
    let slope = |t: &Exact| &(&dd * t) + &fd;
    let turns = !slope(&low).is_positive() && !slope(&high).is_negative();
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
    if volumes.iter().all(Exact::is_positive) || volumes.iter().all(Exact::is_negative) {
        Side::Inside
    } else if volumes.iter().any(Exact::is_positive) && volumes.iter().any(Exact::is_negative) {
        Side::Outside
    } else {
        Side::Border
    }
}

/// On which side of a triangle's plane a point is: `Greater` is the one from which the corners run counter-clockwise.
pub fn side_of_plane(point: DVec3, corners: [DVec3; 3]) -> Ordering {
    let [a, b, c] = corners.map(vector);
    let normal = cross(&minus(&b, &a), &minus(&c, &a));
    let height = dot(&normal, &minus(&vector(point), &a));
    match (height.is_positive(), height.is_negative()) {
        (true, _) => Ordering::Greater,
        (_, true) => Ordering::Less,
        _ => Ordering::Equal,
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
    let side = |z: f64| side_of_plane(DVec3::new(3.0, 4.0, z), corners);
    let sides = [5e-324, 0.0, -5e-324].map(side);
    assert_eq!(sides, [Ordering::Greater, Ordering::Equal, Ordering::Less]);
    assert_eq!(exact(0.75).0, R::new(3.into(), 4.into()));
    // Not in lowest terms, and yet the same numbers.
    let (a, b) = (exact(0.75), exact(2.5));
    let results = [&a + &b, &a - &b, &a * &b].map(|x| x.0.reduced());
    let quarters = |n: i32| R::new(n.into(), 4.into());
    assert_eq!(
        results,
        [quarters(13), quarters(-7), R::new(15.into(), 8.into())]
    );
    assert!((&a - &b).is_negative() && a.is_positive() && !exact(0.0).is_negative());
}
