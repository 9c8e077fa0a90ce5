//! The record hooks in `lessons/hello/hooks`: what a tracer records by them is read, agrees with the library where the tracer is right,
//! and shows where it is wrong.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use raytree::grade::pixel_tree;
use raytree::probe::RayKind;
use raytree::trace::facts::FactName;

use super::flat::lesson;
use super::hello::is_found;

/// Pixels of 320x240: the background, both balls, the floor, shadows, and mirrors in mirrors.
const PIXELS: [(u32, u32); 8] = [
    (160, 130),
    (40, 200),
    (60, 150),
    (100, 150),
    (260, 200),
    (100, 20),
    (230, 190),
    (120, 190),
];

fn hook(name: &str) -> PathBuf {
    lesson("hello/hooks").join(name)
}

/// Runs a program for a pixel, which records into a file.
fn record(command: &[String], (x, y): (u32, u32), file: &Path) {
    let ran = Command::new(&command[0])
        .args(&command[1..])
        .args([x, y, 320, 240].map(|n| n.to_string()))
        .env("RAYTREE_RECORD", file)
        .env("RAYTREE_PIXEL", format!("{x},{y}"))
        .output()
        .expect("runs");
    let said = String::from_utf8_lossy(&ran.stderr);
    assert!(
        ran.status.success() && said.is_empty(),
        "{command:?}: {said}"
    );
}

/// What `raytree diff` says of a record, and whether it agrees.
fn diff((x, y): (u32, u32), file: &Path) -> (bool, String) {
    let scene = hook("example.json");
    let ran = Command::new(env!("CARGO_BIN_EXE_raytree"))
        .arg("diff")
        .arg(format!("{}@{x},{y}", scene.display()))
        .arg(file)
        .args(["--size", "320x240"])
        .output()
        .expect("runs");
    let told = String::from_utf8_lossy(&ran.stdout).into_owned();
    (ran.status.success(), told)
}

/// A program with the hook in it agrees with the library, and records nothing if nobody asks for it.
fn check(command: &[String], folder: &Path) {
    let file = folder.join("rays.json");
    let mut blocked = 0;
    for pixel in PIXELS {
        record(command, pixel, &file);
        let (agrees, told) = diff(pixel, &file);
        assert!(
            agrees && !told.contains("not told"),
            "{command:?} {pixel:?}: {told}"
        );
        let text = fs::read_to_string(&file).expect("written");
        blocked += text.matches("blocked").count();
    }
    assert!(blocked > 1, "{blocked}");
    fs::remove_file(&file).expect("there");
    let words = ["160", "130", "320", "240"];
    let quiet = Command::new(&command[0])
        .args(&command[1..])
        .args(words)
        .current_dir(folder)
        .status();
    assert!(quiet.expect("runs").success() && !file.exists());
    let other = Command::new(&command[0])
        .args(&command[1..])
        .args(words)
        .env("RAYTREE_RECORD", &file)
        .env("RAYTREE_PIXEL", "1,2")
        .status();
    let recorded = fs::read_to_string(&file).unwrap_or_default();
    assert!(
        other.expect("runs").success() && recorded.is_empty(),
        "{recorded}"
    );
}

fn text(path: &Path) -> String {
    path.to_str().expect("UTF-8").to_owned()
}

#[test]
fn a_tracer_in_python_records_our_trees() {
    if is_found("python3", true) {
        let folder = tempfile::tempdir().expect("a folder");
        check(
            &["python3".to_owned(), text(&hook("example.py"))],
            folder.path(),
        );
    }
}

/// The same program with a mistake: the first thing that differs is told, where the mistake is.
#[test]
fn a_mistake_is_found_in_a_record() {
    if !is_found("python3", true) {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    fs::copy(
        hook("raytree_hook.py"),
        folder.path().join("raytree_hook.py"),
    )
    .expect("copied");
    let program = fs::read_to_string(hook("example.py")).expect("there");
    for (right, wrong, told) in [
        (
            "axpy(-2 * dot(n, d), n, d)",
            "axpy(-1 * dot(n, d), n, d)",
            "reflect-no-2",
        ),
        ("[k * dot(n, l) for k", "[k for k", "diffuse"),
    ] {
        assert_eq!(program.matches(right).count(), 1, "{right}");
        let path = folder.path().join("wrong.py");
        fs::write(&path, program.replace(right, wrong)).expect("written");
        let file = folder.path().join("rays.json");
        let command = ["python3".to_owned(), text(&path)];
        let said: Vec<String> = PIXELS
            .into_iter()
            .filter_map(|pixel| {
                record(&command, pixel, &file);
                let (agrees, said) = diff(pixel, &file);
                (!agrees).then_some(said)
            })
            .collect();
        assert!(
            said.iter().any(|said| said.contains(told)),
            "{told}: {said:?}"
        );
    }
}

fn compiled(compiler: &str, words: &[&str]) {
    let folder = tempfile::tempdir().expect("a folder");
    let program = folder.path().join("example");
    let ran = Command::new(compiler)
        .args(["-Wall", "-Wextra", "-Werror", "-O1"])
        .args(words)
        .arg(hook("example.c"))
        .args(["-lm", "-o"])
        .arg(&program)
        .output()
        .expect("runs");
    let said = String::from_utf8_lossy(&ran.stderr);
    assert!(ran.status.success(), "{said}");
    check(&[text(&program)], folder.path());
}

#[test]
fn a_tracer_in_c_records_our_trees() {
    if is_found("cc", true) {
        compiled("cc", &[]);
    }
}

#[test]
fn a_tracer_in_cpp_records_our_trees() {
    if is_found("c++", false) {
        compiled("c++", &["-x", "c++", "-std=c++17"]);
    }
}

/// Two pixels in one file, with all that can be told, as far as the hook for JavaScript has it.
#[test]
fn javascript_records_trees_of_several_pixels() {
    if !is_found("node", false) {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("rays.json");
    let script = r#"
        const h = require(process.argv[1]);
        for (const x of [3, 4]) {
            h.pixelBegin(x, 7);
            h.rayBegin("I", [0, 1, 4], [0, 0, -1]);
            h.hit(2.5, "a \"ball\"", [0, 1, 1.5], [0, 0, 1]);
            h.term("ambient", [0.1, 0.2, 0.3]);
            h.rayBegin("L", [0, 1, 1.5], [0, 1, 0], "lamp");
            h.hit(1, "shade");
            h.rayEnd();
            h.rayBegin("R", [0, 1, 1.5], [0, 0, 1], null, [0.5, 0.5, 0.5]);
            h.rayEnd([1, 1, x]);
            h.rayEnd([0.6, 0.7, 0.8]);
            h.pixelEnd([0.6, 0.7, 0.8]);
        }"#;
    let ran = Command::new("node")
        .args(["-e", script])
        .arg(hook("raytree_hook.js"))
        .env("RAYTREE_RECORD", &file)
        .output()
        .expect("runs");
    let said = String::from_utf8_lossy(&ran.stderr);
    assert!(ran.status.success(), "{said}");
    for x in [3, 4] {
        let tree = pixel_tree::in_file(&text(&file), Some((x, 7))).expect("a tree");
        assert!(tree.problems.is_empty(), "{:?}", tree.problems);
        let ray = |kind| {
            tree.rays
                .iter()
                .find(|ray| ray.kind == kind)
                .expect("a ray")
        };
        let (eye, shadow, mirrored) = (
            ray(RayKind::Incident),
            ray(RayKind::Light),
            ray(RayKind::Reflected),
        );
        assert_eq!(tree.rays.len(), 3);
        assert_eq!(eye.word(&FactName::Object), Some("a \"ball\""));
        assert_eq!(eye.number(&FactName::T), Some(2.5));
        assert_eq!(shadow.word(&FactName::Outcome), Some("blocked"));
        assert_eq!(mirrored.word(&FactName::Outcome), Some("miss"));
        let radiance = mirrored.color(&FactName::Radiance).expect("told");
        assert_eq!(radiance.channels(), [1.0, 1.0, f64::from(x)]);
    }
}

#[test]
fn each_hook_is_short_and_in_the_book() {
    let book = fs::read_to_string(format!(
        "{}/book/src/handing-in.md",
        env!("CARGO_MANIFEST_DIR")
    ));
    let book = book.expect("there");
    for name in ["raytree_hook.py", "raytree_hook.h", "raytree_hook.js"] {
        let lines = fs::read_to_string(hook(name))
            .expect("there")
            .lines()
            .count();
        assert!(lines < 60, "{name} has {lines} lines");
        assert!(book.contains(name), "{name} is not in the book");
    }
}
