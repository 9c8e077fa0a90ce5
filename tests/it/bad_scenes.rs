//! Bad scenes get a kind answer: where, what, and what to do. Never a panic.

mod format;
mod models;
mod parts;
mod paths;
mod shapes;
mod values;

use std::fs;
use std::path::PathBuf;

use raytree::scene::{Scene, load};

/// A folder with files in it, gone when dropped.
struct Folder(tempfile::TempDir);

impl Folder {
    fn new(files: &[(&str, &[u8])]) -> Self {
        let folder = Self(tempfile::tempdir().expect("a temporary folder"));
        for (name, bytes) in files {
            fs::write(folder.path(name), bytes).expect("a file");
        }
        folder
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn load(&self, name: &str) -> Result<Scene, String> {
        let path = self.path(name);
        load(path.to_str().expect("UTF-8")).map_err(|e| {
            let text = e.to_string();
            // The folder has a different name each time.
            text.replace(&format!("{}/", self.0.path().display()), "")
        })
    }
}

/// What is said about a scene file that holds `bytes`.
fn refused(bytes: &[u8]) -> String {
    let message = Folder::new(&[("a.json", bytes)])
        .load("a.json")
        .expect_err("a bad scene");
    for word in [
        "Some(", "Err(", "Error", "f64", "struct", "File", "variant", "\\n",
    ] {
        assert!(
            !message.contains(word),
            "no words of a programmer: {message}"
        );
    }
    assert_eq!(message.lines().count(), 2, "{message}");
    message
}

/// A scene around the given rest.
fn scene(rest: &str) -> String {
    format!(
        r#"{{"format": "raytree-scene/1", "camera": {{"eye": [0, 0, 5], "look_at": [0, 0, 0]}},
"ambient": [1, 1, 1], "materials": {{"red": {{"diffuse": [1, 0, 0]}}}}{rest}}}"#
    )
}

fn sphere(fields: &str) -> String {
    scene(&format!(
        r#", "objects": [{{"sphere": {{"name": "ball", "material": "red", {fields}}}}}]"#
    ))
}

const BALL: &str =
    r#"{"sphere": {"name": "ball", "material": "red", "center": [0, 0, 0], "radius": 1}}"#;

/// A scene with `objects`, which is text, and other files beside it.
fn loaded(objects: &str, files: &[(&str, &[u8])]) -> Result<Scene, String> {
    let text = scene(&format!(r#", "objects": [{objects}]"#));
    let mut all = vec![("a.json", text.as_bytes())];
    all.extend(files);
    Folder::new(&all).load("a.json")
}

const OBJ: &str = r#"{"obj": {"name": "model", "file": "m.obj"}}"#;

fn with_obj(text: &str) -> Result<Scene, String> {
    loaded(OBJ, &[("m.obj", text.as_bytes())])
}

const CORNERS: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

#[track_caller]
fn assert_says(message: &str, parts: &[&str]) {
    for part in parts {
        assert!(message.contains(part), "`{part}` is not in:\n{message}");
    }
}
