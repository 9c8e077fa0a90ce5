//! What must hold for any ray.

use super::*;
use crate::geometry::test_rays::many;
use crate::math::rounding::offset_origin;

/// A ray that leaves a torus' surface, on the side it goes to: it must not find the place it left.
fn leave(torus: Torus, random: &mut TestRays, grazing: bool) {
    let (s, c) = libm::sincos(TAU * random.unit());
    let (v, u) = libm::sincos(TAU * random.unit());
    let ring = torus.major + torus.minor * u;
    let near = DVec3::new(ring * c, torus.minor * v, ring * s);
    let distance = 10.0 * random.unit();
    let to = random.direction();
    let arrival = Ray::new(near - distance * to, to);
    let spans = torus.spans(&arrival);
    for (cut, _) in spans.cuts() {
        let found = torus.surface(&arrival, cut.t, 0);
        let mut direction = random.direction();
        if grazing {
            // Nearly along the surface.
            let tangent = direction.cross(found.normal).normalize();
            direction = (tangent + 1e-9 * random.signed() * found.normal).normalize();
        }
        let origin = offset_origin(found.point, found.error, found.normal, direction);
        let next = torus.spans(&Ray::new(origin, direction));
        let ahead = next.cuts().filter(|(cut, _)| cut.t > 0.0).count();
        let outwards = direction.dot(found.normal) >= 0.0;
        assert_eq!(
            ahead % 2 == 0,
            outwards,
            "{torus:?} {origin:?} {direction:?}"
        );
        // The outer half is convex: from there, nothing of the torus is in front.
        let ring = libm::hypot(found.point.x, found.point.z);
        if outwards && ring >= torus.major {
            assert_eq!(ahead, 0, "{torus:?} {origin:?} {direction:?}");
        }
        // And it is not jumped over: the offset is far below 1e-9.
        assert!((origin - found.point).length() < 1e-13 * (torus.major + torus.minor));
    }
}

const ALL_SHAPES: [Torus; 6] = [
    RING,
    HORN,
    SPINDLE,
    THREAD,
    torus(1e3, 0.1),
    torus(1e-3, 9e-4),
];

#[test]
fn a_ray_that_leaves_does_not_find_its_own_surface() {
    let mut random = TestRays(5);
    for torus in ALL_SHAPES {
        for i in 0..many(400) {
            leave(torus, &mut random, i % 2 == 0);
        }
    }
}

/// Aimed at the surface, at random or so that it nearly touches.
fn aimed(torus: Torus, random: &mut TestRays) -> Ray {
    let (s, c) = libm::sincos(TAU * random.unit());
    let (v, u) = libm::sincos(TAU * random.unit());
    let n = DVec3::new(u * c, v, u * s);
    let p = torus.major * DVec3::new(c, 0.0, s) + torus.minor * n;
    let mut d = random.direction();
    if random.unit() < 0.5 {
        d = d.cross(n).normalize();
    }
    let size = torus.major + torus.minor;
    let gap = size * random.signed() * libm::exp(-36.0 * random.unit());
    let far = size * [1.0, 1e3, 1e6][(3.0 * random.unit()) as usize];
    Ray::new(p + gap * n - far * d, d)
}

fn even(torus: Torus, ray: &Ray) {
    let steps = torus.arithmetic(ray);
    let crossings = steps.pieces.iter().filter(|piece| piece.crossing.is_some());
    assert_eq!(crossings.count() % 2, 0);
    let spans = steps.spans();
    let t: Vec<_> = spans.cuts().map(|(cut, _)| cut.t).collect();
    assert!(t.len().is_multiple_of(2) && t.windows(2).all(|pair| pair[0] < pair[1]));
    for (cut, enters) in spans.cuts() {
        assert_eq!(spans.enters(cut.t), Some(enters));
    }
}

#[test]
fn every_line_crosses_an_even_number_of_times() {
    let mut random = TestRays(7);
    for torus in ALL_SHAPES {
        (0..many(500)).for_each(|_| even(torus, &aimed(torus, &mut random)));
    }
}

#[test]
fn the_mean_length_of_spans_is_the_volume() {
    const SIDE: u32 = 200;
    for torus in [RING, HORN, SPINDLE] {
        for down in [DVec3::NEG_Y, DVec3::new(0.48, 0.6, 0.64)] {
            let (u, v) = down.any_orthonormal_pair();
            let size = torus.major + torus.minor;
            let mut sum = 0.0;
            for i in 0..SIDE * SIDE {
                let place = |k: u32| size * (2.0 * (f64::from(k) + 0.5) / f64::from(SIDE) - 1.0);
                let origin = place(i % SIDE) * u + place(i / SIDE) * v;
                sum += torus.spans(&Ray::new(origin, down)).length();
            }
            let mean = sum / f64::from(SIDE * SIDE);
            let volume = mean * 4.0 * size * size;
            assert!(
                (volume / torus.volume() - 1.0).abs() < 3e-3,
                "{torus:?} {volume}"
            );
        }
    }
    assert_eq!(RING.volume(), 2.0 * PI * PI * 0.0625);
    // With no major radius left, a spindle is a sphere.
    assert!((torus(1e-12, 1.0).volume() - 4.0 / 3.0 * PI).abs() < 1e-11);
}

#[test]
fn normals_are_gradients_and_point_outwards() {
    let mut random = TestRays(9);
    let f = |torus: Torus, p: DVec3| {
        let ring = libm::hypot(p.x, p.z) - torus.major;
        ring * ring + p.y * p.y - torus.minor * torus.minor
    };
    for torus in [RING, HORN, SPINDLE] {
        for _ in 0..200 {
            let from = random.ray(1.0, 5.0);
            for (cut, enters) in torus.spans(&from).cuts() {
                let found = torus.surface(&from, cut.t, 0);
                let difference = |axis: DVec3| {
                    let h = 1e-6 * axis;
                    (f(torus, found.point + h) - f(torus, found.point - h)) / 2e-6
                };
                let slope = DVec3::new(
                    difference(DVec3::X),
                    difference(DVec3::Y),
                    difference(DVec3::Z),
                );
                let gradient = torus.gradient(found.point);
                assert!(
                    (slope - gradient).length()
                        < 1e-6 * (1.0 + 1.0 / libm::hypot(found.point.x, found.point.z))
                );
                assert!((found.normal - gradient.normalize()).length() < 1e-13);
                assert!((found.normal.length() - 1.0).abs() < 1e-15);
                assert_eq!(found.normal.dot(from.direction) < 0.0, enters);
                assert!(distance(torus, found.point) <= found.error.max_element());
                let uv = found.uv;
                assert!(uv.cmpge(DVec2::ZERO).all() && uv.cmple(DVec2::ONE).all());
                let Aabb { min, max } = torus.bounds();
                assert!(found.point.cmpge(min).all() && found.point.cmple(max).all());
            }
        }
    }
}

#[test]
fn no_numbers_are_too_strange() {
    let mut random = TestRays(10);
    let mut pick = || random.strange();
    for _ in 0..20_000 {
        let from = ray([pick(), pick(), pick()], [pick(), pick(), pick()]);
        let torus = torus(pick(), pick());
        for (cut, _) in torus.spans(&from).cuts() {
            assert!(!cut.t.is_nan());
        }
        torus.surface(&from, 1.0, 0);
    }
    for direction in [[0.0; 3], [f64::NAN; 3]] {
        assert_eq!(RING.spans(&ray([0.5; 3], direction)), Spans::none());
    }
}
