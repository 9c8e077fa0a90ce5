//! Area lights against answers known on paper: irradiance and the spread of points.

use std::f64::consts::PI;

use raytree::accel::AccelKind;
use raytree::geometry::{Aabb, Cuboid, Disc, Shape, Sphere, Triangle};
use raytree::math::{DVec3, Rgb};
use raytree::sampling::{LightSampling, SampleSet, Sampler};
use raytree::scene::Settings;
use raytree::shading::Area;
use raytree::shading::area::AreaShape;
use raytree::trace::{View, trace_pixel};
use raytree::world::World;

use crate::floor::{LAMP, SQUARE, floor, irradiance, part, polygon, runs, settings};
use crate::from_text;

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

/// Hard case 56: of a sphere that fills a cone of 1e-6 radians, near or far, every single sample brings E = pi (r / d)^2 to
/// a millionth.
#[test]
fn a_sphere_of_a_millionth_of_a_radian_lights_as_the_formula_says() {
    for (radius, height) in [(5e-10, 1e-3), (5e-7, 1.0), (1.0, 2e6), (5e3, 1e10)] {
        let sphere = format!(
            r#"{{"sphere": {{"name": "lamp", "material": "lamp", "center": [0, {height}, 0], "radius": {radius}}}}}"#
        );
        let world = floor([0.0, 0.0], LAMP, &sphere);
        let truth = PI * (radius / height) * (radius / height);
        for seed in 0..20 {
            for sampler in [Sampler::Random, Sampler::Sobol, Sampler::Grid] {
                let how = (sampler, LightSampling::Area);
                let found = irradiance(&world, &settings(how, 1, seed));
                let off = (found / truth - 1.0).abs();
                assert!(off < 1e-6, "{radius}, {height}, {sampler:?}: {off:e}");
            }
        }
    }
}

#[test]
fn inside_a_shining_sphere_a_white_floor_is_as_bright_as_the_sphere() {
    let furnace =
        r#"{"sphere": {"name": "lamp", "material": "lamp", "center": [0, 0.3, 0], "radius": 10}}"#;
    unbiased(&floor([0.0, 0.0], LAMP, furnace), PI, "white furnace");
}

/// The points of a light that `from` meets, with its two lists of numbers.
fn points(area: &Area, from: DVec3) -> Vec<DVec3> {
    let run = SampleSet {
        key: 77,
        count: 40_000,
    };
    (0..run.count)
        .filter_map(|i| area.sample(from, Sampler::Random.point(run, i)))
        .map(|seen| from + seen.direction * seen.distance)
        .collect()
}

/// Chi-square of the counts of cells against their shares, which add up to 1. Seven such tests at p = 0.01 in all:
/// z < 2.98, where z is nearly normal (Wilson and Hilferty 1931).
fn follows(shares: &[f64], cells: impl Iterator<Item = usize>, what: &str) {
    let mut counts = vec![0.0; shares.len()];
    for cell in cells {
        counts[cell] += 1.0;
    }
    let all = counts.iter().sum::<f64>();
    let least = shares.iter().fold(f64::INFINITY, |a, b| a.min(*b)) * all;
    assert!(least > 100.0, "{what}: the test is blind with {least}");
    let chi: f64 = counts
        .iter()
        .zip(shares)
        .map(|(n, share)| (n - share * all) * (n - share * all) / (share * all))
        .sum();
    let freedom = shares.len() as f64 - 1.0;
    let off = 2.0 / (9.0 * freedom);
    let z = (libm::cbrt(chi / freedom) - (1.0 - off)) / off.sqrt();
    assert!(z < 2.98, "{what}: chi-square {chi} of {freedom}, z = {z}");
}

/// The cell, of `n` x `n` in the unit square.
fn cell(n: usize, [u, v]: [f64; 2]) -> usize {
    let place = |x: f64| ((x * n as f64) as usize).min(n - 1);
    place(v) * n + place(u)
}

/// As many points in each of 8 x 8 cells.
fn even(places: impl Iterator<Item = [f64; 2]>, what: &str) {
    follows(&[1.0 / 64.0; 64], places.map(|p| cell(8, p)), what);
}

#[test]
fn points_are_even_on_every_form() {
    let area = |shapes: &[Shape]| Area::new(shapes, Rgb::WHITE).expect("an area");
    let turn = |x: f64, y: f64| libm::atan2(y, x) / (2.0 * PI) + 0.5;
    let from = DVec3::new(0.2, -3.0, 0.1);
    let disc = Disc::new(DVec3::ZERO, DVec3::Y, 2.0);
    even(
        points(&area(&[Shape::Disc(Box::new(disc))]), from)
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
fn points_are_even_on_parallelograms_meshes_and_boxes() {
    let area = |shapes: &[Shape]| Area::new(shapes, Rgb::WHITE).expect("an area");
    let triangle = |corners: [DVec3; 3]| Shape::Triangle(Triangle { corners });
    let from = DVec3::new(0.3, -4.0, 0.2);
    // A slanted parallelogram: the parts of its edges tell the place.
    let (a, u, v) = (
        DVec3::NEG_ONE,
        DVec3::new(2.0, 0.0, 0.5),
        DVec3::new(1.0, 1.0, 2.0),
    );
    let light = area(&[
        triangle([a, a + u, a + u + v]),
        triangle([a, a + u + v, a + v]),
    ]);
    assert!(matches!(light.shape, AreaShape::Parallelogram(..)));
    let across = u.cross(v);
    let part = |p: DVec3, other: DVec3| (p - a).cross(other).dot(across) / across.length_squared();
    even(
        points(&light, from)
            .iter()
            .map(|p| [part(*p, v), -part(*p, u)]),
        "parallelogram",
    );
    // A square of four triangles, of 1, 2, 3 and 4 tenths of it, that meet inside.
    let square =
        [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, z]| DVec3::new(x, 0.0, z));
    let middle = DVec3::new(0.4, 0.0, 0.2);
    let sides = [0, 1, 2, 3].map(|i| triangle([square[i], square[(i + 1) % 4], middle]));
    let light = area(&sides);
    assert!(matches!(&light.shape, AreaShape::Mesh(triangles) if triangles.len() == 4));
    even(
        points(&light, from)
            .iter()
            .map(|p| [0.5 * (p.x + 1.0), 0.5 * (p.z + 1.0)]),
        "mesh",
    );
    // A box of 1 x 2 x 3: each side by its area, and even on it.
    let size = DVec3::new(1.0, 2.0, 3.0);
    let light = area(&[Shape::Cuboid(Cuboid {
        bounds: Aabb {
            min: DVec3::ZERO,
            max: size,
        },
    })]);
    let side_of = |p: DVec3| {
        let part = p / size;
        let axis = (0..3).min_by(|i, j| {
            let off = |i: usize| part[i].min(1.0 - part[i]).abs();
            off(*i).total_cmp(&off(*j))
        });
        let axis = axis.expect("three axes");
        let side = 2 * axis + usize::from(part[axis] > 0.5);
        16 * side + cell(4, [part[(axis + 1) % 3], part[(axis + 2) % 3]])
    };
    let [x, y, z] = size.to_array();
    let shares: Vec<f64> = [y * z, y * z, z * x, z * x, x * y, x * y]
        .iter()
        .flat_map(|side| [side / 22.0 / 16.0; 16])
        .collect();
    follows(
        &shares,
        points(&light, from).into_iter().map(side_of),
        "box",
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
                let scene = from_text::scene(&text);
                let world = World::new(scene, AccelKind::List);
                let settings = Settings::default().with(|s| {
                    s.image.width = 8;
                    s.image.height = 6;
                    s.light.samples = 64;
                });
                let (mut lit, mut blocked) = (0, 0);
                for at in (0..48).map(|i| (i % 8, i / 8)) {
                    let trace = trace_pixel(&world, &settings, at, false);
                    let view = View {
                        world: &world,
                        settings: &settings,
                        trace: &trace,
                    };
                    for bundle in view.light_estimates(0) {
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

#[test]
fn a_light_does_not_stand_in_its_own_way_above_a_large_floor() {
    // A ray sets out as far off the floor as the errors of the floor's corners are large.
    for edge in [5.0, 1e3, 1e7] {
        let text = format!(
            r#"{{"format": "raytree-scene/1", "name": "t",
            "camera": {{"eye": [0, 0.5, 0.5], "look_at": [0, 0, 0]}},
            "materials": {{"lamp": {{"diffuse": [0, 0, 0], "emission": [1, 1, 1]}}, "white": {{"diffuse": [1, 1, 1]}}}},
            "lights": [{LAMP}],
            "objects": [
              {{"quad": {{"name": "lamp", "material": "lamp", "corner": [-1, 2, -1], "u": [2, 0, 0], "v": [0, 0, 2]}}}},
              {{"quad": {{"name": "floor", "material": "white", "corner": [-{edge}, 0, {edge}], "u": [{}, 0, 0], "v": [0, 0, -{}]}}}}
            ]}}"#,
            2.0 * edge,
            2.0 * edge
        );
        let scene = from_text::scene(&text);
        let world = World::new(scene, AccelKind::List);
        let settings = Settings::default().with(|s| {
            s.image.width = 8;
            s.image.height = 6;
            s.light.samples = 64;
        });
        for at in (0..48).map(|i| (i % 8, i / 8)) {
            let trace = trace_pixel(&world, &settings, at, false);
            let view = View {
                world: &world,
                settings: &settings,
                trace: &trace,
            };
            let bundles = view.light_estimates(0);
            assert!(
                !bundles.is_empty() && bundles.iter().all(|b| b.blocked == 0),
                "{edge}, {at:?}"
            );
        }
    }
}
