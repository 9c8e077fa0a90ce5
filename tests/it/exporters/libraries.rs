//! The line `mtllib`: no file outside of the folder is opened, and the model is drawn.

use super::{GREY, RED, SQUARE, drawn, matt};

const PAINT: &[u8] = b"newmtl paint\nKd 1 0 0\n";
const OTHER: &[u8] = b"newmtl other\nKd 0 1 0\n";
const LACKS: &str = "m.obj:2 missing-material";
const MISSING: &str = "m.obj:1 missing-library";

#[track_caller]
fn with(line: &str, beside: &[(&str, &[u8])], radiance: [f64; 3], told: &[&str]) {
    let model = format!("{line}\nusemtl paint\n{SQUARE}");
    let mut files = vec![("m.obj", model.as_bytes())];
    files.extend(beside);
    drawn(&files, matt(radiance), told);
}

#[test]
fn several_libraries_in_a_line() {
    let both = [("a.mtl", OTHER), ("b.mtl", PAINT)];
    with("mtllib a.mtl b.mtl", &both, RED, &[]);
    with("mtllib b.mtl a.mtl # two", &both, RED, &[]);
    with("mtllib a.mtl \\\n  b.mtl", &both, RED, &[]);
    with("mtllib\ta.mtl\tb.mtl", &both, RED, &[]);
    with("mtllib c.mtl b.mtl", &both, RED, &[MISSING]);
    with("mtllib a.mtl c.mtl", &both, GREY, &[MISSING, LACKS]);
    with("mtllib", &both, GREY, &[MISSING, LACKS]);
    // One name with blanks in it comes before several.
    let blanks = [("a.mtl b.mtl", PAINT), ("a.mtl", OTHER)];
    with("mtllib a.mtl b.mtl", &blanks, RED, &[]);
    with(
        "mtllib \"my paints.mtl\"",
        &[("my paints.mtl", PAINT)],
        RED,
        &[],
    );
    // The first of two descriptions counts.
    with(
        "mtllib b.mtl c.mtl",
        &[("b.mtl", PAINT), ("c.mtl", b"newmtl paint\nKd 0 1 0\n")],
        RED,
        &[],
    );
}

#[test]
fn paths_of_another_computer() {
    let missing = [MISSING, LACKS];
    let beside = [("door.mtl", PAINT)];
    let below = [("paints/door.mtl", PAINT)];
    for path in [
        ".\\paints\\door.mtl",
        "paints\\door.mtl",
        "./paints/door.mtl",
    ] {
        with(&format!("mtllib {path}"), &[], GREY, &missing);
        with(&format!("mtllib {path}"), &below, RED, &[]);
        with(
            &format!("mtllib {path}"),
            &beside,
            RED,
            &["m.obj:1 library-path"],
        );
    }
    for path in [
        "C:\\My Work\\door.mtl",
        "/home/me/door.mtl",
        "../door.mtl",
        "a/../../door.mtl",
        "\\\\server\\door.mtl",
    ] {
        with(&format!("mtllib {path}"), &[], GREY, &missing);
        with(
            &format!("mtllib {path}"),
            &beside,
            RED,
            &["m.obj:1 library-path"],
        );
    }
    for path in ["/etc/passwd", "..", "/", "../", "\u{0}.mtl"] {
        with(&format!("mtllib {path}"), &beside, GREY, &missing);
    }
}

#[test]
fn no_library() {
    with("# nothing", &[], GREY, &[LACKS]);
    with("# nothing", &[("m.mtl", PAINT)], GREY, &[LACKS]);
    with("mtllib m.mtl", &[], GREY, &[MISSING, LACKS]);
    with("mtllib m.mtl", &[("m.mtl", b"")], GREY, &[LACKS]);
    // A material that no face has is not missed.
    let text = format!("usemtl other\n{SQUARE}usemtl unused\n");
    drawn(
        &[("m.obj", text.as_bytes())],
        matt(GREY),
        &["m.obj:1 missing-material"],
    );
}

#[test]
fn a_library_named_again_is_read_once() {
    with(
        "mtllib m.mtl\nmtllib m.mtl\nmtllib x.mtl\nmtllib x.mtl",
        &[("m.mtl", PAINT)],
        RED,
        &["m.obj:3 missing-library"],
    );
}
