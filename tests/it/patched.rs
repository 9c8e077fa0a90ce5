//! The finder on mistakes that share no code with our bends: the Python tracer of `lessons/solutions` with one line changed.

use std::fs;
use std::path::Path;
use std::process::Command;

use raytree::grade::report::Marked;
use raytree::grade::submission::{Submission, SubmittedFile};
use raytree::grade::task::{Check, CheckKind, Task};
use raytree::scene::{Bend, Scene, flat};
use raytree::tracer::thread_pool;

use super::flat::lesson;
use super::hello::is_found;
use super::solutions::{patched, source};

/// The three tasks without their pictures, which the Python tracer does not draw.
fn tasks() -> Vec<Task> {
    let load = |name: &str| {
        let path = lesson(&format!("tasks/{name}.toml"));
        let path = path.to_str().expect("UTF-8").to_owned();
        let mut task = thread_pool::install(0, || Task::load(&path)).expect("a task");
        let is_picture = |check: &Check| matches!(check.kind, CheckKind::Picture { .. });
        task.checks.retain(|check| !is_picture(check));
        task
    };
    ["hits", "light", "glass"].map(load).into()
}

/// What the program with this text hands in for a task.
fn handed_in(task: &Task, text: &str, folder: &Path) -> Submission {
    let write = |name: &str, text: &[u8]| {
        let path = folder.join(name);
        fs::write(&path, text).expect("written");
        path
    };
    let mut submission = Submission {
        name: "student".to_owned(),
        ..Submission::default()
    };
    for (index, scene) in task.scenes.iter().enumerate() {
        let checks = task.checks.iter().filter(|check| check.scene == index);
        let pixels = checks.flat_map(|check| match &check.kind {
            CheckKind::Trees { pixels, .. } => pixels.iter().filter_map(|p| p.pixel).collect(),
            _ => Vec::new(),
        });
        let mut pixels: Vec<String> = pixels.map(|(x, y)| format!("{x} {y}\n")).collect();
        pixels.sort();
        pixels.dedup();
        let with_settings = Scene {
            settings: scene.settings,
            ..scene.world.scene.clone()
        };
        let mut json = Vec::new();
        flat::write_json(&mut json, &with_settings).expect("a buffer takes everything");
        let ran = Command::new("python3")
            .arg(write("tracer.py", text.as_bytes()))
            .arg(write("scene.json", &json))
            .args(["320", "240"])
            .arg(write("pixels", pixels.concat().as_bytes()))
            .output()
            .expect("runs");
        assert!(ran.status.success(), "{}", scene.label);
        let stem = scene.label.trim_end_matches(".json");
        submission.files.push(SubmittedFile {
            name: format!("{stem}.ndjson"),
            bytes: ran.stdout,
        });
    }
    submission
}

fn marked(task: &Task, text: &str, folder: &Path) -> Marked {
    Marked::new(std::slice::from_ref(task), handed_in(task, text, folder))
}

#[test]
fn the_right_solution_earns_all_points_in_every_task() {
    if !is_found("python3", true) {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    for task in tasks() {
        let marked = marked(&task, &source(), folder.path());
        assert_eq!(marked.score(), marked.most(), "{}: {:?}", task.name, marked);
    }
}

/// Each patch is the mistake of a bend of the same name. It is named, or is one of two that are named, in a task at least; and in no
/// task another mistake is named.
#[test]
fn patched_solutions_are_named_and_never_wrongly() {
    if !is_found("python3", true) {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let tasks = tasks();
    let mut table = Vec::new();
    let (mut all, mut named) = (0, 0);
    for entry in fs::read_dir(lesson("solutions/python/patches")).expect("a folder") {
        let path = entry.expect("readable").path();
        let name = path.file_stem().and_then(|s| s.to_str()).expect("UTF-8");
        let bend: Bend = name.parse().expect("a bend of this name");
        let broken = patched(&fs::read_to_string(&path).expect("there"), name);
        let mut is_named = false;
        for task in &tasks {
            let marked = marked(task, &broken, folder.path());
            if marked.score() == marked.most() {
                continue;
            }
            let candidates = marked.diagnosis.map(|found| found.candidates);
            let candidates = candidates.unwrap_or_default();
            let names: Vec<String> = candidates.iter().map(ToString::to_string).collect();
            table.push(format!("{name} in {}: {names:?}", task.name));
            let is_there = candidates.iter().any(|bends| bends.has(bend));
            assert!(is_there || names.is_empty(), "{}", table.join("\n"));
            is_named |= is_there && names.len() <= 2;
        }
        all += 1;
        named += u32::from(is_named);
    }
    println!("{}", table.join("\n"));
    assert_eq!(all, 18);
    assert!(
        12 * named >= 11 * all,
        "{named} of {all}:\n{}",
        table.join("\n")
    );
}
