//! Spheres: tiny and far, huge and near, touched at their rim, left and entered.

use proptest::prelude::*;
use raytree::geometry::{Intersection, Shape, Sphere};
use raytree::math::{DVec3, Ray};

use super::common;
use super::oracle::{crossing_within, line_meets_sphere};
use super::support::{Random, count, test, towards};

/// The quadratic of the school: b^2 - 4 a c, both halves of which are nearly equal here.
fn school_formula_hits(ray: &Ray, center: DVec3, radius: f64) -> bool {
    let f = ray.origin - center;
    let (a, b) = (ray.direction.length_squared(), 2.0 * f.dot(ray.direction));
    let c = f.length_squared() - radius * radius;
    b * b - 4.0 * a * c >= 0.0
}

#[test]
fn case_19_a_tiny_sphere_far_away() {
    let (radius, distance) = (1e-4, 1e5);
    let mut random = Random(19);
    let (rays, mut wrong, mut met) = (count(100_000, 4000), 0, 0);
    for i in 0..rays {
        let center = distance * random.direction();
        let target = center + 1.5 * radius * random.point();
        let ray = towards(DVec3::ZERO, target).expect("a direction");
        let found = test(&Shape::Sphere(Sphere { center, radius }), &ray);
        let expected = line_meets_sphere(&ray, center, radius);
        let hit = matches!(found, Intersection::Hit { .. });
        assert_eq!(hit, expected, "{center} {ray:?}");
        wrong += usize::from(school_formula_hits(&ray, center, radius) != expected);
        if let Intersection::Hit { t, .. } = found {
            met += 1;
            if i % 8 == 0 {
                assert!(
                    crossing_within(&ray, center, radius, t, 2e-10),
                    "{ray:?}: {t}"
                );
            }
        }
    }
    let share = wrong as f64 / rays as f64;
    println!(
        "{rays} rays, {met} hits, none wrong; the school formula is wrong on {:.1} %",
        100.0 * share
    );
    assert!(met > rays / 4 && share > 0.3, "{met} of {rays}, {share}");
}

#[test]
fn case_20_a_huge_sphere_just_below() {
    let radius = 1e6;
    let center = DVec3::new(0.0, -radius, 0.0);
    let ulp = radius.next_up() - radius;
    let mut random = Random(20);
    for _ in 0..count(50_000, 2000) {
        let down = -random.share() - 1e-6;
        let aside = 10.0 * random.point();
        let direction = DVec3::new(aside.x, down, aside.z).normalize();
        let ray = Ray::new(DVec3::new(0.0, 1e-3, 0.0), direction);
        let shape = Shape::Sphere(Sphere { center, radius });
        let Intersection::Hit { t, .. } = test(&shape, &ray) else {
            assert!(!line_meets_sphere(&ray, center, radius), "{ray:?}");
            continue;
        };
        let normal = (ray.at(t) - center).normalize();
        let cos = normal.dot(direction).abs();
        let allowed = 2.0 * ulp / cos;
        assert!(
            crossing_within(&ray, center, radius, t, allowed),
            "{ray:?}: {t}, cos {cos}"
        );
    }
}

#[test]
fn case_21_tangents_to_the_last_bit() {
    let sphere = |radius| {
        Shape::Sphere(Sphere {
            center: DVec3::ZERO,
            radius,
        })
    };
    for radius in [1.0, 0.1, 3e7, 1e-9] {
        for x in [f64::next_down(radius), radius, f64::next_up(radius)] {
            for axis in 0..3 {
                let (mut origin, mut direction) = (DVec3::ZERO, DVec3::ZERO);
                origin[axis] = x;
                origin[(axis + 1) % 3] = 5.0 * radius;
                direction[(axis + 1) % 3] = -1.0;
                let ray = Ray::new(origin, direction);
                // r^2 and x^2 are rounded: where they are equal then, either answer will do.
                let decided = x * x != radius * radius || x == radius;
                let found = test(&sphere(radius), &ray);
                if decided {
                    let hit = matches!(found, Intersection::Hit { .. });
                    assert_eq!(hit, x <= radius, "{radius} {x}");
                }
                if let Intersection::Hit { t, place, part } = found {
                    let at = sphere(radius).surface(&ray, t, place, part);
                    assert!((at.normal.length() - 1.0).abs() < 1e-15);
                    assert!(at.point.is_finite() && at.error.is_finite() && at.uv.is_finite());
                }
            }
        }
    }
}

#[test]
fn case_22_on_the_sphere_going_out_and_going_in() {
    let mut random = Random(22);
    for _ in 0..count(20_000, 2000) {
        // Points that are on it exactly: along the axes.
        let radius = 1e-3 + 1000.0 * random.share();
        let up = DVec3::AXES[random.below(3)] * if random.below(2) == 0 { 1.0 } else { -1.0 };
        let center = DVec3::ZERO;
        let shape = Shape::Sphere(Sphere { center, radius });
        let slanted = (up + 0.9 * random.point()).normalize();
        let out = if slanted.dot(up) < 0.0 {
            -slanted
        } else {
            slanted
        };
        let leaves = test(&shape, &Ray::new(radius * up, out));
        assert!(!matches!(leaves, Intersection::Hit { .. }), "{leaves:?}");
        let Intersection::Hit { t, .. } = test(&shape, &Ray::new(radius * up, -out)) else {
            panic!("the far side is hit");
        };
        // A flat chord is told as much less exactly as it is flat, as for any crossing.
        let allowed = 4.0 * f64::EPSILON * radius / out.dot(up);
        let ray = Ray::new(radius * up, -out);
        assert!(
            t > 0.0 && crossing_within(&ray, center, radius, t, allowed),
            "{t}"
        );
    }
}

#[test]
fn case_23_from_the_centre_t_is_the_radius() {
    for power in -300..300 {
        let radius = f64::exp2(f64::from(power));
        let shape = Shape::Sphere(Sphere {
            center: DVec3::ONE * 0.0,
            radius,
        });
        for direction in DVec3::AXES {
            let found = test(&shape, &Ray::new(DVec3::ZERO, direction));
            assert!(
                matches!(found, Intersection::Hit { t, .. } if t == radius),
                "2^{power}: {found:?}"
            );
        }
    }
}

proptest! {
    #![proptest_config(common::config(1000))]

    /// Any sphere from anywhere: t is within a few roundings of the numbers that it is made of, seen along the normal.
    #[test]
    fn case_19_any_sphere_is_crossed_where_it_is(
        seed: u64,
        power in -8i32..8,
        away in -3i32..9,
    ) {
        let mut random = Random(seed);
        let radius = libm::pow(10.0, f64::from(power));
        let center = radius * libm::pow(10.0, f64::from(away)) * random.direction();
        let Some(ray) = towards(DVec3::ZERO, center + radius * random.point()) else {
            return Ok(());
        };
        let shape = Shape::Sphere(Sphere { center, radius });
        if let Intersection::Hit { t, .. } = test(&shape, &ray) {
            let normal = (ray.at(t) - center).normalize();
            let cos = normal.dot(ray.direction).abs().max(1e-6);
            let allowed = 16.0 * f64::EPSILON * (center.length() + radius) / cos;
            prop_assert!(crossing_within(&ray, center, radius, t, allowed), "{shape:?} {ray:?} {t}");
        }
    }
}
