//! Scene files and models inside the program.

/// Name and text of each scene, in the order in which they are listed.
const SCENES: [(&str, &str); 18] = [
    ("whitted", include_str!("../../../scenes/whitted.json")),
    ("triangle", include_str!("../../../scenes/triangle.json")),
    ("mirrors", include_str!("../../../scenes/mirrors.json")),
    (
        "glass-block",
        include_str!("../../../scenes/glass-block.json"),
    ),
    (
        "nested-glass",
        include_str!("../../../scenes/nested-glass.json"),
    ),
    ("shadows", include_str!("../../../scenes/shadows.json")),
    ("room", include_str!("../../../scenes/room.json")),
    ("teapot", include_str!("../../../scenes/teapot.json")),
    ("bunny", include_str!("../../../scenes/bunny.json")),
    (
        "soft-shadow",
        include_str!("../../../scenes/soft-shadow.json"),
    ),
    ("lamps", include_str!("../../../scenes/lamps.json")),
    ("polygons", include_str!("../../../scenes/polygons.json")),
    ("quadrics", include_str!("../../../scenes/quadrics.json")),
    ("torus", include_str!("../../../scenes/torus.json")),
    ("csg", include_str!("../../../scenes/csg.json")),
    (
        "teapot-patches",
        include_str!("../../../scenes/teapot-patches.json"),
    ),
    ("gouraud", include_str!("../../../scenes/gouraud.json")),
    ("solar", include_str!("../../../scenes/solar.json")),
];

/// Name and text of each model.
const FILES: [(&str, &str); 3] = [
    ("teapot.obj", include_str!("../../../scenes/teapot.obj")),
    ("bunny.obj", include_str!("../../../scenes/bunny.obj")),
    ("ball.obj", include_str!("../../../scenes/ball.obj")),
];

/// The default scene.
pub const DEFAULT: &str = "whitted";

/// Names of the built-in scenes.
pub fn names() -> impl Iterator<Item = &'static str> {
    SCENES.iter().map(|(name, _)| *name)
}

/// The text of a built-in scene, in the format of scene files.
pub fn scene(name: &str) -> Option<&'static str> {
    find(&SCENES, name)
}

/// The text of a file that a built-in scene names.
pub fn file(name: &str) -> Option<&'static str> {
    find(&FILES, name)
}

fn find(list: &[(&str, &'static str)], name: &str) -> Option<&'static str> {
    let (_, text) = list.iter().find(|(known, _)| *known == name)?;
    Some(text)
}
