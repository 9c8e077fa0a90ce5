//! Limits of what is done: flags, pictures and recordings.

use assert_cmd::Command;
use raytree::scene::limits::{MAX_DEPTH, MAX_DIAGRAM_NODES, MAX_LIGHTS, MAX_RADIANCE};

use super::CAMERA;

/// What the program says to arguments that it refuses.
fn said(arguments: &[&str], code: i32) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_raytree"))
        .args(arguments)
        .output()
        .expect("it runs");
    let said = String::from_utf8(output.stderr).expect("UTF-8");
    assert_eq!(output.status.code(), Some(code), "{arguments:?}: {said}");
    said
}

/// 262,144 triangles without a tree make as many events a ray: enough of them are quickly there.
#[test]
fn a_log_that_is_full_ends_with_status_three() {
    let folder = tempfile::tempdir().expect("a folder");
    let diagram = folder.path().join("a.dot").display().to_string();
    let trace = |samples: &str, code: i32| {
        let scene = ["trace", "spd:tetra:9", "--accel", "list", "--traversal"];
        let pixel = ["--pixel", "160,120", "--samples", samples];
        let to = ["--format", "dot", "-o", &diagram];
        said(&[&scene[..], &pixel, &to].concat(), code)
    };
    let whole = trace("20", 0);
    assert!(!whole.contains("the log is full"), "{whole}");
    let full = trace("36", 3);
    assert!(
        full.contains("the log is full") && full.contains("events that were not kept"),
        "{full}"
    );
    // What it ends in is still a tree, whose last ray has no end.
    let text = std::fs::read_to_string(&diagram).expect("a diagram");
    assert_eq!(text.matches("\\ncut\\n").count(), 1, "{text}");
}

#[test]
fn nodes_of_a_diagram() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("tree");
    let trace = |format: &str, depth: &str| {
        let place = path.display().to_string();
        let scene = [
            "trace",
            "nested-glass",
            "--pixel",
            "160,120",
            "--min-weight",
            "0",
        ];
        let to = ["--depth", depth, "--format", format, "-o", &place];
        assert_eq!(said(&[&scene[..], &to].concat(), 0), "");
        std::fs::read_to_string(&path).expect("a tree")
    };
    for (depth, many) in [("6", false), ("14", true)] {
        // Every ray has a number.
        let nodes = trace("json", depth).matches("\"id\": ").count();
        assert_eq!(nodes > MAX_DIAGRAM_NODES, many, "{nodes}");
        let dot = trace("dot", depth);
        // All but the eye ray have one that sent them; dotted lines lead to rays that were not sent.
        let lines = |dotted: bool| {
            let is_it = |line: &&str| line.contains(" -> n") && line.contains("dotted") == dotted;
            dot.lines().filter(is_it).count()
        };
        let (sent, absent) = (lines(false), lines(true));
        assert_eq!(sent + 1 + absent == MAX_DIAGRAM_NODES, many);
        let more = format!("{} more rays", nodes - sent - 1);
        assert_eq!((sent + 1 < nodes, dot.contains(&more)), (many, many));
        let svg = trace("svg", depth);
        assert_eq!(svg.contains(&more), many);
    }
}

/// No number that a file may hold makes light without end: so many lights, as strong and as near as they may be, on the
/// brightest of surfaces, seen in mirrors, are far below what `f64` can hold, and squares of them too.
#[test]
fn the_brightest_scene_is_finite() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.json");
    let (r, n) = (MAX_RADIANCE, MAX_LIGHTS);
    let light = |i: usize| {
        format!(
            r#"{{"point": {{"name": "l{i}", "position": [0, 0, 4], "intensity": [{r:e}, {r:e}, {r:e}], "attenuation": [1e-100, 0, 0]}}}}"#
        )
    };
    let lights: Vec<String> = (0..n).map(light).collect();
    let all = format!("[{r:e}, {r:e}, {r:e}]");
    let material = format!(
        r#""diffuse": {all}, "specular": {all}, "shininess": 0, "emission": {all}, "mirror": [1, 1, 1]"#
    );
    let mirror = |name: &str, z: i32| {
        let normal = -z.signum();
        format!(
            r#"{{"plane": {{"name": "{name}", "material": "m", "point": [0, 0, {z}], "normal": [0, 0, {normal}]}}}}"#
        )
    };
    let text = format!(
        r#"{{{CAMERA}, "background": {all}, "ambient": {all}, "materials": {{"m": {{{material}}}}}, "lights": [{}], "objects": [{}, {}]}}"#,
        lights.join(","),
        mirror("front", -1),
        mirror("back", 6)
    );
    std::fs::write(&path, text).expect("a file");
    let scene = path.display().to_string();
    let picture = folder.path().join("a.png").display().to_string();
    let errors = folder.path().join("e.pfm").display().to_string();
    let common = [
        "--size",
        "2x2",
        "--depth",
        "4",
        "--samples",
        "2",
        "--sampling",
        "sobol",
    ];
    let files = ["-o", &picture, "--error-map", &errors];
    let render = [&["render", &scene][..], &common, &files].concat();
    // The material is told, as it should be.
    let told = said(&render, 0);
    assert!(!told.contains("finite"), "{told}");
    let tree = folder.path().join("t.json").display().to_string();
    let to = ["--pixel", "1,1", "-o", &tree];
    let told = said(&[&["trace", &scene][..], &common, &to].concat(), 0);
    assert!(!told.contains("finite"), "{told}");
    let text = std::fs::read_to_string(&tree).expect("a tree");
    let tree: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let red = tree["color"]["linear"][0].as_f64().expect("a number");
    assert!(red > 1e127 && red < 1e130, "{red:e}");
}

#[test]
fn flags() {
    let refused = |flag: &str, value: &str, word: &str| {
        let said = said(&["render", "triangle", flag, value], 2);
        assert!(said.contains(flag) && said.contains(word), "{said}");
    };
    refused("--size", "16385x1", "at most 16384");
    refused("--size", "16384x4097", "at most 67108864");
    refused("--samples", "4097", "4096");
    refused("--light-samples", "65537", "65536");
    refused("--threads", "1025", "1024");
    refused("--max-rays", "0", "at least 1");
    let budget = said(&["cost", "triangle", "--budget", "1000001"], 2);
    assert!(
        budget.contains("--budget") && budget.contains("1e6"),
        "{budget}"
    );
    let folder = tempfile::tempdir().expect("a folder");
    let picture = folder.path().join("a.png").display().to_string();
    let within = [
        "--samples",
        "4096",
        "--light-samples",
        "65536",
        "--threads",
        "1024",
        "--max-rays",
        "9",
    ];
    let render = ["render", "triangle", "--size", "3x3", "-o", &picture];
    // So few rays are too few for so many samples: a limit, not a mistake.
    let cut = said(&[&render[..], &within[..]].concat(), 3);
    assert!(
        cut.contains("stopped at a limit") && cut.contains("--max-rays"),
        "{cut}"
    );
}

#[test]
fn bounces_and_rays_end_with_status_three() {
    // Two mirrors: a ray goes to and fro for ever.
    let folder = tempfile::tempdir().expect("a folder");
    let scene = folder.path().join("a.json");
    let mirror = |name: &str, z: i32| {
        let normal = -z.signum();
        format!(
            r#"{{"plane": {{"name": "{name}", "material": "m", "point": [0, 0, {z}], "normal": [0, 0, {normal}]}}}}"#
        )
    };
    let objects = [mirror("front", -1), mirror("back", 6)].join(",");
    let materials = r#""materials": {"m": {"mirror": [1, 1, 1]}}"#;
    std::fs::write(
        &scene,
        format!("{{{CAMERA}, {materials}, \"objects\": [{objects}]}}"),
    )
    .expect("a file");
    let scene = scene.display().to_string();
    let picture = folder.path().join("a.png").display().to_string();
    let render = |more: &[&str], code: i32| {
        let common = [
            "render",
            &scene,
            "--size",
            "2x2",
            "--min-weight",
            "0",
            "-o",
            &picture,
        ];
        said(&[&common[..], more].concat(), code)
    };
    let most = MAX_DEPTH.to_string();
    // All light is lost, which is a warning, but as much as was asked for.
    let warned = render(&["--depth", &most], 0);
    assert!(
        warned.contains("rays-cut") && !warned.contains("stopped at a limit"),
        "{warned}"
    );
    assert!(warned.contains("none is higher"), "{warned}");
    let beyond = (MAX_DEPTH + 1).to_string();
    assert!(render(&["--depth", &beyond], 3).contains("stopped at a limit"));
    // Four pixels that each send six rays.
    let warned = render(&["--depth", "5", "--max-rays", "24"], 0);
    assert!(!warned.contains("stopped at a limit"), "{warned}");
    assert!(render(&["--depth", "5", "--max-rays", "23"], 3).contains("stopped at a limit"));
}
