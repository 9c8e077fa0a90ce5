//! Parts of a scene: a use is the group of the same objects, and what a hit says of its frames is how it stands in the world.

use raytree::accel::AccelKind;
use raytree::math::{DVec3, Ray};
use raytree::probe::Silent;
use raytree::scene::{self, Scene};
use raytree::trace::document::RayNode;
use raytree::trace::{Document, View, document, trace_pixel};
use raytree::tracer::{Film, draw};
use raytree::world::World;

use crate::cli::{refused, run};
use crate::from_text::scene as read;

const MATERIALS: &str = r#""red": {"diffuse": [0.7, 0.2, 0.1]}, "steel": {"diffuse": [0.2, 0.2, 0.3], "mirror": [0.5, 0.5, 0.5]},
    "glass": {"transmission": [0.9, 0.9, 0.9], "ior": 1.5}"#;

/// A scene of these parts and objects.
fn text(parts: &str, objects: &str) -> String {
    format!(
        r#"{{"format": "raytree-scene/1", "background": [0.3, 0.4, 0.6], "ambient": [0.3, 0.3, 0.3],
        "camera": {{"eye": [0.4, 1.7, 6], "look_at": [0, 0.4, 0], "vertical_fov": 40}}, "materials": {{{MATERIALS}}},
        "lights": [{{"point": {{"name": "lamp", "position": [2, 4, 3], "intensity": [0.9, 0.9, 0.9]}}}}],
        "parts": {{{parts}}}, "objects": [{objects}], "settings": {{"depth": 5}}}}"#
    )
}

fn world(scene: Scene) -> World {
    World::new(scene, AccelKind::default())
}

fn picture(scene: Scene) -> Film {
    let settings = scene.settings.with(|s| {
        (s.image.width, s.image.height) = (80, 60);
        s.pixel.samples = 1;
    });
    draw(&world(scene), &settings, 0)
}

/// Objects of many kinds: a body of glass, a mesh, a solid cut from others.
const OBJECTS: &str = r#"{"sphere": {"name": "rim", "material": "glass", "center": [0.5, 0, 0], "radius": 0.4}},
    {"mesh": {"name": "fin", "material": "red", "vertices": [[0, 0, 0], [0, 1, 0], [-1, 0.4, 0.3], [-0.6, 1.2, 0]],
        "triangles": [[0, 1, 2], [1, 3, 2]]}},
    {"csg": {"name": "cut", "material": "steel", "op": "difference", "transform": [{"translate": [0, -0.6, 0.4]}], "parts": [
        {"box": {"name": "block", "min": [-0.4, -0.3, -0.3], "max": [0.4, 0.3, 0.3]}},
        {"sphere": {"name": "hole", "material": "red", "center": [0, 0.3, 0.3], "radius": 0.25}}]}}"#;

#[test]
fn a_use_is_the_group_of_the_same_objects() {
    let places = [
        r#"[{"rotate": {"axis": [0.2, 1, 0], "degrees": 40}}, {"translate": [-1.2, 0.3, 0]}]"#,
        // Mirrored: triangles keep their fronts.
        r#"[{"scale": [-1, 1, 1]}, {"translate": [1.4, 0.6, -0.5]}]"#,
        r#"[{"scale": [0.5, 1.5, 0.7]}]"#,
    ];
    let named = |kind: &str, rest: &str| -> String {
        let one = places.iter().enumerate().map(|(i, place)| {
            format!(r#"{{"{kind}": {{"name": "o{i}", {rest}, "transform": {place}}}}}"#)
        });
        one.collect::<Vec<_>>().join(",\n")
    };
    let used = read(&text(
        &format!("\"p\": [{OBJECTS}]"),
        &named("use", r#""part": "p""#),
    ));
    let written = read(&text(
        "",
        &named("group", &format!("\"objects\": [{OBJECTS}]")),
    ));
    let names =
        |scene: &Scene| -> Vec<String> { scene.objects.iter().map(|o| o.name.clone()).collect() };
    assert_eq!(names(&used), names(&written));
    assert_eq!(names(&used)[4], "o1/fin");
    assert_eq!(used.objects[2].leaves[1].name, "o0/cut/hole");
    let [a, b] = [used, written].map(picture);
    assert!(a.pixels.iter().any(|p| *p != a.pixels[0]));
    assert_eq!(a.pixels, b.pixels);
}

#[test]
fn thirty_two_turns_by_a_thirty_second_are_none() {
    let turn = r#"[{"rotate": {"axis": [0, 0, 1], "degrees": 11.25}}]"#;
    let ball =
        r#"{"sphere": {"name": "s", "material": "red", "center": [3, 0.5, 0], "radius": 1}}"#;
    let mut parts = vec![format!("\"p0\": [{ball}]")];
    for i in 1..32 {
        let one = format!(
            r#""p{i}": [{{"use": {{"name": "u{i}", "part": "p{}", "transform": {turn}}}}}]"#,
            i - 1
        );
        parts.push(one);
    }
    let outermost = format!(r#"{{"use": {{"name": "u", "part": "p31", "transform": {turn}}}}}"#);
    let scene = read(&text(&parts.join(",\n"), &outermost));
    assert_eq!(scene.frames_of(&scene.objects[0]).count(), 32);
    let map = scene.frames[31].matrix();
    let same = |row: usize, column: usize| f64::from(row == column);
    for (i, row) in map.iter().enumerate() {
        for (j, x) in row.iter().enumerate() {
            assert!((x - same(i, j)).abs() <= 1e-14, "{map:?}");
        }
    }
    let ray = Ray::new(DVec3::new(3.0, 0.5, 9.0), DVec3::new(0.0, 0.0, -1.0));
    let hit = world(scene).closest(&ray, 0.0, &mut Silent).expect("a hit");
    assert!((hit.t - 8.0).abs() < 1e-13, "{}", hit.t);
}

/// Every ray of a tree that hit something.
fn hits<'a>(node: &'a RayNode, found: &mut Vec<&'a RayNode>) {
    if node.hit.is_some() {
        found.push(node);
    }
    for child in &node.children {
        hits(child, found);
    }
}

#[test]
fn frames_carry_the_ray_there_and_back() {
    let scene = scene::load("solar").expect("a built-in scene");
    let settings = scene.settings.with(|s| {
        (s.image.width, s.image.height) = (64, 48);
        s.pixel.samples = 1;
    });
    let world = world(scene);
    let mut depths = [0; 4];
    for pixel in (0..64 * 48).step_by(7).map(|i| (i % 64, i / 64)) {
        let trace = trace_pixel(&world, &settings, pixel, false);
        let document: Document = document::of(View {
            world: &world,
            settings: &settings,
            trace: &trace,
        });
        let mut found = Vec::new();
        for root in document.samples.iter().filter_map(|s| s.root.as_ref()) {
            hits(root, &mut found);
        }
        for node in found {
            let hit = node.hit.as_ref().expect("a hit");
            depths[hit.frames.len()] += 1;
            let object = world.scene.objects.iter().find(|o| o.name == hit.object);
            let frames: Vec<_> = world.scene.frames_of(object.expect("known")).collect();
            assert_eq!(frames.len(), hit.frames.len());
            let mut outside = hit.object.clone();
            for (frame, told) in frames.iter().zip(&hit.frames) {
                assert!(outside.starts_with(&format!("{}/", told.group)));
                outside.clone_from(&told.group);
                let ray = Ray::new(DVec3::from(node.origin), DVec3::from(node.direction));
                let there = frame.ray(&ray);
                let p = (there.origin + hit.t * there.direction).extend(1.0);
                let back = told.to_world.map(|row| glam::DVec4::from(row).dot(p));
                assert!((DVec3::from(back) - DVec3::from(hit.point)).length() < 1e-12);
            }
        }
    }
    // In a group there are only uses of parts, so nothing stands in one frame.
    assert!(
        depths[0] > 0 && depths[2] > 0 && depths[3] > 0,
        "{depths:?}"
    );
}

#[test]
fn the_frames_are_explained() {
    let ran = run(&["trace", "solar", "--pixel", "38,30", "--size", "64x48"]);
    let tree: serde_json::Value = serde_json::from_slice(&ran.out).expect("JSON");
    let hit = &tree["samples"][0]["root"]["hit"];
    assert_eq!(hit["frames"][0]["group"], "inner/earth", "{hit}");
    assert_eq!(hit["frames"][1]["group"], "inner", "{hit}");
    assert_eq!(hit["frames"][2], serde_json::Value::Null);
}

#[test]
fn a_material_of_a_use_is_that_of_all_in_it() {
    let both = r#"{"use": {"name": "a", "part": "p", "material": "steel"}}, {"use": {"name": "b", "part": "p"}}"#;
    let scene = read(&text(&format!("\"p\": [{OBJECTS}]"), both));
    let shown = |object: usize| -> Vec<&str> {
        let materials = scene.materials_of(&scene.objects[object]);
        materials.map(|m| m.name.as_str()).collect()
    };
    assert_eq!(shown(0), ["steel"]);
    assert_eq!(shown(2), ["steel", "steel", "steel"]);
    assert_eq!(shown(3), ["glass"]);
    assert_eq!(shown(5), ["steel", "steel", "red"]);
    // The outermost one counts.
    let inner = r#""q": [{"use": {"name": "in", "part": "p", "material": "red"}}]"#;
    let outer = r#"{"use": {"name": "out", "part": "q", "material": "steel"}}"#;
    let scene = read(&text(&format!("\"p\": [{OBJECTS}], {inner}"), outer));
    let name = |o: usize| {
        scene.materials[scene.objects[o].material as usize]
            .name
            .as_str()
    };
    assert_eq!([name(0), name(1), name(2)], ["steel"; 3]);
}

#[test]
fn a_change_of_a_part_is_seen_at_every_use() {
    let object = |pixel: &'static str, more: &[&'static str]| -> String {
        let base = ["trace", "solar", "--size", "64x48", "--pixel", pixel];
        let ran = run(&[&base[..], more].concat());
        assert_eq!(ran.code, 0, "{}", ran.err);
        let tree: serde_json::Value = serde_json::from_slice(&ran.out).expect("JSON");
        tree["samples"][0]["root"]["hit"]["object"].to_string()
    };
    for (pixel, name) in [("38,30", "inner/earth/ball"), ("49,21", "far/twin/ball")] {
        assert_eq!(object(pixel, &[]), format!("\"{name}\""));
        let changed = object(pixel, &["--change", "part.earth/ball.radius=0.01"]);
        assert!(!changed.contains("ball"), "{changed}");
    }
    let change = "part.earth/bal.radius=1";
    let words = ["there is no part `earth/bal`", "did you mean `earth/ball`?"];
    refused(&["render", "solar", "--change", change], 1, &words);
    let change = "object.inner/earth.part=\"moon\"";
    let ran = run(&[
        "trace", "solar", "--pixel", "1,1", "--size", "8x8", "--change", change,
    ]);
    assert_eq!(ran.code, 0, "{}", ran.err);
}
