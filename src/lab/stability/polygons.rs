//! Polygons as a tree has them: cut by its planes, and several in one plane.

use super::{Case, Chance, Outcome, percent};
use crate::accel::{Accel, AccelKind};
use crate::geometry::{Hit, Intersection, Shape, Shear, Triangle};
use crate::math::{DVec3, Interval, Ray};
use crate::probe::Silent;

pub const T_JUNCTIONS: Case = Case {
    name: "t-junctions",
    hard: "rays aimed at an edge that a plane has cut on one of its two sides",
    source: "trees that keep fragments; ours cut polygons only to learn which leaves they reach",
    measure: t_junctions,
};

pub const COPLANAR_TWINS: Case = Case {
    name: "coplanar-twins",
    hard: "one triangle twice, in two colours: which of them is seen?",
    source: "speckles of polygons in one plane; ours: of equal t the smaller number, in every tree",
    measure: coplanar_twins,
};

const RAYS: usize = 2000;

fn triangle(corners: [DVec3; 3]) -> Shape {
    Shape::Triangle(Triangle { corners })
}

fn t(shape: &Shape, ray: &Ray) -> Option<f64> {
    match shape.intersect(ray, &Shear::new(ray), Interval::FORWARD) {
        Intersection::Hit { t, .. } => Some(t),
        _ => None,
    }
}

/// Two triangles on either side of an edge, as the ray sees them; one of them is cut at a place of the edge, which rounding has moved
/// off it.
fn t_junctions() -> Vec<Outcome> {
    let mut chance = Chance(35);
    let (mut fragments, mut whole) = (0, 0);
    for _ in 0..RAYS {
        let (a, b) = (chance.point(), chance.point());
        let ahead = chance.point().normalize();
        let aside = (b - a).cross(ahead).normalize();
        let mut beside = |side: f64| {
            let along = a.lerp(b, chance.next());
            along + side * (0.2 + chance.next()) * aside + 0.3 * chance.next() * ahead
        };
        let (c, d) = (beside(1.0), beside(-1.0));
        let (cut, target) = (a.lerp(b, chance.next()), a.lerp(b, chance.next()));
        let origin = target - 3.0 * ahead;
        let ray = Ray::new(origin, (target - origin).normalize());
        let slips = |corners: &[[DVec3; 3]]| {
            let mut shapes = corners.iter().map(|corners| triangle(*corners));
            !shapes.any(|shape| t(&shape, &ray).is_some())
        };
        let other = [b, a, d];
        fragments += usize::from(slips(&[[a, cut, c], [cut, b, c], other]));
        whole += usize::from(slips(&[[a, b, c], other]));
    }
    outcomes(
        "% of rays slip through",
        ["fragments", "ours"],
        [fragments, whole],
    )
}

/// The first that is found wins, unless a later one is nearer: then it is a matter of the order in which they are tested. Ours is
/// asked of every accelerator.
fn coplanar_twins() -> Vec<Outcome> {
    let mut chance = Chance(15);
    let corners = [chance.point(), chance.point(), chance.point()];
    let twins = [triangle(corners), triangle(corners)];
    let trees = AccelKind::ALL.map(|kind| Accel::build(kind, &twins));
    let (mut by_order, mut ours) = (0, 0);
    for _ in 0..RAYS {
        let (u, v) = (0.5 * chance.next(), 0.5 * chance.next());
        let target = corners[0] * (1.0 - u - v) + corners[1] * u + corners[2] * v;
        let origin = target + 3.0 * chance.point().normalize();
        let ray = Ray::new(origin, (target - origin).normalize());
        let first_found = |order: [usize; 2]| {
            let mut best: Option<(f64, usize)> = None;
            for i in order {
                if let Some(t) = t(&twins[i], &ray)
                    && best.is_none_or(|(nearest, _)| t < nearest)
                {
                    best = Some((t, i));
                }
            }
            best.map(|(_, i)| i)
        };
        by_order += usize::from(first_found([0, 1]) != first_found([1, 0]));
        let seen = |tree: &Accel| {
            let hit: Option<Hit> = tree.closest(&twins, &ray, Interval::FORWARD, &mut Silent);
            hit.map(|hit| hit.primitive)
        };
        let first = seen(&trees[0]);
        ours += usize::from(trees.iter().any(|tree| seen(tree) != first));
    }
    let unit = "% of rays see another in another order";
    outcomes(unit, ["the first that is found", "ours"], [by_order, ours])
}

fn outcomes(unit: &'static str, names: [&str; 2], wrong: [usize; 2]) -> Vec<Outcome> {
    let one = |(name, wrong): (&str, usize)| Outcome {
        arithmetic: name.to_owned(),
        ours: name == "ours",
        found: percent(wrong, RAYS),
        allowed: 0.0,
        unit,
    };
    names.into_iter().zip(wrong).map(one).collect()
}
