//! Solids with curved walls, looked at from far away.

use super::expansion::Expansion;
use super::picture::{Panel, Picture, Seen, panel};
use super::pinhole::Eye;
use super::{Case, Chance, Outcome, percent, told, under};
use crate::geometry::{
    Arithmetic, Body, Intersection, Quadratic, Quadric, QuarticMethod, Shape, Shear, Torus,
};
use crate::math::{DVec3, Interval, Ray};

pub const FAR_CYLINDER: Case = Case {
    name: "far-cylinder",
    hard: "radius 1 at distance 1e8: b^2 and 4ac agree in nearly all digits",
    source: "Haines, Guenther and Akenine-Moeller 2019, Ray Tracing Gems, chapter 7",
    measure: far_cylinder,
    picture: Picture {
        shows: "the cylinder from 1e8 m",
        wrong: "hit or missed wrongly",
        draw: wall,
    },
};

pub const FAR_TORUS: Case = Case {
    name: "far-torus",
    hard: "radius 1 at distance 1e5: the quartic's terms are 1e20, and 1 decides",
    source: "Yuksel 2022, High-performance polynomial root finding for graphics",
    measure: far_torus,
    picture: Picture {
        shows: "the ring from 1e5 m",
        wrong: "hit or missed wrongly",
        draw: ring,
    },
};

/// Distances of the eyes, in metres.
const FAR: f64 = 1e8;
const FAR_RING: f64 = 1e5;

const RING: Torus = Torus {
    major: 1.0,
    minor: 0.25,
};

/// So long that rays across meet its wall only.
fn post() -> Shape {
    Shape::Body(Box::new(Body::Quadric(Quadric::cylinder(1.0, 1e3))))
}

fn torus() -> Shape {
    Shape::Body(Box::new(Body::Torus(RING)))
}

fn quadratics() -> [(String, bool, Arithmetic); 2] {
    [Quadratic::Naive, Quadratic::Stable].map(|quadratic| {
        let ours = quadratic == Quadratic::default();
        let arithmetic = Arithmetic {
            quadratic,
            ..Arithmetic::default()
        };
        (told(ours, "quadratic", quadratic.name()), ours, arithmetic)
    })
}

fn quartics() -> [(String, bool, Arithmetic); 3] {
    QuarticMethod::ALL.map(|quartic| {
        let ours = quartic == QuarticMethod::default();
        let arithmetic = Arithmetic {
            quartic,
            ..Arithmetic::default()
        };
        (told(ours, "quartic", quartic.name()), ours, arithmetic)
    })
}

fn meet(shape: &Shape, ray: &Ray) -> Option<f64> {
    match shape.intersect(ray, &Shear::new(ray), Interval::FORWARD) {
        Intersection::Hit { t, .. } => Some(t),
        _ => None,
    }
}

/// Seen along its axis the cylinder is a circle: a line meets it exactly if |p x e|^2 < r^2 e.e, p and e the parts of o and d across.
fn meets_wall(ray: &Ray) -> bool {
    let (o, d) = (ray.origin, ray.direction);
    let cross = Expansion::product(o.x, d.z).plus(&Expansion::product(-o.z, d.x));
    let across = Expansion::product(d.x, d.x).plus(&Expansion::product(d.z, d.z));
    across.plus(&cross.times(&cross).negative()).double() > 0.0
}

fn far_cylinder() -> Vec<Outcome> {
    const RAYS: usize = 2000;
    let mut chance = Chance(23);
    let rays: Vec<Ray> = (0..RAYS)
        .map(|_| {
            let away = DVec3::new(chance.next() - 0.5, 0.1 * chance.next(), 1.0);
            let origin = away.normalize() * FAR;
            let target = chance.point() * 1.2;
            Ray::new(origin, (target - origin).normalize())
        })
        .collect();
    let outcome = |(arithmetic, ours, choice): (String, bool, Arithmetic)| {
        let shape = under(choice, post());
        let is_wrong = |ray: &&Ray| meet(&shape, ray).is_some() != meets_wall(ray);
        Outcome {
            arithmetic,
            ours,
            found: percent(rays.iter().filter(is_wrong).count(), RAYS),
            allowed: 0.0,
            unit: "% of rays hit or miss wrongly",
        }
    };
    quadratics().map(outcome).to_vec()
}

/// Rays straight down on the outer side of the ring, from a known distance: that is t.
fn far_torus() -> Vec<Outcome> {
    const RAYS: usize = 1000;
    let mut chance = Chance(24);
    let rays: Vec<Ray> = (0..RAYS)
        .map(|_| {
            let turn = std::f64::consts::TAU * chance.next();
            let up = 2.0 * chance.next() - 1.0;
            let (sin, cos) = libm::sincos(turn);
            let side = DVec3::new(cos, 0.0, sin);
            let normal = (side + up * DVec3::Y).normalize();
            let point = RING.major * side + RING.minor * normal;
            Ray::new(point + FAR_RING * normal, -normal)
        })
        .collect();
    let outcome = |(arithmetic, ours, choice): (String, bool, Arithmetic)| {
        let shape = under(choice, torus());
        let is_wrong = |ray: &&Ray| meet(&shape, ray).is_none_or(|t| (t - FAR_RING).abs() > 1e-9);
        Outcome {
            arithmetic,
            ours,
            found: percent(rays.iter().filter(is_wrong).count(), RAYS),
            allowed: 0.0,
            unit: "% of rays miss or are 1e-9 m off",
        }
    };
    quartics().map(outcome).to_vec()
}

/// Hit in grey, missed in black.
fn seen(shape: &Shape, ray: &Ray, truth: bool) -> Seen {
    let hit = meet(shape, ray).is_some();
    Seen {
        brightness: if hit { 0.8 } else { 0.02 },
        wrong: hit != truth,
    }
}

fn wall(size: (u32, u32)) -> Vec<Panel> {
    let from = DVec3::new(0.6, 0.05, 0.8) * FAR;
    let eye = Eye::new(from, DVec3::ZERO, 1.25 / FAR);
    let of = |(name, ours, choice): (String, bool, Arithmetic)| {
        let shape = under(choice, post());
        panel((&name, ours), size, |place| {
            let ray = eye.ray(place);
            seen(&shape, &ray, meets_wall(&ray))
        })
    };
    quadratics().map(of).to_vec()
}

/// The truth is found from near by, where all ways agree: the rays are the same lines but for their rounding.
fn ring(size: (u32, u32)) -> Vec<Panel> {
    let from = DVec3::new(0.36, 0.8, 0.48) * FAR_RING;
    let eye = Eye::new(from, DVec3::ZERO, 1.6 / FAR_RING);
    let of = |(name, ours, choice): (String, bool, Arithmetic)| {
        let shape = under(choice, torus());
        panel((&name, ours), size, |place| {
            let ray = eye.ray(place);
            let near = Ray::new(ray.at(FAR_RING - 4.0), ray.direction);
            seen(&shape, &ray, meet(&torus(), &near).is_some())
        })
    };
    quartics().map(of).to_vec()
}
