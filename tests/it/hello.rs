//! The programs in `lessons/hello` agree with the library on the rays of two scenes.

use std::fs;
use std::path::Path;
use std::process::Command;

use raytree::accel::AccelKind;
use raytree::scene::{Scene, flat, load};
use raytree::world::World;
use serde_json::Value;

use super::flat::{lesson, task, traced};

const SIZE: (u32, u32) = (320, 240);

/// A scene with its flat files.
struct Exercise {
    world: World,
    json: String,
    text: String,
}

impl Exercise {
    fn new(scene: Scene, folder: &Path) -> Self {
        let path = |ending: &str| {
            let path = folder.join(format!("{}.{ending}", scene.name));
            path.to_str().expect("UTF-8").to_owned()
        };
        let (mut json, mut text) = (Vec::new(), Vec::new());
        flat::write_json(&mut json, &scene).expect("a buffer takes everything");
        flat::write_text(&mut text, &scene).expect("a buffer takes everything");
        let exercise = (path("json"), path("txt"));
        fs::write(&exercise.0, json).expect("written");
        fs::write(&exercise.1, text).expect("written");
        Self {
            world: World::new(scene, AccelKind::default()),
            json: exercise.0,
            text: exercise.1,
        }
    }
}

/// True if there is such a program; in CI it must be there if it `is_needed`.
pub fn is_found(program: &str, is_needed: bool) -> bool {
    let found = Command::new(program).arg("--version").output().is_ok();
    let ci = std::env::var("CI").is_ok_and(|ci| ci == "true");
    assert!(found || !(ci && is_needed), "{program} is not installed");
    found
}

/// The words of `command` before the scene, x, y, width and height print the trees that the library finds.
fn check(command: &[&str], takes_text: bool, folder: &Path) {
    let triangle = load("triangle").expect("built in");
    let mut outcomes = [0; 2];
    for exercise in [triangle, task("hits")].map(|scene| Exercise::new(scene, folder)) {
        let file = if takes_text {
            &exercise.text
        } else {
            &exercise.json
        };
        for pixel in [
            (160, 120),
            (75, 150),
            (200, 130),
            (3, 5),
            (188, 95),
            (105, 165),
            (160, 200),
        ] {
            let place = [pixel.0, pixel.1, SIZE.0, SIZE.1].map(|n: u32| n.to_string());
            let ran = Command::new(command[0])
                .args(&command[1..])
                .arg(file)
                .args(&place)
                .output()
                .expect("runs");
            let said = String::from_utf8_lossy(&ran.stderr);
            assert!(
                ran.status.success() && said.is_empty(),
                "{command:?}: {said}"
            );
            let printed: Value = serde_json::from_slice(&ran.stdout).expect("JSON");
            outcomes[usize::from(same(&printed, &exercise.world, pixel))] += 1;
        }
    }
    assert!(outcomes[0] > 1 && outcomes[1] > 5, "{outcomes:?}");
}

/// Whether the ray hits anything, in which it agrees with the library as in all else.
#[track_caller]
fn same(printed: &Value, world: &World, pixel: (u32, u32)) -> bool {
    let document = traced(world, pixel, SIZE);
    let root = document.samples[0].root.as_ref().expect("a tree");
    let about = format!("{pixel:?}: {printed}");
    assert_eq!(printed["pixel"]["x"], pixel.0, "{about}");
    assert_eq!(printed["pixel"]["y"], pixel.1, "{about}");
    let near = |value: &Value, expected: [f64; 3]| {
        let close = |i: usize| (value[i].as_f64().expect("a number") - expected[i]).abs() < 1e-12;
        assert!((0..3).all(close), "{value} is not {expected:?} in {about}");
    };
    let ray = &printed["root"];
    assert_eq!(ray["kind"], "I");
    near(&ray["origin"], root.origin);
    near(&ray["direction"], root.direction);
    let Some(hit) = &root.hit else {
        assert!(ray["outcome"] == "miss" && ray["hit"].is_null(), "{about}");
        return false;
    };
    assert_eq!(ray["outcome"], "hit", "{about}");
    assert_eq!(ray["hit"]["object"], hit.object.as_str(), "{about}");
    let t = ray["hit"]["t"].as_f64().expect("a number");
    assert!((t - hit.t).abs() < 1e-12 * hit.t.max(1.0), "{t}, {}", hit.t);
    near(&ray["hit"]["point"], hit.point);
    near(&ray["hit"]["geometric_normal"], hit.geometric_normal);
    true
}

/// The path of a program in `lessons/hello`.
fn source(name: &str) -> String {
    let path = lesson("hello").join(name);
    path.to_str().expect("UTF-8").to_owned()
}

#[test]
fn python_finds_what_the_library_finds() {
    if is_found("python3", true) {
        let folder = tempfile::tempdir().expect("a folder");
        check(&["python3", &source("hello.py")], false, folder.path());
    }
}

#[test]
fn javascript_finds_what_the_library_finds() {
    if is_found("node", false) {
        let folder = tempfile::tempdir().expect("a folder");
        check(&["node", &source("hello.js")], false, folder.path());
    }
}

#[test]
fn c_finds_what_the_library_finds() {
    if is_found("cc", true) {
        compiled(
            "cc",
            &[
                "-Wall",
                "-Wextra",
                "-Werror",
                "-O1",
                &source("hello.c"),
                "-lm",
            ],
        );
    }
}

#[test]
fn cpp_finds_what_the_library_finds() {
    if is_found("c++", false) {
        compiled(
            "c++",
            &[
                "-std=c++17",
                "-Wall",
                "-Wextra",
                "-Werror",
                &source("hello.cpp"),
            ],
        );
    }
}

/// Compiles a program and checks it.
fn compiled(compiler: &str, words: &[&str]) {
    let folder = tempfile::tempdir().expect("a folder");
    let program = folder.path().join("hello");
    let ran = Command::new(compiler)
        .args(words)
        .arg("-o")
        .arg(&program)
        .output()
        .expect("runs");
    let said = String::from_utf8_lossy(&ran.stderr);
    assert!(ran.status.success(), "{said}");
    check(&[program.to_str().expect("UTF-8")], true, folder.path());
}

#[test]
fn each_program_is_short() {
    for name in ["hello.py", "hello.c", "hello.cpp", "hello.js"] {
        let lines = fs::read_to_string(source(name))
            .expect("there")
            .lines()
            .count();
        assert!(lines < 60, "{name} has {lines} lines");
    }
}
