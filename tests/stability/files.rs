//! Files that lie about themselves (cases 87 to 104): each is refused with one message that names the place, or read as it
//! is meant. Sources: the issue trackers of tobj, of the crates image and toml, of pbrt and Blender's importers, where most
//! of these were panics, silent nonsense or a way out of the folder.

use raytree::geometry::Shape;
use raytree::math::DVec3;
use raytree::scene::{Scene, load, load_from_memory};

const CORNERS: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const FACE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const CAMERA: &str =
    r#""format": "raytree-scene/1", "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0]}"#;

/// The first of these files, with the others beside it.
fn read(files: &[(&str, &[u8])]) -> Result<Scene, String> {
    let held = files
        .iter()
        .map(|(name, bytes)| ((*name).to_string(), bytes.to_vec()));
    load_from_memory(files[0].0, held.collect()).map_err(|e| e.to_string())
}

fn model(text: &str) -> Result<Scene, String> {
    read(&[("m.obj", text.as_bytes())])
}

/// A scene with these fields beside format and camera.
fn scene(fields: &str) -> Result<Scene, String> {
    read(&[
        ("a.json", format!("{{{CAMERA}, {fields}}}").as_bytes()),
        ("m.obj", FACE.as_bytes()),
    ])
}

/// It is refused, in two lines that begin with the place and have all these words.
#[track_caller]
fn refused(read: Result<Scene, String>, place: &str, words: &[&str]) {
    let said = read.expect_err("it is refused");
    assert_eq!(said.lines().count(), 2, "{said}");
    assert!(said.starts_with(place), "it names {place}: {said}");
    for word in words {
        assert!(said.contains(word), "it says `{word}`: {said}");
    }
}

#[test]
fn case_087_a_colour_of_one_or_two_numbers() {
    for (line, count) in [("Kd", 0), ("Kd 1", 1), ("Ks 1 2", 2), ("Ka 1 1 1 1", 4)] {
        let mtl = format!("newmtl a\n{line}\n");
        let obj = format!("mtllib x.mtl\nusemtl a\n{FACE}");
        let files = [("m.obj", obj.as_bytes()), ("x.mtl", mtl.as_bytes())];
        let scene = read(&files).expect("a bad line never stops a model");
        let told = scene.warnings.iter().map(ToString::to_string);
        let told: Vec<String> = told.filter(|told| told.starts_with("x.mtl:2: ")).collect();
        // One number stands for three (the specification).
        assert_eq!(told.len(), usize::from(count != 1), "{line}: {told:?}");
    }
}

#[test]
fn case_088_a_vertex_that_is_no_number() {
    for word in [
        "nan",
        "NaN",
        "-nan",
        "inf",
        "-Infinity",
        "1e999",
        "nan(0x1)",
        "1.#IND",
        "0x1p3",
    ] {
        refused(
            model(&format!("{CORNERS}v 0 {word} 0\nf 1 2 3\n")),
            "m.obj:4: ",
            &[word],
        );
    }
}

#[test]
fn case_089_vertices_that_are_not_there() {
    for index in [
        "0",
        "-0",
        "-4",
        "4",
        "4294967297",
        "10000000000000000000",
        "1e0",
        "+-1",
        "",
    ] {
        let corner = format!("{index}/1");
        refused(
            model(&format!("{CORNERS}vt 0 0\nf 1 2 {corner}\n")),
            "m.obj:5: ",
            &[&corner],
        );
    }
    let last = model(&format!("{CORNERS}f -3 -2 -1\n")).expect("they count backwards");
    assert_eq!(last.shapes.len(), 1);
}

#[test]
fn case_090_faces_of_one_and_two_corners() {
    let scene = model(&format!("{CORNERS}f 1\nf 2 3\nf 1 2 3\n")).expect("the others are left out");
    assert_eq!(scene.shapes.len(), 1);
    assert!(
        scene.warnings[0]
            .to_string()
            .starts_with("m.obj:4: a face has fewer than three corners"),
        "{:?}",
        scene.warnings
    );
    refused(model(&format!("{CORNERS}f\n")), "m.obj: ", &["no face"]);
    refused(model(&format!("{CORNERS}f 1 2\n")), "m.obj: ", &["no face"]);
}

#[test]
#[expect(
    clippy::format_collect,
    reason = "texts are made line by line, as they read"
)]
fn case_091_a_concave_face_is_covered_once() {
    // A comb with teeth, from each of its corners: a fan covers its gaps as well.
    let comb: Vec<[f64; 2]> = (0..8)
        .flat_map(|i| {
            let x = f64::from(i);
            [[x, 3.0], [x + 0.5, 3.0], [x + 0.5, 1.0], [x + 1.0, 1.0]]
        })
        .chain([[8.0, 0.0], [0.0, 0.0]])
        .collect();
    let expected = 8.0 + 8.0 * 0.5 * 2.0;
    for turn in 0..comb.len() {
        let mut corners = comb.clone();
        corners.rotate_left(turn);
        // Clockwise as it stands: the last shall be first.
        let points: String = corners
            .iter()
            .rev()
            .map(|[x, y]| format!("v {x} {y} 0\n"))
            .collect();
        let face: String = (1..=corners.len()).map(|i| format!(" {i}")).collect();
        let scene = model(&format!("{points}f{face}\n")).expect("a comb");
        let triangle = |shape: &Shape| match shape {
            Shape::Triangle(t) => {
                (t.corners[1] - t.corners[0]).cross(t.corners[2] - t.corners[0]) / 2.0
            }
            _ => panic!("a triangle"),
        };
        let area: DVec3 = scene.shapes.iter().map(triangle).sum();
        let covered: f64 = scene.shapes.iter().map(|s| triangle(s).length()).sum();
        assert!((area.length() - expected).abs() < 1e-12, "{turn}: {area}");
        assert!((covered - expected).abs() < 1e-12, "{turn}: {covered}");
    }
}

#[test]
fn case_092_paths_that_lead_out_of_the_folder() {
    for path in [
        "/etc/passwd",
        "../x.mtl",
        "a/../../x.mtl",
        "a\\x.mtl",
        "..",
        "./../x.mtl",
        "\0x.mtl",
    ] {
        let cure = "copy the file into the folder";
        let grey = model(&format!("mtllib {path}\nusemtl a\n{FACE}")).expect("drawn without");
        let told = grey.warnings[0].to_string();
        assert!(
            told.starts_with("m.obj:1: ") && grey.warnings.len() == 2,
            "{told}"
        );
        let path = path.replace('\\', "\\\\").replace('\0', "\\u0000");
        let object = format!(r#""objects": [{{"obj": {{"name": "m", "file": "{path}"}}}}]"#);
        refused(scene(&object), "a.json: objects[0].obj.file: ", &[cure]);
    }
}

#[cfg(unix)]
#[test]
fn case_093_a_link_out_of_the_folder() {
    let folders = [tempfile::tempdir(), tempfile::tempdir()].map(|f| f.expect("a folder"));
    let [inside, outside] = folders.each_ref().map(tempfile::TempDir::path);
    std::fs::write(outside.join("x.mtl"), "newmtl a\nKd 1 1 1\n").expect("a file");
    std::fs::write(
        inside.join("m.obj"),
        format!("mtllib l/x.mtl\nusemtl a\n{FACE}"),
    )
    .expect("a file");
    std::os::unix::fs::symlink(outside, inside.join("l")).expect("a link to a folder");
    let path = inside.join("m.obj").display().to_string();
    let scene = load(&path).expect("drawn without");
    let said = scene.warnings[0].to_string();
    assert!(
        said.starts_with(&format!("{path}:1: ")) && said.contains("link"),
        "{said}"
    );
    assert_eq!(scene.materials.len(), 1, "nothing was read");
}

#[test]
fn case_096_numbers_that_only_some_types_can_hold() {
    let ball = |radius: &str| {
        scene(&format!(
            r#""materials": {{"a": {{}}}},
"objects": [{{"sphere": {{"name": "s", "material": "a", "center": [0, 0, 0], "radius": {radius}}}}}]"#
        ))
    };
    for large in ["1e40", "1e308", "1000000000000.1"] {
        refused(
            ball(large),
            "a.json: objects[0].sphere.radius: ",
            &["above 0, 1e12 at most"],
        );
    }
    refused(
        ball("1e309"),
        "a.json:2:",
        &["objects[0].sphere.radius", "too large"],
    );
    // The smallest number there is is a number.
    for small in ["5e-324", "1e-320", "2.2250738585072014e-308"] {
        assert!(ball(small).is_ok(), "{small}");
    }
    // Below it, a radius is zero.
    refused(
        ball("1e-400"),
        "a.json: objects[0].sphere.radius: ",
        &["above 0"],
    );
    for seed in ["18446744073709551616", "-1", "1.5"] {
        refused(
            scene(&format!(r#""settings": {{"seed": {seed}}}"#)),
            "a.json:1:",
            &["settings.seed"],
        );
    }
}

#[test]
fn case_097_words_for_numbers() {
    for word in [
        "NaN", "nan", "Infinity", "-inf", "+1", ".5", "1.", "01", "0x10", "1_000", "1e", "1,5",
    ] {
        refused(
            scene(&format!(r#""settings": {{"exposure": {word}}}"#)),
            "a.json:1:",
            &[],
        );
    }
}

#[test]
fn case_098_brackets_inside_brackets() {
    let nested = |depth: usize| {
        let open = r#"{"group": {"name": "g", "objects": ["#.repeat(depth);
        scene(&format!(r#""objects": [{open}{}]"#, "]}}".repeat(depth)))
    };
    assert!(nested(32).is_ok());
    for depth in [33, 41, 42, 43, 128, 129, 100_000] {
        refused(nested(depth), "a.json:", &["32 deep"]);
    }
    for (open, close) in [("[", "]"), ("{\"a\":", "}"), ("[{\"group\":", "}]")] {
        let text = open.repeat(100_000);
        refused(read(&[("a.json", text.as_bytes())]), "a.json", &[]);
        // Text that is no JSON is told first; what is, but is no note, by its field.
        let broken = scene(&format!("\"note\": {text}"));
        refused(broken, "a.json:1:", &["a value is missing here"]);
        let closed = format!("\"note\": {text}1{}", close.repeat(100_000));
        refused(scene(&closed), "a.json:1:", &["note"]);
    }
}

#[test]
fn case_099_files_that_name_themselves() {
    let itself = format!("mtllib m.obj\nmtllib m.obj\nusemtl a\n{FACE}");
    let scene = model(&itself).expect("as a file of materials it is empty");
    let told = |what| scene.warnings.iter().any(|w| w.to_string().contains(what));
    assert!(told("material `a`") && told("left out"));
    let object = r#""objects": [{"obj": {"name": "m", "file": "a.json"}}]"#;
    refused(self::scene(object), "a.json: ", &["no face"]);
}

#[test]
fn case_101_more_samples_than_anyone_can_wait_for() {
    for samples in [
        "4097",
        "4294967295",
        "4294967296",
        "1000000000000",
        "1e12",
        "0",
    ] {
        let settings = format!(r#""settings": {{"samples": {samples}}}"#);
        refused(scene(&settings), "a.json", &["settings.samples"]);
    }
    assert!(scene(r#""settings": {"samples": 4096}"#).is_ok());
}

#[test]
fn case_102_a_key_that_stands_twice() {
    for (fields, key) in [
        (r#""ambient": [1, 1, 1], "ambient": [0, 0, 0]"#, "ambient"),
        (r#""materials": {"a": {}, "a": {}}"#, "a"),
        (r#""materials": {"a": {}, "\u0061": {}}"#, "a"),
        (r#""settings": {"depth": 1, "depth": 2}"#, "depth"),
        (r#""objects": [], "objects": []"#, "objects"),
    ] {
        refused(
            scene(fields),
            "a.json:1:",
            &[&format!("`{key}` is given twice")],
        );
    }
}

#[test]
fn case_103_bytes_that_are_no_text() {
    for bytes in [
        &b"\xff"[..],
        b"\xc3\x28",
        b"\xed\xa0\x80",
        b"\xf4\x90\x80\x80",
        b"\xc0\x80",
        b"\xe9",
    ] {
        let obj = [b"# ", bytes, b"\n", FACE.as_bytes()].concat();
        let scene = read(&[("m.obj", &obj)]).expect("drawn all the same");
        let told = scene.warnings[0].to_string();
        assert!(
            told.starts_with("m.obj:1: ") && told.contains("UTF-8"),
            "{told}"
        );
        let note = [b"{\"note\":\n\"", bytes, b"\"}"].concat();
        refused(
            read(&[("a.json", &note)]),
            "a.json: ",
            &["UTF-8", "line 2, byte 10"],
        );
    }
}

#[test]
fn case_104_line_ends_continued_lines_and_decimal_commas() {
    let plain = model(FACE).expect("a triangle");
    for text in [
        FACE.replace('\n', "\r\n"),
        format!("\u{feff}{FACE}"),
        FACE.trim_end().to_string(),
        FACE.replace('\n', "\r"),
        format!("{CORNERS}f 1 2 \\\n3\n"),
    ] {
        let same = model(&text).expect("the same");
        assert_eq!(format!("{:?}", same.shapes), format!("{:?}", plain.shapes));
    }
    refused(model("v 0 0,5 0\n"), "m.obj:1: ", &["0,5", "decimal point"]);
}
