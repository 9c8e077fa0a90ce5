//! The OBJ reader against a simple one, on files that both understand alike.

use std::fmt::Write as _;
use std::path::Path;

use raytree::geometry::Shape;
use raytree::math::DVec3;
use raytree::scene;

/// The corners of all triangles, in the order of the file.
fn ours(path: &Path) -> Vec<[DVec3; 3]> {
    let scene = scene::load(path.to_str().expect("a plain path")).expect("a good file");
    let triangle = |shape: &Shape| match shape {
        Shape::Triangle(triangle) => triangle.corners,
        other => panic!("a mesh has only triangles: {other:?}"),
    };
    scene.shapes.iter().map(triangle).collect()
}

/// The same as read line by line: each face is a fan.
fn theirs(path: &Path) -> Vec<[DVec3; 3]> {
    let (mut points, mut all) = (Vec::<DVec3>::new(), Vec::new());
    for line in std::fs::read_to_string(path).expect("text").lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        match &words[..] {
            ["v", rest @ ..] => {
                let numbers: Vec<f64> = rest.iter().map(|w| w.parse().expect("a number")).collect();
                points.push(DVec3::from_slice(&numbers));
            }
            ["f", corners @ ..] => {
                let point = |corner: &&str| {
                    let index = corner.split('/').next().expect("a number");
                    match index.parse::<isize>().expect("a number") {
                        i if i > 0 => points[i as usize - 1],
                        i => points[points.len().checked_add_signed(i).expect("a point")],
                    }
                };
                let corners: Vec<DVec3> = corners.iter().map(point).collect();
                all.extend((2..corners.len()).map(|i| [corners[0], corners[i - 1], corners[i]]));
            }
            _ => {}
        }
    }
    all
}

#[test]
fn built_in_models_are_read_as_by_another_reader() {
    for model in ["teapot.obj", "bunny.obj"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("scenes")
            .join(model);
        let (ours, theirs) = (ours(&path), theirs(&path));
        assert!(ours.len() > 900, "{model}");
        assert_eq!(ours, theirs, "{model}");
    }
}

#[test]
fn models_of_a_large_file_fit_together() {
    // Long enough for several models of the crate that reads it; indices count backwards as well as forwards, and parts,
    // comments and normals stand between.
    let mut text = String::new();
    for i in 0..60_000u32 {
        let (x, y) = (f64::from(i % 300) / 7.0, f64::from(i / 300) / 3.0);
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "v {x} {y} {}\nv {x} {} 0.25e0",
            f64::from(i) * 1e-3,
            y + 0.1
        );
        if i % 1000 == 0 {
            let _ = writeln!(text, "g part{i}\n# a comment\nvn 0 0 1");
        }
        let _ = match i % 3 {
            0 if i > 2 => writeln!(text, "f -1 -2 -4"),
            1 => writeln!(text, "f {0}//1 {1}//1 1//1", 2 * i + 1, 2 * i + 2),
            _ => Ok(()),
        };
    }
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("large.obj");
    std::fs::write(&path, text).expect("writable");
    let (ours, theirs) = (ours(&path), theirs(&path));
    assert!(ours.len() > 39_000);
    assert_eq!(ours, theirs);
}
