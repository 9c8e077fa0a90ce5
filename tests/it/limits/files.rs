//! Limits of what is read: files, scenes and models.

#![expect(
    clippy::format_collect,
    reason = "texts are made line by line, as they read"
)]

use raytree::scene::limits::{
    IOR, MAX_COORDINATE, MAX_CORNERS, MAX_EDGE, MAX_EXPONENT, MAX_FILE_BYTES, MAX_GROUP_DEPTH,
    MAX_LIGHT_SAMPLES, MAX_LIGHTS, MAX_NAME_BYTES, MAX_NESTING, MAX_PIXELS, MAX_PRIMITIVES,
    MAX_RADIANCE, MAX_SAMPLES, MAX_WARNINGS,
};
use raytree::scene::load;

use super::{CAMERA, limit, read, scene};

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
    // A zigzag, so that it is not convex; beyond the limit its triangles are a guess.
    let guessed = |corners: usize| {
        let points: String = (0..corners)
            .map(|i| match i {
                0 => "v 0 -9 0\n".to_owned(),
                i if i + 1 == corners => format!("v {i} -9 0\n"),
                i => format!("v {i} {} 0\n", i % 2),
            })
            .collect();
        let face: String = (1..=corners).map(|i| format!(" {i}")).collect();
        let scene = read("m.obj", &[("m.obj", &format!("{points}f{face}\n"))]);
        let warnings = scene.expect("drawn").warnings;
        warnings.iter().any(|w| w.code.name() == "guessed-face")
    };
    assert!(!guessed(MAX_CORNERS));
    assert!(guessed(MAX_CORNERS + 1));
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
        let lines: String = (0..count)
            .map(|i| format!("usemtl m{i}\nf 1 2 3\n"))
            .collect();
        let text = format!("mtllib x.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n{lines}");
        read("m.obj", &[("m.obj", &text), ("x.mtl", "")])
            .expect("only warnings")
            .warnings
    };
    assert_eq!(warned(MAX_WARNINGS).len(), MAX_WARNINGS);
    let more = warned(MAX_WARNINGS + 7);
    assert_eq!(more.len(), MAX_WARNINGS + 1);
    let last = more[MAX_WARNINGS].to_string();
    assert!(last.contains("and 7 more warnings"), "{last}");
}
