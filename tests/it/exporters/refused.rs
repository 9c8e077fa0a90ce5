//! What is refused: broken points, indices of no point, and what draws nothing; with file, line and cure.

use super::{CORNERS, SQUARE, read};

#[track_caller]
fn refused(text: &str, place: &str, word: &str) {
    let said = read(&[("m.obj", text.as_bytes())]).expect_err(text);
    assert_eq!(said.lines().count(), 2, "{said}");
    assert!(
        said.starts_with(place) && said.contains(word),
        "{text}{said}"
    );
}

#[test]
fn broken_points() {
    for point in [
        "v nan 0 0",
        "v 0 inf 0",
        "v 0 0 1e13",
        "v 0 0",
        "v",
        "v 0,5 0 0",
        "v 1 2 z",
        "v 0 0 1e999",
    ] {
        refused(&format!("{CORNERS}{point}\nf 1 2 3\n"), "m.obj:5: ", "`v`");
    }
}

#[test]
fn corners_that_name_no_point() {
    for corner in [
        "0",
        "5",
        "-5",
        "x",
        "1.5",
        "-0",
        "99999999999",
        "-9223372036854775808",
        "99999999999999999999",
        "/1",
        "//",
        "/",
    ] {
        refused(&format!("{CORNERS}f 1 2 {corner}\n"), "m.obj:5: ", corner);
    }
    // Backwards from the points so far, whatever comes later.
    refused(&format!("v 0 0 0\nf -1 -2 1\n{CORNERS}"), "m.obj:2: ", "-2");
    refused("f 1 2 3\n", "m.obj:1: ", "there are 0");
    // The first mistake counts.
    refused(
        &format!("{CORNERS}f 1 2 9\nv nan 0 0\n"),
        "m.obj:5: ",
        "`9`",
    );
    refused("v nan 0 0\nv 0 0 0\nf 1 2 3 4 5\n", "m.obj:1: ", "nan");
}

#[test]
fn what_draws_nothing() {
    for text in [
        "",
        "\n",
        CORNERS,
        "hello\n",
        "v 0 0 0\nf 1 1\n",
        "\u{0}\u{1}",
        "l 1 2\n",
    ] {
        refused(text, "m.obj: there is no face", "f a b c");
    }
    refused(
        "v 0 0 0\nf 1 1 1\n",
        "m.obj: all of its triangles",
        "without area",
    );
    assert!(read(&[("m.obj", SQUARE.as_bytes())]).is_ok());
}
