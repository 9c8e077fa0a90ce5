//! Cures that cure: each shows the right shape of the field that it is about, as the schema has it.

use super::{assert_says, refused};

const CAMERA: &str = r#""camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0]}"#;

/// What is said about a scene with this rest.
fn said(rest: &str) -> String {
    refused(format!("{{\"format\": \"raytree-scene/1\", {CAMERA}, {rest}}}").as_bytes())
}

#[test]
fn a_missing_field_is_shown_with_its_value() {
    let no_format = refused(format!("{{{CAMERA}}}").as_bytes());
    let add = "add \"format\": \"raytree-scene/1\"";
    assert_says(&no_format, &["`format` is missing", add]);
    let no_camera = refused(br#"{"format": "raytree-scene/1"}"#);
    let add = r#"add "camera": {"eye": [x, y, z], "look_at": [x, y, z]} (the eye)"#;
    assert_says(&no_camera, &["`camera` is missing", add]);
    let both = refused(b"{}");
    assert_says(
        &both,
        &[
            "`format`, `camera` are missing",
            "add \"format\": \"raytree-scene/1\"",
        ],
    );
    for (rest, parts) in [
        (
            r#""objects": [{"sphere": {"name": "a", "material": "m", "center": [0, 0, 0]}}]"#,
            &[
                "objects[0].sphere: the field `radius` is missing",
                "add \"radius\": 1 (the radius, above 0)",
            ][..],
        ),
        (
            r#""lights": [{"point": {"name": "a", "position": [0, 0, 0]}}]"#,
            &[
                "lights[0].point",
                "add \"intensity\": [r, g, b] (its strength, linear)",
            ],
        ),
        (
            r#""objects": [{"triangle": {"name": "a", "material": "m"}}]"#,
            &["add \"corners\": [[x, y, z], [x, y, z], [x, y, z]] (the corners)"],
        ),
        (
            r#""objects": [{"mesh": {"name": "a", "material": "m", "vertices": []}}]"#,
            &[
                "the mesh has neither triangles nor polygons",
                "list them, such as \"triangles\": [[0, 1, 2]]",
            ],
        ),
    ] {
        assert_says(&said(rest), parts);
    }
}

#[test]
fn a_kind_in_the_wrong_place_is_put_around_the_fields() {
    let ball =
        r#"{"sphere": {"name": "...", "material": "...", "center": [x, y, z], "radius": 1}}"#;
    let lamp = r#"{"point": {"name": "...", "position": [x, y, z], "intensity": [r, g, b]}}"#;
    for (rest, place, shape) in [
        // As other programs write it: the kind among the fields, first or last.
        (
            r#""objects": [{"type": "sphere", "name": "ball", "material": "red", "center": [0, 0, 0], "radius": 1}]"#,
            "objects[0]: there is no kind `type`",
            ball,
        ),
        (
            r#""objects": [{"name": "ball", "radius": 1, "kind": "sphere"}]"#,
            "objects[0]",
            ball,
        ),
        (
            r#""lights": [{"type": "point", "position": [0, 0, 0]}]"#,
            "lights[0]",
            lamp,
        ),
        // Without a kind: its fields tell.
        (
            r#""objects": [{"name": "ball", "center": [0, 0, 0], "radius": 1}]"#,
            "objects[0]",
            ball,
        ),
        (
            r#""objects": [{"name": "a", "file": "a.obj"}]"#,
            "objects[0]",
            r#"{"obj": {"name": "...", "file": "..."}}"#,
        ),
        (
            r#""objects": [{"group": {"name": "g", "objects": [], "transform": [{"axis": [0, 1, 0], "degrees": 9}]}}]"#,
            "objects[0].group.transform[0]",
            r#"{"rotate": {"axis": [x, y, z], "degrees": 1}}"#,
        ),
        // A kind that nothing tells.
        (
            r#""objects": [{"blob": {"name": "a"}}]"#,
            "there is no kind `blob`",
            "possible here: sphere, plane",
        ),
        // Beside the fields.
        (
            r#""objects": [{"disc": {"name": "a", "material": "m", "center": [0, 0, 0], "normal": [0, 1, 0], "radius": 1}, "material": "red"}]"#,
            "a second field stands beside the kind",
            r#"{"disc": {"name": "...", "material": "...", "center": [x, y, z], "normal": [x, y, z], "radius": 1}}"#,
        ),
    ] {
        assert_says(&said(rest), &[place, shape]);
    }
}

#[test]
fn a_wrong_type_is_shown_with_the_right_one() {
    for (rest, found, shape) in [
        (
            r#""background": "blue""#,
            "the text \"blue\"",
            "write \"background\": [r, g, b]",
        ),
        (r#""background": null"#, "null", "or leave the field out"),
        (
            r#""materials": {"m": {"diffuse": {"r": 1, "g": 0, "b": 0}}}"#,
            "materials.m.diffuse: here stands an object {...}",
            "write \"diffuse\": [r, g, b] (lambert's share of a light)",
        ),
        (
            r#""materials": [{"name": "red", "diffuse": [1, 0, 0]}]"#,
            "a list [...]",
            "an object {...} with a name for each entry",
        ),
        (
            r#""objects": {"sphere": {}}"#,
            "an object {...}; what is expected is a list",
            r#"write "objects": [{"sphere": {...}}, ...]"#,
        ),
        (
            r#""objects": [{"group": {"name": "g", "objects": [], "transform": {"scale": 2}}}]"#,
            "transform: here stands an object",
            r#"write "transform": [{"translate": [x, y, z]}, ...]"#,
        ),
        (
            r#""objects": [{"group": {"name": "g", "objects": [], "transform": [{"scale": "big"}]}}]"#,
            "what is expected is a number or a list of length 3",
            "write \"scale\": 1",
        ),
        (r#""camera": 5"#, "`camera` is given twice", "keep one"),
        (
            r#""settings": {"fresnel": true}"#,
            "there is no fresnel",
            r#"one of "none", "schlick", "exact""#,
        ),
        (r#""name": 5"#, "the number 5", "write \"name\": \"...\""),
        (
            r#""settings": {"size": "320x240"}"#,
            "the text \"320x240\"",
            "write \"size\": [1, 1]",
        ),
    ] {
        assert_says(&said(rest), &[found, shape]);
    }
}

#[test]
fn a_csg_that_cannot_be_made_says_why_and_what_to_do() {
    let csg = |parts: &str| {
        said(&format!(
            r#""materials": {{"m": {{}}}}, "objects": [{{"csg": {{"name": "c", "material": "m", "op": "union", "parts": [{parts}]}}}}]"#
        ))
    };
    for (parts, what, cure) in [
        (
            r#"{"plane": {"name": "p", "point": [0, 0, 0], "normal": [0, 1, 0]}}"#,
            "the csg `c` has no end, since half-spaces",
            "intersect the whole with a solid that has an end",
        ),
        (
            r#"{"cone": {"name": "p", "base": [0, 0, 0], "top": [0, 1, 0], "radius": 1, "open": true}}"#,
            "has a cone without an inside as its part number 1",
            "leave out `open`",
        ),
        ("", "has a union of no parts", "give it at least one"),
    ] {
        assert_says(&csg(parts), &[what, cure]);
    }
}
