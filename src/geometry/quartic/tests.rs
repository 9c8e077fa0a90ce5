//! Surfaces that are known on paper. What must hold for any of degree 4 is in [`laws`].

mod laws;

use super::*;
use crate::geometry::Body;
use crate::geometry::arithmetic::quartic::{QuarticMethod, quartic};
use crate::geometry::test_rays::TestRays;
use crate::geometry::{Cuboid, Sphere, Torus};

/// The place of x^i y^j z^k in POV-Ray's order.
fn place(powers: [usize; 3]) -> usize {
    let mut list = Vec::new();
    for x in (0..=4).rev() {
        for y in (0..=4 - x).rev() {
            list.extend((0..=4 - x - y).rev().map(|z| [x, y, z]));
        }
    }
    assert_eq!(list.len(), 35);
    list.iter().position(|p| *p == powers).expect("degree 4")
}

fn cube(half: f64) -> Aabb {
    Aabb {
        min: DVec3::splat(-half),
        max: DVec3::splat(half),
    }
}

fn of_terms(terms: &[([usize; 3], f64)], half: f64) -> Quartic {
    let mut coefficients = [0.0; 35];
    for (powers, factor) in terms {
        coefficients[place(*powers)] += factor;
    }
    Quartic {
        coefficients,
        bounds: cube(half),
    }
}

/// x^2 + y^2 + z^2 = 1, of degree 2.
fn ball(half: f64) -> Quartic {
    let squares = [[2, 0, 0], [0, 2, 0], [0, 0, 2]].map(|powers| (powers, 1.0));
    of_terms(&[&squares[..], &[([0, 0, 0], -1.0)]].concat(), half)
}

/// x^4 - 5 x^2 + y^4 - 5 y^2 + z^4 - 5 z^2 + 11.8: the "tangle cube", eight lumps that hang together.
fn tangle() -> Quartic {
    let mut terms = vec![([0, 0, 0], 11.8)];
    for axis in 0..3 {
        let power = |n| std::array::from_fn(|k| if k == axis { n } else { 0 });
        terms.extend([(power(4), 1.0), (power(2), -5.0)]);
    }
    of_terms(&terms, 3.0)
}

/// The torus around the y axis, R = 1: (x^2 + y^2 + z^2 + 1 - r^2)^2 = 4 (x^2 + z^2).
fn ring(minor: f64) -> Quartic {
    let c = 1.0 - minor * minor;
    let mut terms = vec![([0, 0, 0], c * c), ([2, 0, 0], -4.0), ([0, 0, 2], -4.0)];
    for i in 0..3 {
        for j in 0..3 {
            terms.push((
                std::array::from_fn(|k| 2 * (usize::from(k == i) + usize::from(k == j))),
                1.0,
            ));
        }
        terms.push((std::array::from_fn(|k| 2 * usize::from(k == i)), 2.0 * c));
    }
    of_terms(&terms, 1.5)
}

/// The tangle cube cut to a thin plate away from its middle.
fn plate() -> Quartic {
    let bounds = Aabb {
        min: DVec3::new(-3.0, 1.0, -2.0),
        max: DVec3::new(2.5, 1.001, 3.0),
    };
    Quartic { bounds, ..tangle() }
}

fn cuts(quartic: &Quartic, ray: &Ray) -> Vec<Cut> {
    quartic.spans(ray).cuts().map(|(cut, _)| cut).collect()
}

#[test]
fn the_order_is_that_of_povray() {
    // The torus of POV-Ray's documentation of `quartic`: R = sqrt(40), r = sqrt(12), around y.
    let mut coefficients = [0.0; 35];
    for (place, value) in [
        (0, 1.0),
        (4, 2.0),
        (7, 2.0),
        (9, -104.0),
        (20, 1.0),
        (23, 2.0),
        (25, 56.0),
    ] {
        coefficients[place] = value;
    }
    (coefficients[30], coefficients[32], coefficients[34]) = (1.0, -104.0, 784.0);
    let bounds = cube(10.0);
    let quartic = Quartic {
        coefficients,
        bounds,
    };
    let torus = Torus {
        major: 40f64.sqrt(),
        minor: 12f64.sqrt(),
    };
    let mut random = TestRays(11);
    for _ in 0..200 {
        let ray = random.ray(9.0, 30.0);
        let expected = torus.spans(&ray);
        assert_eq!(quartic.spans(&ray).0.len(), expected.0.len());
        assert!((quartic.spans(&ray).length() - expected.length()).abs() < 1e-9);
    }
    // And where x, y and z stand, which a torus does not tell.
    for (powers, place_there, value) in [
        ([3, 0, 0], 3, 8.0),
        ([1, 0, 0], 19, 2.0),
        ([0, 1, 0], 29, 3.0),
        ([0, 0, 1], 33, 5.0),
    ] {
        assert_eq!(place(powers), place_there);
        let one = of_terms(&[(powers, 1.0)], 1.0);
        assert_eq!(one.value(DVec3::new(2.0, 3.0, 5.0)), value);
    }
}

#[test]
fn a_ball_is_a_ball() {
    let (quartic, sphere) = (
        ball(2.0),
        Sphere {
            center: DVec3::ZERO,
            radius: 1.0,
        },
    );
    let mut random = TestRays(1);
    for i in 0..500 {
        let far = [0.0, 5.0, 1e4, 1e7][i % 4];
        let ray = random.ray(0.9, far);
        let expected = sphere.span(&ray).map_or(Vec::new(), Vec::from);
        let found = cuts(&quartic, &ray);
        assert_eq!(found.len(), expected.len());
        for (cut, t) in found.iter().zip(expected) {
            assert!((cut.t - t).abs() < 1e-14 * (1e3 + far) && cut.part == 0);
        }
    }
}

#[test]
fn the_box_closes_what_is_cut_off() {
    // A ball in a box of half its size across: only the faces at x are met along x.
    let quartic = ball(0.5);
    let along = cuts(&quartic, &Ray::new(DVec3::new(-4.0, 0.25, 0.125), DVec3::X));
    assert_eq!(along, [Cut { t: 3.5, part: 1 }, Cut { t: 4.5, part: 2 }]);
    let down = cuts(&quartic, &Ray::new(DVec3::new(0.0, 4.0, 0.0), DVec3::NEG_Y));
    assert_eq!(down, [Cut { t: 3.5, part: 4 }, Cut { t: 4.5, part: 3 }]);
    // Where F < 0 everywhere, the solid is the box; where F > 0, there is none.
    let full = of_terms(&[([0, 0, 0], -1.0)], 1.0);
    let none = of_terms(&[([0, 0, 0], 1.0)], 1.0);
    let cuboid = Cuboid { bounds: cube(1.0) };
    let mut random = TestRays(2);
    for _ in 0..300 {
        let ray = random.ray(1.3, 4.0);
        let expected = cuboid.span(&ray).map_or(Vec::new(), Vec::from);
        let found = cuts(&full, &ray);
        assert_eq!(found.len(), expected.len());
        for (cut, t) in found.iter().zip(expected) {
            assert!((cut.t - t).abs() < 1e-14);
            let p = full.surface(&ray, cut.t, cut.part);
            assert_eq!(p.normal, cuboid.surface(&ray, t).normal);
            assert!((p.uv - cuboid.surface(&ray, t).uv).length() < 1e-13);
        }
        assert!(cuts(&none, &ray).is_empty());
    }
}

#[test]
fn a_torus_is_a_torus() {
    let (quartic, torus) = (
        ring(0.25),
        Torus {
            major: 1.0,
            minor: 0.25,
        },
    );
    let mut random = TestRays(3);
    let mut four = 0;
    for _ in 0..2000 {
        let ray = random.ray(1.2, 4.0);
        let expected: Vec<_> = torus.spans(&ray).cuts().map(|(cut, _)| cut.t).collect();
        let found = cuts(&quartic, &ray);
        assert_eq!(found.len(), expected.len());
        four += usize::from(found.len() == 4);
        for (cut, t) in found.iter().zip(expected) {
            let normal = torus.surface(&ray, t, 0).normal;
            assert!((cut.t - t).abs() * normal.dot(ray.direction).abs() < 1e-14);
            assert!((quartic.surface(&ray, cut.t, 0).normal - normal).length() < 1e-12);
        }
    }
    assert!(four > 20, "{four}");
}

#[test]
fn a_touch_from_outside_is_none() {
    let ball = ball(2.0);
    for (x, count) in [(1.0, 0), (1.0f64.next_down(), 2)] {
        let ray = Ray::new(DVec3::new(x, 0.0, -3.0), DVec3::Z);
        assert_eq!(cuts(&ball, &ray).len(), count);
    }
}

#[test]
fn gradients_are_slopes() {
    let mut random = TestRays(4);
    let mut coefficients = [0.0; 35];
    coefficients.fill_with(|| random.signed());
    let quartic = Quartic {
        coefficients,
        bounds: cube(1.0),
    };
    for _ in 0..200 {
        let p = random.in_cube();
        let gradient = quartic.gradient(p);
        for axis in 0..3 {
            let h = 1e-6 * DVec3::AXES[axis];
            let slope = (quartic.value(p + h) - quartic.value(p - h)) / 2e-6;
            assert!((slope - gradient[axis]).abs() < 1e-8);
        }
        let ray = random.ray(1.0, 0.5);
        let polynomial = quartic.coefficients_along(&ray);
        let t = random.signed();
        let direct = quartic.value(ray.at(t));
        assert!((crate::math::polynomial::value(&polynomial, t) - direct).abs() < 1e-12);
    }
}

/// As a body has it: by the mean length of spans.
fn volume(quartic: &Quartic) -> f64 {
    Body::Quartic(*quartic).volume()
}

#[test]
fn spans_are_in_order_and_their_length_is_the_volume() {
    let torus = Torus {
        major: 1.0,
        minor: 0.25,
    };
    let ratio = volume(&ring(0.25)) / torus.volume();
    assert!((ratio - 1.0).abs() < 5e-3, "{ratio}");
    assert!((volume(&ball(2.0)) / (4.0 / 3.0 * std::f64::consts::PI) - 1.0).abs() < 1e-3);
    // Two caps of height 1/4 are missing on each axis: the box cuts the ball's faces, not its edges.
    let caps = 6.0 * std::f64::consts::PI * 0.0625 * (3.0 - 0.25) / 3.0;
    assert!((volume(&ball(0.75)) - (4.0 / 3.0 * std::f64::consts::PI - caps)).abs() < 2e-3);
    let mut random = TestRays(7);
    for _ in 0..1000 {
        let found = cuts(&tangle(), &random.ray(3.0, 8.0));
        assert!(found.len().is_multiple_of(2));
        assert!(found.windows(2).all(|pair| pair[0].t < pair[1].t));
    }
}

#[test]
fn the_methods_agree_near_by() {
    let mut random = TestRays(8);
    for solid in [ball(0.75), ring(0.25), tangle()] {
        for _ in 0..200 {
            let ray = random.ray(0.7, 3.0);
            let length = |method| quartic(&solid, &ray, method).length();
            let ours = length(QuarticMethod::Polished);
            assert!((length(QuarticMethod::Moved) - ours).abs() < 1e-6);
            // Ferrari's formula takes all as of degree 4.
            if solid != ball(0.75) {
                assert!((length(QuarticMethod::Plain) - ours).abs() < 1e-4);
            }
        }
    }
}

#[test]
fn no_numbers_are_too_strange() {
    let mut random = TestRays(9);
    for _ in 0..3000 {
        let mut pick = || random.strange();
        let ray = Ray::new(
            DVec3::new(pick(), pick(), pick()),
            DVec3::new(pick(), pick(), pick()),
        );
        let mut quartic = tangle();
        quartic.coefficients.fill_with(&mut pick);
        for (cut, _) in quartic
            .spans(&ray)
            .cuts()
            .chain(tangle().spans(&ray).cuts())
        {
            assert!(!cut.t.is_nan());
        }
        for part in [0, 1, 6, 99] {
            quartic.surface(&ray, 1.0, part);
        }
    }
    let zero = of_terms(&[], 1.0);
    assert!(cuts(&zero, &Ray::new(DVec3::Z * 3.0, DVec3::NEG_Z)).is_empty());
}
