//! Characters that cannot be seen, or that turn others around: shown by their numbers wherever people read.

use std::fs;

use raytree::scene::printable::is_printable;
use serde_json::Value;

use super::{raytree, run};

/// Bidi overrides and isolates, an escape sequence's beginning, zero width, and a space that is none.
const ODD: [char; 7] = [
    '\u{202e}',
    '\u{2066}',
    '\u{200b}',
    '\u{feff}',
    '\u{a0}',
    '\u{e0041}',
    '\u{ad}',
];

/// A scene whose every name has a character in it.
fn scene(odd: char) -> String {
    format!(
        r#"{{"format": "raytree-scene/1", "name": "scene {odd}", "camera": {{"eye": [0, 0, 4], "look_at": [0, 0, 0]}},
  "materials": {{"glass {odd}": {{"diffuse": [1, 1, 1], "specular": [1, 1, 1], "transmission": [1, 1, 1], "ior": 1.5}}}},
  "lights": [{{"point": {{"name": "lamp {odd}", "position": [0, 0, 9], "intensity": [1, 1, 1]}}}}],
  "objects": [{{"sphere": {{"name": "ball {odd}", "material": "glass {odd}", "center": [0, 0, 0], "radius": 1}}}}]}}"#
    )
}

fn all_seen(what: &str, text: &[u8]) {
    let text = std::str::from_utf8(text).expect("UTF-8");
    let odd = text.chars().find(|c| *c != '\n' && !is_printable(*c));
    assert_eq!(odd, None, "{what}: {}", text.escape_debug());
}

#[test]
fn names_are_shown_with_numbers_for_what_cannot_be_seen() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.json");
    let file = path.to_str().expect("UTF-8");
    let plot = folder.path().join("a.svg");
    for odd in ODD {
        fs::write(&path, scene(odd)).expect("a file");
        let number = format!("\\u{{{:x}}}", odd as u32);
        for format in ["text", "html", "dot", "svg"] {
            let ran = run(&[
                "trace", file, "--size", "9x9", "--pixel", "4,4", "--format", format,
            ]);
            assert_eq!(ran.code, 0, "{}", ran.err);
            all_seen(format, &ran.out);
            let text = String::from_utf8(ran.out).expect("UTF-8");
            let number = if format == "dot" {
                number.replace('\\', "\\\\")
            } else {
                number.clone()
            };
            for name in ["scene", "lamp", "ball"] {
                assert!(
                    text.contains(&format!("{name} {number}")),
                    "{format}, {name}: {text}"
                );
            }
        }
        let ran = run(&["effects", file]);
        all_seen("effects", &ran.out);
        let ran = run(&["effects", file, "--json"]);
        all_seen("effects as JSON", &ran.out);
        let cost = [
            "cost", file, "--budget", "1", "--most", "1", "--runs", "1", "--knob", "depth",
            "--size", "4x3",
        ];
        let ran = run(&[&cost[..], &["--plot", plot.to_str().expect("UTF-8")]].concat());
        all_seen("cost", &ran.out);
        all_seen("plot", &fs::read(&plot).expect("written"));
        // In JSON it is the name itself, lossless, in letters that do no harm.
        let ran = run(&["trace", file, "--size", "9x9", "--pixel", "4,4"]);
        all_seen("JSON", &ran.out);
        let tree: Value = serde_json::from_slice(&ran.out).expect("JSON");
        assert_eq!(tree["scene"]["name"], format!("scene {odd}"));
        assert_eq!(
            tree["samples"][0]["root"]["hit"]["object"],
            format!("ball {odd}")
        );
        // Errors name materials and keys of the file.
        for (from, to) in [
            ("\"material\": \"glass", "\"material\": \"gloss"),
            ("\"radius\"", "\"radius X\""),
        ] {
            let wrong = scene(odd).replace(from, &to.replace('X', &odd.to_string()));
            fs::write(&path, wrong).expect("a file");
            let ran = run(&["render", file]);
            assert_eq!(ran.code, 1);
            all_seen("error", ran.err.as_bytes());
            assert!(ran.err.contains(&number), "{}", ran.err);
        }
    }
}

#[test]
#[cfg(unix)]
fn paths_do_not_steer_a_terminal() {
    let folder = tempfile::tempdir().expect("a folder");
    let odd = "a\u{1b}]0;title\u{7}\u{202e}";
    let at = |name: &str| folder.path().join(name).display().to_string();
    let missing = at(&format!("{odd}/a.png"));
    let scene_file = at(&format!("{odd}.json"));
    fs::write(&scene_file, scene('x')).expect("a file");
    let read = at(&format!("{odd}.json"));
    for (args, code) in [
        (&["render", "triangle", "-o", &missing][..], 1),
        (&["render", &scene_file, "-o", &read], 2),
        (&["render", &at(&format!("{odd}.obj"))], 1),
        (&["render", &format!("no{odd}")], 1),
        (&["render", "triangle", "--size", odd], 2),
        (&["render", "triangle", "--samples", odd], 2),
        (&[odd], 2),
        (&["cost", "triangle", "--reference", &missing], 1),
        (&["cost", "triangle", "--knob", odd], 2),
        (&["trace", "triangle", "--pixel", odd], 2),
    ] {
        let ran = run(args);
        assert_eq!(ran.code, code, "{}", ran.err);
        assert!(ran.out.is_empty());
        all_seen("error", ran.err.as_bytes());
        // (The parser of command lines leaves out whole escape sequences.)
        assert!(ran.err.contains("\\u{202e}"), "{}", ran.err);
    }
    // A command to do it again can be typed as it is.
    let again = [
        "render",
        &scene_file,
        "--size",
        "4x3",
        "--until-error",
        "0.1",
        "-o",
        "/dev/null",
    ];
    let output = raytree(&again).output().expect("runs");
    let said = String::from_utf8(output.stderr).expect("UTF-8");
    all_seen("again", said.as_bytes());
    assert!(said.contains("\\x1b]0;title\\x07\\U0000202e"), "{said}");
}
