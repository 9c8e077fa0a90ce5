//! Light that is not there or cannot show.

use super::{LAMP, RED, ball, file, silent, warns, with};
use crate::from_text::read;

#[test]
fn nothing_shines() {
    let words = [
        "lights: ",
        "no light falls on `ball`",
        "\"position\": [0.3, 0.2, 5]",
    ];
    warns(&with("", &ball(RED)), "no-light", &words);
    let more = ball(RED).replace(
        "\"objects\": [",
        r#""objects": [{"plane": {"name": "floor", "material": "red",
"point": [0, -1, 0], "normal": [0, 1, 0]}}, "#,
    );
    warns(&with("", &more), "no-light", &["`floor` and 1 more"]);
    let shiny = ball(r#""specular": [1, 1, 1]"#);
    warns(&with("", &shiny), "no-light", &["`ball`"]);
    // Ambient light that no material sends back.
    let shut = ball(&format!(r#"{RED}, "ambient": [0, 0, 0]"#));
    warns(
        &with("", &format!(r#"{shut}, "ambient": [1, 1, 1]"#)),
        "no-light",
        &["`ball`"],
    );
    // What shines lights nothing by itself.
    let glowing = more.replace("\"objects\"", r#""objects_""#);
    assert!(read(&with("", &glowing)).is_err());
    let lamp = r#""materials": {"red": {"diffuse": [0.8, 0.1, 0.1]}, "glow": {"emission": [2, 2, 2]}}, "objects": [
{"sphere": {"name": "ball", "material": "red", "center": [0, 0, 0], "radius": 1}},
{"disc": {"name": "tube", "material": "glow", "center": [0, 2, 0], "normal": [0, -1, 0], "radius": 0.5}}]"#;
    warns(
        &with("", lamp),
        "no-light",
        &["{\"area\": {\"name\": \"lamp\", \"object\": \"tube\"}}"],
    );
    silent(&with(
        r#"{"area": {"name": "lamp", "object": "tube"}}"#,
        lamp,
    ));
}

#[test]
fn what_needs_no_light_may_have_none() {
    silent(&with(
        "",
        &format!(r#"{}, "ambient": [0.3, 0.3, 0.3]"#, ball(RED)),
    ));
    for material in [
        r#""mirror": [0.9, 0.9, 0.9]"#,
        r#""transmission": [1, 1, 1], "ior": 1.5, "specular": [0.5, 0.5, 0.5]"#,
        r#""emission": [1, 0, 0]"#,
        "",
    ] {
        silent(&with("", &ball(material)));
    }
}

#[test]
fn lights_without_strength_and_without_surfaces() {
    let off = LAMP.replace("[1, 1, 1]", "[0, 0, 0]");
    let both = format!("{off}, {}", LAMP.replace("\"lamp\"", "\"sun\""));
    let words = ["lights[0]: ", "`lamp` has no strength"];
    warns(&with(&both, &ball(RED)), "light-of-no-use", &words);
    for material in [
        r#""mirror": [0.9, 0.9, 0.9]"#,
        r#""emission": [1, 0, 0]"#,
        "",
    ] {
        warns(
            &file(&ball(material)),
            "light-of-no-use",
            &["lights: no object shows"],
        );
    }
    silent(&file(&ball(
        r#""mirror": [0.9, 0.9, 0.9], "specular": [1, 1, 1]"#,
    )));
    let checker = r#""checker": {"diffuse": [0.5, 0.5, 0.5], "size": 1}"#;
    silent(&file(&ball(checker)));
}

#[test]
fn an_object_shines_as_one_light_only() {
    let text = |lights: &str| {
        with(
            lights,
            r#""materials": {"e": {"emission": [1, 1, 1]}, "m": {"diffuse": [1, 1, 1]}}, "objects": [
{"quad": {"name": "p", "material": "e", "corner": [-0.5, 2, -0.5], "u": [1, 0, 0], "v": [0, 0, 1]}},
{"quad": {"name": "q", "material": "e", "corner": [2.5, 2, -0.5], "u": [1, 0, 0], "v": [0, 0, 1]}},
{"plane": {"name": "f", "material": "m", "point": [0, 0, 0], "normal": [0, 1, 0]}}]"#,
        )
    };
    let area = |name: &str, object: &str| {
        format!(r#"{{"area": {{"name": "{name}", "object": "{object}"}}}}"#)
    };
    let lights = |list: &[(&str, &str)]| {
        let all: Vec<String> = list.iter().map(|(n, o)| area(n, o)).collect();
        text(&all.join(", "))
    };
    for (list, place) in [
        (&[("a", "p"), ("b", "p")][..], "lights[1].area.object"),
        (
            &[("a", "p"), ("b", "q"), ("c", "q")],
            "lights[2].area.object",
        ),
        (
            &[("a", "p"), ("b", "q"), ("c", "p")],
            "`p` shines as `a` already",
        ),
    ] {
        let error = read(&lights(list)).expect_err("twice").to_string();
        assert!(
            error.contains(place) && error.contains("twice what it shows"),
            "{error}"
        );
    }
    silent(&lights(&[("a", "p"), ("b", "q")]));
}
