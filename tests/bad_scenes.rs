//! Bad scenes get a kind answer: where, what, and what to do. Never a panic.

use std::fs;
use std::path::PathBuf;

use raytree::scene::{Scene, load};

/// A folder with files in it, gone when dropped.
struct Folder(tempfile::TempDir);

impl Folder {
    fn new(files: &[(&str, &[u8])]) -> Self {
        let folder = Self(tempfile::tempdir().expect("a temporary folder"));
        for (name, bytes) in files {
            fs::write(folder.path(name), bytes).expect("a file");
        }
        folder
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn load(&self, name: &str) -> Result<Scene, String> {
        let path = self.path(name);
        load(path.to_str().expect("UTF-8")).map_err(|e| {
            let text = e.to_string();
            // The folder has a different name each time.
            text.replace(&format!("{}/", self.0.path().display()), "")
        })
    }
}

/// What is said about a scene file that holds `bytes`.
fn refused(bytes: &[u8]) -> String {
    let message = Folder::new(&[("a.json", bytes)])
        .load("a.json")
        .expect_err("a bad scene");
    for word in [
        "Some(", "Err(", "Error", "f64", "struct", "File", "variant", "\\n",
    ] {
        assert!(
            !message.contains(word),
            "no words of a programmer: {message}"
        );
    }
    assert_eq!(message.lines().count(), 2, "{message}");
    message
}

/// A scene around the given rest.
fn scene(rest: &str) -> String {
    format!(
        r#"{{"format": "raytree-scene/1", "camera": {{"eye": [0, 0, 5], "look_at": [0, 0, 0]}},
"materials": {{"red": {{"diffuse": [1, 0, 0]}}}}{rest}}}"#
    )
}

fn sphere(fields: &str) -> String {
    scene(&format!(
        r#", "objects": [{{"sphere": {{"name": "ball", "material": "red", {fields}}}}}]"#
    ))
}

const BALL: &str =
    r#"{"sphere": {"name": "ball", "material": "red", "center": [0, 0, 0], "radius": 1}}"#;

/// A scene with `objects`, which is text, and other files beside it.
fn loaded(objects: &str, files: &[(&str, &[u8])]) -> Result<Scene, String> {
    let text = scene(&format!(r#", "objects": [{objects}]"#));
    let mut all = vec![("a.json", text.as_bytes())];
    all.extend(files);
    Folder::new(&all).load("a.json")
}

const OBJ: &str = r#"{"obj": {"name": "model", "file": "m.obj"}}"#;

fn with_obj(text: &str) -> Result<Scene, String> {
    loaded(OBJ, &[("m.obj", text.as_bytes())])
}

const CORNERS: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

#[track_caller]
fn assert_says(message: &str, parts: &[&str]) {
    for part in parts {
        assert!(message.contains(part), "`{part}` is not in:\n{message}");
    }
}

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
        &["objects[0].sphere.center", "length 2", "three numbers"],
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

#[test]
fn folder_instead_of_file() {
    let folder = Folder::new(&[]);
    fs::create_dir(folder.path("a.json")).expect("a folder");
    let message = folder.load("a.json").expect_err("a folder");
    assert_says(&message, &["a.json: this is a folder", ".json or .obj"]);
}

#[test]
fn missing_file() {
    let message = Folder::new(&[]).load("a.json").expect_err("missing");
    assert_says(
        &message,
        &["a.json: there is no such file", "check the spelling"],
    );
}

#[cfg(unix)]
#[test]
fn device_instead_of_file() {
    let folder = Folder::new(&[]);
    std::os::unix::fs::symlink("/dev/zero", folder.path("a.json")).expect("a link");
    let message = folder.load("a.json").expect_err("a device");
    assert_says(&message, &["not a regular file"]);
}

#[test]
fn unknown_scene() {
    let message = load("whited").expect_err("unknown").to_string();
    assert_says(
        &message,
        &[
            "whited: there is no built-in scene",
            "did you mean `whitted`?",
            "bunny",
            ".json or .obj",
        ],
    );
    let folder = Folder::new(&[("a.txt", b"x")]);
    assert_says(
        &folder.load("a.txt").expect_err("unknown"),
        &["ends in .json"],
    );
}

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
        &["transform[0].scale", "one number or a list"],
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
    assert_says(warning, &["`m`", "2 of 4", "number 1", "left out"]);
}

#[test]
fn missing_obj() {
    let message = loaded(OBJ, &[]).expect_err("missing");
    assert_says(
        &message,
        &[
            "objects[0].obj.file",
            "no file `m.obj`",
            "the folder of the scene",
        ],
    );
}

#[test]
fn obj_path_outside_the_folder() {
    for path in ["/etc/passwd", "../m.obj", "a/../../m.obj", "a\\\\m.obj", ""] {
        let message = loaded(&OBJ.replace("m.obj", path), &[]).expect_err(path);
        assert_says(
            &message,
            &["objects[0].obj.file", "copy the file into the folder"],
        );
    }
}

#[test]
fn obj_with_bad_indices() {
    for index in [
        "0",
        "-4",
        "4",
        "99999999999",
        "-9223372036854775808",
        "99999999999999999999999",
    ] {
        let message = with_obj(&format!("{CORNERS}f 1 2 {index}\n")).expect_err(index);
        assert_says(&message, &["m.obj:4:", index]);
    }
    let message = with_obj(&format!(
        "{CORNERS}vt 0 0\nf 1/9223372036854775807 2/1 3/1\n"
    ));
    assert_says(
        &message.expect_err("wild"),
        &["m.obj:5:", "texture coordinate"],
    );
}

#[test]
fn obj_with_bad_vertices() {
    for number in ["nan", "inf", "-Infinity", "1e39", "1e999", "zero", "0,5"] {
        let message = with_obj(&format!("{CORNERS}v 0 {number} 0\nf 1 2 3\n")).expect_err(number);
        assert_says(&message, &["m.obj:4:", number, "number"]);
    }
    let message = with_obj("v 0 0\n").expect_err("short");
    assert_says(&message, &["m.obj:1:", "needs 3 numbers and has 2"]);
}

#[test]
fn obj_without_faces() {
    for text in ["", CORNERS] {
        let message = with_obj(text).expect_err("no faces");
        assert_says(&message, &["m.obj: there is no face", "f a b c"]);
    }
}

#[test]
fn obj_faces_of_one_and_two_corners_are_left_out_with_one_warning() {
    let scene = with_obj(&format!("{CORNERS}f 1\nf 1 2\nl 1 2 3\nf 1 2 3\n")).expect("a warning");
    assert_eq!(scene.shapes.len(), 1);
    assert_eq!(scene.warnings.len(), 1);
    assert_says(&scene.warnings[0], &["m.obj:4", "2 faces", "left out"]);
}

#[test]
fn obj_triangles_without_area_are_warned_of_by_line() {
    let scene = with_obj(&format!("{CORNERS}f 1 2 3\nf 1 1 2\n")).expect("a warning");
    assert_eq!(scene.shapes.len(), 1);
    assert_says(&scene.warnings[0], &["`model`", "1 of 2", "line 5"]);
}

#[test]
fn mtllib_outside_the_folder() {
    for path in ["/etc/passwd", "../x.mtl", "a/../../x.mtl", "a\\x.mtl"] {
        let message = with_obj(&format!("mtllib {path}\n{CORNERS}f 1 2 3\n")).expect_err(path);
        assert_says(
            &message,
            &["m.obj:1:", path, "copy the file into the folder"],
        );
    }
}

#[cfg(unix)]
#[test]
fn mtllib_that_is_a_link_out_of_the_folder() {
    let outside = Folder::new(&[("x.mtl", b"newmtl a\nKd 1 1 1\n")]);
    let obj = format!("mtllib x.mtl\n{CORNERS}f 1 2 3\n");
    let folder = Folder::new(&[("m.obj", obj.as_bytes())]);
    std::os::unix::fs::symlink(outside.path("x.mtl"), folder.path("x.mtl")).expect("a link");
    let message = folder.load("m.obj").expect_err("a link");
    assert_says(
        &message,
        &["m.obj:1:", "link", "outside the scene's folder"],
    );
    // A link that stays inside is followed.
    fs::remove_file(folder.path("x.mtl")).expect("the link");
    fs::write(folder.path("y.mtl"), "newmtl a\nKd 1 1 1\n").expect("a file");
    std::os::unix::fs::symlink("y.mtl", folder.path("x.mtl")).expect("a link");
    assert!(folder.load("m.obj").is_ok_and(|s| s.warnings.is_empty()));
}

#[test]
fn mtl_with_two_numbers() {
    let obj = format!("mtllib x.mtl\n{CORNERS}usemtl a\nf 1 2 3\n");
    for line in [
        "Kd 1 2",
        "Kd 1",
        "Kd",
        "Kd 1 2 x",
        "Ks nan 0 0",
        "d 7",
        "Ns",
    ] {
        let mtl = format!("newmtl a\n{line}\n");
        let files = [("m.obj", obj.as_bytes()), ("x.mtl", mtl.as_bytes())];
        let message = loaded(OBJ, &files).expect_err(line);
        assert_says(&message, &["x.mtl:2:", &line[..1], "\n  write "]);
    }
}

#[test]
fn missing_mtl_is_a_warning() {
    let scene =
        with_obj(&format!("mtllib x.mtl\n{CORNERS}usemtl a\nf 1 2 3\n")).expect("a warning");
    assert_says(
        &scene.warnings.join("\n"),
        &[
            "m.obj:1",
            "no file `x.mtl`",
            "m.obj:5",
            "material `a`",
            "grey",
        ],
    );
    assert!(
        scene.materials[scene.objects[0].material as usize]
            .name
            .starts_with("grey")
    );
}

#[test]
fn obj_with_its_own_materials() {
    let obj = format!(
        "mtllib x.mtl\n{CORNERS}v 1 1 0\no one\nusemtl a\nf 1 2 3\no two\nusemtl b\nf 2 4 3\n"
    );
    let mtl = "newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 0 1\nd 0.5\nNi 1.5\n";
    let files = [("m.obj", obj.as_bytes()), ("x.mtl", mtl.as_bytes())];
    let scene = loaded(OBJ, &files).expect("a good model");
    let named = |o: &raytree::scene::Object| {
        let material = &scene.materials[o.material as usize];
        (o.name.clone(), material.name.clone())
    };
    let objects: Vec<_> = scene.objects.iter().map(named).collect();
    let pair = |a: &str, b: &str| (a.to_string(), b.to_string());
    assert_eq!(objects, [pair("model/one", "a"), pair("model/two", "b")]);
    // The scene's own material goes before all of them, and makes one object of it.
    let obj = OBJ.replace("\"file\"", "\"material\": \"red\", \"file\"");
    let scene = loaded(&obj, &files).expect("a good model");
    assert_eq!(scene.objects.len(), 1);
    assert_eq!(scene.shapes.len(), 2);
}

#[test]
fn bare_obj_is_framed_and_lit() {
    let cube = "v 100 0 0\nv 101 0 0\nv 101 3 0\nv 100 3 -1\nf 1 2 3 4\nf 4 3 2 1\n";
    let scene = Folder::new(&[("cube.obj", cube.as_bytes())])
        .load("cube.obj")
        .expect("a good model");
    assert_eq!((scene.name.as_str(), scene.lights.len()), ("cube", 1));
    let camera = &scene.camera;
    for shape in &scene.shapes {
        for corner in shape.bounds().expect("triangles").corners() {
            let p = corner - camera.eye;
            let depth = -p.dot(camera.frame.w);
            assert!(depth > 0.0);
            assert!(p.dot(camera.frame.u).abs() < depth * camera.half_height);
            assert!(p.dot(camera.frame.v).abs() < depth * camera.half_height);
        }
    }
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

#[test]
fn obj_faces_without_normals_stay_flat_beside_those_with() {
    let text = format!("{CORNERS}vn 0 0.6 0.8\no a\nf 1//1 2//1 3//1\nf 1 2 3\no b\nf 1 2 3\n");
    let scene = with_obj(&text.replace('\n', "\r\n")).expect("a good model");
    let normal = |object: usize, triangle| {
        let data = scene.objects[object].vertices.as_ref()?;
        data.normal(triangle, [0.5, 0.25, 0.25])
    };
    assert!(normal(0, 0).is_some_and(|n| (n.y - 0.6).abs() < 1e-15));
    assert_eq!(normal(0, 1), None);
    assert_eq!(normal(1, 0), None);
}

#[test]
fn obj_concave_faces_are_covered_once() {
    // A fan from the first corner would also cover what lies outside of the notch.
    let scene = with_obj("v 2 -1 0\nv 1 0 0\nv 2 1 0\nv 0 0 0\nf 1 2 3 4\n").expect("a good model");
    let area = |shape: &raytree::geometry::Shape| match shape {
        raytree::geometry::Shape::Triangle(t) => {
            let [a, b, c] = t.corners;
            (b - a).cross(c - a).length() / 2.0
        }
        _ => panic!("a triangle"),
    };
    let total: f64 = scene.shapes.iter().map(area).sum();
    assert!((total - 1.0).abs() < 1e-12, "{total}");
    assert_eq!(scene.warnings, [""; 0]);
}
