//! Spheres: small and far, large and near.

use super::expansion::Expansion;
use super::{Case, Chance, Outcome, percent, under};
use crate::geometry::{Arithmetic, Intersection, Precision, Quadratic, Shape, Shear, Sphere};
use crate::math::{DVec3, Interval, Ray};

pub const FAR_SPHERE: Case = Case {
    name: "far-sphere",
    hard: "radius 1e-4 at distance 1e5: b^2 and 4ac agree in nearly all digits",
    source: "Haines, Guenther and Akenine-Moeller 2019, Ray Tracing Gems, chapter 7",
    measure: far_sphere,
};

pub const NEAR_SPHERE: Case = Case {
    name: "near-sphere",
    hard: "radius 1e6, the eye 1e-3 above: f.f and r^2 agree in nearly all digits",
    source: "Press et al. 2007, Numerical Recipes, section 5.6; the same chapter",
    measure: near_sphere,
};

/// The choices that are compared.
fn choices() -> [(String, bool, Arithmetic); 3] {
    let of = |quadratic, precision| Arithmetic {
        quadratic,
        precision,
        ..Arithmetic::default()
    };
    [
        (of(Quadratic::Naive, Precision::Double), "--quadratic naive"),
        (
            of(Quadratic::Stable, Precision::Single),
            "--precision single",
        ),
        (Arithmetic::default(), "ours"),
    ]
    .map(|(a, name)| (name.to_owned(), name == "ours", a))
}

fn meet(shape: &Shape, ray: &Ray) -> Option<f64> {
    match shape.intersect(ray, &Shear::new(ray), Interval::FORWARD) {
        Intersection::Hit { t, .. } => Some(t),
        _ => None,
    }
}

/// The sphere is at the world's origin, so that o - c is exact; hit or miss is then exactly the sign of
/// (o.d)^2 - d.d (o.o - r^2).
fn far_sphere() -> Vec<Outcome> {
    const RAYS: usize = 2000;
    let ball = Sphere {
        center: DVec3::ZERO,
        radius: 1e-4,
    };
    let mut chance = Chance(19);
    let rays: Vec<Ray> = (0..RAYS)
        .map(|_| {
            let origin = chance.point().normalize() * 1e5;
            let target = chance.point() * 1.2 * ball.radius;
            Ray::new(origin, (target - origin).normalize())
        })
        .collect();
    let truth: Vec<bool> = rays.iter().map(|ray| is_hit(&ball, ray)).collect();
    let outcome = |(arithmetic, ours, choice): (String, bool, Arithmetic)| {
        let shape = under(choice, Shape::Sphere(ball));
        let wrong = rays
            .iter()
            .zip(&truth)
            .filter(|(ray, hit)| meet(&shape, ray).is_some() != **hit);
        Outcome {
            arithmetic,
            ours,
            found: percent(wrong.count(), RAYS),
            allowed: 0.0,
            unit: "% of rays hit or miss wrongly",
        }
    };
    choices().map(outcome).to_vec()
}

fn dot(a: DVec3, b: DVec3) -> Expansion {
    let [x, y, z] = [0, 1, 2].map(|k| Expansion::product(a[k], b[k]));
    x.plus(&y).plus(&z)
}

fn is_hit(ball: &Sphere, ray: &Ray) -> bool {
    let (o, d) = (ray.origin, ray.direction);
    let b = dot(o, d);
    let c = dot(o, o).plus(&Expansion::product(ball.radius, -ball.radius));
    b.times(&b).plus(&dot(d, d).times(&c).negative()).double() >= 0.0
}

/// How far the point at t is off the sphere, in metres: (|o + t d|^2 - r^2) / 2 r, evaluated exactly until the last step.
fn near_sphere() -> Vec<Outcome> {
    let ball = Sphere {
        center: DVec3::ZERO,
        radius: 1e6,
    };
    let origin = DVec3::new(0.0, ball.radius + 1e-3, 0.0);
    let mut chance = Chance(20);
    let rays: Vec<Ray> = (0..1000)
        .map(|_| {
            let aside = chance.point();
            let down = DVec3::new(aside.x, -0.05 - chance.next(), aside.z);
            Ray::new(origin, down.normalize())
        })
        .collect();
    let outcome = |(arithmetic, ours, choice): (String, bool, Arithmetic)| {
        let shape = under(choice, Shape::Sphere(ball));
        let off = |ray: &Ray| meet(&shape, ray).map_or(f64::INFINITY, |t| residual(&ball, ray, t));
        Outcome {
            arithmetic,
            ours,
            found: rays.iter().map(off).fold(0.0, f64::max),
            // Two units in the last place of the radius.
            allowed: 2.0 * f64::EPSILON * ball.radius,
            unit: "m off the surface at most",
        }
    };
    choices().map(outcome).to_vec()
}

fn residual(ball: &Sphere, ray: &Ray, t: f64) -> f64 {
    let parts = [0, 1, 2].map(|k| {
        let along = Expansion::product(t, ray.direction[k]);
        let p = along.plus(&Expansion::difference(ray.origin[k], 0.0));
        p.times(&p)
    });
    let [x, y, z] = parts;
    let squares = x.plus(&y).plus(&z);
    let off = squares.plus(&Expansion::product(ball.radius, -ball.radius));
    (off.double() / (2.0 * ball.radius)).abs()
}
