//! Polygons that a tree has cut by its planes.

use super::picture::{Panel, Picture, Seen, panel};
use super::pinhole::Eye;
use super::{Case, Chance, Outcome, percent};
use crate::geometry::{Intersection, Shape, Shear, Triangle};
use crate::math::{DVec3, Interval, Ray};

pub const T_JUNCTIONS: Case = Case {
    name: "t-junctions",
    hard: "rays aimed at an edge that a plane has cut on one of its two sides",
    source: "trees that keep fragments; ours cut only to learn which leaves are met",
    measure: t_junctions,
    picture: Picture {
        shows: "a wall of bands, rays at their edges",
        wrong: "slips through",
        draw: wall,
    },
};

pub const RAYS: usize = 2000;

pub fn triangle(corners: [DVec3; 3]) -> Shape {
    Shape::Triangle(Triangle { corners })
}

/// Where a ray meets a shape.
pub fn t(shape: &Shape, ray: &Ray) -> Option<f64> {
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

pub fn outcomes(unit: &'static str, names: [&str; 2], wrong: [usize; 2]) -> Vec<Outcome> {
    let one = |(name, wrong): (&str, usize)| Outcome {
        arithmetic: name.to_owned(),
        ours: name == "ours",
        found: percent(wrong, RAYS),
        allowed: 0.0,
        unit,
    };
    names.into_iter().zip(wrong).map(one).collect()
}

/// Bands across the window. Of the two triangles at each edge one has been cut by four planes, or is whole.
fn wall(size: (u32, u32)) -> Vec<Panel> {
    const BANDS: usize = 10;
    const CUTS: usize = 4;
    let mut chance = Chance(36);
    let mut end = |side: f64, i: usize| {
        let y = 2.6 * (i as f64 + 0.6 * chance.next()) / BANDS as f64 - 1.4;
        DVec3::new(1.4 * side, y, 0.2 * chance.next())
    };
    let lines: Vec<[DVec3; 2]> = (0..=BANDS).map(|i| [end(-1.0, i), end(1.0, i)]).collect();
    let (mut fragments, mut whole) = (Vec::new(), Vec::new());
    for pair in lines.windows(2) {
        let [[a, b], [d, c]] = [pair[0], pair[1]];
        let mut cuts: Vec<f64> = (0..CUTS).map(|_| chance.next()).collect();
        cuts.sort_by(f64::total_cmp);
        let mut along = vec![a];
        along.extend(cuts.into_iter().map(|s| a.lerp(b, s)));
        along.push(b);
        fragments.extend(along.windows(2).map(|part| [part[0], part[1], c]));
        fragments.push([a, c, d]);
        whole.extend([[a, b, c], [a, c, d]]);
    }
    let eye = Eye::new(DVec3::new(0.1, 0.2, 3.0), DVec3::ZERO, 0.33);
    let of = |(name, wall): (&str, Vec<[DVec3; 3]>)| {
        let shapes: Vec<Shape> = wall.into_iter().map(triangle).collect();
        panel((name, name == "ours"), size, |place| {
            let ray = eye.ray_at_edge(&lines, place);
            let ray = ray.unwrap_or_else(|| eye.ray(place));
            let hit = shapes.iter().position(|shape| t(shape, &ray).is_some());
            Seen {
                brightness: hit.map_or(0.0, |i| 0.5 + 0.35 * grey(i)),
                wrong: hit.is_none(),
            }
        })
    };
    [("fragments", fragments), ("ours", whole)].map(of).to_vec()
}

/// A number from 0 to 1 to tell neighbours from each other.
pub fn grey(i: usize) -> f64 {
    (i * 5 % 8) as f64 / 7.0
}
