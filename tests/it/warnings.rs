//! Warnings about scenes that are accepted and can hardly be meant, and near cases that must not warn.

mod bodies;
mod built_in;
mod cuts;
mod light;
mod places;
mod values;

use raytree::accel::AccelKind;
use raytree::scene::Scene;
use raytree::scene::effects::effects;
use raytree::world::{World, checks};

use crate::from_text::scene;

/// A scene file with a camera before the origin, a lamp and these further fields.
pub fn file(fields: &str) -> String {
    with(LAMP, fields)
}

/// A scene file with a camera before the origin, with these lights and further fields.
pub fn with(lights: &str, fields: &str) -> String {
    format!(
        r#"{{"format": "raytree-scene/1", "camera": {{"eye": [0.3, 0.2, 5], "look_at": [0, 0, 0], "vertical_fov": 20}},
"background": [0.2, 0.4, 0.6], "lights": [{lights}], {fields}}}"#
    )
}

/// A lamp behind the eye.
pub const LAMP: &str =
    r#"{"point": {"name": "lamp", "position": [3, 4, 5], "intensity": [1, 1, 1]}}"#;

/// A red ball in the middle, whose material has these fields.
pub fn ball(material: &str) -> String {
    format!(
        r#""materials": {{"red": {{{material}}}}}, "objects": [{{"sphere": {{"name": "ball", "material": "red",
"center": [0, 0, 0], "radius": 1}}}}]"#
    )
}

/// A matt red.
pub const RED: &str = r#""diffuse": [0.8, 0.1, 0.1]"#;

/// The codes of a scene's warnings, and their texts: those of its file, then those of its surfaces in space.
pub fn told(text: &str) -> Vec<(&'static str, String)> {
    all(scene(text))
}

/// The codes and texts of all that a scene warns of before it is rendered.
pub fn all(scene: Scene) -> Vec<(&'static str, String)> {
    let settings = scene.settings.with(|s| s.effects = effects(&scene));
    let world = World::new(scene, AccelKind::Bvh);
    let mut warnings = world.scene.warnings.clone();
    warnings.extend(checks::warnings(&world, &settings, "test.json"));
    let texts = warnings.iter().map(|w| (w.code.name(), w.to_string()));
    texts.collect()
}

/// Asserts that one warning is told, of this code, with all of these words.
#[track_caller]
pub fn warns(text: &str, code: &str, words: &[&str]) {
    one(&told(text), code, words);
}

/// Asserts that this list is one warning of this code with all of these words.
#[track_caller]
pub fn one(told: &[(&str, String)], code: &str, words: &[&str]) {
    let [(found, said)] = told else {
        panic!("{code} alone is wanted: {told:?}");
    };
    assert_eq!(*found, code, "{said}");
    for word in words {
        assert!(said.contains(word), "`{word}` is not in {said}");
    }
}

/// Asserts that nothing is told.
#[track_caller]
pub fn silent(text: &str) {
    assert_eq!(told(text), [], "{text}");
}
