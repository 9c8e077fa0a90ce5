//! Values: colours above 1, sums above 1, angles in radians.

use super::{LAMP, RED, ball, file, silent, warns, with};

#[test]
fn colours_from_0_to_255() {
    let text = file(&ball(r#""diffuse": [204, 26, 26]"#));
    let words = ["materials.red.diffuse", "204 times", "[0.8, 0.102, 0.102]"];
    warns(&text, "share-above-one", &words);
    let text = file(&ball(r#""diffuse": [0.5, 1.2, 0]"#));
    warns(&text, "share-above-one", &["1.2 times", "from 0 to 1"]);
    let text = file(&ball(r#""specular": [255, 255, 255]"#));
    warns(&text, "share-above-one", &["red.specular", "[1, 1, 1]"]);
    let text = file(&ball(&format!(r#"{RED}, "ambient": [90, 0, 0]"#)));
    warns(&text, "share-above-one", &["red.ambient", "divide by 255"]);
    let checker = r#""checker": {"diffuse": [64, 64, 64], "size": 1}"#;
    let text = file(&ball(&format!("{RED}, {checker}")));
    warns(&text, "share-above-one", &["red.checker.diffuse"]);
    for shares in ["[1, 1, 1]", "[1, 0, 0.999]", "[0, 1.0000000001, 0]"] {
        silent(&file(&ball(&format!(r#""diffuse": {shares}"#))));
    }
}

#[test]
fn light_from_0_to_255() {
    let ball = ball(RED);
    for (field, from, to) in [
        ("background", "[0.2, 0.4, 0.6]", "[51, 102, 153]"),
        ("lights[0].point.intensity", "[1, 1, 1]", "[255, 255, 240]"),
    ] {
        let text = file(&ball).replace(from, to);
        warns(&text, "color-to-255", &[field, "divide by 255"]);
    }
    let text = file(&format!(r#"{ball}, "ambient": [20, 20, 25]"#));
    warns(&text, "color-to-255", &["ambient: "]);
    // What is weakened by distance, what is shown darker, what no painting program would write.
    let weak = r#""intensity": [80, 80, 80], "attenuation": [0, 0, 1]"#;
    silent(&with(
        &LAMP.replace(r#""intensity": [1, 1, 1]"#, weak),
        &ball,
    ));
    let dark = format!(r#"{ball}, "settings": {{"exposure": 0.01}}"#);
    silent(&file(&dark).replace("[0.2, 0.4, 0.6]", "[51, 102, 153]"));
    silent(&file(&ball).replace("[0.2, 0.4, 0.6]", "[20.5, 30, 40]"));
    silent(&file(&ball).replace("[0.2, 0.4, 0.6]", "[4, 5, 6]"));
}

#[test]
fn more_goes_out_than_comes_in() {
    let glass = r#""mirror": [1, 1, 1], "transmission": [1, 1, 1], "ior": 1.5"#;
    let words = ["materials.red", "is 2 in red", "Fresnel"];
    warns(&with("", &ball(glass)), "sum-above-one", &words);
    for (material, words) in [
        (
            r#""diffuse": [0.5, 0.7, 0.2], "mirror": [0.5, 0.5, 0.5]"#,
            "is 1.2 in green",
        ),
        (
            r#""diffuse": [0, 0, 0.3], "transmission": [0.1, 0.1, 0.8]"#,
            "is 1.1 in blue",
        ),
        (
            r#""diffuse": [0.1, 0, 0], "mirror": [0.4, 0, 0], "checker": {"diffuse": [0.7, 0, 0], "size": 1}"#,
            "is 1.1 in red",
        ),
    ] {
        warns(&with("", &ball(material)), "sum-above-one", &[words]);
    }
    for material in [
        r#""diffuse": [0.1, 0.2, 0.3], "mirror": [0.2, 0.1, 0.1], "transmission": [0.7, 0.7, 0.6]"#,
        r#""mirror": [0.5, 0, 0], "transmission": [0.5, 1, 1], "ior": 1.5"#,
        // A highlight is no share of all that comes in.
        r#""diffuse": [0.8, 0.8, 0.8], "specular": [0.9, 0.9, 0.9]"#,
    ] {
        let ambient = r#""ambient": [0.5, 0.5, 0.5]"#;
        silent(&with("", &format!("{}, {ambient}", ball(material))));
    }
}

#[test]
fn a_field_of_view_in_radians() {
    let fov = |degrees: &str| {
        file(&ball(RED)).replace(
            "\"vertical_fov\": 20",
            &format!("\"vertical_fov\": {degrees}"),
        )
    };
    let words = ["camera.vertical_fov", "0.7854 degrees", "in degrees: 45 "];
    warns(&fov("0.7854"), "angle-in-radians", &words);
    for (given, meant) in [
        ("1.0472", ": 60 "),
        ("0.9", ": 51.5662 "),
        ("3.1", ": 177.6"),
    ] {
        warns(&fov(given), "angle-in-radians", &[meant]);
    }
    for given in ["3.3", "4", "45", "57.3"] {
        silent(&fov(given));
    }
    // A telescope: all that there is fills the view.
    silent(&fov("1.5").replace("[0.3, 0.2, 5]", "[0, 0, 90]"));
    // So far away, but there is more around it than is in the view.
    let far = fov("0.5").replace("[0.3, 0.2, 5]", "[0, 0, 90]");
    warns(&far, "angle-in-radians", &["28.6479"]);
}

#[test]
fn a_cone_in_radians() {
    let spot = |angle: &str| {
        let light = r#"{"spot": {"name": "s", "position": [0, 0, 6], "look_at": [0, 0, 0], "intensity": [1, 1, 1],
"cone_angle": ANGLE}}"#;
        with(&light.replace("ANGLE", angle), &ball(RED))
    };
    let words = ["lights[0].spot.cone_angle", "in degrees: 30 "];
    warns(&spot("0.5236"), "angle-in-radians", &words);
    for angle in ["0.4", "1", "2.5", "3.1416"] {
        warns(&spot(angle), "angle-in-radians", &["looks like radians"]);
    }
    for angle in ["3.5", "30", "90", "180"] {
        silent(&spot(angle));
    }
}

#[test]
fn a_rotation_in_radians() {
    let turned = |degrees: &str| {
        let rotate = format!(
            r#""transform": [{{"rotate": {{"axis": [0, 1, 0], "degrees": {degrees}}}}}], "radius""#
        );
        file(&ball(RED).replace("\"radius\"", &rotate))
    };
    let words = [
        "objects[0].sphere.transform[0].rotate.degrees",
        "in degrees: 90 ",
    ];
    for quarter in ["1.5708", "1.57", "1.570796326794897"] {
        warns(&turned(quarter), "angle-in-radians", &words);
    }
    for (given, meant) in [("-0.785", ": -45 "), ("3.14", ": 180 "), ("0.524", ": 30 ")] {
        warns(&turned(given), "angle-in-radians", &[meant]);
    }
    for small in ["0", "1", "1.5", "2", "-3", "0.5", "0.25", "45", "157"] {
        silent(&turned(small));
    }
}
