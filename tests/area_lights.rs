//! Area lights against answers known on paper: irradiance and the spread of points.

#[path = "common/floor.rs"]
mod floor;

use std::f64::consts::PI;

use floor::{LAMP, SQUARE, floor, irradiance, part, polygon, runs, settings};
use raytree::accel::AccelKind;
use raytree::geometry::{Disc, Shape, Sphere, Triangle};
use raytree::math::points::Run;
use raytree::math::{DVec3, LightSampling, Rgb, Sampler};
use raytree::scene::{self, Settings, World};
use raytree::shading::Area;
use raytree::trace::{View, trace_pixel};

/// Every sampler that has chance in it hits the true value: |z| < 4.3, which one honest test in 10^5 exceeds; there
/// are about 60. (1e-9 is what single-precision points may add.)
fn unbiased(world: &World, truth: f64, what: &str) {
    let samplers = [Sampler::Random, Sampler::Stratified, Sampler::Sobol];
    for (sampler, by) in samplers
        .into_iter()
        .flat_map(|s| LightSampling::ALL.map(|by| (s, by)))
    {
        let (mean, error) = runs(world, (sampler, by), 64, 200);
        let off = (mean - truth).abs();
        assert!(
            off < 4.3 * error + 1e-9,
            "{what}, {sampler:?}, {by:?}: {mean} +- {error}, not {truth}"
        );
        assert!(
            error < 0.05 * truth,
            "{what}, {sampler:?}, {by:?}: the test is blind"
        );
    }
    // A grid has no chance in it: it is off by what its cells leave out.
    let grid = irradiance(
        world,
        &settings((Sampler::Grid, LightSampling::Area), 4096, 0),
    );
    assert!(
        (grid - truth).abs() < 5e-3 * truth,
        "{what}, grid: {grid}, not {truth}"
    );
}

#[test]
fn the_oracle_gives_the_published_figures() {
    let centre = polygon(DVec3::ZERO, &part(-1.0, 1.0));
    assert!((centre - 0.752_274_688_45).abs() < 1e-11, "{centre}");
    let aside = polygon(DVec3::new(0.3, 0.0, -0.2), &part(-1.0, 1.0));
    assert!((aside - 0.724_914_736_09).abs() < 1e-11, "{aside}");
}

#[test]
fn a_square_of_two_triangles_or_of_a_mesh_lights_as_the_formula_says() {
    let mesh = r#"{"mesh": {"name": "lamp", "material": "lamp",
        "vertices": [[-1, 2, -1], [1, 2, -1], [1, 2, 1], [-1, 2, 1], [0.4, 2, 0.1]],
        "triangles": [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]}}"#;
    for (at, truth) in [
        ([0.0, 0.0], 0.752_274_688_45),
        ([0.3, -0.2], 0.724_914_736_09),
    ] {
        unbiased(&floor(at, LAMP, SQUARE), truth, "square");
        unbiased(&floor(at, LAMP, mesh), truth, "mesh");
    }
}

#[test]
fn a_triangle_lights_as_the_formula_says() {
    let lamp = r#"{"triangle": {"name": "lamp", "material": "lamp", "corners": [[-1, 2, -1], [1, 2, -1], [0.2, 1.5, 1]]}}"#;
    let corners = [[-1.0, 2.0, -1.0], [1.0, 2.0, -1.0], [0.2, 1.5, 1.0]].map(DVec3::from);
    unbiased(
        &floor([0.0, 0.0], LAMP, lamp),
        polygon(DVec3::ZERO, &corners),
        "triangle",
    );
}

#[test]
fn a_disc_above_lights_pi_r2_over_r2_and_h2() {
    let disc = r#"{"disc": {"name": "lamp", "material": "lamp", "center": [0, 2, 0], "normal": [0, -1, 0], "radius": 1}}"#;
    unbiased(&floor([0.0, 0.0], LAMP, disc), PI / 5.0, "disc");
}

#[test]
fn a_sphere_lights_as_its_cone_and_cosine() {
    let sphere =
        r#"{"sphere": {"name": "lamp", "material": "lamp", "center": [0, 3, 0], "radius": 1}}"#;
    unbiased(&floor([0.0, 0.0], LAMP, sphere), PI / 9.0, "sphere above");
    // From (4, 0, 0): distance 5, cosine 3/5.
    unbiased(
        &floor([4.0, 0.0], LAMP, sphere),
        PI / 25.0 * 0.6,
        "sphere aside",
    );
}

#[test]
fn inside_a_shining_sphere_a_white_floor_is_as_bright_as_the_sphere() {
    let furnace =
        r#"{"sphere": {"name": "lamp", "material": "lamp", "center": [0, 0.3, 0], "radius": 10}}"#;
    unbiased(&floor([0.0, 0.0], LAMP, furnace), PI, "white furnace");
}

/// The points of a light that `from` meets, with its two lists of numbers.
fn points(area: &Area, from: DVec3) -> Vec<DVec3> {
    let run = Run {
        key: 77,
        count: 40_000,
    };
    (0..run.count)
        .filter_map(|i| area.sample(from, Sampler::Random.point(run, i)))
        .map(|seen| from + seen.direction * seen.distance)
        .collect()
}

/// Chi-square of counts that should all be equal; 8 x 8 cells: 63 degrees of freedom, 99.999 % below 124.
fn even(cells: impl Iterator<Item = [f64; 2]>, what: &str) {
    let mut counts = [0.0; 64];
    for [u, v] in cells {
        let place = |x: f64| ((x * 8.0) as usize).min(7);
        counts[place(v) * 8 + place(u)] += 1.0;
    }
    let expected = counts.iter().sum::<f64>() / 64.0;
    let chi: f64 = counts
        .iter()
        .map(|n| (n - expected) * (n - expected) / expected)
        .sum();
    assert!(expected > 500.0 && chi < 124.0, "{what}: {chi}");
}

#[test]
fn points_are_even_on_every_form() {
    let area = |shapes: &[Shape]| Area::new(shapes, Rgb::WHITE).expect("an area");
    let turn = |x: f64, y: f64| libm::atan2(y, x) / (2.0 * PI) + 0.5;
    let from = DVec3::new(0.2, -3.0, 0.1);
    let disc = Disc::new(DVec3::ZERO, DVec3::Y, 2.0);
    even(
        points(&area(&[Shape::Disc(disc)]), from)
            .iter()
            .map(|p| [(p.x * p.x + p.z * p.z) / 4.0, turn(p.x, p.z)]),
        "disc",
    );
    // In a right triangle x + y < 1: x is even once stretched by its density 2 (1 - x), y then even in 0..1-x.
    let corners = [DVec3::ZERO, DVec3::X, DVec3::Z];
    even(
        points(&area(&[Shape::Triangle(Triangle { corners })]), from)
            .iter()
            .map(|p| [1.0 - (1.0 - p.x) * (1.0 - p.x), p.z / (1.0 - p.x)]),
        "triangle",
    );
    let sphere = Sphere {
        center: DVec3::ZERO,
        radius: 1.5,
    };
    let light = area(&[Shape::Sphere(sphere)]);
    even(
        points(&light, DVec3::new(0.3, 0.2, 0.1))
            .iter()
            .map(|p| [p.z / 3.0 + 0.5, turn(p.x, p.y)]),
        "sphere from inside",
    );
    // From outside, in the cone: 1 - cos of the angle from its axis, and the turn around it.
    let outside = DVec3::new(0.0, 0.0, 4.0);
    let most = 1.0 - (1.0 - (1.5f64 / 4.0).powi(2)).sqrt();
    even(
        points(&light, outside).iter().map(|p| {
            let d = (*p - outside).normalize();
            [(1.0 + d.z) / most, turn(d.x, d.y)]
        }),
        "sphere from outside",
    );
}

#[test]
fn a_light_does_not_stand_in_its_own_way_at_any_scale() {
    // Every sample from every place arrives: nothing else is there.
    for scale in [1e-4, 1.0, 1e6] {
        for offset in [0.0, 1e3, 1e9] {
            let place = |x: f64, y: f64, z: f64| {
                format!(
                    "[{}, {}, {}]",
                    x * scale + offset,
                    y * scale - offset,
                    z * scale
                )
            };
            let lamp = [
                format!(
                    r#"{{"sphere": {{"name": "lamp", "material": "lamp", "center": {}, "radius": {scale}}}}}"#,
                    place(0.0, 3.0, 0.0)
                ),
                format!(
                    r#"{{"disc": {{"name": "lamp", "material": "lamp", "center": {}, "normal": [0.3, -1, 0.2], "radius": {scale}}}}}"#,
                    place(0.0, 3.0, 0.0)
                ),
                format!(
                    r#"{{"triangle": {{"name": "lamp", "material": "lamp", "corners": [{}, {}, {}]}}}}"#,
                    place(0.0, 3.0, 0.0),
                    place(1.0, 2.0, 0.0),
                    place(0.0, 2.5, 1.5)
                ),
            ];
            for lamp in lamp {
                let text = format!(
                    r#"{{"format": "raytree-scene/1", "name": "t",
                    "camera": {{"eye": {}, "look_at": {}, "vertical_fov": 60}},
                    "materials": {{"lamp": {{"diffuse": [0, 0, 0], "emission": [1, 1, 1]}}, "white": {{"diffuse": [1, 1, 1]}}}},
                    "lights": [{LAMP}],
                    "objects": [{lamp}, {{"plane": {{"name": "floor", "material": "white", "point": {}, "normal": [0, 1, 0]}}}}]}}"#,
                    place(0.0, 1.0, 3.0),
                    place(0.0, 0.0, 0.0),
                    place(0.0, 0.0, 0.0)
                );
                let folder = tempfile::tempdir().expect("a folder");
                let path = folder.path().join("t.json");
                std::fs::write(&path, text).expect("room on the disk");
                let scene = scene::load(path.to_str().expect("a plain path")).expect("a scene");
                let world = World::new(scene, AccelKind::List);
                let settings = Settings {
                    width: 8,
                    height: 6,
                    light_samples: 64,
                    ..Settings::default()
                };
                let (mut lit, mut blocked) = (0, 0);
                for at in (0..48).map(|i| (i % 8, i / 8)) {
                    let trace = trace_pixel(&world, &settings, at, false);
                    let view = View {
                        world: &world,
                        settings: &settings,
                        trace: &trace,
                    };
                    for bundle in view.bundles(0) {
                        lit += bundle.lit;
                        blocked += bundle.blocked;
                    }
                }
                assert!(lit > 300, "{lamp}: {lit}");
                assert_eq!(blocked, 0, "{lamp}: of {lit}");
            }
        }
    }
}
