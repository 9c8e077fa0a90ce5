//! Triangles: surfaces that are left, and edges that are shared.

use super::{Case, Chance, Outcome, percent, under};
use crate::geometry::{Arithmetic, Intersection, Offset, Shape, Shear, Triangle, TriangleTest};
use crate::math::rounding::offset_origin;
use crate::math::{DVec3, Interval, Ray};

pub const SELF_HITS: Case = Case {
    name: "self-hits",
    hard: "rays that leave a surface find it again (1e6 m from the origin)",
    source: "Pharr, Jakob and Humphreys, Physically Based Rendering, 4th edition, section 6.8",
    measure: self_hits,
};

pub const PLATE_GAP: Case = Case {
    name: "plate-gap",
    hard: "a second surface 1e-9 m behind must not be lost (1e3 m from the origin)",
    source: "Waechter and Binder 2019, Ray Tracing Gems, chapter 6",
    measure: plate_gap,
};

pub const SHARED_EDGES: Case = Case {
    name: "shared-edges",
    hard: "rays aimed at the edges of a closed mesh (1e3 m from the origin)",
    source: "Woop, Benthin and Wald 2013",
    measure: || crossings(|[a, b, _], s| a.lerp(b, s)),
};

pub const SHARED_CORNERS: Case = Case {
    name: "shared-corners",
    hard: "rays aimed at its corners, where several triangles meet",
    source: "the same; a ray must cross a closed mesh an odd number of times from inside",
    measure: || crossings(|[a, _, _], _| a),
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
        let name = if ours {
            "ours".to_owned()
        } else {
            format!("--offset {offset}")
        };
        let choice = Arithmetic {
            offset,
            ..Arithmetic::default()
        };
        (name, ours, choice)
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
    let Intersection::Hit { t, barycentric } = meet(shape, ray) else {
        return None;
    };
    let at = shape.surface(ray, t, barycentric);
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

/// A ball of triangles around `center`: an octahedron whose sides are cut into four, three times.
fn ball(center: DVec3) -> Vec<Triangle> {
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    let mut all: Vec<[DVec3; 3]> = Vec::new();
    for (s, t, u) in (0..8).map(|i| (i & 1, i >> 1 & 1, i >> 2)) {
        let sign = |bit: i32| 1.0 - 2.0 * f64::from(bit);
        all.push([x * sign(s), y * sign(t), z * sign(u)]);
    }
    for _ in 0..3 {
        all = all
            .into_iter()
            .flat_map(|[a, b, c]| {
                // The sum of two is the same either way, so neighbours agree about the middle.
                let [ab, bc, ca] = [a + b, b + c, c + a].map(DVec3::normalize);
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
            })
            .collect();
    }
    let place = |corners: [DVec3; 3]| Triangle {
        corners: corners.map(|p| p + center),
    };
    all.into_iter().map(place).collect()
}

/// Rays from inside to places on the edges that `aim` chooses: from inside, an odd number of triangles is crossed.
fn crossings(aim: fn([DVec3; 3], f64) -> DVec3) -> Vec<Outcome> {
    let center = DVec3::splat(1e3);
    let mesh = ball(center);
    let mut chance = Chance(3);
    let rays: Vec<Ray> = (0..RAYS)
        .map(|i| {
            let target = aim(mesh[i % mesh.len()].corners, chance.next());
            let origin = center + 0.3 * chance.point();
            Ray::new(origin, (target - origin).normalize())
        })
        .collect();
    TriangleTest::ALL
        .map(|triangle| {
            let choice = Arithmetic {
                triangle,
                ..Arithmetic::default()
            };
            let ours = choice == Arithmetic::default();
            let shapes: Vec<Shape> = mesh
                .iter()
                .map(|t| under(choice, Shape::Triangle(*t)))
                .collect();
            let wrong = rays.iter().filter(|ray| {
                let shear = Shear::new(ray);
                let hit = |shape: &&Shape| {
                    let found = shape.intersect(ray, &shear, Interval::FORWARD);
                    matches!(found, Intersection::Hit { .. })
                };
                shapes.iter().filter(hit).count() % 2 == 0
            });
            Outcome {
                arithmetic: if ours {
                    "ours".to_owned()
                } else {
                    format!("--triangle {}", triangle.name())
                },
                ours,
                found: percent(wrong.count(), RAYS),
                allowed: 0.0,
                unit: "% of rays cross an even number of times",
            }
        })
        .to_vec()
}
