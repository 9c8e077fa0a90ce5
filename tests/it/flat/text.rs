//! The text form says what the JSON form says.

use raytree::scene::flat::{self, FlatObject};
use raytree::scene::{self, Scene, builtin};

use super::super::from_text;
use super::{MOVED, read};

fn lines(scene: &Scene) -> Vec<Vec<String>> {
    let mut text = Vec::new();
    flat::write_text(&mut text, scene).expect("a buffer takes everything");
    let text = String::from_utf8(text).expect("UTF-8");
    let words = |line: &str| line.split(' ').map(str::to_owned).collect();
    text.lines().map(words).collect()
}

/// The words of a line from `from` on as numbers.
fn numbers(line: &[String], from: usize) -> Vec<f64> {
    let words = line[from..].iter().map_while(|word| word.parse().ok());
    words.collect()
}

#[test]
fn lines_have_the_numbers_of_the_json() {
    for scene in builtin::names().map(|name| scene::load(name).expect("built in")) {
        if flat::check_text(&scene).is_err() {
            continue;
        }
        let (flat, lines) = (read(&scene), lines(&scene));
        let find = |kind: &str| lines.iter().find(|l| l[0] == kind).expect("a line");
        let camera = &flat.camera;
        let vectors = [camera.eye, camera.u, camera.v, camera.w];
        let mut expected: Vec<f64> = vectors.into_iter().flatten().collect();
        expected.push(camera.half_height);
        assert_eq!(numbers(find("camera"), 1), expected);
        let shapes = &lines[lines.len() - flat.objects.len()..];
        for (object, line) in flat.objects.iter().zip(shapes) {
            let (kind, expected): (_, Vec<f64>) = match object {
                FlatObject::Triangle { corners, .. } => ("triangle", corners.concat()),
                FlatObject::Sphere { center, radius, .. } => {
                    ("sphere", [&center[..], &[*radius]].concat())
                }
                FlatObject::Plane { point, normal, .. } => ("plane", [*point, *normal].concat()),
                FlatObject::Box { min, max, .. } => ("box", [*min, *max].concat()),
                FlatObject::Disc {
                    center,
                    normal,
                    radius,
                    ..
                } => ("disc", [&center[..], &normal[..], &[*radius]].concat()),
                FlatObject::Polygon { loops, .. } => {
                    let mut all = vec![loops.len() as f64];
                    for corners in loops {
                        all.push(corners.len() as f64);
                        all.extend(corners.iter().flatten());
                    }
                    ("polygon", all)
                }
                other => panic!("{other:?} is not in the text form"),
            };
            assert_eq!((line[0].as_str(), numbers(line, 2)), (kind, expected));
            assert_eq!(line[1].replace("%20", " "), object.name());
        }
        assert!(lines.iter().filter(|l| l[0] == "material").count() == flat.materials.len());
    }
}

#[test]
fn a_name_is_one_word() {
    let text = r#"{
      "format": "raytree-scene/1", "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0]},
      "materials": {"50 % gray": {"diffuse": [0.5, 0.5, 0.5], "checker": {"diffuse": [1, 0, 0], "size": 2}}},
      "lights": [{"directional": {"name": "the sun", "direction": [0, -2, 0], "intensity": [1, 1, 1]}}],
      "objects": [
        {"plane": {"name": "Fußboden", "material": "50 % gray", "point": [0, -1, 0], "normal": [0, 3, 0]}},
        {"triangle": {
          "name": "a b", "material": "50 % gray", "corners": [[0, 0, 0], [1, 0, 0], [0, 1, 0]],
          "normals": [[0, 0, 1], [0, 0, 1], [0, 0, 1]]
        }}
      ]
    }"#;
    let lines = lines(&from_text::scene(text));
    let lines: Vec<String> = lines.iter().map(|words| words.join(" ")).collect();
    let expected = [
        "material 50%20%25%20gray 0.5 0.5 0.5 0.5 0.5 0.5 0 0 0 32 0 0 0 0 0 0 1 0 0 0 0",
        "checker 50%20%25%20gray 1 0 0 1 0 0 2",
        "directional the%20sun 0 -1 0 1 1 1",
        "plane Fußboden 0 -1 0 0 1 0 50%20%25%20gray axes 1 0 0 0 0 -1",
        "triangle a%20b 0 0 0 1 0 0 0 1 0 50%20%25%20gray normals 0 0 1 0 0 1 0 0 1 uvs 0 0 1 0 0 1",
    ];
    assert_eq!(lines[lines.len() - 5..], expected);
}

#[test]
fn what_the_text_form_cannot_say_is_refused() {
    let error = flat::check_text(&from_text::scene(MOVED)).expect_err("an egg");
    let told = error.to_string();
    assert!(
        told.contains("`all/egg`") && told.contains("--flat"),
        "{told}"
    );
}
