//! A scene of one plane and many lamps, each of which every sample asks: its pixels have the largest trees that can be recorded, since
//! each ray takes few steps.

use std::io::Write;

use tempfile::NamedTempFile;

/// Lamps in a row, and rows.
const ROW: u32 = 16;

/// The scene in a file.
pub fn written() -> NamedTempFile {
    let place = |n: u32| (f64::from(n) - 7.5) / 4.0;
    let lamp = |i: u32| {
        let (x, z) = (place(i % ROW), place(i / ROW));
        let intensity = [0.004; 3];
        format!(
            r#"{{"point": {{"name": "lamp {i}", "position": [{x}, 3, {z}], "intensity": {intensity:?}}}}}"#
        )
    };
    let lamps: Vec<String> = (0..ROW * ROW).map(lamp).collect();
    let text = format!(
        r#"{{"format": "raytree-scene/1", "name": "million", "camera": {{"eye": [0, 1, 4], "look_at": [0, 0, 0]}},
        "materials": {{"floor": {{"diffuse": [0.5, 0.5, 0.5]}}}}, "lights": [{}],
        "objects": [{{"plane": {{"name": "floor", "material": "floor", "point": [0, 0, 0], "normal": [0, 1, 0]}}}}]}}"#,
        lamps.join(",")
    );
    let file = tempfile::Builder::new().suffix(".json").tempfile();
    let mut file = file.expect("a temporary file");
    file.write_all(text.as_bytes()).expect("a full disk?");
    file
}
