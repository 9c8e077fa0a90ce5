//! Warnings on standard error and as JSON, and the flags that hide or deny them.

use std::fs;

use raytree::scene;
use raytree::trace::Document;
use serde_json::Value;

use super::{Ran, run};

/// Runs a command on a scene that warns of two things: an angle in radians and a colour from 0 to 255.
fn ran(command: &[&str]) -> Ran {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("odd.json");
    let text = r#"{"format": "raytree-scene/1", "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0], "vertical_fov": 0.7854},
"materials": {"red": {"diffuse": [204, 26, 26]}},
"lights": [{"point": {"name": "lamp", "position": [3, 4, 5], "intensity": [1, 1, 1]}}],
"objects": [{"sphere": {"name": "ball", "material": "red", "center": [0, 0, 0], "radius": 1}}]}"#;
    fs::write(&path, text).expect("a file");
    let path = path.to_str().expect("UTF-8");
    let picture = folder.path().join("p.png");
    let picture = picture.to_str().expect("UTF-8");
    let named = |word: &&str| match *word {
        "SCENE" => path.to_owned(),
        "PICTURE" => picture.to_owned(),
        word => word.to_owned(),
    };
    let words: Vec<String> = command.iter().map(named).collect();
    let mut ran = run(&words.iter().map(String::as_str).collect::<Vec<_>>());
    ran.err = ran.err.replace(path, "odd.json");
    // That it was drawn is told by the first letter of its file.
    if fs::read(picture).is_ok_and(|bytes| bytes.starts_with(b"\x89PNG")) {
        ran.out.extend_from_slice(b"\ndrawn");
    }
    ran
}

/// All commands that take a scene, each as quick as it can be.
const COMMANDS: [&[&str]; 4] = [
    &["render", "SCENE", "--size", "8x6", "-o", "PICTURE"],
    &["trace", "SCENE", "--size", "8x6", "--pixel", "4,3"],
    &["effects", "SCENE"],
    &[
        "cost",
        "SCENE",
        "--size",
        "8x6",
        "--most",
        "1",
        "--reference-samples",
        "2",
        "--runs",
        "1",
        "--knob",
        "pixel-samples",
    ],
];

#[test]
fn every_command_tells_warnings_and_hides_or_denies_them() {
    for command in COMMANDS {
        let told = ran(command);
        assert_eq!(told.code, 0, "{command:?}: {}", told.err);
        for words in [
            "warning: odd.json: materials.red.diffuse: ",
            "[share-above-one]",
            "warning: odd.json: camera.vertical_fov: ",
            "[angle-in-radians]\n  write it in degrees: 45",
        ] {
            assert!(told.err.contains(words), "{command:?}: {}", told.err);
        }
        let quiet = ran(&[command, &["--quiet"]].concat());
        assert_eq!((quiet.code, quiet.err.as_str()), (0, ""), "{command:?}");
        assert!(!quiet.out.is_empty());
        let denied = ran(&[command, &["--deny-warnings"]].concat());
        assert_eq!(denied.code, 1, "{command:?}");
        assert!(denied.out.is_empty(), "{command:?}: no work is done");
        assert!(
            denied.err.starts_with(&told.err),
            "{command:?}: {}",
            denied.err
        );
        assert!(
            denied.err.contains("error: odd.json: there are 2 warnings"),
            "{}",
            denied.err
        );
        let both = ran(&[command, &["-q", "--deny-warnings"]].concat());
        assert_eq!(both.code, 1);
        assert!(both.err.starts_with("error: "), "{}", both.err);
    }
}

#[test]
fn a_scene_without_warnings_is_allowed() {
    let strict = run(&["render", "whitted", "--size", "8x6", "--deny-warnings"]);
    assert_eq!((strict.code, strict.err.as_str()), (0, ""));
    let noted = [
        "render",
        "whitted",
        "--size",
        "8x6",
        "--without",
        "refraction",
    ];
    assert!(run(&noted).err.starts_with("note: "));
    let quiet = run(&[&noted[..], &["--quiet", "--deny-warnings"]].concat());
    assert_eq!((quiet.code, quiet.err.as_str()), (0, ""));
}

#[test]
fn warnings_are_in_json_with_code_place_and_cure() {
    let codes = |command: &[&str]| -> Vec<Value> {
        let ran = ran(command);
        let out = String::from_utf8(ran.out)
            .expect("UTF-8")
            .replace("\ndrawn", "");
        let json: Value = serde_json::from_str(&out).expect("JSON");
        let list = json["warnings"].as_array().expect("warnings").clone();
        for warning in &list {
            for key in ["code", "file", "field", "message", "cure"] {
                assert!(
                    warning[key].as_str().is_some_and(|s| !s.is_empty()),
                    "{key}: {warning}"
                );
            }
            assert_eq!(warning["count"], 1);
        }
        list.into_iter().map(|mut w| w["code"].take()).collect()
    };
    for (command, more) in [
        (COMMANDS[0], &["--stats", "--json"][..]),
        (COMMANDS[1], &[]),
        (COMMANDS[2], &["--json"]),
        (COMMANDS[3], &["--json"]),
    ] {
        let found = codes(&[command, more].concat());
        assert_eq!(
            found,
            ["share-above-one", "angle-in-radians"],
            "{command:?}"
        );
    }
}

#[test]
fn a_tree_keeps_its_warnings_and_says_nothing_of_none() {
    let ran = ran(COMMANDS[1]);
    let document: Document = serde_json::from_slice(&ran.out).expect("a tree");
    assert_eq!(document.warnings.len(), 2);
    assert_eq!(document.warnings[0].code, scene::WarningCode::ShareAboveOne);
    let again = serde_json::to_vec(&document).expect("writable");
    assert_eq!(
        serde_json::from_slice::<Document>(&again).expect("JSON"),
        document
    );
    let plain = run(&["trace", "triangle", "--size", "8x6", "--pixel", "4,3"]);
    let plain: Value = serde_json::from_slice(&plain.out).expect("JSON");
    assert_eq!(plain.get("warnings"), None);
}
