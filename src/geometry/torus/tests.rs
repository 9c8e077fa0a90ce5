//! What is known of a torus on paper. What must hold for any ray is in [`laws`].

mod laws;
mod near_tangent;

use near_tangent::NEAR_TANGENT;

use super::*;
use crate::geometry::test_rays::TestRays;

const RING: Torus = torus(1.0, 0.25);
const HORN: Torus = torus(1.0, 1.0);
const SPINDLE: Torus = torus(1.0, 1.5);
const THREAD: Torus = torus(1.0, 1e-6);

const fn torus(major: f64, minor: f64) -> Torus {
    Torus { major, minor }
}

fn ray(origin: [f64; 3], direction: [f64; 3]) -> Ray {
    Ray::new(DVec3::from(origin), DVec3::from(direction))
}

fn cuts(torus: Torus, ray: &Ray) -> Vec<f64> {
    torus.spans(ray).cuts().map(|(cut, _)| cut.t).collect()
}

/// How far a point is from the surface.
fn distance(torus: Torus, p: DVec3) -> f64 {
    let ring = libm::hypot(p.x, p.z) - torus.major;
    (libm::hypot(ring, p.y) - torus.minor).abs()
}

#[test]
fn along_x_all_four_crossings_are_exact() {
    let expected = [-1.25, -0.75, 0.75, 1.25];
    assert_eq!(cuts(RING, &ray([0.0; 3], [1.0, 0.0, 0.0])), expected);
    for distance in [8.0, 4096.0, 1e7] {
        let far = ray([-distance, 0.0, 0.0], [1.0, 0.0, 0.0]);
        assert_eq!(cuts(RING, &far), expected.map(|t| distance + t));
    }
    let thread = cuts(THREAD, &ray([0.0; 3], [0.0, 0.0, -1.0]));
    assert_eq!(thread, [-1.0 - 1e-6, -1.0 + 1e-6, 1.0 - 1e-6, 1.0 + 1e-6]);
}

#[test]
fn t_is_in_units_of_the_direction() {
    let mut random = TestRays(1);
    for _ in 0..100 {
        let one = random.ray(1.0, 3.0);
        let many = Ray::new(one.origin, one.direction * 1024.0);
        let scaled: Vec<_> = cuts(RING, &many).iter().map(|t| t * 1024.0).collect();
        assert_eq!(cuts(RING, &one), scaled);
    }
}

#[test]
fn a_ray_in_the_top_plane_touches_and_one_float_lower_crosses() {
    let top = RING.minor;
    for direction in [
        [1.0, 0.0, 0.0],
        [0.0, 0.0, 1.0],
        [1.0, 0.0, 1.0],
        [3.0, 0.0, -4.0],
    ] {
        for x in [0.0, 0.5, -0.3] {
            let above = ray([x, top, 0.1], direction);
            let below = ray([x, top.next_down(), 0.1], direction);
            assert!(cuts(RING, &above).is_empty());
            assert_eq!(cuts(RING, &below).len(), 4, "{below:?}");
        }
    }
}

#[test]
fn a_ray_along_the_axis_passes_the_hole_and_crosses_a_spindle() {
    let axis = ray([0.0; 3], [0.0, 1.0, 0.0]);
    assert_eq!(
        RING.arithmetic(&axis).quick_miss,
        Some(TorusMiss::Bernstein)
    );
    assert!(cuts(HORN, &axis).is_empty());
    let found = cuts(SPINDLE, &axis);
    assert_eq!(found, [-1.25f64.sqrt(), 1.25f64.sqrt()]);
    // In the middle of a horn the surface touches itself: the line is inside but for one point.
    let through = HORN.spans(&ray([0.0; 3], [1.0, 0.0, 0.0]));
    assert_eq!(through.length(), 4.0);
}

#[test]
fn the_lemon_in_a_spindle_is_no_surface() {
    let mut random = TestRays(2);
    for _ in 0..500 {
        // From anywhere in the lemon, in any direction, there is one way in and one way out around the origin.
        let from = Ray::new(0.3 * random.in_cube(), random.direction());
        let spans = SPINDLE.spans(&from);
        let around = |span: &&crate::geometry::Span| span.enter.t < 0.0 && span.leave.t > 0.0;
        assert_eq!(spans.0.iter().filter(around).count(), 1);
        for t in cuts(SPINDLE, &from) {
            assert!(distance(SPINDLE, from.at(t)) < 1e-14);
        }
    }
}

#[test]
fn from_any_distance_the_crossings_are_the_same() {
    // Along z nothing is rounded but t itself, so the same line may start anywhere.
    let mut random = TestRays(3);
    let line = |torus: Torus, x: f64, y: f64| {
        let near = cuts(torus, &ray([x, y, 0.0], [0.0, 0.0, 1.0]));
        for start in [1e1, 1e3, 1e5, 1e7] {
            let far = cuts(torus, &ray([x, y, -start], [0.0, 0.0, 1.0]));
            let expected: Vec<_> = near.iter().map(|t| start + t).collect();
            assert_eq!(far, expected);
        }
        near.len()
    };
    for torus in [RING, HORN, SPINDLE, THREAD] {
        for _ in 0..50 {
            line(torus, 2.0 * random.signed(), torus.minor * random.signed());
        }
    }
    // The outer and the inner equator, a hair off: on the outer side it misses, on the inner it crosses twice, not four times.
    for gap in [1e-15, 1e-12, 1e-9] {
        assert_eq!(line(RING, 1.25 + gap, 0.0), 0);
        assert_eq!(line(RING, 1.25 - gap, 0.0), 2);
        assert_eq!(line(RING, 0.75 + gap, 0.0), 2);
        assert_eq!(line(RING, 0.75 - gap, 0.0), 4);
    }
}

#[test]
fn rays_that_nearly_touch_are_counted_as_50_digits_count_them() {
    for (origin, direction, expected) in NEAR_TANGENT {
        let ray = ray(origin, direction);
        let found = cuts(RING, &ray);
        assert_eq!(found.len(), expected.len(), "{ray:?}");
        for (t, exact) in found.iter().zip(expected) {
            // As for the crossing's distance from the surface: |dt| times the cosine.
            let p = point_at(&ray, *t);
            let cosine = (RING.gradient(p).normalize().dot(ray.direction)).abs();
            let size = ray.origin.length() + 1.25;
            assert!(
                (t - exact).abs() * cosine <= gamma(16) * size,
                "{t} {exact}"
            );
        }
    }
}

#[test]
fn the_plane_that_touches_twice_cuts_two_circles() {
    // Villarceau 1848: the plane through the centre with sin(angle) = r / R cuts circles of radius R, their middles at +-r.
    let sin = RING.minor / RING.major;
    let slope = DVec3::new((1.0 - sin * sin).sqrt(), sin, 0.0);
    let mut random = TestRays(4);
    let mut four = 0;
    for _ in 0..200 {
        let angle = TAU * random.unit();
        let (s, c) = libm::sincos(angle);
        let (across, along) = (0.7 * random.signed(), slope * c + DVec3::Z * s);
        let origin = across * (DVec3::Z * c - slope * s);
        let found = cuts(RING, &Ray::new(origin, along));
        let mut expected = Vec::new();
        for middle in [DVec3::Z * RING.minor, DVec3::Z * -RING.minor] {
            let (b, off) = (
                (middle - origin).dot(along),
                (middle - origin).length_squared(),
            );
            let half = (1.0 - (off - b * b)).max(0.0).sqrt();
            expected.extend([b - half, b + half]);
        }
        expected.sort_by(f64::total_cmp);
        // Where the circles cross, the plane touches the torus: there two crossings may be one touch.
        let gaps = expected.windows(2).map(|pair| pair[1] - pair[0]);
        if gaps.fold(f64::INFINITY, f64::min) > 1e-3 {
            four += 1;
            assert_eq!(found.len(), 4);
            assert!(
                found
                    .iter()
                    .zip(&expected)
                    .all(|(t, x)| (t - x).abs() < 1e-12)
            );
        }
    }
    assert!(four > 150);
}
