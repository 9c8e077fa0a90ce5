//! Values and names that a scene cannot have.

use super::{BALL, assert_says, loaded, refused, scene, sphere};

#[test]
fn up_parallel_to_view() {
    let text = scene("").replace("\"look_at\"", "\"up\": [0, 0, -2], \"look_at\"");
    assert_says(
        &refused(text.as_bytes()),
        &["camera.up", "parallel", "choose another"],
    );
}

#[test]
fn camera_that_cannot_see() {
    let text = scene("").replace("[0, 0, 5]", "[0, 0, 0]");
    assert_says(
        &refused(text.as_bytes()),
        &["camera", "the same point", "move one"],
    );
    for fov in ["0", "180", "-3"] {
        let text = scene("").replace(
            "\"look_at\"",
            &format!("\"vertical_fov\": {fov}, \"look_at\""),
        );
        assert_says(
            &refused(text.as_bytes()),
            &["camera.vertical_fov", "between 0 and 180"],
        );
    }
    let text = scene("").replace("\"look_at\"", "\"up\": [0, 0, 0], \"look_at\"");
    assert_says(&refused(text.as_bytes()), &["camera.up", "no direction"]);
}

#[test]
fn numbers_out_of_range() {
    let ball = r#""center": [0, 0, 0], "radius": "#;
    for radius in ["0", "-1"] {
        let text = sphere(&format!("{ball}{radius}"));
        assert_says(
            &refused(text.as_bytes()),
            &["objects[0].sphere.radius", "above 0"],
        );
    }
    for (field, place) in [
        (r#""ior": 0"#, "materials.red.ior"),
        (r#""diffuse": [0, -1, 0]"#, "materials.red.diffuse[1]"),
        (r#""mirror": [2, 0, 0]"#, "materials.red.mirror[0]"),
        (r#""shininess": -1"#, "materials.red.shininess"),
        (
            r#""checker": {"diffuse": [0, 0, 0], "size": 0}"#,
            "materials.red.checker.size",
        ),
    ] {
        let text = scene("").replace(r#""diffuse": [1, 0, 0]"#, field);
        assert_says(&refused(text.as_bytes()), &[place, "write a number"]);
    }
    for (field, place) in [
        (r#""size": [0, 0]"#, "settings.size"),
        (r#""size": [1000000, 1000000]"#, "settings.size"),
        (r#""samples": 0"#, "settings.samples"),
        (r#""samples": 4000000000"#, "settings.samples"),
        (r#""exposure": -1"#, "settings.exposure"),
        (r#""depth": -1"#, "settings.depth"),
    ] {
        let text = scene(&format!(r#", "settings": {{{field}}}"#));
        assert_says(&refused(text.as_bytes()), &[place]);
    }
    for light in [
        r#"{"point": {"name": "l", "position": [0, 0, 0], "intensity": [1, 1, 1], "attenuation": [0, 0, 0]}}"#,
        r#"{"directional": {"name": "l", "direction": [0, 0, 0], "intensity": [1, 1, 1]}}"#,
        r#"{"spot": {"name": "l", "position": [0, 0, 0], "look_at": [0, 0, 0], "intensity": [1, 1, 1], "cone_angle": 9}}"#,
    ] {
        let text = scene(&format!(r#", "lights": [{light}]"#));
        assert_says(&refused(text.as_bytes()), &["lights[0]."]);
    }
}

#[test]
fn box_inside_out() {
    let message = loaded(
        r#"{"box": {"name": "b", "material": "red", "min": [0, 1, 0], "max": [1, 1, 1]}}"#,
        &[],
    );
    assert_says(
        &message.expect_err("flat"),
        &["objects[0].box", "along y", "smaller"],
    );
}

#[test]
fn flattening_transform() {
    let text = sphere(r#""center": [0, 0, 0], "radius": 1, "transform": [{"scale": [1, 0, 1]}]"#);
    assert_says(
        &refused(text.as_bytes()),
        &["objects[0].sphere.transform", "flat"],
    );
    let text = sphere(r#""center": [0, 0, 0], "radius": 1, "transform": [{"scale": "x"}]"#);
    assert_says(
        &refused(text.as_bytes()),
        &["transform[0].scale", "a number or a list"],
    );
}

#[test]
fn an_object_too_far_away_after_its_transform() {
    let text = sphere(
        r#""center": [9, 0, 0], "radius": 1, "transform": [{"scale": 1e11}, {"scale": 1e11}]"#,
    );
    assert_says(
        &refused(text.as_bytes()),
        &["objects[0].sphere", "1e12 metres"],
    );
}

#[test]
fn duplicate_names() {
    let message = loaded(&format!("{BALL}, {BALL}"), &[]).expect_err("twice");
    assert_says(
        &message,
        &[
            "objects[1].sphere.name",
            "two objects named `ball`",
            "different name",
        ],
    );
    let light =
        r#"{"directional": {"name": "sun", "direction": [0, 1, 0], "intensity": [1, 1, 1]}}"#;
    let text = scene(&format!(r#", "lights": [{light}, {light}]"#));
    assert_says(
        &refused(text.as_bytes()),
        &["lights[1].directional.name", "two lights named `sun`"],
    );
}

#[test]
fn unknown_material() {
    let message = loaded(&BALL.replace("\"red\"", "\"rad\""), &[]).expect_err("unknown");
    assert_says(
        &message,
        &[
            "objects[0].sphere.material",
            "no material `rad`",
            "did you mean `red`?",
        ],
    );
}

#[test]
fn names_cannot_steer_the_terminal() {
    let message = loaded(&BALL.replace("\"ball\"", r#""\u001b[2J""#), &[]).expect_err("bad name");
    assert_says(&message, &["objects[0].sphere.name", "control character"]);
}

#[test]
fn mesh_with_bad_indices() {
    let mesh = |triangles: &str, more: &str| {
        let mesh = format!(
            r#"{{"mesh": {{"name": "m", "material": "red", "vertices": [[0,0,0],[1,0,0],[0,1,0]],
            "triangles": [{triangles}]{more}}}}}"#
        );
        loaded(&mesh, &[])
    };
    assert!(mesh("[0, 1, 2]", "").is_ok());
    let message = mesh("[0, 1, 3]", "").expect_err("3 of 3");
    assert_says(
        &message,
        &[
            "objects[0].mesh.triangles[0][2]",
            "no vertex 3",
            "counted from 0",
        ],
    );
    assert!(mesh("[0, 1, -1]", "").is_err());
    let message = mesh("[0, 1, 2]", r#", "normals": [[0, 0, 1]]"#).expect_err("1 of 3");
    assert_says(
        &message,
        &["objects[0].mesh.normals", "1 normals for 3 vertices"],
    );
}

#[test]
fn shadings_that_are_none() {
    let mesh = |shading: &str| {
        let mesh = format!(
            r#"{{"mesh": {{"name": "m", "material": "red", "vertices": [[0,0,0],[1,0,0],[0,1,0]],
            "triangles": [[0, 1, 2]], "shading": {shading}}}}}"#
        );
        loaded(&mesh, &[])
    };
    for word in ["flat", "gouraud", "phong"] {
        assert!(mesh(&format!("\"{word}\"")).is_ok(), "{word}");
    }
    for bad in ["\"gourad\"", "3", "[]"] {
        let message = mesh(bad).expect_err(bad);
        assert_says(&message, &["objects[0].mesh.shading", "flat"]);
    }
    let holed = r#"{"polygon": {"name": "p", "material": "red", "shading": "gouraud",
        "points": [[0,0,0],[3,0,0],[3,3,0],[0,3,0]], "holes": [[[1,1,0],[2,1,0],[1,2,0]]]}}"#;
    let message = loaded(holed, &[]).expect_err("it has a hole");
    assert_says(
        &message,
        &["objects[0].polygon.shading", "holes", "mesh of triangles"],
    );
    assert!(loaded(&holed.replace("gouraud", "flat"), &[]).is_ok());
    // A ball has no corners.
    let ball = BALL.replace("\"radius\"", "\"shading\": \"flat\", \"radius\"");
    assert_says(&loaded(&ball, &[]).expect_err("a ball"), &["shading"]);
}

#[test]
fn zero_area_triangles_are_left_out_with_one_warning() {
    let mesh = r#"{"mesh": {"name": "m", "material": "red",
        "vertices": [[0,0,0],[1,0,0],[2,0,0],[0,1,0]],
        "triangles": [[0,1,3],[0,1,2],[1,1,1],[0,2,3]],
        "normals": [[0,0,1],[0,0,1],[0,0,1],[0,0,1]]}}"#;
    let scene = loaded(mesh, &[]).expect("only a warning");
    assert_eq!(scene.shapes.len(), 2);
    let data = scene.objects[0].vertices.as_ref().expect("normals");
    assert_eq!(data.normal_indices, [[0, 1, 3], [0, 2, 3]]);
    let [warning] = &scene.warnings[..] else {
        panic!("one warning: {:?}", scene.warnings)
    };
    assert_says(
        &warning.to_string(),
        &["`m`", "2 of 4", "number 1", "left out"],
    );
}

#[test]
fn mirrored_meshes_keep_their_front() {
    let mesh = r#"{"mesh": {"name": "m", "material": "red", "vertices": [[0,0,0],[1,0,0],[0,1,0]],
        "triangles": [[0,1,2]], "normals": [[0,0,1],[0,0,1],[0,0,1]],
        "transform": [{"scale": [-1, 1, 1]}]}}"#;
    let scene = loaded(mesh, &[]).expect("a good mesh");
    let raytree::geometry::Shape::Triangle(triangle) = &scene.shapes[0] else {
        panic!("a triangle")
    };
    let normal = triangle.normal().expect("area");
    assert!(normal.z > 0.99);
    let data = scene.objects[0].vertices.as_ref().expect("normals");
    assert!(data.normal(0, [0.2, 0.3, 0.5]).expect("normals").z > 0.99);
}
