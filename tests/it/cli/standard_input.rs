//! Scenes on standard input, and from text in the library.

use std::fs;
use std::process::{Output, Stdio};

use raytree::scene::{from_json, load};
use serde_json::Value;

use super::raytree;

const SCENE: &str = r#"{"format": "raytree-scene/1", "camera": {"eye": [0, 0, 4], "look_at": [0, 0, 0]},
  "materials": {"m": {"emission": [1, 0.5, 0]}},
  "objects": [{"sphere": {"name": "ball", "material": "m", "center": [0, 0, 0], "radius": 1}}]}"#;

/// What a command does with this text on its standard input, in this folder.
fn fed(folder: &std::path::Path, args: &[&str], text: &[u8]) -> Output {
    let mut command = raytree(args);
    command
        .current_dir(folder)
        .write_stdin(text)
        .output()
        .expect("runs")
}

#[test]
fn every_command_reads_a_scene_from_standard_input() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("a.json"), SCENE).expect("a file");
    let size = ["--size", "16x12"];
    for command in [
        &["render", "SCENE"][..],
        &["trace", "SCENE", "--pixel", "8,6"],
        &["trace", "SCENE", "--pixel", "8,6", "--format", "text"],
        &["effects", "SCENE"],
        &[
            "cost",
            "SCENE",
            "--budget",
            "3",
            "--most",
            "1",
            "--runs",
            "1",
            "--knob",
            "pixel-samples",
            "--csv",
        ],
    ] {
        let with = |scene: &str| -> Vec<String> {
            let words = command.iter().map(|w| w.replace("SCENE", scene));
            let size = if command[0] == "effects" {
                &[][..]
            } else {
                &size
            };
            words.chain(size.iter().map(|w| (*w).to_owned())).collect()
        };
        let run = |scene: &str, text: &str| {
            let args = with(scene);
            let args: Vec<&str> = args.iter().map(String::as_str).collect();
            let output = fed(folder.path(), &args, text.as_bytes());
            let said = String::from_utf8_lossy(&output.stderr).into_owned();
            assert_eq!(
                (output.status.code(), said.as_str()),
                (Some(0), ""),
                "{args:?}"
            );
            String::from_utf8(output.stdout).expect("UTF-8")
        };
        let (piped, from_file) = (run("-", SCENE), run("a.json", ""));
        if command[0] == "cost" {
            assert_eq!(piped.lines().count(), from_file.lines().count());
        } else {
            // The same, but for the name that a file gives.
            assert_eq!(piped.replace("standard input", "a"), from_file);
        }
    }
}

#[test]
fn what_is_wrong_with_standard_input_is_told_by_that_name() {
    let folder = tempfile::tempdir().expect("a folder");
    for (text, words) in [
        (
            &b"{\"format\": \"raytree-scene/1\",\n }"[..],
            "error: standard input:2:",
        ),
        (b"", "standard input: the file is empty"),
        (b"\xff\xfe", "standard input: this is not UTF-8"),
        (b"v 0 0 0\n", "standard input: this is not a scene"),
    ] {
        let output = fed(folder.path(), &["render", "-"], text);
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert!(said.contains(words), "{said}");
    }
}

/// Without an end, and larger than any scene may be.
#[test]
#[cfg(unix)]
fn standard_input_is_bounded() {
    let endless = fs::File::open("/dev/zero").expect("a device");
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_raytree"))
        .args(["effects", "-"])
        .stdin(Stdio::from(endless))
        .output()
        .expect("runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("256 MiB at most"), "{said}");
}

#[test]
fn a_scene_on_standard_input_names_models_of_the_current_folder() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(
        folder.path().join("a.obj"),
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    )
    .expect("a file");
    let scene = |file: &str| {
        format!(
            r#"{{"format": "raytree-scene/1", "camera": {{"eye": [0.2, 0.2, 4], "look_at": [0.2, 0.2, 0]}},
            "objects": [{{"obj": {{"name": "a", "file": "{file}"}}}}]}}"#
        )
    };
    let trace = ["trace", "-", "--size", "9x9", "--pixel", "4,4"];
    let output = fed(folder.path(), &trace, scene("a.obj").as_bytes());
    let tree: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let object = tree["samples"][0]["root"]["hit"]["object"]
        .as_str()
        .expect("a hit");
    assert!(object.starts_with('a'), "{object}");
    // What is read may not be replaced, and no path leads out.
    let into = ["render", "-", "-o", "a.obj"];
    let output = fed(folder.path(), &into, scene("a.obj").as_bytes());
    assert_eq!(output.status.code(), Some(2));
    let output = fed(folder.path(), &trace, scene("../a.obj").as_bytes());
    assert_eq!(output.status.code(), Some(1));
}

/// A file that comes in by a redirection is read as well.
#[test]
#[cfg(unix)]
fn a_redirected_scene_is_not_replaced() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.png");
    fs::write(&path, SCENE).expect("a file");
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_raytree"))
        .args(["render", "-", "--size", "8x6", "-o"])
        .arg(&path)
        .stdin(fs::File::open(&path).expect("there"))
        .output()
        .expect("runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains("this file is read"), "{said}");
    assert_eq!(fs::read_to_string(&path).expect("there"), SCENE);
}

#[test]
fn the_library_reads_a_scene_from_text() {
    let scene = from_json(SCENE).expect("a scene");
    assert_eq!((scene.name.as_str(), scene.objects.len()), ("scene", 1));
    assert!(scene.files.is_empty());
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.json");
    fs::write(&path, SCENE).expect("a file");
    let from_file = load(path.to_str().expect("UTF-8")).expect("a scene");
    assert_eq!(scene.hash, from_file.hash);
    assert_eq!(from_file.files.len(), 1);
    for (text, words) in [
        (
            SCENE.replace("\"radius\": 1", "\"radius\": 0"),
            "scene: objects[0].sphere.radius: 0",
        ),
        (SCENE[..100].to_owned(), "scene:2:"),
        (String::new(), "empty"),
        (
            SCENE.replace(r#""sphere""#, r#""obj""#).replace(
                r#""center": [0, 0, 0], "radius": 1"#,
                r#""file": "/etc/passwd""#,
            ),
            "leads out",
        ),
    ] {
        let error = from_json(&text).expect_err("no scene").to_string();
        assert!(error.contains(words), "{error}");
    }
}
