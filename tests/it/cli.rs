//! The command line as a user types it: what it prints, where, and with which exit status.

mod advice;
mod notices;
mod outputs;
mod results;
mod samples;
mod stability;
mod standard_input;
mod unseen;

use std::fs;

use assert_cmd::Command;
use serde_json::Value;

fn raytree(args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_raytree"));
    command
        .args(args)
        .env_remove("FORCE_COLOR")
        .env_remove("CLICOLOR_FORCE");
    command
}

pub struct Ran {
    pub code: i32,
    pub out: Vec<u8>,
    pub err: String,
}

pub fn run(args: &[&str]) -> Ran {
    let output = raytree(args).output().expect("runs");
    Ran {
        code: output.status.code().expect("ended by itself"),
        out: output.stdout,
        err: String::from_utf8(output.stderr).expect("UTF-8"),
    }
}

/// Fails with this status, nothing on stdout, and a message that has all these words and no trace of a panic.
pub fn refused(args: &[&str], code: i32, words: &[&str]) {
    let ran = run(args);
    assert_eq!(ran.code, code, "{args:?}: {}", ran.err);
    assert!(ran.out.is_empty(), "{args:?} writes to stdout");
    for word in words {
        assert!(
            ran.err.contains(word),
            "{args:?} says `{word}`:\n{}",
            ran.err
        );
    }
    assert!(!ran.err.contains("panicked"), "{}", ran.err);
}

#[test]
fn a_png_is_written_whole() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("picture.png");
    let ran = run(&[
        "render",
        "triangle",
        "--size",
        "40x30",
        "-o",
        file.to_str().expect("UTF-8"),
    ]);
    assert_eq!((ran.code, ran.err.as_str()), (0, ""));
    assert!(ran.out.is_empty());
    let picture = image::open(&file).expect("a PNG").to_rgb8();
    assert_eq!(picture.dimensions(), (40, 30));
    // It is the picture that the ray tree explains.
    let traced = run(&["trace", "triangle", "--size", "40x30", "--pixel", "20,15"]);
    let tree: Value = serde_json::from_slice(&traced.out).expect("JSON");
    let srgb = [0, 1, 2].map(|i| tree["color"]["srgb8"][i].as_u64().expect("a number") as u8);
    assert_eq!(picture.get_pixel(20, 15).0, srgb);
}

#[test]
fn a_piped_picture_is_plain_ascii() {
    let ran = run(&["render", "whitted"]);
    assert_eq!(ran.code, 0);
    let text = String::from_utf8(ran.out).expect("UTF-8");
    assert!(text.is_ascii() && !text.contains('\x1b'));
    let lines: Vec<&str> = text.lines().collect();
    assert!(lines.len() > 20 && lines.iter().all(|l| l.len() == 80));
    let kinds = text.chars().collect::<std::collections::BTreeSet<_>>();
    assert!(kinds.len() > 5, "a picture, not a blank: {kinds:?}");
    let forced = run(&["render", "whitted", "--size", "8x4", "--color", "truecolor"]);
    assert!(
        String::from_utf8(forced.out)
            .expect("UTF-8")
            .contains("\x1b[38;2;")
    );
}

#[test]
fn every_format_of_a_tree_is_written() {
    let base = [
        "trace", "whitted", "--size", "64x48", "--pixel", "30,20", "--format",
    ];
    let written = |format: &str| {
        let ran = run(&[&base[..], &[format]].concat());
        assert_eq!((ran.code, ran.err.as_str()), (0, ""), "{format}");
        String::from_utf8(ran.out).expect("UTF-8")
    };
    assert!(written("json").starts_with("{\n  \"format\": \"raytree/1\""));
    assert!(written("text").starts_with("whitted, pixel (30, 20) of 64 x 48"));
    assert!(written("dot").starts_with("digraph raytree {"));
    let svg = written("svg");
    assert!(svg.starts_with("<svg ") && svg.trim_end().ends_with("</svg>"));
    let page = written("html");
    assert!(page.starts_with("<!DOCTYPE html>") && page.trim_end().ends_with("</html>"));
    let deep = run(&[
        "trace",
        "room",
        "--size",
        "64x48",
        "--pixel",
        "30,20",
        "--traversal",
    ]);
    let tree: Value = serde_json::from_slice(&deep.out).expect("JSON");
    let steps = tree["samples"][0]["root"]["traversal"]
        .as_array()
        .expect("steps");
    assert!(
        steps.iter().any(|s| s.get("node").is_some()),
        "nodes were visited"
    );
    assert!(steps.iter().any(|s| s["result"] == "hit"), "a test hit");
}

#[test]
fn counters_do_not_depend_on_the_machine() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("p.png");
    let file = file.to_str().expect("UTF-8");
    let stats = |threads: &str| -> Value {
        let ran = run(&[
            "render",
            "whitted",
            "--size",
            "40x30",
            "-o",
            file,
            "--stats",
            "--json",
            "--threads",
            threads,
        ]);
        let mut stats: Value = serde_json::from_slice(&ran.out).expect("JSON");
        stats["seconds"].take();
        stats
    };
    assert_eq!(stats("1"), stats("3"));
    assert_eq!(stats("1")["rays"]["I"], 1200);
    let told = run(&[
        "render", "whitted", "--size", "40x30", "-o", file, "--stats",
    ]);
    assert!(told.err.contains("rays") && told.err.contains("tests"));
}

#[test]
fn lists_and_schemas_are_printed() {
    let scenes = String::from_utf8(run(&["scenes"]).out).expect("UTF-8");
    for name in [
        "whitted",
        "triangle",
        "mirrors",
        "glass-block",
        "nested-glass",
        "shadows",
        "room",
        "teapot",
        "bunny",
    ] {
        assert!(
            scenes.lines().any(|l| l.starts_with(name)),
            "{name} in\n{scenes}"
        );
    }
    for format in ["scene", "tree", "flat"] {
        let schema: Value = serde_json::from_slice(&run(&["schema", format]).out).expect("JSON");
        assert!(schema["$schema"].is_string());
    }
    let script = run(&["completions", "bash"]);
    assert!(
        String::from_utf8(script.out)
            .expect("UTF-8")
            .contains("raytree")
    );
}

#[test]
fn effects_are_listed_and_what_is_left_out_is_said() {
    let ran = run(&["effects", "soft-shadow"]);
    assert_eq!(ran.code, 0);
    let text = String::from_utf8(ran.out).expect("UTF-8");
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[1], "soft-shadows  on   light `lamp` has an area");
    assert_eq!(
        lines[4],
        "refraction    off  no material has a transmission coefficient"
    );
    let json = run(&["effects", "glass-block", "--json"]).out;
    let json: serde_json::Value = serde_json::from_slice(&json).expect("JSON");
    assert_eq!(json["effects"][4]["effect"], "refraction");
    assert_eq!(json["effects"][4]["on"], true);
    let whole = run(&["render", "whitted", "--size", "8x6"]);
    assert_eq!(whole.err, "");
    let part = run(&[
        "render",
        "whitted",
        "--size",
        "8x6",
        "--without",
        "refraction,soft-shadows",
    ]);
    assert_eq!(part.err, "note: refraction is left out: no T rays\n");
    refused(
        &["render", "whitted", "--without", "gravity"],
        2,
        &["refraction"],
    );
}

#[test]
fn a_wrong_command_line_is_status_2() {
    refused(
        &["render", "whitted", "--size", "0x0"],
        2,
        &["--size", "no pixels"],
    );
    refused(
        &["render", "whitted", "--size", "1000000x1000000"],
        2,
        &["--size", "16384"],
    );
    refused(&["render", "whitted", "--size", "big"], 2, &["320x240"]);
    refused(
        &["render", "whitted", "--min-weight", "NaN"],
        2,
        &["--min-weight"],
    );
    refused(&["render", "whitted", "--samples", "0"], 2, &["--samples"]);
    refused(&["trace", "whitted", "--pixel", "middle"], 2, &["160,120"]);
    refused(
        &["trace", "whitted", "--pixel", "320,0"],
        2,
        &["320,0", "320x240", "319,239"],
    );
    refused(&["trace", "whitted"], 2, &["--pixel"]);
    refused(&["paint", "whitted"], 2, &["paint"]);
}

#[test]
fn a_wrong_scene_is_status_1() {
    refused(&["render", "whited"], 1, &["whited", "whitted"]);
    refused(
        &["render", "no/such/scene.json"],
        1,
        &["no/such/scene.json"],
    );
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("broken.json");
    fs::write(&file, "{ \"format\": \"raytree-scene/1\",\n  \"camera\": {").expect("writable");
    refused(
        &["trace", file.to_str().expect("UTF-8"), "--pixel", "0,0"],
        1,
        &["broken.json", ":2:"],
    );
}

#[test]
fn what_cannot_be_written_is_status_1_and_leaves_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let missing = folder.path().join("no-such-folder/p.png");
    refused(
        &[
            "render",
            "triangle",
            "--size",
            "8x6",
            "-o",
            missing.to_str().expect("UTF-8"),
        ],
        1,
        &["no-such-folder", "cannot be written"],
    );
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 0);
}

#[test]
fn a_pfm_holds_the_radiance_that_trace_tells() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("picture.PFM");
    let name = file.to_str().expect("UTF-8");
    // The exposure is for screens: radiance does not know it.
    let exposed = ["whitted", "--size", "9x7", "--exposure", "0.25"];
    let ran = run(&[&["render", "-o", name], &exposed[..]].concat());
    assert_eq!((ran.code, ran.err.as_str()), (0, ""));
    let bytes = fs::read(&file).expect("written");
    let floats = bytes.strip_prefix(b"PF\n9 7\n-1.0\n").expect("a header");
    assert_eq!(floats.len(), 9 * 7 * 12);
    for (x, y) in [(0, 0), (4, 3), (8, 6), (2, 5)] {
        let pixel = format!("{x},{y}");
        let traced = run(&[&["trace", "--pixel", &pixel], &exposed[..]].concat());
        let traced: Value = serde_json::from_slice(&traced.out).expect("JSON");
        for channel in 0..3 {
            let at = ((6 - y) * 9 + x) * 12 + channel * 4;
            let got = f32::from_le_bytes(floats[at..at + 4].try_into().expect("4 bytes"));
            let linear = traced["color"]["linear"][channel]
                .as_f64()
                .expect("a number");
            assert_eq!(got, linear as f32, "pixel {pixel}");
        }
    }
}

/// A file keeps its old contents until the new ones are complete.
#[test]
fn a_failed_command_does_not_touch_the_old_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("old.json");
    fs::write(&file, "precious").expect("writable");
    let name = file.to_str().expect("UTF-8");
    refused(
        &["trace", "whitted", "--pixel", "999,0", "-o", name],
        2,
        &["outside"],
    );
    assert_eq!(fs::read_to_string(&file).expect("still there"), "precious");
    let names: Vec<_> = fs::read_dir(folder.path()).expect("a folder").collect();
    assert_eq!(names.len(), 1, "no temporary file is left");
}

/// The eye inside a mirror ball: rays that never end by themselves.
const MIRROR_BALL: &str = r#"{ "format": "raytree-scene/1",
  "camera": { "eye": [0, 0, 0.5], "look_at": [0, 0.1, 0] },
  "materials": { "mirror": { "mirror": [0.99, 0.99, 0.99], "ambient": [0.1, 0.1, 0.1] } },
  "ambient": [1, 1, 1],
  "objects": [ { "sphere": { "name": "ball", "material": "mirror", "center": [0, 0, 0], "radius": 1 } } ] }"#;

#[test]
fn endless_depth_is_bounded_and_status_3_keeps_the_picture() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = folder.path().join("ball.json");
    fs::write(&scene, MIRROR_BALL).expect("writable");
    let scene = scene.to_str().expect("UTF-8");
    let file = folder.path().join("deep.png");
    let picture = file.to_str().expect("UTF-8");
    let endless = [
        "--size",
        "16x12",
        "--depth",
        "1000000000",
        "--min-weight",
        "0",
    ];
    // By the deepest recursion, and by the ray budget: 10 rays a pixel.
    for (budget, reason) in [("1000000000", "depth limit"), ("1920", "rays are used up")] {
        let limits = [&endless[..], &["--max-rays", budget]].concat();
        let ran = run(&[&["render", scene, "-o", picture], &limits[..]].concat());
        assert_eq!(ran.code, 3, "{}", ran.err);
        assert!(ran.err.contains("stopped at a limit"), "{}", ran.err);
        assert_eq!(
            image::open(&file).expect("kept").to_rgb8().dimensions(),
            (16, 12)
        );
        // The same pixel alone is cut at the same place, and says so.
        let pixel = ["trace", scene, "--pixel", "8,6", "--format", "text"];
        let traced = run(&[&pixel[..], &limits[..]].concat());
        assert_eq!(traced.code, 3, "{}", traced.err);
        assert!(String::from_utf8_lossy(&traced.out).contains(reason));
    }
}

#[test]
fn a_closed_pipe_is_no_error() {
    let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_raytree"))
        .args(["trace", "whitted", "--pixel", "100,120", "--traversal"])
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .expect("runs");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("ends");
    assert!(output.status.success());
    assert!(output.stderr.is_empty());
}

#[test]
fn the_debugger_without_a_terminal_says_what_to_do_instead() {
    for args in [&[][..], &["view", "whitted"][..]] {
        refused(args, 1, &["terminal", "raytree trace"]);
    }
}
