//! Parts that cannot be used: each is told where, what and what to do.

use super::{BALL, assert_says, refused, scene};

/// What is said about these parts and objects.
fn said(parts: &str, objects: &str) -> String {
    let rest = format!(r#", "parts": {{{parts}}}, "objects": [{objects}]"#);
    refused(scene(&rest).as_bytes())
}

fn used(name: &str, part: &str) -> String {
    format!(r#"{{"use": {{"name": "{name}", "part": "{part}"}}}}"#)
}

#[test]
fn a_part_that_is_not_there() {
    let ball = format!("\"wheel\": [{BALL}]");
    let message = said(&ball, &used("a", "whel"));
    let words = [
        "objects[0].use.part: there is no part `whel`",
        "did you mean `wheel`?",
    ];
    assert_says(&message, &words);
    let message = said(&ball, &used("a", "door"));
    assert_says(&message, &["or use one of: wheel"]);
    let message = said("", &used("a", "door"));
    assert_says(&message, &["describe it: \"parts\": {\"door\": [...]}"]);
}

#[test]
fn a_part_that_uses_itself() {
    let message = said(
        &format!("\"a\": [{BALL}, {}]", used("x", "a")),
        &used("u", "a"),
    );
    let words = [
        "parts.a[1].use.part: the part `a` uses itself: a uses a",
        "take the use out",
    ];
    assert_says(&message, &words);
    let chain = format!("\"a\": [{}], \"b\": [{}]", used("x", "b"), used("y", "a"));
    let message = said(&chain, &used("u", "b"));
    assert_says(&message, &["uses itself: b uses a uses b"]);
}

#[test]
fn an_error_in_a_part_is_where_it_stands() {
    let bad = BALL.replace("\"radius\": 1", "\"radius\": -1");
    let message = said(&format!("\"a\": [{BALL}, {bad}]"), &used("u", "a"));
    assert_says(&message, &["parts.a[1].sphere.radius", "-1"]);
    let flat = r#"{"use": {"name": "u", "part": "a", "transform": [{"scale": [1, 0, 1]}]}}"#;
    let message = said(&format!("\"a\": [{BALL}]"), flat);
    assert_says(&message, &["objects[0].use.transform", "make no factor 0"]);
    let twice = format!("{}, {}", used("u", "a"), used("u", "a"));
    let message = said(&format!("\"a\": [{BALL}]"), &twice);
    assert_says(&message, &["two objects named `u/ball`"]);
}

#[test]
fn parts_that_double_are_refused_at_once() {
    let mut parts = vec![format!("\"p0\": [{BALL}]")];
    for i in 1..32 {
        let below = format!("p{}", i - 1);
        parts.push(format!(
            "\"p{i}\": [{}, {}]",
            used("a", &below),
            used("b", &below)
        ));
    }
    let message = said(&parts.join(","), &used("u", "p31"));
    assert_says(
        &message,
        &["place more than 200000 objects and groups", "less often"],
    );
    // Without any shape in them as well.
    let empty = parts.join(",").replace(BALL, "");
    let message = said(&empty, &used("u", "p31"));
    assert_says(&message, &["place more than 200000 objects and groups"]);
}
