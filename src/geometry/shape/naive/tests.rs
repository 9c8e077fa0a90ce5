//! Other arithmetic agrees with ours where nothing is hard, and never brings a NaN.

use super::*;
use crate::geometry::{
    Cuboid, Disc, PatchMethod, Plane, QuarticMethod, Sphere, Transformed, Triangle,
};
use crate::math::Transform;

const CHOICES: usize = 3 * 2 * 2;

/// Every way to test; the offset plays no part in it.
fn arithmetic(i: usize) -> Arithmetic {
    Arithmetic {
        triangle: TriangleTest::ALL[i % 3],
        quadratic: Quadratic::ALL[i / 3 % 2],
        quartic: QuarticMethod::ALL[i % 3],
        precision: Precision::ALL[i / 6],
        offset: Offset::Bounded,
        patch: PatchMethod::Exact,
    }
}

/// A number in [-1, 1), always the same for the same i.
fn noise(i: u64) -> f64 {
    let bits = (i + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let bits = (bits ^ (bits >> 31)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    (bits >> 11) as f64 / (1u64 << 52) as f64 - 1.0
}

fn point(i: u64) -> DVec3 {
    DVec3::new(noise(3 * i), noise(3 * i + 1), noise(3 * i + 2))
}

fn shapes() -> Vec<Shape> {
    let turned = glam::DAffine3::from_axis_angle(DVec3::ONE.normalize(), 0.7);
    let cuboid = Cuboid {
        bounds: Aabb::around([DVec3::new(-0.5, -0.4, -0.3), DVec3::new(0.3, 0.4, 0.5)]),
    };
    vec![
        Shape::Triangle(Triangle {
            corners: [point(1), point(2), point(3)],
        }),
        Shape::Sphere(Sphere {
            center: 0.1 * point(4),
            radius: 0.6,
        }),
        Shape::Plane(Box::new(Plane::new(0.2 * point(5), point(6).normalize()))),
        Shape::Cuboid(cuboid),
        Shape::Disc(Box::new(Disc::new(
            0.2 * point(7),
            point(8).normalize(),
            0.7,
        ))),
        Shape::Transformed(Box::new(Transformed {
            shape: Shape::Cuboid(cuboid),
            transform: Transform::new(turned).expect("a turn"),
        })),
    ]
}

fn random_ray(i: u64) -> Ray {
    let origin = 3.0 * point(2 * i + 100).normalize();
    let target = 0.7 * point(2 * i + 101);
    Ray::new(origin, (target - origin).normalize())
}

#[test]
fn where_nothing_is_hard_all_arithmetic_agrees() {
    for shape in shapes() {
        let (mut hits, mut differ) = (0, 0);
        for i in 0..2000 {
            let ray = random_ray(i);
            let shear = Shear::new(&ray);
            let ours = shape.intersect(&ray, &shear, Interval::FORWARD);
            hits += u32::from(matches!(ours, Intersection::Hit { .. }));
            for arithmetic in (0..CHOICES).map(arithmetic) {
                let digits = if arithmetic.precision == Precision::Single {
                    1e-3
                } else {
                    1e-10
                };
                let other = shape.computed_with(arithmetic);
                match (ours, other.intersect(&ray, &shear, Interval::FORWARD)) {
                    (Intersection::Hit { t, .. }, Intersection::Hit { t: other, .. }) => {
                        differ += u32::from((t - other).abs() > digits);
                    }
                    (Intersection::Hit { .. }, _) | (_, Intersection::Hit { .. }) => differ += 1,
                    _ => {}
                }
            }
        }
        assert!(hits > 100, "{}: {hits}", shape.kind());
        // In single precision an edge may be missed by a hair.
        assert!(differ <= 12, "{}: {differ}", shape.kind());
    }
}

#[test]
fn in_double_precision_the_generic_sphere_is_ours_bit_for_bit() {
    let Shape::Sphere(ball) = shapes()[1] else {
        panic!("the second shape is a sphere");
    };
    for i in 0..2000 {
        let ray = random_ray(i);
        let ours = ball.intersect(&ray, Interval::FORWARD);
        assert_eq!(sphere::stable::<f64>(&ball, &ray, Interval::FORWARD), ours);
    }
}

#[test]
fn the_offset_is_what_was_asked_for() {
    let ray = Ray::new(
        DVec3::new(0.3, 4.0, 0.1),
        DVec3::new(-0.08, -1.0, 0.02).normalize(),
    );
    for shape in &shapes()[1..2] {
        let Intersection::Hit { t, .. } =
            shape.intersect(&ray, &Shear::new(&ray), Interval::FORWARD)
        else {
            panic!("the ray runs to the sphere");
        };
        let with = |offset| {
            let arithmetic = Arithmetic {
                offset,
                ..Arithmetic::default()
            };
            let at = shape
                .computed_with(arithmetic)
                .surface(&ray, t, [0.0; 3], 0);
            let origin =
                crate::math::rounding::offset_origin(at.point, at.error, at.normal, at.normal);
            (origin - ray.at(t)).dot(at.normal)
        };
        assert_eq!(with(Offset::None), 0.0);
        assert!((with(Offset::Fixed(1e-3)) - 1e-3).abs() < 1e-12);
        assert!(with(Offset::Bounded) < 1e-13);
    }
}

#[test]
fn no_number_makes_a_nan() {
    let odd = [
        0.0,
        -0.0,
        1e-310,
        1e-160,
        1.0,
        1e12,
        1e160,
        f64::MAX,
        f64::INFINITY,
        f64::NAN,
    ];
    let pick = |i: u64| odd[(noise(i).abs() * 10.0) as usize];
    let point = |i: u64| DVec3::new(pick(3 * i), pick(3 * i + 1), pick(3 * i + 2));
    for i in 0..3000 {
        let corners = [point(5 * i), point(5 * i + 1), point(5 * i + 2)];
        let shape = Shape::Triangle(Triangle { corners });
        let ray = Ray::new(point(5 * i + 3), point(5 * i + 4));
        for arithmetic in (0..CHOICES).map(arithmetic) {
            let naive = shape.computed_with(arithmetic);
            if arithmetic.triangle == TriangleTest::Watertight
                && arithmetic.precision == Precision::Double
            {
                continue;
            }
            let found = naive.intersect(&ray, &Shear::new(&ray), Interval::FORWARD);
            if let Intersection::Hit { t, place, .. } = found {
                assert!(
                    t.is_finite() && place.iter().all(|w| w.is_finite()),
                    "{arithmetic:?} {shape:?} {ray:?}"
                );
            }
        }
    }
}

#[test]
fn our_own_arithmetic_needs_no_wrapper() {
    let shape = &shapes()[0];
    let naive = shape.computed_with(arithmetic(0));
    assert!(matches!(naive, Shape::Naive(_)));
    assert!(matches!(
        naive.computed_with(Arithmetic::default()),
        Shape::Triangle(_)
    ));
    let twice = naive.computed_with(arithmetic(1));
    assert!(matches!(twice.plain(), Shape::Triangle(_)));
}
