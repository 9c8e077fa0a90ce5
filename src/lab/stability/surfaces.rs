//! Surfaces that rays leave: they must not be hit again, and what stands close behind must not be lost.

use super::meshes::ball;
use super::picture::{Panel, Picture, Seen, panel};
use super::pinhole::Eye;
use super::{Case, Chance, Outcome, percent, told, under};
use crate::geometry::{Arithmetic, Intersection, Offset, Shape, Shear, Triangle};
use crate::math::rounding::offset_origin;
use crate::math::{DVec3, Interval, Ray};

pub const SELF_HITS: Case = Case {
    name: "self-hits",
    hard: "rays that leave a surface find it again (1e6 m from the origin)",
    source: "Pharr, Jakob and Humphreys, Physically Based Rendering, 4th edition, 6.8",
    measure: self_hits,
    picture: Picture {
        shows: "a ball in the light",
        wrong: "the ray to the light meets what it left",
        draw: acne,
    },
};

pub const PLATE_GAP: Case = Case {
    name: "plate-gap",
    hard: "a second surface 1e-9 m behind must not be lost (1e3 m from the origin)",
    source: "Waechter and Binder 2019, Ray Tracing Gems, chapter 6",
    measure: plate_gap,
    picture: Picture {
        shows: "a card close behind a clear pane",
        wrong: "seen through the pane it is lost",
        draw: card_behind_pane,
    },
};

const RAYS: usize = 2000;

fn offsets() -> [(String, bool, Arithmetic); 4] {
    [
        Offset::None,
        Offset::Fixed(1e-9),
        Offset::Fixed(1e-4),
        Offset::Bounded,
    ]
    .map(|offset| {
        let ours = offset == Offset::Bounded;
        let choice = Arithmetic {
            offset,
            ..Arithmetic::default()
        };
        (told(ours, "offset", offset), ours, choice)
    })
}

fn meet(shape: &Shape, ray: &Ray) -> Intersection {
    shape.intersect(ray, &Shear::new(ray), Interval::FORWARD)
}

/// A triangle somewhere near `center`, and a ray that meets it.
fn met(chance: &mut Chance, center: DVec3) -> (Triangle, Ray) {
    let corners = [0, 1, 2].map(|_| center + chance.point());
    let (u, v) = (0.1 + 0.4 * chance.next(), 0.1 + 0.4 * chance.next());
    let [a, b, c] = corners;
    let target = a * (1.0 - u - v) + b * u + c * v;
    let origin = target + 3.0 * chance.point().normalize();
    (
        Triangle { corners },
        Ray::new(origin, (target - origin).normalize()),
    )
}

/// The ray that leaves the surface where `ray` meets it, to the side that `turned` chooses.
fn leaving(shape: &Shape, ray: &Ray, direction: DVec3) -> Option<Ray> {
    let Intersection::Hit { t, place, part } = meet(shape, ray) else {
        return None;
    };
    let at = shape.surface(ray, t, place, part);
    let origin = offset_origin(at.point, at.error, at.normal, direction);
    Some(Ray::new(origin, direction))
}

fn self_hits() -> Vec<Outcome> {
    let outcome = |(arithmetic, ours, choice): (String, bool, Arithmetic)| {
        let mut chance = Chance(1);
        let (mut wrong, mut all) = (0, 0);
        for _ in 0..RAYS {
            let (triangle, ray) = met(&mut chance, DVec3::splat(1e6));
            let shape = under(choice, Shape::Triangle(triangle));
            let direction = chance.point().normalize();
            if let Some(next) = leaving(&shape, &ray, direction) {
                all += 1;
                wrong += usize::from(matches!(meet(&shape, &next), Intersection::Hit { .. }));
            }
        }
        Outcome {
            arithmetic,
            ours,
            found: percent(wrong, all),
            allowed: 0.0,
            unit: "% of rays hit what they left",
        }
    };
    offsets().map(outcome).to_vec()
}

/// Plates of any tilt, and their twins behind them; rays go straight on through the first.
fn plate_gap() -> Vec<Outcome> {
    let outcome = |(arithmetic, ours, choice): (String, bool, Arithmetic)| {
        let mut chance = Chance(2);
        let (mut wrong, mut all) = (0, 0);
        for _ in 0..RAYS {
            let (plate, ray) = met(&mut chance, DVec3::splat(1e3));
            let Some(n) = plate.normal() else { continue };
            // Straight enough, so that the gap is crossed well inside of the border.
            if n.dot(ray.direction).abs() < 1e-3 {
                continue;
            }
            let behind = 1e-9 * n * n.dot(ray.direction).signum();
            let twin = Triangle {
                corners: plate.corners.map(|p| p + behind),
            };
            let [first, second] = [plate, twin].map(|t| under(choice, Shape::Triangle(t)));
            if let Some(next) = leaving(&first, &ray, ray.direction) {
                all += 1;
                wrong += usize::from(!matches!(meet(&second, &next), Intersection::Hit { .. }));
            }
        }
        Outcome {
            arithmetic,
            ours,
            found: percent(wrong, all),
            allowed: 0.0,
            unit: "% of rays miss the second plate",
        }
    };
    offsets().map(outcome).to_vec()
}

/// A ball of triangles in the light. It is convex: what is turned to the light has nothing before it.
fn acne(size: (u32, u32)) -> Vec<Panel> {
    let center = DVec3::splat(1e6);
    let light = DVec3::new(0.5, 0.7, 0.5).normalize();
    let eye = Eye::new(center + DVec3::new(0.0, 0.5, 3.5), center, 0.3);
    let mesh = ball(center);
    let of = |(name, ours, choice): (String, bool, Arithmetic)| {
        let shapes: Vec<Shape> = mesh
            .iter()
            .map(|t| under(choice, Shape::Triangle(*t)))
            .collect();
        panel((&name, ours), size, |place| {
            let right = |brightness| Seen {
                brightness,
                wrong: false,
            };
            let ray = eye.ray(place);
            let Some((shape, _)) = closest(&shapes, &ray) else {
                return right(0.02);
            };
            let Some(normal) = normal_towards(shape, -ray.direction) else {
                return right(0.02);
            };
            let shade = 0.05 + 0.9 * normal.dot(light);
            match leaving(shape, &ray, light) {
                Some(next) if shade > 0.05 => {
                    let wrong = closest(&shapes, &next).is_some();
                    let brightness = if wrong { 0.05 } else { shade };
                    Seen { brightness, wrong }
                }
                _ => right(0.05),
            }
        })
    };
    offsets().map(of).to_vec()
}

/// The shape that is hit first, and where.
fn closest<'a>(shapes: &'a [Shape], ray: &Ray) -> Option<(&'a Shape, f64)> {
    let hits = shapes.iter().filter_map(|shape| match meet(shape, ray) {
        Intersection::Hit { t, .. } => Some((shape, t)),
        _ => None,
    });
    hits.min_by(|a, b| a.1.total_cmp(&b.1))
}

/// A triangle's normal on the side to which `side` points.
fn normal_towards(shape: &Shape, side: DVec3) -> Option<DVec3> {
    let Shape::Triangle(triangle) = shape.plain() else {
        return None;
    };
    let n = triangle.normal()?;
    Some(n * n.dot(side).signum())
}

/// A pane, and 1e-9 m behind it a larger card with rings on it, which fills the window. Both have their middle in `center`, but for
/// the gap.
fn card_behind_pane(size: (u32, u32)) -> Vec<Panel> {
    let center = DVec3::splat(1e3);
    let corners = [
        DVec3::new(-0.8, -0.5, 0.3),
        DVec3::new(0.75, -0.45, -0.1),
        DVec3::new(0.05, 0.95, -0.2),
    ];
    let pane = Triangle {
        corners: corners.map(|p| center + p),
    };
    let eye = Eye::new(center + DVec3::new(0.0, 0.0, 3.0), center, 0.33);
    let behind = pane.normal().map_or(DVec3::ZERO, |n| -1e-9 * n);
    let card = Triangle {
        corners: corners.map(|p| center + 6.0 * p + behind),
    };
    let rings = |p: DVec3| {
        let even = ((p - center).length() * 6.0) as i64 % 2 == 0;
        if even { 0.85 } else { 0.25 }
    };
    let of = |(name, ours, choice): (String, bool, Arithmetic)| {
        let [pane, card] = [pane, card].map(|t| under(choice, Shape::Triangle(t)));
        panel((&name, ours), size, |place| {
            let ray = eye.ray(place);
            // Through the pane if it is there, straight on.
            let next = leaving(&pane, &ray, ray.direction).unwrap_or(ray);
            match meet(&card, &next) {
                Intersection::Hit { t, .. } => Seen {
                    brightness: rings(next.at(t)),
                    wrong: false,
                },
                _ => Seen {
                    brightness: 0.0,
                    wrong: true,
                },
            }
        })
    };
    offsets().map(of).to_vec()
}
