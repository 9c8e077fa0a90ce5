//! Polygonal lights sampled by their projected solid angle: no noise without a blocker, no bias with one, and
//! directions that are even in the polygon's shadow on the unit disc.

use std::f64::consts::{PI, SQRT_2};

use raytree::geometry::{Shape, Triangle};
use raytree::math::{DVec3, Rgb};
use raytree::sampling::{SampleSet, Sampler};
use raytree::shading::{Area, ProjectedPolygon};

/// What lies above the plane through the origin with this normal.
fn clipped(corners: &[DVec3], n: DVec3) -> Vec<DVec3> {
    let mut out = Vec::new();
    for (i, a) in corners.iter().enumerate() {
        let b = corners[(i + 1) % corners.len()];
        let (da, db) = (a.dot(n), b.dot(n));
        if da > 0.0 {
            out.push(*a);
        }
        if (da > 0.0) != (db > 0.0) {
            out.push(*a + (b - *a) * (da / (da - db)));
        }
    }
    out
}

/// P of a polygon seen from the origin, by Lambert's formula.
fn lambert(corners: &[DVec3], n: DVec3) -> f64 {
    let corners = clipped(corners, n);
    let sum: f64 = (0..corners.len())
        .map(|i| {
            let (a, b) = (corners[i], corners[(i + 1) % corners.len()]);
            let cross = a.cross(b);
            libm::atan2(cross.length(), a.dot(b)) * cross.normalize_or_zero().dot(n)
        })
        .sum();
    sum.abs() / 2.0
}

/// A parallelogram at the place of (corner, u, v), a surface at the origin with this normal.
struct Case {
    name: &'static str,
    normal: DVec3,
    corner: DVec3,
    u: DVec3,
    v: DVec3,
}

fn cases() -> Vec<Case> {
    let case = |name, normal: [f64; 3], corner: [f64; 3], u: [f64; 3], v: [f64; 3]| Case {
        name,
        normal: DVec3::from(normal).normalize(),
        corner: DVec3::from(corner),
        u: DVec3::from(u),
        v: DVec3::from(v),
    };
    let up = [0.0, 1.0, 0.0];
    let (x, z) = ([2.0, 0.0, 0.0], [0.0, 0.0, 2.0]);
    vec![
        case("overhead", up, [-1.0, 2.0, -1.0], x, z),
        case("a corner overhead", up, [0.0, 1.0, 0.0], x, z),
        case("an edge overhead", up, [0.0, 1.0, -1.0], x, z),
        case("aside", up, [1.0, 1.0, -0.5], x, z),
        case("aside, a corner first", up, [1.0, 1.0, 0.7], x, z),
        case("upright", up, [-1.0, 0.2, 1.5], x, [0.0, 2.0, 0.3]),
        case(
            "behind the horizon in part",
            up,
            [-1.0, -1.0, 1.5],
            x,
            [0.0, 2.0, 0.3],
        ),
        case(
            "one corner above the horizon",
            [0.0, 1.0, 0.9],
            [-1.0, 0.5, -1.4],
            x,
            z,
        ),
        case(
            "three corners above",
            [0.6, 1.0, 0.9],
            [-1.0, 0.5, -1.0],
            x,
            z,
        ),
        case("very near", up, [-1.0, 0.01, -1.0], x, z),
        case(
            "skew",
            [0.3, 1.0, -0.2],
            [0.2, 0.7, 0.4],
            [1.0, 0.5, 0.2],
            [-0.3, 0.6, 0.9],
        ),
        case(
            "long",
            up,
            [-40.0, 1.0, 1.0],
            [80.0, 0.0, 0.0],
            [0.0, 0.1, 0.5],
        ),
    ]
}

impl Case {
    fn polygon(&self) -> [DVec3; 4] {
        let Self { corner, u, v, .. } = self;
        [*corner, corner + u, corner + u + v, corner + v]
    }

    fn projected(&self) -> ProjectedPolygon {
        ProjectedPolygon::new(DVec3::ZERO, self.normal, &self.polygon()).expect(self.name)
    }

    /// Where a way from the origin meets the parallelogram, in its own coordinates.
    fn place(&self, way: DVec3) -> [f64; 2] {
        let n = self.u.cross(self.v);
        let at = way * (n.dot(self.corner) / n.dot(way)) - self.corner;
        [at.cross(self.v).dot(n), self.u.cross(at).dot(n)].map(|x| x / n.length_squared())
    }
}

#[test]
fn the_area_is_lamberts() {
    for case in cases() {
        let truth = lambert(&case.polygon(), case.normal);
        let area = case.projected().area;
        assert!(
            (area - truth).abs() < 1e-13,
            "{}: {area}, not {truth}",
            case.name
        );
    }
    // The published irradiance under a square of side 2 at height 2, for a radiance of 1.
    let overhead = &cases()[0];
    assert!((overhead.projected().area - 0.752_274_688_45).abs() < 1e-11);
}

/// Counts in 8 x 8 cells of a light against what Lambert's formula expects of each; cells with less than 5 are pooled.
/// 1 % for all of the 12 cases together.
#[test]
fn directions_are_spread_in_proportion_to_what_they_bring() {
    let count = 40_000;
    for case in cases() {
        let seen = case.projected();
        let mut counts = [0.0; 64];
        for index in 0..count {
            let run = SampleSet { key: 5, count };
            let way = seen.direction(Sampler::Random.point(run, index));
            assert!((way.length() - 1.0).abs() < 1e-14 && way.dot(case.normal) >= 0.0);
            let place = case.place(way);
            assert!(
                place.iter().all(|x| (-1e-9..=1.0 + 1e-9).contains(x)),
                "{}: {place:?}",
                case.name
            );
            let [i, j] = place.map(|x| ((x * 8.0) as usize).min(7));
            counts[j * 8 + i] += 1.0;
        }
        let (mut chi, mut cells, mut pool) = (0.0, 0.0, [0.0; 2]);
        let mut add = |[got, expected]: [f64; 2]| {
            if expected > 0.0 {
                chi += (got - expected) * (got - expected) / expected;
                cells += 1.0;
            }
        };
        for (cell, got) in counts.into_iter().enumerate() {
            let (i, j) = ((cell % 8) as f64 / 8.0, (cell / 8) as f64 / 8.0);
            let (u, v) = (case.u / 8.0, case.v / 8.0);
            let a = case.corner + case.u * i + case.v * j;
            let share = lambert(&[a, a + u, a + u + v, a + v], case.normal) / seen.area;
            let expected = share * f64::from(count);
            if expected < 5.0 {
                pool = [pool[0] + got, pool[1] + expected];
            } else {
                add([got, expected]);
            }
        }
        add(pool);
        let freedom: f64 = cells - 1.0;
        // Wilson and Hilferty 1931: the cube root of chi-square is nearly normal.
        let off = 2.0 / (9.0 * freedom);
        let z = (libm::cbrt(chi / freedom) - (1.0 - off)) / off.sqrt();
        let by_chance = libm::erfc(z / SQRT_2) / 2.0;
        assert!(
            by_chance > 0.01 / 12.0,
            "{}: chi-square {chi} of {freedom}",
            case.name
        );
    }
}

#[test]
fn every_sample_brings_the_same() {
    for case in cases() {
        let [a, b, c, d] = case.polygon();
        let halves = [[a, b, c], [a, c, d]];
        let light = Area::new(
            &halves.map(|corners| Shape::Triangle(Triangle { corners })),
            Rgb::WHITE,
        )
        .expect("an area");
        let truth = lambert(&case.polygon(), case.normal) / PI;
        let seen = light.projected(DVec3::ZERO, case.normal).expect(case.name);
        for index in 0..1000 {
            let u = Sampler::Sobol.point(
                SampleSet {
                    key: 1,
                    count: 1000,
                },
                index,
            );
            let lit = light
                .sample_projected((DVec3::ZERO, case.normal), &seen, u)
                .expect(case.name);
            let brought = lit.intensity.channels()[0] * case.normal.dot(lit.direction);
            assert!((brought - truth).abs() < 1e-12, "{}: {brought}", case.name);
            let share = lit.projected.map(|share| share.irradiance());
            assert_eq!(share, Some(Rgb::grey(seen.area / PI)));
        }
    }
}

#[test]
fn what_is_not_worth_it_is_left_to_the_area() {
    let square = |size: f64, height: f64| {
        let s = size / 2.0;
        [[-s, -s], [s, -s], [s, s], [-s, s]].map(|[x, z]| DVec3::new(x, height, z))
    };
    let seen = |polygon: &[DVec3]| ProjectedPolygon::new(DVec3::ZERO, DVec3::Y, polygon);
    assert!(seen(&square(1.0, -1.0)).is_none(), "below");
    assert!(seen(&square(1.0, 0.0)).is_none(), "at the horizon");
    assert!(seen(&square(1e-6, 1.0)).is_none(), "tiny");
    assert!(seen(&square(0.0, 1.0)).is_none(), "no area");
    assert!(seen(&[DVec3::Y; 4]).is_none(), "a point");
    assert!(seen(&[DVec3::ZERO; 4]).is_none(), "here");
    let edge_on =
        [[0.0, 1.0], [0.0, 2.0], [1.0, 2.0], [1.0, 1.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
    assert!(seen(&edge_on).is_none(), "edge-on");
}
