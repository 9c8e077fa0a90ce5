//! Places: eye and lamps that are shut in, lights and cameras that miss everything.

use super::{LAMP, RED, ball, file, silent, warns, with};

/// Objects in red, with a lamp.
fn objects(list: &str) -> String {
    with(
        LAMP,
        &format!(
            r#""materials": {{"red": {{{RED}}}, "glass": {{"transmission": [1, 1, 1], "ior": 1.5}}}}, "objects": [{list}]"#
        ),
    )
}

/// A box around everything, lamp and eye, or of this size.
fn room(half: f64) -> String {
    objects(&format!(
        r#"{{"box": {{"name": "room", "material": "red", "min": [-{half}, -{half}, -{half}], "max": [{half}, {half}, {half}]}}}}"#
    ))
}

#[test]
fn the_eye_is_inside_of_something_opaque() {
    let inside = |text: &str| text.replace("[0.3, 0.2, 5]", "[0, 0, 0.5]");
    let text = inside(&file(&ball(RED)));
    let words = ["camera.eye", "inside of `ball`", "put a light into it"];
    warns(&text, "eye-inside", &words);
    let sun =
        r#"{"directional": {"name": "sun", "direction": [0, -1, -1], "intensity": [1, 1, 1]}}"#;
    warns(&inside(&with(sun, &ball(RED))), "eye-inside", &["`ball`"]);
    let mirror = r#""mirror": [0.9, 0.9, 0.9], "specular": [1, 1, 1]"#;
    warns(&inside(&file(&ball(mirror))), "eye-inside", &["`ball`"]);
    // A box, and a mesh turned inwards or outwards, are as dark.
    warns(&inside(&room(2.0)), "eye-inside", &["`room`"]);
    let turned = r#""transform": [{"rotate": {"axis": [1, 2, 3], "degrees": 40}}], "min""#;
    warns(
        &inside(&room(2.0)).replace("\"min\"", turned),
        "eye-inside",
        &["`room`"],
    );
    // A room with a lamp in it, an eye outside, an eye in glass, a ball that shines.
    silent(&room(9.0));
    silent(&file(&ball(RED)));
    silent(&inside(&file(&ball(&format!(
        r#"{RED}, "transmission": [0.1, 0.1, 0.1], "ior": 1.5"#
    )))));
    silent(&inside(&file(&ball(&format!(
        r#"{RED}, "emission": [1, 1, 1]"#
    )))));
    // Without any light there may be ambient light.
    silent(&inside(&with(
        "",
        &format!(r#"{}, "ambient": [1, 1, 1]"#, ball(RED)),
    )));
}

#[test]
fn a_lamp_is_inside_of_something_opaque() {
    let at = |position: &str| file(&ball(RED)).replace("[3, 4, 5]", position);
    let words = ["lights[0]", "`lamp` is inside of `ball`", "area light"];
    warns(&at("[0, 0, 0]"), "lamp-inside", &words);
    warns(&at("[0, 0.9, 0.1]"), "lamp-inside", &["`ball`"]);
    let spot = r#"{"spot": {"name": "spot", "position": [0, 0, 0.5], "look_at": [0, 0, 9], "intensity": [1, 1, 1],
"cone_angle": 80}}"#;
    warns(
        &with(&format!("{LAMP}, {spot}"), &ball(RED)),
        "lamp-inside",
        &["lights[1]", "`spot`"],
    );
    silent(&at("[0, 1.1, 0]"));
    silent(&at("[0, 0, 0]").replace(
        RED,
        &format!(r#"{RED}, "transmission": [0.1, 0.1, 0.1], "ior": 1.5"#),
    ));
    // In an open bowl.
    let bowl = r#"{"disc": {"name": "d", "material": "red", "center": [0, 0, 0], "normal": [0, 0, 1], "radius": 1}}"#;
    silent(&objects(bowl));
}

#[test]
fn nothing_is_in_the_picture() {
    let looking = |at: &str| {
        file(&ball(RED)).replace("\"look_at\": [0, 0, 0]", &format!("\"look_at\": {at}"))
    };
    let words = ["camera: ", "background alone", "\"look_at\": [0, 0, 0]"];
    for at in ["[0, 0, 9]", "[9, 0, 0]", "[0, 5, 1]"] {
        warns(&looking(at), "nothing-in-view", &words);
    }
    let floor = r#"{"plane": {"name": "floor", "material": "red", "point": [0, -1, 0], "normal": [0, 1, 0]}}"#;
    warns(
        &objects(floor).replace("[0, 0, 0]", "[0, 9, 0]"),
        "nothing-in-view",
        &["turn the camera"],
    );
    silent(&objects(floor));
    // At the very edge it can not be told.
    for at in ["[0, 0, 0]", "[1.5, 0, 0]", "[0, 1.4, 0]"] {
        silent(&looking(at));
    }
}

#[test]
fn a_spot_light_misses_everything() {
    let spot = |at: &str, angle: u32| {
        let light = format!(
            r#"{{"spot": {{"name": "spot", "position": [0, 6, 0], "look_at": {at}, "intensity": [1, 1, 1],
"cone_angle": {angle}}}}}"#
        );
        with(&light, &ball(RED))
    };
    let words = [
        "lights[0].spot",
        "in the cone of light `spot`",
        "cone_angle",
    ];
    for (at, angle) in [("[0, 9, 0]", 30), ("[6, 6, 0]", 60), ("[4, 0, 0]", 10)] {
        warns(&spot(at, angle), "light-of-no-use", &words);
    }
    for (at, angle) in [
        ("[0, 0, 0]", 30),
        ("[6, 6, 0]", 89),
        ("[0, 9, 0]", 175),
        ("[2, 0, 0]", 12),
    ] {
        silent(&spot(at, angle));
    }
    // An endless floor is in every cone that looks down.
    let floor = ball(RED).replace(
        "\"objects\": [",
        r#""objects": [{"plane": {"name": "floor", "material": "red",
"point": [0, -1, 0], "normal": [0, 1, 0]}}, "#,
    );
    let floored = |at: &str, angle| spot(at, angle).replace(&ball(RED), &floor);
    silent(&floored("[4, 0, 0]", 10));
    warns(&floored("[4, 9, 0]", 10), "light-of-no-use", &["`spot`"]);
}

#[test]
fn a_light_is_behind_a_floor() {
    let scene = |light: &str, floor: &str| {
        let floor = format!(
            r#""objects": [{{"plane": {{"name": "floor", "material": "{floor}", "point": [0, -1, 0], "normal": [0, 1, 0]}}}}, "#
        );
        let glow = r#""materials": {"tin": {"mirror": [0.5, 0.5, 0.5]}, "water": {"transmission": [1, 1, 1], "ior": 1.33}, "#;
        let text = with(light, &ball(RED)).replace("\"objects\": [", &floor);
        text.replace("\"materials\": {", glow)
    };
    let below = LAMP.replace("[3, 4, 5]", "[3, -4, 5]");
    let words = [
        "lights[0]",
        "`lamp` is behind the plane `floor`",
        "the eye's side",
    ];
    warns(&scene(&below, "red"), "light-of-no-use", &words);
    warns(&scene(&below, "tin"), "light-of-no-use", &["`floor`"]);
    let sun =
        r#"{"directional": {"name": "sun", "direction": [0, 1, -1], "intensity": [1, 1, 1]}}"#;
    warns(&scene(sun, "red"), "light-of-no-use", &["`sun`"]);
    silent(&scene(LAMP, "red"));
    silent(&scene(&sun.replace("[0, 1, -1]", "[0, -1, -1]"), "red"));
    // Both below: the floor is a ceiling.
    silent(&scene(&below, "red").replace("[0.3, 0.2, 5]", "[0.3, -4, 5]"));
    // Through water the lamp's side can be seen. (There is no floor in the pool: that is told.)
    warns(&scene(&below, "water"), "open-body", &["`floor`"]);
}
