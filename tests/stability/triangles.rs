//! Single triangles: shared edges, no area, strange rays, strange numbers.

use proptest::prelude::*;
use raytree::geometry::{Intersection, Shear, Triangle};
use raytree::math::{DVec3, Interval, Ray};

use super::common;
use super::oracle::{Side, line_in_triangle};
use super::support::{Random, count, hits, test, towards, triangle};

fn p(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

/// How many of the two triangles on the edge a-b, with third corners c and d, a ray hits.
fn how_many([a, b, c, d]: [DVec3; 4], ray: &Ray) -> usize {
    let pair = [triangle([a, b, c]), triangle([b, a, d])];
    pair.iter().filter(|t| hits(t, ray)).count()
}

/// A ray through the shared edge hits exactly one triangle, in every order of corners and triangles, with every winding
/// and every order of axes.
#[test]
fn case_06_shared_edge_is_hit_once_however_it_is_written() {
    let mut random = Random(6);
    for _ in 0..count(20_000, 2000) {
        let [a, b] = [random.point(), random.point()];
        // c and d lie on either side of the edge, as the ray sees it.
        let (ahead, edge) = (random.direction(), (b - a).normalize());
        let aside = edge.cross(ahead).normalize();
        let side = |sign: f64, r: &mut Random| {
            a + r.share() * (b - a) + sign * (0.1 + r.share()) * aside + 0.3 * r.unit() * ahead
        };
        let (c, d) = (side(1.0, &mut random), side(-1.0, &mut random));
        let on = a + (0.01 + 0.98 * random.share()) * (b - a);
        let ray = towards(on - 2.0 * ahead, on).expect("a direction");
        for axes in [
            [0, 1, 2],
            [1, 2, 0],
            [2, 0, 1],
            [1, 0, 2],
            [0, 2, 1],
            [2, 1, 0],
        ] {
            for sign in [1.0, -1.0] {
                let map = |v: DVec3| {
                    let v = sign * v;
                    p(v[axes[0]], v[axes[1]], v[axes[2]])
                };
                let ray = Ray::new(map(ray.origin), map(ray.direction));
                let corners = [a, b, c, d].map(map);
                let [a, b, c, d] = corners;
                // The other winding, and the other triangle first.
                for corners in [corners, [b, a, c, d], [b, a, d, c]] {
                    assert_eq!(how_many(corners, &ray), 1, "{corners:?} {ray:?}");
                }
            }
        }
    }
}

/// No area: collinear corners, a corner twice, all three the same. The loader leaves such faces out and says which. One
/// that came through all the same is hit at most within rounding of its line, and never with a NaN.
#[test]
fn case_07_no_area_is_left_out_and_else_harmless() {
    let mut random = Random(7);
    for _ in 0..count(100_000, 5000) {
        let (a, along) = (random.point(), random.point());
        // On a line exactly: multiples of the same step.
        let step = (along * 1024.0).round() / 1024.0;
        let a = (a * 1024.0).round() / 1024.0;
        for corners in [[a, a + step, a + 2.0 * step], [a, a, a + step], [a; 3]] {
            let on = corners[0] + random.share() * (corners[2] - corners[0]);
            let ray = towards(on + random.direction(), on).expect("a direction");
            assert_eq!(Triangle { corners }.normal(), None);
            // Two corners that are one have the same view: no rounding makes an area of them.
            let collinear = corners[1] != corners[0];
            if let Intersection::Hit {
                t,
                place: barycentric,
                ..
            } = test(&triangle(corners), &ray)
            {
                assert!(collinear, "{corners:?} {ray:?}");
                let point = Triangle { corners }.surface(barycentric).point;
                assert!((point - ray.at(t)).length() < 1e-13, "{corners:?} {ray:?}");
            }
            // Beside the line there is nothing.
            let aside = step.any_orthogonal_vector().normalize_or(DVec3::X) * 1e-12;
            let ray = Ray::new(ray.origin + aside, ray.direction);
            let seen_apart = aside.cross(ray.direction).dot(step).abs() > 1e-13;
            assert!(!seen_apart || !hits(&triangle(corners), &ray));
        }
    }
    let warnings = super::support::scene(
        r#"{"format": "raytree-scene/1", "camera": {"eye": [0,0,5], "look_at": [0,0,0], "vertical_fov": 40},
        "materials": {"m": {}}, "objects": [{"mesh": {"name": "flat", "material": "m",
        "vertices": [[0,0,0],[1,0,0],[2,0,0],[0,1,0]], "triangles": [[0,1,3],[0,1,2]]}}]}"#,
    )
    .warnings;
    assert!(
        warnings
            .iter()
            .any(|w| w.to_string().contains("`flat`: 1 of 2")),
        "{warnings:?}"
    );
}

#[test]
fn case_08_a_ray_in_the_plane_misses() {
    let mut random = Random(8);
    for _ in 0..count(100_000, 10_000) {
        // In the plane y = h, where nothing is rounded.
        let h = random.unit();
        let level = |v: DVec3| p(v.x, h, v.z);
        let corners = [random.point(), random.point(), random.point()].map(level);
        let direction = p(random.unit(), 0.0, random.unit()).normalize();
        let ray = Ray::new(level(3.0 * random.point()), direction);
        assert_eq!(test(&triangle(corners), &ray), Intersection::Miss);
    }
}

/// Source: pbrt-v4, `shapes_test.cpp`, Triangle.BadCases: the plane holds the ray's origin in no way, and the triangle is
/// edge-on.
#[test]
fn case_09_pbrt_bad_case_is_missed() {
    let x = -1_113.454_59;
    let corner = |y: f64| p(x, y, -56.243_190_8);
    let corners = [
        corner(-79.049_614),
        corner(-87.092_269_9),
        corner(-79.209_014_9),
    ];
    let origin = p(-1_081.479_25, 99.999_954_2, 87.770_111_1);
    let direction = p(-32.107_299_8, -183.355_865, -144.607_635);
    assert!(!hits(&triangle(corners), &Ray::new(origin, direction)));
}

#[test]
fn case_10_zeros_of_either_sign_in_the_direction_are_the_same() {
    let mut random = Random(10);
    let mut met = 0;
    for _ in 0..count(200_000, 20_000) {
        let mut direction = random.direction();
        let zeros = 1 + random.below(2);
        let first = random.below(3);
        for i in 0..zeros {
            direction[(first + i) % 3] = 0.0;
        }
        let direction = direction.normalize();
        let on = random.point();
        let corners = [0, 1, 2].map(|_| on + 0.5 * random.direction());
        let shape = triangle(corners);
        let mut seen = None;
        for signs in 0..8u32 {
            let mut d = direction;
            for axis in 0..3 {
                if d[axis] == 0.0 && signs >> axis & 1 == 1 {
                    d[axis] = -0.0;
                }
            }
            let found = test(&shape, &Ray::new(on - 3.0 * direction, d));
            assert_eq!(*seen.get_or_insert(found), found, "{corners:?} along {d:?}");
        }
        met += usize::from(matches!(seen, Some(Intersection::Hit { .. })));
    }
    assert!(met > 100, "{met}");
}

#[test]
fn case_11_the_length_of_the_direction_does_not_matter() {
    let mut random = Random(11);
    let mut met = 0;
    for _ in 0..count(200_000, 20_000) {
        let corners = [random.point(), random.point(), random.point()];
        let on = (corners[0] + corners[1] + corners[2]) / 3.0 + 0.3 * random.point();
        let Some(unit) = towards(3.0 * random.direction(), on) else {
            continue;
        };
        let Intersection::Hit {
            t,
            place: barycentric,
            ..
        } = test(&triangle(corners), &unit)
        else {
            continue;
        };
        met += 1;
        for length in [1e-160, 1e150] {
            let ray = Ray::new(unit.origin, length * unit.direction);
            let found = test(&triangle(corners), &ray);
            let Intersection::Hit {
                t: scaled,
                place: weights,
                ..
            } = found
            else {
                panic!("{corners:?} {ray:?}: {found:?}");
            };
            assert!((scaled * length / t - 1.0).abs() < 1e-12);
            let off = [0, 1, 2].map(|i| (weights[i] - barycentric[i]).abs());
            // As far as the rounding of the direction turns it.
            let normal = Triangle { corners }.normal().expect("an area");
            let cos = normal.dot(unit.direction).abs();
            let area = (corners[1] - corners[0])
                .cross(corners[2] - corners[0])
                .length();
            assert!(off.iter().all(|e| *e < 1e-13 / cos / area), "{off:?}");
        }
    }
    assert!(met > 1000, "{met}");
}

/// Rays that are none: no direction, NaN and infinity in any place; intervals that are empty.
#[test]
fn case_12_rays_that_are_none_miss_in_every_accelerator() {
    let mut random = Random(12);
    let shapes: Vec<_> = (0..40)
        .map(|_| triangle([random.point(), random.point(), random.point()]))
        .collect();
    let bad = [
        DVec3::NAN,
        DVec3::INFINITY,
        DVec3::NEG_INFINITY,
        p(0.0, f64::NAN, 1.0),
    ];
    let good = Ray::new(p(0.1, 0.1, 3.0), DVec3::NEG_Z);
    let mut rays = vec![(Ray::new(good.origin, DVec3::ZERO), Interval::FORWARD)];
    for bad in bad {
        rays.push((Ray::new(good.origin, bad), Interval::FORWARD));
        rays.push((Ray::new(bad, good.direction), Interval::FORWARD));
    }
    for max in [f64::NAN, 0.0, -1.0] {
        rays.push((good, Interval::before(max)));
    }
    let start = std::time::Instant::now();
    for (kind, accel) in super::support::all(&shapes) {
        for (ray, interval) in &rays {
            let hit = accel.closest(&shapes, ray, *interval, &mut raytree::probe::Silent);
            assert_eq!(hit, None, "{kind:?}: {ray:?} {interval:?}");
            assert_eq!(
                accel.all_hits(&shapes, ray, *interval),
                [],
                "{kind:?}: {ray:?}"
            );
        }
    }
    assert!(start.elapsed().as_secs() < 10);
}

#[test]
fn case_13_subnormal_triangles_give_no_nan() {
    let mut random = Random(13);
    for _ in 0..count(100_000, 10_000) {
        let corners = [0, 1, 2].map(|_| random.point() * 1e-310);
        let from = random.direction() * [1e-310, 1e-300, 1.0][random.below(3)];
        let Some(ray) = towards(from, corners[0] * 0.3 + corners[1] * 0.4 + corners[2] * 0.3)
        else {
            continue;
        };
        if let Intersection::Hit {
            t,
            place: barycentric,
            ..
        } = test(&triangle(corners), &ray)
        {
            assert!(t.is_finite() && barycentric.iter().all(|w| w.is_finite()));
            let surface = Triangle { corners }.surface(barycentric);
            assert!(surface.point.is_finite() && (surface.normal.length() - 1.0).abs() < 1e-12);
        }
    }
}

proptest! {
    #![proptest_config(common::config(400))]

    /// Along an axis the view of the ray rounds nothing, so the answer must be the exact one, at the last bit of an edge.
    #[test]
    fn case_06_axis_rays_agree_with_exact_arithmetic(seed: u64, axis in 0usize..3, back: bool) {
        let mut random = Random(seed);
        // Multiples of 2^-40 so that differences are exact.
        let grid = |v: DVec3| (v * f64::exp2(40.0)).round() * f64::exp2(-40.0);
        let corners = [0, 1, 2].map(|_| grid(random.point()));
        let mut direction = DVec3::AXES[axis];
        if back {
            direction = -direction;
        }
        let (i, w) = (random.below(3), random.share());
        let on = corners[i] + w * (corners[(i + 1) % 3] - corners[i]);
        for step in [0.0, f64::exp2(-40.0), -f64::exp2(-40.0)] {
            let origin = grid(on) + step * DVec3::ONE - 4.0 * direction;
            let ray = Ray::new(origin, direction);
            let expected = line_in_triangle(&ray, corners);
            let inside = Triangle { corners }.edges(&Shear::new(&ray)).inside;
            match expected {
                Side::Inside => prop_assert!(inside),
                Side::Outside => prop_assert!(!inside),
                Side::Border => {}
            }
        }
    }
}
