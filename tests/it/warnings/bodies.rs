//! Surfaces: normals against the winding, bodies that are inside out, mixed or open.

use raytree::scene::load_from_memory;

use super::{all, file, one, silent, warns, with};

/// A triangle that faces the eye, with these corner normals.
fn triangle(normals: &str) -> String {
    file(&format!(
        r#""materials": {{"m": {{"diffuse": [1, 1, 1]}}}}, "objects": [{{"triangle": {{"name": "t", "material": "m",
"corners": [[-1, -1, 0], [1, -1, 0], [0, 1, 0]], "normals": {normals}}}}}]"#
    ))
}

#[test]
fn corner_normals_on_the_back() {
    let against = "[[0.4, 0, -1], [-0.4, 0, -1], [0, 0.4, -1]]";
    let words = [
        "objects[0].triangle",
        "object `t`: 1 of 1",
        "on their back",
        "counter-clockwise",
    ];
    warns(&triangle(against), "normals-against-winding", &words);
    silent(&triangle("[[0.4, 0, 1], [-0.4, 0, 1], [0, 0.4, 1]]"));
    // At a silhouette a corner may lean over.
    silent(&triangle("[[0.4, 0, 1], [-1, 0, -0.1], [0, 0.4, 1]]"));
    // A mirror turns both.
    let mirrored = |normals: &str| {
        let scale = r#""transform": [{"scale": [-1, 1, 1]}], "normals""#;
        triangle(normals).replace("\"normals\"", scale)
    };
    silent(&mirrored("[[0.4, 0, 1], [-0.4, 0, 1], [0, 0.4, 1]]"));
    warns(&mirrored(against), "normals-against-winding", &["1 of 1"]);
}

#[test]
fn corner_normals_of_part_of_a_mesh() {
    let mesh = |triangles: &str| {
        file(&format!(
            r#""materials": {{"m": {{"diffuse": [1, 1, 1]}}}}, "objects": [{{"mesh": {{"name": "sheet", "material": "m",
"vertices": [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]],
"normals": [[-0.1, 0, 1], [0.1, 0, 1], [0.1, 0, 1], [-0.1, 0, 1]], "triangles": [{triangles}]}}}}]"#
        ))
    };
    silent(&mesh("[0, 1, 2], [0, 2, 3]"));
    let words = ["`sheet`: 1 of 2", "the first is number 1"];
    warns(
        &mesh("[0, 1, 2], [0, 3, 2]"),
        "normals-against-winding",
        &words,
    );
    warns(
        &mesh("[0, 2, 1], [0, 3, 2]"),
        "normals-against-winding",
        &["2 of 2"],
    );
}

/// The faces of a block, as in the file of a student: wound inwards.
const INWARDS: &str = "[2, 3, 1], [2, 1, 0], [5, 7, 6], [5, 6, 4], [1, 5, 4], [1, 4, 0], [6, 7, 3], [6, 3, 2], [4, 6, 2], \
                       [4, 2, 0], [3, 7, 5], [3, 5, 1]";

/// Those faces, each turned over.
fn outwards() -> String {
    let turned = INWARDS.split("], [").map(|face| {
        let corners: Vec<&str> = face.trim_matches(['[', ']']).split(", ").collect();
        format!("[{}, {}, {}]", corners[0], corners[2], corners[1])
    });
    turned.collect::<Vec<_>>().join(", ")
}

/// The corners of a block of this half size around x.
fn corners(x: f64, half: f64) -> String {
    let ends = [-half, half];
    let all = ends
        .iter()
        .flat_map(|a| ends.iter().flat_map(move |b| ends.map(|c| (*a, *b, c))));
    let texts = all.map(|(a, b, c)| format!("[{}, {b}, {c}]", x + a));
    texts.collect::<Vec<_>>().join(", ")
}

/// The faces with their numbers raised by 8: of the second block of a mesh.
fn second(faces: &str) -> String {
    let raised = faces.split("], [").map(|face| {
        let corners = face.trim_matches(['[', ']']).split(", ");
        let raised = corners.map(|n| (n.parse::<u32>().expect("a number") + 8).to_string());
        format!("[{}]", raised.collect::<Vec<_>>().join(", "))
    });
    raised.collect::<Vec<_>>().join(", ")
}

/// A glass mesh, in ambient light so that nothing else is strange.
fn glass(vertices: &str, triangles: &str) -> String {
    with(
        "",
        &format!(
            r#""materials": {{"glass": {{"transmission": [1, 1, 1], "ior": 1.5}}}}, "objects": [{{"mesh": {{
"name": "block", "material": "glass", "vertices": [{vertices}], "triangles": [{triangles}]}}}}]"#
        ),
    )
}

#[test]
fn a_closed_glass_body_is_inside_out() {
    let block = corners(0.0, 1.0);
    let words = [
        "`block` is transparent (index 1.5)",
        "inside out: 1 of its 1",
        "flip normals",
    ];
    warns(&glass(&block, INWARDS), "inside-out", &words);
    silent(&glass(&block, &outwards()));
    // What does not refract, and what is opaque, has no inside that matters.
    silent(&glass(&block, INWARDS).replace("\"ior\": 1.5", "\"ior\": 1"));
    let matt = glass(&block, INWARDS).replace("\"transmission\"", "\"diffuse\"");
    silent(&format!(
        "{}, \"ambient\": [1, 1, 1]}}",
        &matt[..matt.len() - 1]
    ));
    // A mirror turns the corners with it.
    let mirrored = |faces: &str| {
        let scale = r#""transform": [{"scale": [1, 1, -2]}], "vertices""#;
        glass(&block, faces).replace("\"vertices\"", scale)
    };
    warns(&mirrored(INWARDS), "inside-out", &["1 of its 1"]);
    silent(&mirrored(&outwards()));
}

#[test]
fn of_several_parts_one_is_inside_out() {
    let beside = format!("{}, {}", corners(-1.5, 1.0), corners(1.5, 1.0));
    let (inwards, outwards) = (INWARDS, outwards());
    let faces = |a: &str, b: &str| format!("{a}, {}", second(b));
    warns(
        &glass(&beside, &faces(&outwards, inwards)),
        "inside-out",
        &["1 of its 2"],
    );
    warns(
        &glass(&beside, &faces(inwards, inwards)),
        "inside-out",
        &["2 of its 2"],
    );
    silent(&glass(&beside, &faces(&outwards, &outwards)));
    // A hole in a block: what is turned inwards there is right.
    let hollow = format!("{}, {}", corners(0.0, 1.0), corners(0.0, 0.5));
    silent(&glass(&hollow, &faces(&outwards, inwards)));
    warns(
        &glass(&hollow, &faces(inwards, &outwards)),
        "inside-out",
        &["1 of its 2"],
    );
}

#[test]
fn faces_that_run_both_ways_and_holes() {
    let block = corners(0.0, 1.0);
    let faces = outwards();
    let one_turned = faces.replace("[2, 1, 3]", "[2, 3, 1]");
    assert_ne!(one_turned, faces);
    let words = ["both ways: at 3 edges", "recalculate normals"];
    warns(&glass(&block, &one_turned), "mixed-winding", &words);
    let side_turned = one_turned.replace("[2, 0, 1]", "[2, 1, 0]");
    warns(
        &glass(&block, &side_turned),
        "mixed-winding",
        &["at 4 edges"],
    );
    let hole = faces.replace("[2, 1, 3], ", "");
    warns(
        &glass(&block, &hole),
        "open-body",
        &["3 edges have a face on one side only", "close it"],
    );
    let lid = hole.replace("[2, 0, 1], ", "");
    warns(&glass(&block, &lid), "open-body", &["4 edges"]);
    silent(&glass(&block, &lid).replace("\"ior\": 1.5", "\"ior\": 1"));
}

#[test]
fn a_lone_pane_is_open_and_the_surface_of_a_pool_is_not() {
    let pane = |floor: &str| {
        with(
            "",
            &format!(
                r#""ambient": [1, 1, 1], "materials": {{"glass": {{"transmission": [1, 1, 1], "ior": 1.5}},
"red": {{"diffuse": [0.8, 0.1, 0.1]}}}}, "objects": [{{"quad": {{"name": "pane", "material": "glass",
"corner": [-1, -1, 0], "u": [2, 0, 0], "v": [0, 2, 0]}}}}{floor}]"#
            ),
        )
    };
    warns(
        &pane(""),
        "open-body",
        &["`pane`", "flat", "box for a pane"],
    );
    let disc = pane("").replace(r#""quad""#, r#""disc""#);
    let disc = disc.replace(
        r#""corner": [-1, -1, 0], "u": [2, 0, 0], "v": [0, 2, 0]"#,
        r#""center": [0, 0, 0], "normal": [0, 0, 1], "radius": 2"#,
    );
    warns(&disc, "open-body", &["`pane`"]);
    let plane = disc.replace(r#""disc""#, r#""plane""#);
    let plane = plane.replace(
        r#""center": [0, 0, 0], "normal": [0, 0, 1], "radius": 2"#,
        r#""point": [0, 0, 0], "normal": [0, 0, 1]"#,
    );
    warns(&plane, "open-body", &["`pane`"]);
    let floor = r#", {"plane": {"name": "floor", "material": "red", "point": [0, 0, -2], "normal": [0, 0, 1]}}"#;
    silent(&pane(floor));
    silent(&pane("").replace("\"ior\": 1.5", "\"ior\": 1"));
    // A floor on the wrong side.
    warns(&pane(&floor.replace("-2]", "9]")), "open-body", &["`pane`"]);
}

#[test]
fn a_model_of_a_file_is_inside_out() {
    let model = "v -1 -1 -1\nv -1 -1 1\nv -1 1 -1\nv -1 1 1\nv 1 -1 -1\nv 1 -1 1\nv 1 1 -1\nv 1 1 1\n\
f 3 4 2 1\nf 6 8 7 5\nf 2 6 5 1\nf 7 8 4 3\nf 5 7 3 1\nf 4 8 6 2\n";
    let text = with(
        "",
        r#""materials": {"glass": {"transmission": [1, 1, 1], "ior": 1.5}},
"objects": [{"obj": {"name": "block", "file": "block.obj", "material": "glass"}}]"#,
    );
    let files = [("a.json", text.as_str()), ("block.obj", model)];
    let files = files.map(|(name, text)| (name.to_owned(), text.as_bytes().to_vec()));
    let scene = load_from_memory("a.json", files.into()).expect("a scene");
    one(&all(scene), "inside-out", &["`block`"]);
}

/// Two balls of glass and water at these places of the x axis, with these radii, and a priority of the glass.
fn balls(at: [f64; 2], radii: [f64; 2], priority: i32) -> String {
    let ([a, b], [r, s]) = (at, radii);
    file(&format!(
        r#""materials": {{"glass": {{"diffuse": [0.1, 0.1, 0.1], "transmission": [0.9, 0.9, 0.9], "ior": 1.5, "priority": {priority}}},
"water": {{"diffuse": [0.1, 0.1, 0.1], "transmission": [0.9, 0.9, 0.9], "ior": 1.33}}}}, "objects": [
{{"sphere": {{"name": "a", "material": "glass", "center": [{a}, 0, 0], "radius": {r}}}}},
{{"sphere": {{"name": "b", "material": "water", "center": [{b}, 0, 0], "radius": {s}}}}}]"#
    ))
}

#[test]
fn equal_priorities_where_bodies_overlap_in_part() {
    let words = ["`a` and `b`", "priority"];
    for (at, radii) in [([-0.4, 0.4], [0.6, 0.6]), ([0.0, 0.5], [0.6, 0.3])] {
        warns(&balls(at, radii, 0), "equal-priority", &words);
        silent(&balls(at, radii, 1));
    }
    // One inside of the other, two in the same place, and two apart.
    silent(&balls([0.0, 0.1], [0.6, 0.3], 0));
    silent(&balls([0.0, 0.0], [0.6, 0.6], 0));
    silent(&balls([-0.5, 0.5], [0.3, 0.3], 0));
    // All of one material: whichever it is, light is bent alike.
    silent(&balls([-0.4, 0.4], [0.6, 0.6], 0).replace("\"water\",", "\"glass\","));
}

#[test]
fn a_part_that_nothing_uses() {
    let parts = r#""parts": {"a": [], "b": []}, "#;
    let used = r#"{"use": {"name": "u", "part": "a"}}, {"sphere""#;
    let ball = super::ball(super::RED).replace(r#"{"sphere""#, used);
    let text = super::file(&format!("{parts}{ball}"));
    super::warns(
        &text,
        "unused-part",
        &["parts.b", "nothing uses the part `b`"],
    );
    super::silent(&text.replace(r#", "b": []"#, ""));
}
