//! A ray that leaves a surface does not find it again, at any size and any distance from the origin; and what lies
//! close behind it is not lost.

use proptest::prelude::*;
use raytree::geometry::{
    Aabb, Cuboid, Disc, Intersection, Plane, Shape, Shear, Sphere, Transformed, Triangle,
};
use raytree::math::{DVec3, Interval, Ray, Transform};
use raytree::shading::{Interaction, Side};

use crate::accel::scenes::body;
use crate::common;

/// A number whose power of ten is spread evenly.
fn scale(range: std::ops::Range<i32>) -> impl Strategy<Value = f64> + Clone {
    (range, 1.0..10.0).prop_map(|(power, x)| x * libm::pow(10.0, f64::from(power)))
}

fn unit() -> impl Strategy<Value = DVec3> + Clone {
    let axis = || -1.0..1.0f64;
    let ball = (axis(), axis(), axis()).prop_map(|(x, y, z)| DVec3::new(x, y, z));
    let along = (0usize..3, any::<bool>())
        .prop_map(|(axis, flip)| DVec3::AXES[axis] * if flip { -1.0 } else { 1.0 });
    prop_oneof![4 => ball, 1 => along]
        .prop_filter("a direction", |v| v.length() > 1e-3)
        .prop_map(DVec3::normalize)
}

fn shape() -> impl Strategy<Value = Shape> {
    let at = (unit(), prop_oneof![Just(0.0), scale(-3..7)]).prop_map(|(d, r)| d * r);
    let size = scale(-4..5);
    let sphere = (at.clone(), size.clone())
        .prop_map(|(center, radius)| Shape::Sphere(Sphere { center, radius }));
    let level =
        (unit(), unit(), 0usize..4, size.clone(), at.clone()).prop_map(|(b, c, flat, size, at)| {
            // Often in a plane along the axes, where one coordinate is 0.
            let mut corners = [DVec3::ZERO, b, c].map(|p| p * size + at);
            if flat < 3 {
                for p in &mut corners {
                    p[flat] = 0.0;
                }
            }
            Triangle { corners }
        });
    // A needle's own normal is noise: which way is out cannot be told.
    let level = level
        .prop_filter("an area", |t| {
            let [a, b, c] = t.corners;
            let (e, f) = (b - a, c - a);
            e.cross(f).length() > 1e-7 * e.length().max(f.length()).powi(2)
        })
        .prop_map(Shape::Triangle);
    let cuboid = |at: DVec3, size: DVec3| Cuboid {
        bounds: Aabb {
            min: at - size,
            max: at + size,
        },
    };
    let boxes = (at.clone(), unit(), size.clone())
        .prop_map(move |(at, edge, size)| Shape::Cuboid(cuboid(at, (edge.abs() + 0.01) * size)));
    let discs = (at.clone(), unit(), size.clone())
        .prop_map(|(at, normal, size)| Shape::Disc(Box::new(Disc::new(at, normal, size))));
    let planes = (at.clone(), unit()).prop_map(|(p, n)| Shape::Plane(Box::new(Plane::new(p, n))));
    let placed = (at, unit(), 0.0..6.0f64, unit(), size, any::<bool>()).prop_filter_map(
        "invertible",
        move |(at, axis, angle, stretch, size, round)| {
            let turn = glam::DAffine3::from_axis_angle(axis, angle);
            let map = glam::DAffine3::from_translation(at)
                * turn
                * glam::DAffine3::from_scale((stretch.abs() + 0.05) * size);
            let shape = if round {
                Shape::Sphere(Sphere {
                    center: DVec3::ZERO,
                    radius: 1.0,
                })
            } else {
                Shape::Cuboid(cuboid(DVec3::ZERO, DVec3::ONE))
            };
            Some(Shape::Transformed(Box::new(Transformed {
                shape,
                transform: Transform::new(map)?,
            })))
        },
    );
    prop_oneof![sphere, level, boxes, discs, planes, placed]
}

/// Where a ray towards a place on or in the shape arrives, if it does.
fn arrive(shape: &Shape, target: DVec3, from: DVec3, distance: f64) -> Option<Interaction> {
    let origin = target + from * distance;
    let ray = Ray::new(origin, (target - origin).try_normalize()?);
    match shape.intersect(&ray, &Shear::new(&ray), Interval::FORWARD) {
        Intersection::Hit { t, place, part } => Some(Interaction::new(
            &shape.surface(&ray, t, place, part),
            ray.direction,
            None,
        )),
        _ => None,
    }
}

/// A point in the middle of the shape, or on it.
fn target(shape: &Shape, weights: [f64; 3]) -> DVec3 {
    match shape {
        Shape::Triangle(t) => {
            let sum: f64 = weights.iter().sum();
            t.corners[0] * (weights[0] / sum)
                + t.corners[1] * (weights[1] / sum)
                + t.corners[2] * (weights[2] / sum)
        }
        Shape::Plane(plane) => plane.normal() * 0.5,
        Shape::Disc(disc) => {
            let [x, y, _] = weights.map(|w| (w - 0.5) * disc.radius);
            disc.center + x * disc.frame.u + y * disc.frame.v
        }
        other => other
            .bounds()
            .map_or(DVec3::ZERO, |b| b.min + DVec3::from(weights) * b.size()),
    }
}

proptest! {
    #![proptest_config(common::config(4000))]

    #[test]
    fn a_ray_that_leaves_does_not_come_back(
        shape in shape(),
        weights in [0.01..1.0f64, 0.01..1.0, 0.01..1.0],
        from in unit(),
        distance in scale(-2..3),
        outwards in prop::collection::vec(unit(), 20),
        grazing in scale(-12..0),
    ) {
        let Some(at) = arrive(&shape, target(&shape, weights), from, distance) else {
            return Ok(());
        };
        // From inside a solid the ray rightly meets its other side.
        if at.side == Side::Back && !matches!(shape, Shape::Triangle(_) | Shape::Plane(_)) {
            return Ok(());
        }
        let n = at.geometric_normal;
        for d in outwards {
            let d = if d.dot(n) < 0.0 { -d } else { d };
            // Steep, and nearly along the surface.
            let along = (d - n.dot(d) * n).normalize_or(DVec3::X);
            for direction in [d, (along + grazing * n).normalize()] {
                // A direction that rounding has laid below the surface does not leave it.
                if n.dot(direction) <= 1e-13 {
                    continue;
                }
                let ray = Ray::new(at.origin_towards(direction), direction);
                let found = shape.intersect(&ray, &Shear::new(&ray), Interval::FORWARD);
                prop_assert!(
                    !matches!(found, Intersection::Hit { .. }),
                    "{shape:?} from {:?} along {direction:?}: {found:?}", at.point
                );
            }
        }
    }
}

#[test]
fn a_surface_a_nanometre_behind_is_not_lost() {
    for offset in [0.0, 1e3] {
        for gap in [1e-9, 1e-6] {
            let level = |y: f64| Triangle {
                corners: [[-1.0, y, 1.0], [1.0, y, 1.0], [0.0, y, -1.0]]
                    .map(|p| DVec3::from(p) + offset),
            };
            let (lower, upper) = (level(0.0), Shape::Triangle(level(gap)));
            for i in 0..1000 {
                let w = f64::from(i) / 1000.0;
                let surface = lower.surface([0.2, 0.1 + 0.6 * w, 0.7 - 0.6 * w]);
                let at = Interaction::new(&surface, DVec3::NEG_Y, None);
                let up = DVec3::new(0.3 * (w - 0.5), 1.0, 0.1).normalize();
                let ray = Ray::new(at.origin_towards(up), up);
                let found = upper.intersect(&ray, &Shear::new(&ray), Interval::FORWARD);
                let hit = matches!(found, Intersection::Hit { .. });
                assert!(hit, "offset {offset}, gap {gap}: {found:?}");
            }
        }
    }
}

proptest! {
    #![proptest_config(common::config(3000))]

    /// Of all closed bodies, turned, stretched and moved: a ray that leaves the surface to the outside crosses it an even number of
    /// times ahead, and one that goes in an odd number of times.
    #[test]
    fn a_ray_is_on_the_side_to_which_it_leaves(
        number in 0usize..6,
        at in (unit(), prop_oneof![Just(0.0), scale(-3..7)]).prop_map(|(d, r)| d * r),
        (axis, angle) in (unit(), 0.0..6.0f64),
        (stretch, size) in (unit(), scale(-4..5)),
        weights in [0.01..1.0f64, 0.01..1.0, 0.01..1.0],
        from in unit(),
        distance in scale(-2..3),
        directions in prop::collection::vec(unit(), 10),
        grazing in scale(-9..0),
    ) {
        let map = glam::DAffine3::from_translation(at)
            * glam::DAffine3::from_axis_angle(axis, angle)
            * glam::DAffine3::from_scale((stretch.abs() + 0.05) * size);
        let Some(transform) = Transform::new(map) else {
            return Ok(());
        };
        let shape = Shape::Transformed(Box::new(Transformed {
            shape: Shape::Body(Box::new(body(number))),
            transform,
        }));
        let Some(at) = arrive(&shape, target(&shape, weights), from, distance * size) else {
            return Ok(());
        };
        // Outwards, whatever side the ray came from.
        let out = if at.side == Side::Back { -at.geometric_normal } else { at.geometric_normal };
        for d in directions {
            let along = (d - out.dot(d) * out).normalize_or(DVec3::X);
            let graze = grazing * if out.dot(d) < 0.0 { -1.0 } else { 1.0 };
            for direction in [d, (along + graze * out).normalize()] {
                // A direction along the surface leaves it to neither side.
                if out.dot(direction).abs() <= 1e-13 {
                    continue;
                }
                let ray = Ray::new(at.origin_towards(direction), direction);
                let spans = shape.spans(&ray).expect("a solid");
                let ahead = spans.cuts().filter(|(cut, _)| cut.t > 0.0).count();
                let inside = ahead % 2 == 1;
                prop_assert_eq!(
                    inside, out.dot(direction) < 0.0,
                    "{:?} from {:?} along {:?}: {:?}", shape, at.point, direction, spans
                );
            }
        }
    }
}
