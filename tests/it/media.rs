//! Media where objects overlap: a point has one medium, from wherever a ray comes.

use raytree::accel::AccelKind;
use raytree::math::{DVec3, Ray};
use raytree::probe::{NONE, RayKind};
use raytree::trace::{Outcome, View, document, trace_pixel};
use raytree::world::{OpenMedia, World};

use crate::from_text;
use crate::random::Random;

/// World of balls of glass: center, radius, material.
fn balls(balls: &[(DVec3, f64, &str)], camera: [DVec3; 2]) -> World {
    let objects: Vec<String> = (0..)
        .zip(balls)
        .map(|(i, (center, radius, material))| {
            let [x, y, z] = center.to_array();
            format!(
                r#"{{"sphere": {{"name": "{i}", "material": "{material}", "center": [{x}, {y}, {z}], "radius": {radius}}}}}"#
            )
        })
        .collect();
    let [eye, target] = camera.map(|p| format!("{:?}", p.to_array()));
    let text = format!(
        r#"{{"format": "raytree-scene/1", "camera": {{"eye": {eye}, "look_at": {target}, "up": [0, 1, 0.001]}},
        "materials": {{"a": {{"transmission": [1, 1, 1], "ior": 1.5}}, "b": {{"transmission": [1, 1, 1], "ior": 1.33}}}},
        "background": [1, 1, 1], "objects": [{}], "settings": {{"min_weight": 0, "depth": 8}}}}"#,
        objects.join(", ")
    );
    World::new(from_text::scene(&text), AccelKind::List)
}

#[test]
fn a_point_has_the_same_medium_from_every_direction() {
    let mut random = Random(5);
    let camera = [DVec3::Z * 9.0, DVec3::ZERO];
    let mut points = 0;
    let mut inside_several = 0;
    while points < 100_000 {
        let scene: Vec<(DVec3, f64, &str)> = (0..6)
            .map(|_| {
                // Sizes that are equal, too: the later in the file decides.
                let radius = [0.5, 0.5, 0.8, 1.0][random.below(4)];
                (random.point(), radius, ["a", "b"][random.below(2)])
            })
            .collect();
        let world = balls(&scene, camera);
        for _ in 0..1000 {
            let point = random.point();
            let holders = (0u32..)
                .zip(&scene)
                .filter(|(_, (c, r, _))| (point - c).length() < *r);
            let holders: Vec<_> = holders.collect();
            inside_several += usize::from(holders.len() > 1);
            let smallest = holders
                .iter()
                .rev()
                .min_by(|(_, a), (_, b)| a.1.total_cmp(&b.1));
            let expected = smallest.map_or(NONE, |(object, _)| *object);
            for _ in 0..3 {
                let ray = Ray::new(point, random.direction());
                let medium = world.medium_at_start(&ray, &OpenMedia::NOTHING);
                assert_eq!(
                    medium, expected,
                    "{point} in {scene:?} along {}",
                    ray.direction
                );
            }
            points += 1;
        }
    }
    assert!(inside_several > 10_000, "{inside_several}");
}

/// The first ray and the last, when only transmitted rays are followed; `None` if it does not leave the scene.
fn first_and_last_transmitted(
    scene: &[(DVec3, f64, &str)],
    camera: [DVec3; 2],
) -> Option<[Ray; 2]> {
    let world = balls(scene, camera);
    let settings = world.scene.settings.with(|s| {
        s.image.width = 1;
        s.image.height = 1;
    });
    let tree = trace_pixel(&world, &settings, (0, 0), false).tree;
    let transmitted = |parent: u32| {
        let mut children = tree.children(parent);
        children.find(|c| tree.node(*c).ray.kind == RayKind::Transmitted)
    };
    let last = std::iter::successors(Some(0), |id| transmitted(*id)).last();
    let last = last.filter(|id| tree.node(*id).outcome == Some(Outcome::Miss))?;
    Some([0, last].map(|id| Ray::new(tree.node(id).ray.origin, tree.node(id).ray.direction)))
}

#[test]
fn a_path_through_overlapping_glass_comes_back() {
    let scene = [
        (DVec3::Z * 0.5, 1.0, "a"),
        (DVec3::Z * -0.5, 1.0, "b"),
        (DVec3::X * 0.4, 0.7, "b"),
    ];
    let mut random = Random(11);
    let mut paths = 0;
    for _ in 0..300 {
        let eye = 5.0 * random.direction();
        // What ends at total internal reflection does not come out.
        let Some([there, out]) = first_and_last_transmitted(&scene, [eye, 0.6 * random.point()])
        else {
            continue;
        };
        let beyond = out.origin + 10.0 * out.direction;
        let back = first_and_last_transmitted(&scene, [beyond, out.origin]);
        let [_, back] = back.expect("what came through one way comes through the other");
        let off = (there.direction + back.direction).length();
        assert!(off < 1e-9, "off by {off} from {eye}");
        paths += 1;
    }
    assert!(paths > 100, "{paths}");
}

/// The hit of the only pixel of a scene, as JSON.
fn hit(object: &str) -> serde_json::Value {
    let text = format!(
        r#"{{"format": "raytree-scene/1", "camera": {{"eye": [0, 0, 4], "look_at": [0.5, 0.2, 0]}},
        "materials": {{"m": {{}}}}, "objects": [{object}]}}"#
    );
    let world = World::new(from_text::scene(&text), AccelKind::List);
    let settings = world.scene.settings.with(|s| {
        s.image.width = 1;
        s.image.height = 1;
    });
    let trace = trace_pixel(&world, &settings, (0, 0), false);
    let view = View {
        world: &world,
        settings: &settings,
        trace: &trace,
    };
    let document = serde_json::to_value(document::of(view)).expect("JSON");
    document["samples"][0]["root"]["hit"].clone()
}

fn near(value: &serde_json::Value, expected: &[f64]) {
    let numbers = value.as_array().expect("numbers");
    assert_eq!(numbers.len(), expected.len());
    for (got, expected) in numbers.iter().zip(expected) {
        let got = got.as_f64().expect("a number");
        assert!((got - expected).abs() < 1e-4, "{value} is not {expected:?}");
    }
}

#[test]
fn surface_coordinates_turn_with_a_sphere() {
    let turned = r#"{"sphere": {"name": "s", "material": "m", "center": [0, 0, 0], "radius": 1,
        "transform": [{"rotate": {"axis": [0, 0, 1], "degrees": 90}}]}}"#;
    near(&hit(turned)["uv"], &[0.2768, 0.3737]);
}

#[test]
fn a_mirrored_triangle_keeps_the_order_of_its_corners() {
    let mirrored = hit(
        r#"{"triangle": {"name": "t", "material": "m", "corners": [[-2, -2, 0], [2, -2, 0], [0, 2, 0]],
        "transform": [{"scale": [-1, 1, 1]}]}}"#,
    );
    // The same point, of the triangle that is written as it is seen.
    let plain = hit(
        r#"{"triangle": {"name": "t", "material": "m", "corners": [[2, -2, 0], [-2, -2, 0], [0, 2, 0]]}}"#,
    );
    let [a, b, c] = [0, 1, 2].map(|i| plain["barycentric"][i].as_f64().expect("a number"));
    near(&mirrored["barycentric"], &[a, b, c]);
    near(&mirrored["uv"], &[b, c]);
    near(&plain["uv"], &[b, c]);
    assert_eq!(mirrored["side"], "front");
}
