//! Spheres: small and far, large and near.

use super::expansion::Expansion;
use super::picture::{Panel, Picture, Seen, panel};
use super::pinhole::Eye;
use super::{Case, Chance, Outcome, percent, under};
use crate::geometry::{Arithmetic, Intersection, Precision, Quadratic, Shape, Shear, Sphere};
use crate::math::{DVec3, Interval, Ray};

pub const FAR_SPHERE: Case = Case {
    name: "far-sphere",
    hard: "radius 1e-4 at distance 1e5: b^2 and 4ac agree in nearly all digits",
    source: "Haines, Guenther and Akenine-Moeller 2019, Ray Tracing Gems, chapter 7",
    measure: far_sphere,
    picture: Picture {
        shows: "the sphere from 1e5 m",
        wrong: "hit or missed wrongly",
        draw: disc,
    },
};

pub const NEAR_SPHERE: Case = Case {
    name: "near-sphere",
    hard: "radius 1e6, the eye 1e-3 above: f.f and r^2 agree in nearly all digits",
    source: "Press et al. 2007, Numerical Recipes, section 5.6; the same chapter",
    measure: near_sphere,
    picture: Picture {
        shows: "squares of 1 mm painted on it",
        wrong: "the point is too far off the surface",
        draw: floor,
    },
};

/// Small, and looked at from far away.
const FAR: Sphere = Sphere {
    center: DVec3::ZERO,
    radius: 1e-4,
};

/// Large, and looked at from just above.
const NEAR: Sphere = Sphere {
    center: DVec3::ZERO,
    radius: 1e6,
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
    let ball = FAR;
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

/// A place 1 mm above.
fn above(ball: &Sphere) -> DVec3 {
    DVec3::new(0.0, ball.radius + 1e-3, 0.0)
}

/// How far off the surface a point may be: two units in the last place of the radius.
fn allowed(ball: &Sphere) -> f64 {
    2.0 * f64::EPSILON * ball.radius
}

fn near_sphere() -> Vec<Outcome> {
    let ball = NEAR;
    let origin = above(&ball);
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
            allowed: allowed(&ball),
            unit: "m off the surface at most",
        }
    };
    choices().map(outcome).to_vec()
}

/// How far the point at t is off the sphere, in metres: (|o + t d|^2 - r^2) / 2 r, evaluated exactly until the last step.
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

/// The sphere as it is seen from 1e5 m. The window is 5/4 as wide, so that no pixel's middle is just on the border, where the rounding
/// of the ray itself would decide.
fn disc(size: (u32, u32)) -> Vec<Panel> {
    let ball = FAR;
    let from = DVec3::new(0.48, 0.36, 0.8) * 1e5;
    let eye = Eye::new(from, ball.center, 1.25 * ball.radius / 1e5);
    let of = |(name, ours, choice): (String, bool, Arithmetic)| {
        let shape = under(choice, Shape::Sphere(ball));
        panel((&name, ours), size, |place| {
            let ray = eye.ray(place);
            let hit = meet(&shape, &ray).is_some();
            Seen {
                brightness: if hit { 0.8 } else { 0.02 },
                wrong: hit != is_hit(&ball, &ray),
            }
        })
    };
    choices().map(of).to_vec()
}

/// The sphere as a floor of dark and bright squares, looked down on from 1 mm above.
fn floor(size: (u32, u32)) -> Vec<Panel> {
    let ball = NEAR;
    let origin = above(&ball);
    let eye = Eye::new(origin, origin + DVec3::new(0.3, -0.6, -1.0), 0.5);
    let square = |p: DVec3| {
        let even = ((p.x * 1e3).floor() + (p.z * 1e3).floor()) as i64 % 2 == 0;
        if even { 0.75 } else { 0.15 }
    };
    let of = |(name, ours, choice): (String, bool, Arithmetic)| {
        let shape = under(choice, Shape::Sphere(ball));
        panel((&name, ours), size, |place| {
            let ray = eye.ray(place);
            let Some(t) = meet(&shape, &ray) else {
                return Seen {
                    brightness: 0.0,
                    wrong: true,
                };
            };
            Seen {
                brightness: square(ray.at(t)),
                wrong: residual(&ball, &ray, t) > allowed(&ball),
            }
        })
    };
    choices().map(of).to_vec()
}
