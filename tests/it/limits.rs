//! Every limit is reached: what is just within it is accepted, one more is refused with one message that tells the limit.

#![expect(
    clippy::format_collect,
    reason = "texts are made line by line, as they read"
)]

use std::fmt::Write;

use assert_cmd::Command;
use raytree::probe::{Event, Probe};
use raytree::scene::limits::{
    IOR, MAX_COORDINATE, MAX_CORNERS, MAX_DEPTH, MAX_DIAGRAM_NODES, MAX_EDGE, MAX_EVENT_BYTES,
    MAX_EVENTS, MAX_EXPONENT, MAX_FILE_BYTES, MAX_GROUP_DEPTH, MAX_LIGHT_SAMPLES, MAX_LIGHTS,
    MAX_NAME_BYTES, MAX_NESTING, MAX_PIXELS, MAX_PRIMITIVES, MAX_RADIANCE, MAX_SAMPLES,
    MAX_WARNINGS, table,
};
use raytree::scene::{Scene, load, load_held};
use raytree::trace::Recorder;

const CAMERA: &str =
    r#""format": "raytree-scene/1", "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0]}"#;

fn read(name: &str, files: &[(&str, &str)]) -> Result<Scene, String> {
    let held = files
        .iter()
        .map(|(name, text)| ((*name).to_string(), text.as_bytes().to_vec()));
    load_held(name, held.collect()).map_err(|e| e.to_string())
}

/// A scene with these fields beside format and camera, and a material `a`.
fn scene(fields: &str) -> Result<Scene, String> {
    let text = format!("{{{CAMERA}, \"materials\": {{\"a\": {{}}}}, {fields}}}");
    read("a.json", &[("a.json", &text)])
}

/// The first is accepted, the second refused in two lines that have these words.
#[track_caller]
fn limit(within: Result<Scene, String>, beyond: Result<Scene, String>, words: &[&str]) {
    if let Err(said) = within {
        panic!("within the limit: {said}");
    }
    let said = beyond.expect_err("beyond the limit");
    assert_eq!(said.lines().count(), 2, "{said}");
    for word in words {
        assert!(said.contains(word), "`{word}` is not in:\n{said}");
    }
}

#[test]
fn the_book_shows_the_limits_as_they_are() {
    let mut rows = String::from("| what | at most | beyond |\n|---|---|---|\n");
    for [what, most, beyond] in table() {
        let _ = writeln!(rows, "| {what} | {most} | {beyond} |");
    }
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/book/src/limits.md");
    let book = std::fs::read_to_string(path).expect("the chapter");
    let start = book.find("| what |").expect("the table");
    let end = start
        + book[start..]
            .find("\n\n")
            .map_or(book.len() - start, |end| end + 1);
    if std::env::var_os("RAYTREE_BOOK").is_some() {
        let new = format!("{}{rows}{}", &book[..start], &book[end..]);
        return std::fs::write(path, new).expect("the chapter is written");
    }
    assert_eq!(
        &book[start..end],
        rows,
        "write it anew: RAYTREE_BOOK=1 cargo test --test it limits"
    );
}

#[test]
fn bytes_of_a_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.obj");
    let file = std::fs::File::create(&path).expect("a file");
    let said = |bytes: u64| {
        file.set_len(bytes).expect("a file with a hole");
        load(path.to_str().expect("UTF-8"))
            .expect_err("no model")
            .to_string()
    };
    let large = said(MAX_FILE_BYTES + 1);
    assert!(large.contains("256 MiB at most"), "{large}");
    let within = said(MAX_FILE_BYTES);
    assert!(within.contains("no face"), "{within}");
}

#[test]
fn triangles_and_other_shapes() {
    // Faces of 1000 corners are 998 triangles each, in few letters.
    let corners: String = (0..1000)
        .map(|i| format!("v {} {} 0\n", i % 500, i / 500))
        .collect();
    let outline: Vec<String> = (1..=500)
        .chain((501..=1000).rev())
        .map(|i| i.to_string())
        .collect();
    let face = format!("f {}\n", outline.join(" "));
    let whole = MAX_PRIMITIVES / 998;
    let model = |more: usize| {
        let rest = "f 1 2 501\n".repeat(MAX_PRIMITIVES % 998 + more);
        read(
            "m.obj",
            &[("m.obj", &format!("{corners}{}{rest}", face.repeat(whole)))],
        )
    };
    limit(
        model(0),
        model(1),
        &["m.obj", "more than 2000000 triangles", "fewer triangles"],
    );
}

#[test]
fn corners_of_a_face() {
    let model = |corners: usize| {
        let face: Vec<String> = (0..corners).map(|i| (1 + i % 3).to_string()).collect();
        let text = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf {}\n", face.join(" "));
        read("m.obj", &[("m.obj", &text)])
    };
    limit(
        model(MAX_CORNERS),
        model(MAX_CORNERS + 1),
        &["m.obj:5: ", "1001 corners", "1000 are possible"],
    );
}

#[test]
fn lights() {
    let lights = |count: usize| {
        let light = |i| {
            format!(
                r#"{{"directional": {{"name": "l{i}", "direction": [0, 1, 0], "intensity": [1, 1, 1]}}}}"#
            )
        };
        let lights: Vec<String> = (0..count).map(light).collect();
        scene(&format!("\"lights\": [{}]", lights.join(",")))
    };
    limit(
        lights(MAX_LIGHTS),
        lights(MAX_LIGHTS + 1),
        &["a.json: lights: ", "1001 lights", "1000 at most"],
    );
}

#[test]
fn groups_and_brackets() {
    let nested = |depth: usize| {
        let open = r#"{"group": {"name": "g", "objects": ["#.repeat(depth);
        scene(&format!("\"objects\": [{open}{}]", "]}}".repeat(depth)))
    };
    limit(
        nested(MAX_GROUP_DEPTH),
        nested(MAX_GROUP_DEPTH + 1),
        &["more than 32 deep"],
    );
    // The scene is one bracket, its objects another, each group three more: the parser's own limit comes later.
    let most = (MAX_NESTING - 2) / 3;
    let said = nested(most).expect_err("more than 32");
    assert!(said.contains("groups are nested more than 32"), "{said}");
    let said = nested(most + 1).expect_err("more than the parser reads");
    assert!(said.contains("the file is nested too deeply"), "{said}");
}

#[test]
fn names() {
    let named = |bytes: usize| {
        let name = "n".repeat(bytes - 2);
        let ball = format!(
            r#"{{"sphere": {{"name": "{name}", "material": "a", "center": [0, 0, 0], "radius": 1}}}}"#
        );
        // With the names of its groups.
        scene(&format!(
            r#""objects": [{{"group": {{"name": "g", "objects": [{ball}]}}}}]"#
        ))
    };
    limit(
        named(MAX_NAME_BYTES),
        named(MAX_NAME_BYTES + 1),
        &["201 bytes", "200 bytes at most"],
    );
}

#[test]
fn numbers() {
    let at = |x: f64| {
        scene(&format!(
            "\"objects\": [{{\"plane\": {{\"name\": \"p\", \"material\": \"a\", \"point\": [0, {x:e}, 0], \"normal\": [0, 1, 0]}}}}]"
        ))
    };
    let next = MAX_COORDINATE.next_up();
    limit(
        at(MAX_COORDINATE),
        at(next),
        &["objects[0].plane.point[1]", "from -1e12 to 1e12"],
    );
    limit(
        at(-MAX_COORDINATE),
        at(-next),
        &["objects[0].plane.point[1]"],
    );
    let material = |fields: &str| {
        let text = format!("{{{CAMERA}, \"materials\": {{\"a\": {{{fields}}}}}}}");
        read("a.json", &[("a.json", &text)])
    };
    for (key, [low, high]) in [("ior", IOR), ("shininess", [0.0, MAX_EXPONENT])] {
        let value = |x: f64| material(&format!("\"{key}\": {x:e}"));
        limit(
            value(low),
            value(low.next_down()),
            &["materials.a.", key, "write a number from"],
        );
        limit(
            value(high),
            value(high.next_up()),
            &["materials.a.", key, "write a number from"],
        );
    }
    let emission = |x: f64| material(&format!("\"emission\": [0, {x:e}, 0]"));
    limit(
        emission(MAX_RADIANCE),
        emission(MAX_RADIANCE.next_up()),
        &["materials.a.emission[1]", "0 to 1e12"],
    );
}

#[test]
fn settings() {
    let setting = |text: String| scene(&format!("\"settings\": {{{text}}}"));
    let samples = |n: u32| setting(format!("\"samples\": {n}"));
    limit(
        samples(MAX_SAMPLES),
        samples(MAX_SAMPLES + 1),
        &["settings.samples", "from 1 to 4096"],
    );
    limit(samples(1), samples(0), &["settings.samples"]);
    let rays = |n: u32| setting(format!("\"light_samples\": {n}"));
    limit(
        rays(MAX_LIGHT_SAMPLES),
        rays(MAX_LIGHT_SAMPLES + 1),
        &["settings.light_samples", "from 1 to 65536"],
    );
    let size = |w: u64, h: u64| setting(format!("\"size\": [{w}, {h}]"));
    let edge = u64::from(MAX_EDGE);
    limit(
        size(edge, 1),
        size(edge + 1, 1),
        &["settings.size", "at most 16384 pixels"],
    );
    let rows = MAX_PIXELS / edge;
    limit(
        size(edge, rows),
        size(edge, rows + 1),
        &["settings.size", "at most 67108864"],
    );
}

#[test]
fn warnings_are_counted_where_they_are_not_kept() {
    let warned = |count: usize| {
        let lines: String = (0..count).map(|i| format!("usemtl m{i}\n")).collect();
        let text = format!("mtllib x.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n{lines}f 1 2 3\n");
        read("m.obj", &[("m.obj", &text), ("x.mtl", "")])
            .expect("only warnings")
            .warnings
    };
    assert_eq!(warned(MAX_WARNINGS).len(), MAX_WARNINGS);
    let more = warned(MAX_WARNINGS + 7);
    assert_eq!(more.len(), MAX_WARNINGS + 1);
    assert_eq!(more[MAX_WARNINGS], "and 7 more warnings");
}

#[test]
fn a_recording_keeps_what_there_is_room_for() {
    // The real limit is reached below.
    let mut recorder = Recorder::<true>::with_limit(1000);
    (0..1003).for_each(|_| recorder.event(Event::Miss));
    assert_eq!((recorder.events.len(), recorder.dropped), (1000, 3));
    const {
        assert!(
            MAX_EVENTS * size_of::<Event>() >= MAX_EVENT_BYTES,
            "the bytes decide"
        );
    };
}

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
    assert_eq!(trace("20", 0), "");
    let full = trace("36", 3);
    assert!(
        full.contains("the log is full") && full.contains("events were not kept"),
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
        let shown = nodes.min(MAX_DIAGRAM_NODES);
        let more = format!("{} more rays", nodes - shown);
        let dot = trace("dot", depth);
        // All but the eye ray have one that sent them.
        let sent = dot.lines().filter(|l| l.contains(" -> n")).count();
        assert_eq!((sent, dot.contains(&more)), (shown - 1, many));
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
    assert_eq!(said(&render, 0), "");
    let tree = folder.path().join("t.json").display().to_string();
    let to = ["--pixel", "1,1", "-o", &tree];
    assert_eq!(
        said(&[&["trace", &scene][..], &common, &to].concat(), 0),
        ""
    );
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
    refused("--max-rays", "0", "1..");
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
    assert_eq!(render(&["--depth", &most], 0), "");
    let beyond = (MAX_DEPTH + 1).to_string();
    assert!(render(&["--depth", &beyond], 3).contains("stopped at a limit"));
    // Four pixels that each send six rays.
    assert_eq!(render(&["--depth", "5", "--max-rays", "24"], 0), "");
    assert!(render(&["--depth", "5", "--max-rays", "23"], 3).contains("stopped at a limit"));
}
