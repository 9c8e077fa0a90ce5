//! Shapes that can be said in two ways look alike in both.

use raytree::accel::AccelKind;
use raytree::scene::{Effect, Scene, effects};
use raytree::tracer::{Film, draw};
use raytree::world::World;

use crate::from_text;

/// A scene of these objects over a floor, with a material of each kind.
fn scene(objects: &str) -> Scene {
    from_text::scene(&format!(
        r#"{{"format": "raytree-scene/1", "background": [0.3, 0.4, 0.6], "ambient": [0.2, 0.2, 0.2],
        "camera": {{"eye": [0.4, 1.7, 4], "look_at": [0, 0.6, 0], "vertical_fov": 40}},
        "materials": {{
          "chalk": {{"diffuse": [0.7, 0.5, 0.3]}}, "shiny": {{"diffuse": [0.2, 0.2, 0.2], "specular": [0.8, 0.8, 0.8]}},
          "mirror": {{"mirror": [0.8, 0.8, 0.8]}}, "glass": {{"transmission": [0.9, 0.95, 0.9], "ior": 1.5}},
          "floor": {{"diffuse": [0.6, 0.6, 0.6], "checker": {{"diffuse": [0.2, 0.2, 0.2], "size": 0.5}}}}
        }},
        "lights": [{{"point": {{"name": "lamp", "position": [2, 4, 3], "intensity": [0.9, 0.9, 0.9]}}}}],
        "objects": [
          {{"plane": {{"name": "floor", "material": "floor", "point": [0, -0.01, 0], "normal": [0, 1, 0]}}}},
          {objects}
        ], "settings": {{"depth": 6}}}}"#
    ))
}

fn picture(scene: Scene) -> Film {
    let settings = scene.settings.with(|s| {
        (s.image.width, s.image.height) = (96, 72);
        s.pixel.samples = 1;
    });
    draw(&World::new(scene, AccelKind::default()), &settings, 0)
}

/// The number of pixels that differ by more than `most` in a channel.
fn differing(one: &str, other: &str, most: f64) -> usize {
    let [a, b] = [one, other].map(|objects| picture(scene(objects)));
    let pairs = a.pixels.iter().zip(&b.pixels);
    let differs = |(a, b): &(&raytree::math::Rgb, &raytree::math::Rgb)| {
        let gaps = a.channels().into_iter().zip(b.channels());
        gaps.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max) > most
    };
    pairs.filter(differs).count()
}

const GLASS_BOX: &str = r#"{"box": {"name": "b", "material": "glass", "min": [-0.7, 0, -0.5], "max": [0.6, 1.1, 0.4]}}"#;

#[test]
fn a_body_of_polygons_is_the_box_of_the_same_corners() {
    let mesh = r#"{"mesh": {"name": "b", "material": "glass",
        "vertices": [[-0.7, 0, -0.5], [0.6, 0, -0.5], [-0.7, 1.1, -0.5], [0.6, 1.1, -0.5],
                     [-0.7, 0, 0.4], [0.6, 0, 0.4], [-0.7, 1.1, 0.4], [0.6, 1.1, 0.4]],
        "polygons": [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]]}}"#;
    assert!(differing(GLASS_BOX, mesh, 1e-9) <= 3);
}

#[test]
fn a_csg_of_one_part_is_that_part() {
    let whole = |material: &str| {
        format!(
            r#"{{"csg": {{"name": "c", "material": "{material}", "op": "intersection", "parts": [
            {{"box": {{"name": "room", "min": [-5, -5, -5], "max": [5, 5, 5]}}}},
            {{"sphere": {{"name": "ball", "center": [0, 0.7, 0], "radius": 0.7}}}}]}}}}"#
        )
    };
    for material in ["chalk", "mirror", "glass"] {
        let ball = format!(
            r#"{{"sphere": {{"name": "c", "material": "{material}", "center": [0, 0.7, 0], "radius": 0.7}}}}"#
        );
        assert_eq!(differing(&ball, &whole(material), 1e-9), 0, "{material}");
    }
}

#[test]
fn one_shape_in_two_kinds_is_one_picture() {
    let lying = r#""transform": [{"rotate": {"axis": [0, 0, 1], "degrees": 90}}, {"translate": [0, 0.6, 0]}]"#;
    let pairs = [
        (
            r#"{"ellipsoid": {"name": "s", "material": "glass", "center": [0, 0.7, 0], "radii": [0.6, 0.6, 0.6]}}"#.to_owned(),
            r#"{"sphere": {"name": "s", "material": "glass", "center": [0, 0.7, 0], "radius": 0.6}}"#.to_owned(),
        ),
        (
            r#"{"cylinder": {"name": "s", "material": "glass", "base": [0, 0, 0], "top": [0, 1, 0], "radius": 0.5}}"#.to_owned(),
            r#"{"quadric": {"name": "s", "material": "glass", "coefficients": [1, 0, 1, 0, 0, 0, 0, 0, 0, -0.25], "min": [-1, 0, -1], "max": [1, 1, 1]}}"#.to_owned(),
        ),
        (
            r#"{"torus": {"name": "s", "material": "shiny", "center": [0, 0.6, 0], "axis": [1, 0, 0], "major": 0.45, "minor": 0.15}}"#.to_owned(),
            format!(r#"{{"torus": {{"name": "s", "material": "shiny", "center": [0, 0, 0], "major": 0.45, "minor": 0.15, {lying}}}}}"#),
        ),
        (
            r#"{"quad": {"name": "s", "material": "mirror", "corner": [-0.8, 0, -0.3], "u": [1.6, 0, 0.2], "v": [0, 1.2, -0.1]}}"#.to_owned(),
            r#"{"bezier": {"name": "s", "material": "mirror", "degree": [1, 1], "patches": [[[[-0.8, 0, -0.3], [0.8, 0, -0.1]], [[-0.8, 1.2, -0.4], [0.8, 1.2, -0.2]]]]}}"#.to_owned(),
        ),
        (
            r#"{"polygon": {"name": "s", "material": "shiny", "points": [[-0.8, 0, 0], [0.8, 0, 0], [0.8, 1, 0], [-0.8, 1, 0]]}}"#.to_owned(),
            r#"{"nurbs": {"name": "s", "material": "shiny", "degree": [1, 1], "knots": [[0, 0, 1, 1], [0, 0, 1, 1]],
                "points": [[[-0.8, 0, 0], [0.8, 0, 0]], [[-0.8, 1, 0], [0.8, 1, 0]]]}}"#.to_owned(),
        ),
    ];
    for (one, other) in &pairs {
        let count = differing(one, other, 1e-7);
        assert!(count <= 4, "{count} pixels: {one}\n{other}");
    }
}

/// What only a part of a solid shows is simulated.
#[test]
fn the_materials_of_parts_call_for_effects() {
    let cut = |material: &str| {
        scene(&format!(
            r#"{{"csg": {{"name": "c", "material": "chalk", "op": "difference", "parts": [
            {{"box": {{"name": "cube", "min": [-0.6, 0, -0.6], "max": [0.6, 1.2, 0.6]}}}},
            {{"sphere": {{"name": "bite", "material": "{material}", "center": [0.4, 1, 0.5], "radius": 0.6}}}}]}}}}"#
        ))
    };
    for (material, effect) in [
        ("shiny", Effect::Highlights),
        ("mirror", Effect::Reflection),
    ] {
        assert!(effects::effects(&cut(material)).has(effect), "{material}");
        assert!(!effects::effects(&cut("chalk")).has(effect), "{material}");
    }
}
