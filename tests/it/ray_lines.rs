//! `raytree trace --format obj`: each ray of the tree is a line, from its origin to where it ends.

use assert_cmd::Command;
use serde_json::Value;

fn trace(args: &[&str]) -> String {
    let args = [&["trace"], args].concat();
    let ran = Command::cargo_bin("raytree")
        .expect("built")
        .args(args)
        .output()
        .expect("runs");
    assert!(
        ran.status.success(),
        "{}",
        String::from_utf8_lossy(&ran.stderr)
    );
    String::from_utf8(ran.stdout).expect("UTF-8")
}

type Point = [f64; 3];

/// The lines of the file by their groups.
fn lines(text: &str) -> Vec<(String, [Point; 2])> {
    let (mut points, mut lines, mut group) = (Vec::new(), Vec::new(), String::new());
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        let words: Vec<&str> = line.split(' ').collect();
        let number = |i: usize| words[i].parse::<f64>().expect("a number");
        match words[0] {
            "g" => words[1].clone_into(&mut group),
            "v" => points.push([number(1), number(2), number(3)]),
            "l" => {
                let end = |i: usize| points[number(i) as usize - 1];
                lines.push((group.clone(), [end(1), end(2)]));
            }
            other => panic!("{other}"),
        }
    }
    assert_eq!(points.len(), 2 * lines.len());
    lines
}

/// All rays of a tree.
fn rays<'a>(node: &'a Value, all: &mut Vec<&'a Value>) {
    all.push(node);
    for child in node["children"].as_array().into_iter().flatten() {
        rays(child, all);
    }
}

#[test]
fn every_ray_is_a_line_from_its_origin_to_its_end() {
    for (scene, pixel) in [
        ("whitted", "30,22"),
        ("glass-block", "32,24"),
        ("soft-shadow", "24,30"),
        ("whitted", "2,2"),
    ] {
        let args = [scene, "--size", "64x48", "--pixel", pixel];
        let json: Value = serde_json::from_str(&trace(&args)).expect("JSON");
        let mut all = Vec::new();
        for sample in json["samples"].as_array().expect("a list") {
            rays(&sample["root"], &mut all);
        }
        let lines = lines(&trace(&[&args[..], &["--format", "obj"]].concat()));
        assert_eq!(lines.len(), all.len(), "{scene}");
        let vector = |v: &Value| [0, 1, 2].map(|i| v[i].as_f64().expect("a number"));
        for ray in all {
            let group = match (ray["kind"].as_str(), ray["outcome"].as_str()) {
                (Some("I"), _) => "eye_rays",
                (Some("R"), _) => "reflected_rays",
                (Some("T"), _) => "transmitted_rays",
                (_, Some("blocked")) => "shadow_rays_blocked",
                _ => "shadow_rays_lit",
            };
            let start = vector(&ray["origin"]);
            let near = |a: &Point, b: &Point| (0..3).all(|i| (a[i] - b[i]).abs() < 1e-9);
            let mut those = lines
                .iter()
                .filter(|(g, ends)| g == group && ends[0] == start);
            let is_it = |(_, ends): &(String, [Point; 2])| match ray["hit"].get("point") {
                Some(point) => near(&ends[1], &vector(point)),
                None => ends[1] != start,
            };
            assert!(those.any(is_it), "{scene}: {ray}");
        }
    }
}
