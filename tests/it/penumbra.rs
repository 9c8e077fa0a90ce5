//! Penumbrae against their closed forms, and how fast the error falls with more rays.

use std::f64::consts::TAU;

use raytree::math::DVec3;
use raytree::sampling::{LightSampling, Sampler};
use raytree::scene::Settings;
use raytree::trace::{View, trace_pixel};
use raytree::world::World;

use crate::floor::{EDGE, How, LAMP, SQUARE, floor, irradiance, part, polygon, runs, settings};

/// Lit and blocked samples of the one bundle of the floor.
fn bundle(world: &World, settings: &Settings) -> (f64, f64) {
    let trace = trace_pixel(world, settings, (0, 0), false);
    let view = View {
        world,
        settings,
        trace: &trace,
    };
    let bundles = view.light_estimates(0);
    let bundle = bundles.first().expect("one light");
    (f64::from(bundle.lit), f64::from(bundle.blocked))
}

#[test]
fn penumbrae_of_a_half_plane_have_their_profiles() {
    // The edge stands half way to the lamp: from (x, 0, 0) it hides what lies at less than -x.
    let disc = r#"{"disc": {"name": "lamp", "material": "lamp", "center": [0, 2, 0], "normal": [0, -1, 0], "radius": 0.5}}"#;
    let square = r#"{"quad": {"name": "lamp", "material": "lamp", "corner": [-0.5, 2, -0.5], "u": [1, 0, 0], "v": [0, 0, 1]}}"#;
    let cases = [
        (disc, 0.25, 0.804_498_90),
        (disc, 0.0, 0.5),
        (disc, -0.25, 0.195_501_11),
        (disc, 0.51, 1.0),
        (disc, -0.51, 0.0),
        (square, 0.25, 0.75),
        (square, 0.0, 0.5),
        (square, -0.1, 0.4),
        (square, 0.51, 1.0),
        (square, -0.51, 0.0),
    ];
    for (lamp, x, truth) in cases {
        let world = floor([x, 0.0], LAMP, &format!("{lamp}, {EDGE}"));
        for (sampler, tolerance) in [
            (Sampler::Random, 4.3 * (0.25f64 / 16384.0).sqrt()),
            (Sampler::Stratified, 2e-3),
            (Sampler::Sobol, 1e-3),
            (Sampler::Grid, 8e-3),
        ] {
            let (lit, blocked) =
                bundle(&world, &settings((sampler, LightSampling::Area), 16384, 7));
            let part = lit / (lit + blocked);
            assert!(
                (part - truth).abs() <= tolerance,
                "{lamp} {x} {sampler:?}: {part}, not {truth}"
            );
        }
    }
}

/// The slope of log RMSE over log samples, which go from 16 up in powers of 4: six of them in 64 runs for Sobol's, whose error
/// at an edge along the axes goes up and down on its way; else five in 128 runs. Of n runs the logarithm of an RMSE has a standard
/// error of 1 / sqrt(2 n), as that of normal errors has: so the slope has one of about 0.015.
fn slope(world: &World, how: How, truth: f64) -> f64 {
    let (powers, runs) = match how.0 {
        Sampler::Sobol => (2..=7, 64u32),
        _ => (2..=6, 128),
    };
    let points: Vec<[f64; 2]> = powers
        .map(|power| 4u32.pow(power))
        .map(|n| {
            let squares: f64 = (0..runs)
                .map(|seed| irradiance(world, &settings(how, n, seed.into())) - truth)
                .map(|off| off * off)
                .sum();
            let rmse = (squares / f64::from(runs)).sqrt();
            [libm::log(f64::from(n)), libm::log(rmse)]
        })
        .collect();
    let n = points.len() as f64;
    let mean = |axis: usize| points.iter().map(|p| p[axis]).sum::<f64>() / n;
    let [x, y] = [mean(0), mean(1)];
    let over: f64 = points.iter().map(|p| (p[0] - x) * (p[1] - y)).sum();
    over / points.iter().map(|p| (p[0] - x) * (p[0] - x)).sum::<f64>()
}

#[test]
fn errors_fall_with_the_slopes_of_theory() {
    let smooth = floor([0.3, -0.2], LAMP, SQUARE);
    let truth = 0.724_914_736_09;
    for (sampler, expected, off) in [
        (Sampler::Random, -0.5, 0.05),
        (Sampler::Stratified, -1.0, 0.1),
        (Sampler::Sobol, -1.44, 0.1),
    ] {
        let slope = slope(&smooth, (sampler, LightSampling::Area), truth);
        assert!(
            (slope - expected).abs() < off,
            "smooth, {sampler:?}: {slope}"
        );
    }
    // 0.3711 of the lamp can be seen: the edge falls between all cells of any grid.
    let x = 2.0 * (0.3711 - 0.5);
    let edge = floor([x, 0.0], LAMP, &format!("{SQUARE}, {EDGE}"));
    let truth = polygon(DVec3::new(x, 0.0, 0.0), &part(-x, 1.0));
    for (sampler, expected, off) in [
        (Sampler::Random, -0.5, 0.05),
        (Sampler::Stratified, -0.7, 0.1),
        (Sampler::Sobol, -0.94, 0.1),
    ] {
        let slope = slope(&edge, (sampler, LightSampling::Area), truth);
        assert!((slope - expected).abs() < off, "edge, {sampler:?}: {slope}");
    }
    // A grid's error at the edge does not fall with luck: it is that of the column of cells which the edge cuts.
    let off = |n| {
        (irradiance(&edge, &settings((Sampler::Grid, LightSampling::Area), n, 0)) - truth).abs()
    };
    let (few, many) = (off(1024), off(16384));
    assert!(many > few / 4.0, "16 times the samples: {few} -> {many}");
}

/// What stands half way to the square lamp, and what it leaves of the lamp, as seen from a place on the floor.
struct Blocker {
    name: &'static str,
    object: String,
    hides: Hidden,
}

enum Hidden {
    /// What lies against this way, as seen from the middle.
    Side([f64; 2]),
    /// A circle of this radius.
    Circle(f64),
}

fn edge(name: &'static str, degrees: f64) -> Blocker {
    let (sin, cos) = libm::sincos(degrees.to_radians());
    // It ends at the middle, along (-sin, cos), and lies against (cos, sin).
    let along = |x: f64| format!("{}, 0, {}", -sin * x, cos * x);
    let object = format!(
        r#"{{"quad": {{"name": "edge", "material": "black", "corner": [{}, 1, {}], "u": [{}, 0, {}], "v": [{}]}}}}"#,
        50.0 * sin,
        -50.0 * cos,
        -50.0 * cos,
        -50.0 * sin,
        along(100.0),
    );
    let hides = Hidden::Side([cos, sin]);
    Blocker {
        name,
        object,
        hides,
    }
}

fn blockers() -> [Blocker; 4] {
    [
        edge("parallel edge", 0.0),
        edge("slanted edge", 20.0),
        edge("diagonal edge", 45.0),
        Blocker {
            name: "disc",
            object: r#"{"disc": {"name": "disc", "material": "black", "center": [0, 1, 0], "normal": [0, 1, 0], "radius": 0.4}}"#.into(),
            hides: Hidden::Circle(0.4),
        },
    ]
}

/// The part of a convex polygon at one height that lies before the line through `through` with the normal `n`.
fn clip(corners: &[DVec3], through: [f64; 2], n: [f64; 2]) -> Vec<DVec3> {
    let before = |p: DVec3| (p.x - through[0]) * n[0] + (p.z - through[1]) * n[1];
    let mut kept = Vec::new();
    for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        let (da, db) = (before(*a), before(*b));
        if da >= 0.0 {
            kept.push(*a);
        }
        if (da >= 0.0) != (db >= 0.0) {
            kept.push(*a + (*b - *a) * (da / (da - db)));
        }
    }
    kept
}

impl Blocker {
    /// The irradiance that it leaves at (x, 0, z): its shadow on the lamp is twice as large, opposite to the place.
    fn leaves(&self, [x, z]: [f64; 2]) -> f64 {
        let at = DVec3::new(x, 0.0, z);
        match self.hides {
            Hidden::Side(n) => polygon(at, &clip(&part(-1.0, 1.0), [-x, -z], n)),
            Hidden::Circle(radius) => {
                let corner = |i: u32| {
                    let (sin, cos) = libm::sincos(f64::from(i) * TAU / 20_000.0);
                    DVec3::new(2.0 * radius * cos - x, 2.0, 2.0 * radius * sin - z)
                };
                let mut hidden: Vec<DVec3> = (0..20_000).map(corner).collect();
                for (x, z) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
                    hidden = clip(&hidden, [-x, -z], [x, z]);
                }
                polygon(at, &part(-1.0, 1.0)) - polygon(at, &hidden)
            }
        }
    }
}

#[test]
fn behind_edges_all_ways_of_sampling_are_unbiased() {
    // From one rim of the penumbra to the other. 16 rays a hit.
    for sampler in [Sampler::Random, Sampler::Stratified, Sampler::Sobol] {
        for blocker in blockers() {
            let mut squares = [0.0; 2];
            for at in [
                [-0.8, 0.1],
                [-0.2578, -0.3],
                [0.03, 0.0],
                [0.3, 0.2],
                [0.9, -0.1],
            ] {
                let world = floor(at, LAMP, &format!("{SQUARE}, {}", blocker.object));
                let truth = blocker.leaves(at);
                for (by, squares) in LightSampling::ALL.into_iter().zip(&mut squares) {
                    let (mean, error) = runs(&world, (sampler, by), 16, 200);
                    // 120 tests at p = 0.01 in all: 3.94 deviations.
                    let off = (mean - truth).abs();
                    assert!(
                        off < 3.94 * error + 1e-9,
                        "{} {at:?}, {sampler:?}, {by:?}: {mean} +- {error}, not {truth}",
                        blocker.name
                    );
                    *squares += error * error;
                }
            }
        }
    }
}

#[test]
fn where_nothing_stands_in_the_way_one_projected_ray_is_enough() {
    for (at, truth) in [
        ([0.0, 0.0], 0.752_274_688_45),
        ([0.3, -0.2], 0.724_914_736_09),
    ] {
        let world = floor(at, LAMP, SQUARE);
        for sampler in [Sampler::Random, Sampler::Stratified, Sampler::Sobol] {
            let one = irradiance(&world, &settings((sampler, LightSampling::Projected), 1, 3));
            assert!((one - truth).abs() < 1e-10, "{one}, not {truth}");
        }
    }
}

#[test]
fn a_ball_hides_the_lens_that_two_discs_share() {
    // A ball far below a small far lamp covers, as seen from the floor, a disc as large as the lamp; moved aside by
    // its radius it hides 0.39100222 of it.
    let disc = r#"{"disc": {"name": "lamp", "material": "lamp", "center": [0, 2000, 0], "normal": [0, -1, 0], "radius": 1}}"#;
    let ball = r#"{"sphere": {"name": "ball", "material": "black", "center": [0.5, 1000, 0], "radius": 0.5}}"#;
    let world = floor([0.0, 0.0], LAMP, &format!("{disc}, {ball}"));
    for sampler in [Sampler::Random, Sampler::Stratified, Sampler::Sobol] {
        let how = (sampler, LightSampling::Area);
        let (lit, blocked) = bundle(&world, &settings(how, 16384, 11));
        let hidden = blocked / (lit + blocked);
        // 4 deviations of a coin at most; the ball is seen as if it were flat within 1e-6.
        assert!(
            (hidden - 0.391_002_22).abs() < 0.0153,
            "{sampler:?}: {hidden}"
        );
    }
}
