//! Shapes as scene files have them: polygons of many corners, faces that are not flat, parts that are stretched.
//! Most hard cases of shapes stand beside their code: README.md says where.

use std::f64::consts::TAU;
use std::fmt::Write as _;

use raytree::accel::AccelKind;
use raytree::geometry::Hit;
use raytree::math::{DVec3, Ray};
use raytree::probe::Silent;
use raytree::world::World;

use super::support::{Random, count, scene, towards};

/// The world of these parts and objects.
fn world(parts: &str, objects: &str) -> World {
    let scene = scene(&format!(
        r#"{{"format": "raytree-scene/1", "camera": {{"eye": [0, 0, 5], "look_at": [0, 0, 0]}},
        "materials": {{"m": {{}}}}, "parts": {{{parts}}}, "objects": [{objects}]}}"#
    ));
    World::new(scene, AccelKind::default())
}

fn closest(world: &World, ray: &Ray) -> Option<Hit> {
    world.closest(ray, 0.0, &mut Silent)
}

#[test]
fn case_110_a_thousand_corners_on_a_circle() {
    let mut points = String::new();
    for i in 0..1000 {
        let angle = TAU * f64::from(i) / 1000.0;
        let comma = if i == 0 { "" } else { ", " };
        let _ = write!(
            points,
            "{comma}[{}, {}, 0]",
            libm::cos(angle),
            libm::sin(angle)
        );
    }
    let polygon = world(
        "",
        &format!(r#"{{"polygon": {{"name": "p", "material": "m", "points": [{points}]}}}}"#),
    );
    let disc = world(
        "",
        r#"{"disc": {"name": "d", "material": "m", "center": [0, 0, 0], "normal": [0, 0, 1], "radius": 1}}"#,
    );
    // How far an edge is inside of the circle.
    let sagitta = 1.0 - libm::cos(TAU / 2000.0);
    let (mut differ, mut random) = (0, Random(110));
    for _ in 0..count(200_000, 20_000) {
        let angle = TAU * random.share();
        let radius = 1.0 + 4.0 * sagitta * (random.share() - 0.6);
        let target = radius * DVec3::new(libm::cos(angle), libm::sin(angle), 0.0);
        let ray = towards(DVec3::new(0.3, -0.2, 2.0), target).expect("a direction");
        let [one, other] = [&polygon, &disc].map(|w| closest(w, &ray).is_some());
        if one != other {
            assert!(
                other && radius > 1.0 - sagitta - 1e-12 && radius < 1.0 + 1e-12,
                "{radius}"
            );
            differ += 1;
        }
    }
    assert!(
        differ > 1000,
        "{differ} rays between an edge and its circle"
    );
}

#[test]
fn case_112_a_face_that_is_not_flat_has_no_hole() {
    // A quadrangle with a corner lifted; seen from above it covers the unit square, whichever diagonal it is cut along.
    let corners = ["[0, 0, 0]", "[1, 0, 0]", "[1, 1, 0.4]", "[0, 1, 0]"];
    for turn in 0..4 {
        let points: Vec<&str> = (0..4).map(|i| corners[(i + turn) % 4]).collect();
        let polygon = format!(
            r#"{{"polygon": {{"name": "p", "material": "m", "points": [{}]}}}}"#,
            points.join(", ")
        );
        let world = world("", &polygon);
        assert_eq!(world.scene.warnings.len(), 1, "it is told");
        assert_eq!(world.scene.shapes.len(), 2);
        let mut random = Random(112);
        for i in 0..count(100_000, 10_000) {
            let (x, y) = (random.share(), random.share());
            // A third of the rays on a diagonal.
            let (x, y) = match i % 6 {
                0 => (x, x),
                1 => (x, 1.0 - x),
                _ => (x, y),
            };
            let down = Ray::new(DVec3::new(x, y, 3.0), DVec3::NEG_Z);
            let inside = x > 0.0 && x < 1.0 && y > 0.0 && y < 1.0;
            assert!(!inside || closest(&world, &down).is_some(), "{x} {y}");
            assert_eq!(
                world
                    .crossings(&down, raytree::math::Interval::FORWARD)
                    .len(),
                1
            );
        }
    }
}

#[test]
fn case_166_a_part_that_is_stretched_by_a_hundred_million() {
    let ball = r#"{"sphere": {"name": "s", "material": "m", "center": [0, 0, 0], "radius": 1}}"#;
    let used = r#"{"use": {"name": "u", "part": "p", "transform": [{"scale": [1e-4, 1, 1e4]}]}}"#;
    let world = world(&format!("\"p\": [{ball}]"), used);
    let mut random = Random(166);
    for _ in 0..count(100_000, 10_000) {
        // Along x to a chosen (y, z): the surface is where (x 1e4)^2 + y^2 + (z / 1e4)^2 = 1.
        let (y, z) = (1.6 * random.share() - 0.8, 1.2 * random.share() - 0.6);
        let half = (1.0 - y * y - z * z).sqrt();
        if half.is_nan() {
            continue;
        }
        let ray = Ray::new(DVec3::new(1.0, y, 1e4 * z), DVec3::NEG_X);
        let hit = closest(&world, &ray).expect("inside of the outline");
        assert!(
            (hit.t - (1.0 - 1e-4 * half)).abs() < 1e-15,
            "{} {half}",
            hit.t
        );
        let at = world.scene.interaction(&ray, &hit);
        assert!(at.normal.x > 0.999 && at.point.x > 0.0);
        let across = Ray::new(DVec3::new(0.0, y, -2e4), DVec3::Z);
        let hit = closest(&world, &across).expect("inside of the outline");
        let expected = 2e4 - 1e4 * (1.0 - y * y).sqrt();
        assert!((hit.t - expected).abs() < 1e-11, "{} {expected}", hit.t);
    }
}
