//! The OBJ reader against another one, `tobj`, on files that both understand alike.

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

/// The same as `tobj` reads them.
fn theirs(path: &Path) -> Vec<[DVec3; 3]> {
    let options = tobj::LoadOptions {
        triangulate: true,
        ..tobj::LoadOptions::default()
    };
    let (models, _) = tobj::load_obj(path, &options).expect("a good file");
    let mut all = Vec::new();
    for tobj::Model { mesh, .. } in models {
        let point = |i: &u32| DVec3::from_slice(&mesh.positions[3 * *i as usize..]);
        let triangles = mesh.indices.as_chunks::<3>().0.iter();
        all.extend(triangles.map(|t| [point(&t[0]), point(&t[1]), point(&t[2])]));
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
fn pieces_of_a_large_file_fit_together() {
    // Long enough to be read in pieces by several threads; indices count backwards as well as forwards, and parts,
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
