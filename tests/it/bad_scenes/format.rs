//! Text that is no scene file: broken JSON, wrong fields, wrong types, nesting, encodings.

use std::fs;

use super::{BALL, Folder, assert_says, loaded, refused, scene, sphere};

#[test]
fn truncated_json() {
    let text = sphere(r#""center": [0, 0, 0], "radius": 1"#);
    assert_says(
        &refused(&text.as_bytes()[..text.len() - 20]),
        &["a.json:2:", "ends in the middle", "close every bracket"],
    );
}

#[test]
fn every_prefix_of_a_scene_is_refused_without_a_panic() {
    let text = sphere(r#""center": [0, 0, 0], "radius": 1"#);
    let folder = Folder::new(&[]);
    for end in 0..text.len() {
        fs::write(folder.path("a.json"), &text[..end]).expect("a file");
        assert!(folder.load("a.json").is_err(), "{end}");
    }
}

/// What is missing may stand behind the bracket that is missing, too: the bracket is told first.
#[test]
fn text_that_breaks_off_is_told_before_what_is_missing() {
    let broken = r#"{"format": "raytree-scene/1", "camera": {"eye": [0, 0, 5]}, "objects": [{"sphere": {"radus": 1}}"#;
    let told = refused(broken.as_bytes());
    assert_says(
        &told,
        &["a.json:1:", "ends in the middle", "close every bracket"],
    );
    assert!(
        !told.contains("look_at") && !told.contains("radus"),
        "{told}"
    );
    let closed = format!("{broken}]}}");
    assert_says(&refused(closed.as_bytes()), &["look_at"]);
}

#[test]
fn unknown_field() {
    let text = sphere(r#""center": [0, 0, 0], "radus": 1"#);
    assert_says(
        &refused(text.as_bytes()),
        &[
            "a.json:2:",
            "objects[0].sphere.radus",
            "no field `radus`",
            "did you mean `radius`?",
        ],
    );
}

#[test]
fn unknown_kind_of_object() {
    let text = scene(r#", "objects": [{"shpere": {}}]"#);
    assert_says(
        &refused(text.as_bytes()),
        &["objects[0]", "no kind `shpere`", "did you mean `sphere`?"],
    );
}

#[test]
fn missing_field() {
    let text = sphere(r#""center": [0, 0, 0]"#);
    assert_says(
        &refused(text.as_bytes()),
        &["objects[0].sphere", "`radius` is missing", "add \"radius\""],
    );
}

#[test]
fn second_field_beside_the_kind() {
    let text = scene(&format!(
        r#", "objects": [{}]"#,
        BALL.replace("}}", r#"}, "note": "x"}"#)
    ));
    assert_says(&refused(text.as_bytes()), &["objects[0]", "one kind"]);
}

#[test]
fn wrong_type() {
    let text = sphere(r#""center": [0, 0, 0], "radius": "big""#);
    assert_says(
        &refused(text.as_bytes()),
        &["objects[0].sphere.radius", "\"big\"", "a number"],
    );
    let text = sphere(r#""center": [0, 0], "radius": 1"#);
    assert_says(
        &refused(text.as_bytes()),
        &[
            "objects[0].sphere.center",
            "length 2",
            "\"center\": [x, y, z] (the centre)",
        ],
    );
}

#[test]
fn things_that_students_write() {
    let camera =
        r#""format": "raytree-scene/1", "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0]}"#;
    for (rest, place, cure) in [
        (r#""objects": [{}]"#, "objects[0]", "name its kind"),
        (
            r#""objects": ["sphere"]"#,
            "objects[0].sphere",
            "write an object",
        ),
        (
            r#""objects": [{"sphere": 5}]"#,
            "objects[0].sphere",
            "an object {...}",
        ),
        (
            r#""objects": {"sphere": 5}"#,
            "objects",
            "expected is a list",
        ),
        (
            r#""objects": [{"disc": [1, 2]}]"#,
            "objects[0].disc",
            r#"name the fields, such as {"name": "...", "material": "...", "center": [x, y, z], "normal": [x, y, z], "radius": 1}"#,
        ),
        (
            r#""lights": [{"area": ["a"]}]"#,
            "lights[0].area",
            r#"{"name": "...", "object": "..."}"#,
        ),
        (
            r#""lights": [{}]"#,
            "lights[0]",
            r#"name its kind, such as {"point": {"name": "...", "position": [x, y, z], "intensity": [r, g, b]}}"#,
        ),
        (
            r#""lights": ["spot"]"#,
            "lights[0].spot",
            r#"{"spot": {"name": "...", "position": [x, y, z]"#,
        ),
        (
            r#""objects": [5]"#,
            "objects[0]",
            "not an object {...} with one kind",
        ),
        (
            r#""background": [1, 2, 3, 4]"#,
            "background",
            "a longer list; what is expected is a list of length 3",
        ),
        (
            r#""materials": {"a": {"priority": 1.5}}"#,
            "materials.a.priority",
            "whole number from -2147483648",
        ),
        (
            r#""settings": {"fresnel": 5}"#,
            "settings.fresnel",
            r#"one of "none", "schlick", "exact""#,
        ),
    ] {
        assert_says(
            &refused(format!("{{{camera}, {rest}}}").as_bytes()),
            &[place, cure],
        );
    }
}

#[test]
fn settings_and_materials_that_students_write() {
    let camera =
        r#""format": "raytree-scene/1", "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0]}"#;
    for (rest, place, cure) in [
        (
            r#""settings": {"size": [320]}"#,
            "settings.size",
            "expected is a list of length 2",
        ),
        (
            r#""materials": {"a": {"ior": .5}}"#,
            "materials.a.ior",
            "such as 0.5",
        ),
        (
            r#""materials": {"a": {"diffuse": 5}}"#,
            "materials.a.diffuse",
            "a list of length 3",
        ),
        (r#""materials": {"a": 'b'}"#, "materials.a", "'...'"),
        (
            r#""settings": {"depth": -1}"#,
            "settings.depth",
            "whole number from 0",
        ),
        (
            r#""settings": {"fresnel": "exct"}"#,
            "settings.fresnel",
            "`exact`",
        ),
        (
            r#""settings": {"size": [32.5, 2]}"#,
            "settings.size[0]",
            "whole number",
        ),
        (
            r#""objects": [{"group": {"name": "g", "objects": [], "transform": [{"rotate": [0, 1, 0]}]}}]"#,
            "objects[0].group.transform[0].rotate",
            "name the fields",
        ),
        (r#""materials" {}"#, "", "write \"name\": value"),
        (r#""name": "a" "note": "b""#, "", "the line before"),
    ] {
        assert_says(
            &refused(format!("{{{camera}, {rest}}}").as_bytes()),
            &[place, cure],
        );
    }
    for text in ["[1, 2]", "hello", "# OBJ\nv 0 0 0"] {
        assert_says(
            &refused(text.as_bytes()),
            &["not a scene", "the right file"],
        );
    }
    assert_says(&refused(br#"{"format": 7}"#), &["a.json:1:", "format `7`"]);
}

#[test]
fn nan_and_infinity() {
    for word in ["NaN", "nan", "Infinity", "-Infinity", "inf"] {
        let text = sphere(&format!(r#""center": [0, 0, 0], "radius": {word}"#));
        assert_says(
            &refused(text.as_bytes()),
            &["a.json:2:", "radius", "is not a number in JSON", "finite"],
        );
    }
}

#[test]
fn number_too_large() {
    let text = sphere(r#""center": [0, 0, 0], "radius": 1e400"#);
    assert_says(&refused(text.as_bytes()), &["radius", "too large", "1e12"]);
    let text = sphere(r#""center": [0, 1e40, 0], "radius": 1"#);
    assert_says(
        &refused(text.as_bytes()),
        &["objects[0].sphere.center[1]", "from -1e12 to 1e12"],
    );
}

#[test]
fn comments_and_trailing_commas() {
    let text = sphere("// a comment\n\"center\": [0, 0, 0], \"radius\": 1");
    assert_says(&refused(text.as_bytes()), &["no comments", "\"note\""]);
    let text = sphere(r#""center": [0, 0, 0,], "radius": 1"#);
    assert_says(&refused(text.as_bytes()), &["comma", "take the comma away"]);
}

#[test]
fn duplicate_keys() {
    let text = sphere(r#""center": [0, 0, 0], "radius": 1, "radius": 2"#);
    assert_says(&refused(text.as_bytes()), &["`radius` is given twice"]);
    let text = scene("").replace(r#"{"red":"#, r#"{"red": {}, "red":"#);
    assert_says(
        &refused(text.as_bytes()),
        &["materials", "`red` is given twice"],
    );
}

#[test]
fn wrong_format() {
    let text = scene("").replace("raytree-scene/1", "raytree-scene/9");
    assert_says(
        &refused(text.as_bytes()),
        &[
            "a.json:1:",
            "format",
            "`raytree-scene/9`",
            "write \"format\": \"raytree-scene/1\"",
        ],
    );
}

#[test]
fn nested_two_hundred_deep() {
    let mut objects = BALL.to_string();
    for i in 0..200 {
        objects = format!(r#"{{"group": {{"name": "g{i}", "objects": [{objects}]}}}}"#);
    }
    let text = scene(&format!(r#", "objects": [{objects}]"#));
    assert_says(&refused(text.as_bytes()), &["nested too deeply", "32 deep"]);
}

#[test]
fn groups_nest_32_deep_and_no_deeper() {
    let nested = |depth: usize| {
        let open =
            |text: String, i| text + &format!(r#"{{"group": {{"name": "g{i}", "objects": ["#);
        let open = (0..depth).fold(String::new(), open);
        loaded(&format!("{open}{BALL}{}", "]}}".repeat(depth)), &[])
    };
    let scene = nested(32).expect("32 are possible");
    assert!(scene.objects[0].name.starts_with("g0/g1/g2/"));
    assert_says(&nested(33).expect_err("too deep"), &["more than 32 deep"]);
}

#[test]
fn empty_file() {
    for bytes in [&b""[..], b" \n\n", b"\xef\xbb\xbf"] {
        assert_says(
            &refused(bytes),
            &["a.json: the file is empty", "raytree-scene/1"],
        );
    }
}

#[test]
fn not_utf8() {
    assert_says(
        &refused(b"{\n\"name\": \"caf\xe9\"}"),
        &["not UTF-8", "line 2", "UTF-8"],
    );
}

#[test]
fn a_byte_order_mark_and_windows_line_ends_are_no_mistake() {
    let text = format!("\u{feff}{}", scene(&format!(r#", "objects": [{BALL}]"#)));
    let folder = Folder::new(&[("a.json", text.replace('\n', "\r\n").as_bytes())]);
    assert!(folder.load("a.json").is_ok_and(|s| s.warnings.is_empty()));
}
