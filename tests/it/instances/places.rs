//! Scenes with meshes in parts, and the same scenes with each use written out.

use std::collections::BTreeMap;
use std::fmt::Write;

use raytree::scene::{Scene, Settings, load_from_memory};

const TEAPOT: &[u8] = include_bytes!("../../../scenes/teapot.obj");
const BUNNY: &[u8] = include_bytes!("../../../scenes/bunny.obj");

/// Turned, mirrored, stretched, and small and large.
pub const PLACES: [&str; 4] = [
    r#"{"rotate": {"axis": [0.2, 1, 0], "degrees": 40}}, {"translate": [-1.3, 0.1, 0]}"#,
    r#"{"scale": [-1, 1, 1]}, {"rotate": {"axis": [0, 1, 0.3], "degrees": -25}}, {"translate": [1.3, 0, -0.4]}"#,
    r#"{"scale": [0.6, 0.9, 0.5]}, {"rotate": {"axis": [1, 0.3, 0], "degrees": 20}}, {"translate": [0, 0.2, 1.6]}"#,
    r#"{"scale": [0.5, 0.5, -0.5]}, {"translate": [0.1, 1.6, -0.6]}"#,
];

/// A ball of `around` times `rows` quadrangles, smooth, with texture coordinates; without poles.
pub fn ball(material: &str, around: u32, rows: u32) -> String {
    let (mut points, mut normals, mut uvs, mut triangles) = (vec![], vec![], vec![], vec![]);
    for row in 0..=rows {
        for i in 0..around {
            let up = 0.1 + 2.9 * f64::from(row) / f64::from(rows);
            let turn = std::f64::consts::TAU * f64::from(i) / f64::from(around);
            let n = [
                libm::sin(up) * libm::cos(turn),
                libm::cos(up),
                libm::sin(up) * libm::sin(turn),
            ];
            points.push(format!("{:?}", n.map(|x| 0.4 * x)));
            normals.push(format!("{n:?}"));
            uvs.push(format!("[{}, {up}]", turn / 2.0));
        }
    }
    for row in 0..rows {
        for i in 0..around {
            let [a, b] = [i, (i + 1) % around].map(|i| row * around + i);
            triangles.push(format!("[{a}, {b}, {}]", b + around));
            triangles.push(format!("[{a}, {}, {}]", b + around, a + around));
        }
    }
    let [points, normals, uvs, triangles] =
        [points, normals, uvs, triangles].map(|list| list.join(", "));
    format!(
        r#"{{"mesh": {{"name": "ball", "material": "{material}", "vertices": [{points}], "normals": [{normals}],
        "uvs": [{uvs}], "triangles": [{triangles}], "transform": [{{"translate": [0.2, 1.2, 0]}}]}}}}"#
    )
}

fn models(material: &str) -> [String; 3] {
    let obj = |name: &str, place: &str| {
        format!(
            r#"{{"obj": {{"name": "{name}", "material": "{material}", "file": "{name}.obj", "transform": [{place}]}}}}"#
        )
    };
    [
        obj("teapot", r#"{"translate": [0.4, 0, 0.3]}"#).replacen("teapot", "pot", 1),
        obj("bunny", r#"{"scale": 0.7}, {"translate": [-0.5, 0.1, 0]}"#),
        ball("checked", 12, 8),
    ]
}

/// A model of two objects of 100 and 70 triangles around a point.
fn two_fans() -> String {
    let mut text = String::new();
    for (name, count) in [("left", 100), ("right", 70)] {
        let _ = writeln!(text, "o {name}\nv 0 1 0");
        for i in 0..=count {
            let turn = f64::from(i) / 20.0;
            let _ = writeln!(text, "v {} 0 {}", libm::cos(turn), libm::sin(turn));
        }
        for i in 0..count {
            let _ = writeln!(text, "f {} {} {}", -2 - count, i - 1 - count, i - count);
        }
    }
    text
}

/// A scene of these parts and objects with a floor behind them, or why it is none.
pub fn scene_of(parts: &str, objects: &str) -> Result<Scene, String> {
    let text = format!(
        r#"{{"format": "raytree-scene/1", "background": [0.3, 0.4, 0.6], "ambient": [0.3, 0.3, 0.3],
        "camera": {{"eye": [0.4, 2.2, 6], "look_at": [0, 0.6, 0], "vertical_fov": 38}}, "materials": {{
        "clay": {{"diffuse": [0.6, 0.4, 0.3], "specular": [0.3, 0.3, 0.3], "mirror": [0.3, 0.3, 0.3]}},
        "checked": {{"diffuse": [0.2, 0.4, 0.6], "checker": {{"diffuse": [0.9, 0.9, 0.8], "size": 0.2}}}},
        "glass": {{"transmission": [0.9, 0.9, 0.9], "ior": 1.5}}, "lamp": {{"emission": [1, 1, 1]}}}},
        "lights": [{{"point": {{"name": "lamp", "position": [2, 4, 3], "intensity": [0.9, 0.9, 0.9]}}}}],
        "parts": {{{parts}}}, "objects": [{objects}], "settings": {{"depth": 3}}}}"#
    );
    let two = two_fans();
    let files = [
        ("a.json", text.as_bytes()),
        ("two.obj", two.as_bytes()),
        ("teapot.obj", TEAPOT),
        ("bunny.obj", BUNNY),
    ];
    let files: BTreeMap<_, _> = files
        .into_iter()
        .map(|(name, bytes)| (name.to_owned(), bytes.to_vec()))
        .collect();
    load_from_memory("a.json", files).map_err(|e| e.to_string())
}

const FLOOR: &str = r#"{"quad": {"name": "floor", "material": "clay", "corner": [-9, -0.5, 9], "u": [18, 0, 0], "v": [0, 0, -18]}}"#;

/// Three meshes in a part, used at each of these places.
pub fn in_parts(places: &[&str]) -> Scene {
    let mut objects = FLOOR.to_owned();
    for (i, place) in places.iter().enumerate() {
        let _ = write!(
            objects,
            r#", {{"use": {{"name": "u{i}", "part": "p", "transform": [{place}]}}}}"#
        );
    }
    let part = format!("\"p\": [{}]", models("clay").join(", "));
    scene_of(&part, &objects).expect("a scene")
}

/// The same in groups, without a part.
pub fn written_out(places: &[&str]) -> Scene {
    let mut objects = FLOOR.to_owned();
    for (i, place) in places.iter().enumerate() {
        let inside = models("clay").join(", ");
        let _ = write!(
            objects,
            r#", {{"group": {{"name": "u{i}", "objects": [{inside}], "transform": [{place}]}}}}"#
        );
    }
    scene_of("", &objects).expect("a scene")
}

/// So many bunnies on a floor.
pub fn many_bunnies(count: u32) -> Scene {
    let mut objects = FLOOR.replace("quad", "plane").replace(
        r#""corner": [-9, -0.5, 9], "u": [18, 0, 0], "v": [0, 0, -18]"#,
        r#""point": [0, -0.5, 0], "normal": [0, 1, 0]"#,
    );
    for i in 0..count {
        let (x, z) = (f64::from(i % 40) - 20.0, -f64::from(i / 40));
        let _ = write!(
            objects,
            r#", {{"use": {{"name": "u{i}", "part": "p", "transform": [{{"rotate": {{"axis": [0, 1, 0], "degrees": {i}}}}}, {{"translate": [{x}, 0, {z}]}}]}}}}"#
        );
    }
    let part = r#""p": [{"obj": {"name": "bunny", "material": "clay", "file": "bunny.obj"}}]"#;
    scene_of(part, &objects).expect("a scene")
}

/// Objects that are uses of a mesh that is kept once.
pub fn instances(scene: &Scene) -> usize {
    scene.objects.iter().filter(|o| o.instance).count()
}

/// The settings of a scene for a small picture of one sample a pixel.
pub fn small(scene: &Scene, (width, height): (u32, u32)) -> Settings {
    scene.settings.with(|s| {
        (s.image.width, s.image.height) = (width, height);
        s.pixel.samples = 1;
    })
}
