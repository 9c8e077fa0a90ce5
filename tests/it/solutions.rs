//! The ray tracer in `lessons/solutions/python` has the ray trees of the library, and each patch breaks it.

use std::fs;
use std::path::Path;
use std::process::Command;

use raytree::accel::AccelKind;
use raytree::scene::flat;
use raytree::trace::{Document, View, document, trace_pixel};
use raytree::world::World;
use serde_json::Value;

use super::flat::{lesson, task};
use super::hello::is_found;

const SIZE: (u32, u32) = (320, 240);

/// Every 16th pixel of every 16th row.
fn pixels() -> impl Iterator<Item = (u32, u32)> {
    (0..15).flat_map(|y| (0..20).map(move |x| (4 + 16 * x, 4 + 16 * y)))
}

/// What the program prints of a scene whose text is `source`, a line a pixel.
fn printed(source: &str, scene: &str, folder: &Path) -> Vec<Value> {
    let write = |name: &str, text: &[u8]| {
        let path = folder.join(name);
        fs::write(&path, text).expect("written");
        path
    };
    let mut json = Vec::new();
    flat::write_json(&mut json, &task(scene)).expect("a buffer takes everything");
    let list: Vec<String> = pixels().map(|(x, y)| format!("{x} {y}\n")).collect();
    let list = list.concat();
    let ran = Command::new("python3")
        .arg(write("tracer.py", source.as_bytes()))
        .arg(write("scene.json", &json))
        .args([SIZE.0, SIZE.1].map(|n| n.to_string()))
        .arg(write("pixels", list.as_bytes()))
        .output()
        .expect("runs");
    let said = String::from_utf8_lossy(&ran.stderr);
    assert!(ran.status.success() && said.is_empty(), "{scene}: {said}");
    let lines = ran.stdout.split(|byte| *byte == b'\n');
    let lines = lines.filter(|line| !line.is_empty());
    lines
        .map(|line| serde_json::from_slice(line).expect("JSON"))
        .collect()
}

pub fn source() -> String {
    fs::read_to_string(lesson("solutions/python/tracer.py")).expect("there")
}

fn ours(world: &World, pixel: (u32, u32)) -> Document {
    let settings = world
        .scene
        .settings
        .with(|s| (s.image.width, s.image.height) = SIZE);
    let trace = trace_pixel(world, &settings, pixel, false);
    document::of(View {
        world,
        settings: &settings,
        trace: &trace,
    })
}

/// The program's ray tree agrees with the library's: the same rays, ends, terms and absences; numbers within `tolerance`.
fn check(theirs: &Value, ours: &Value, tolerance: f64, about: &str) {
    let hit_of = |node: &Value| (node["kind"] != "L").then(|| node["hit"]["object"].clone());
    for field in ["kind", "light", "outcome"] {
        assert_eq!(theirs[field], ours[field], "{field}, {about}");
    }
    assert_eq!(hit_of(theirs), hit_of(ours), "{about}");
    let list = |node: &Value, field: &str| node[field].as_array().cloned().unwrap_or_default();
    let pairs = |field: &str| {
        let (theirs, ours) = (list(theirs, field), list(ours, field));
        assert_eq!(theirs.len(), ours.len(), "{field}, {about}");
        theirs.into_iter().zip(ours)
    };
    for (a, b) in pairs("absent") {
        for field in ["kind", "light", "reason"] {
            assert_eq!(a[field], b[field], "absent {field}, {about}");
        }
    }
    for (a, b) in pairs("terms") {
        assert_eq!(
            (&a["term"], &a["light"]),
            (&b["term"], &b["light"]),
            "{about}"
        );
        near(&a["value"], &b["value"], tolerance, about);
    }
    near(&theirs["direction"], &ours["direction"], tolerance, about);
    for place in [
        "/weight",
        "/radiance",
        "/hit/normal",
        "/boundary/reflectance",
    ] {
        if ours["kind"] != "L" {
            let none = &Value::Null;
            let at = |node: &'_ Value| node.pointer(place).unwrap_or(none).clone();
            near(&at(theirs), &at(ours), tolerance, about);
        }
    }
    for (a, b) in pairs("children") {
        check(&a, &b, tolerance, about);
    }
}

/// Numbers, and lists of such, that are near each other; or nothing in both.
fn near(theirs: &Value, ours: &Value, tolerance: f64, about: &str) {
    let numbers = |value: &Value| -> Vec<f64> {
        let all = value.as_array().cloned().unwrap_or(vec![value.clone()]);
        all.iter().filter_map(Value::as_f64).collect()
    };
    let (a, b) = (numbers(theirs), numbers(ours));
    let close = a.iter().zip(&b).all(|(a, b)| (a - b).abs() <= tolerance);
    assert!(a.len() == b.len() && close, "{theirs}, {ours}: {about}");
}

#[test]
fn the_solution_has_the_ray_trees_of_the_library() {
    if !is_found("python3", true) {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    // Its own way to leave a surface moves what is seen through glass: with a smaller step that is gone.
    let exact = source().replace("\nEPSILON = 1e-4", "\nEPSILON = 1e-9");
    assert_ne!(exact, source());
    for (scene, inside) in [("hits", false), ("light", false), ("glass", true)] {
        let world = World::new(task(scene), AccelKind::default());
        let near = printed(&exact, scene, folder.path());
        let own = printed(&source(), scene, folder.path());
        let mut caught = 0;
        assert_eq!((near.len(), own.len()), (300, 300));
        for ((near, own), pixel) in near.iter().zip(&own).zip(pixels()) {
            let about = format!("{scene} {pixel:?}");
            let ours = ours(&world, pixel);
            let color = serde_json::to_value(ours.color).expect("plain data");
            self::near(&near["color"]["linear"], &color["linear"], 1e-6, &about);
            let root = serde_json::to_value(&ours.samples[0].root).expect("plain data");
            check(&near["root"], &root, 2e-6, &about);
            // The same rays, whatever the step.
            check(&own["root"], &root, f64::INFINITY, &about);
            caught += usize::from(root.to_string().contains("total-internal-reflection"));
        }
        assert_eq!(caught > 5, inside, "{scene}: {caught}");
    }
}

#[test]
fn each_patch_changes_one_line_and_with_it_the_trees() {
    if !is_found("python3", true) {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let scenes = ["hits", "light", "glass"];
    let right = scenes.map(|scene| printed(&source(), scene, folder.path()));
    let readme = fs::read_to_string(lesson("solutions/python/README.md")).expect("there");
    let mut count = 0;
    for entry in fs::read_dir(lesson("solutions/python/patches")).expect("a folder") {
        let path = entry.expect("readable").path();
        let name = path.file_stem().and_then(|s| s.to_str()).expect("UTF-8");
        let row = readme
            .lines()
            .find(|l| l.starts_with(&format!("| `{name}` |")));
        let row = row.unwrap_or_else(|| panic!("{name} stands in the README"));
        let broken = patched(&fs::read_to_string(&path).expect("there"), name);
        let seen = (0..3)
            .filter(|i| row.contains(scenes[*i]))
            .collect::<Vec<_>>();
        assert!(!seen.is_empty(), "{name}");
        for i in seen {
            let trees = printed(&broken, scenes[i], folder.path());
            assert_ne!(trees, right[i], "{name} on {}", scenes[i]);
        }
        count += 1;
    }
    assert_eq!(count, 18);
}

/// The program with a patch, put in by its context as the tool `patch` does it.
pub fn patched(patch: &str, name: &str) -> String {
    let hunk: Vec<&str> = patch.lines().skip(3).collect();
    let is = |sign: char| hunk.iter().filter(|l| l.starts_with(sign)).count();
    assert_eq!((is('-'), is('+')), (1, 1), "{name} changes one line");
    assert!(
        patch.starts_with("--- a/tracer.py\n+++ b/tracer.py\n@@ "),
        "{name}"
    );
    let side = |left_out: char| -> String {
        let lines = hunk.iter().filter(|l| !l.starts_with(left_out));
        let lines: Vec<String> = lines.map(|line| format!("{}\n", &line[1..])).collect();
        lines.concat()
    };
    let (before, after) = (side('+'), side('-'));
    assert_eq!(source().matches(&before).count(), 1, "{name} fits");
    source().replace(&before, &after)
}
