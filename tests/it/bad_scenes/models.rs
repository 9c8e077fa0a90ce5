//! OBJ and MTL files.

use super::{CORNERS, Folder, OBJ, assert_says, loaded, with_obj};

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
    let scene = with_obj(&format!("{CORNERS}f 1\nf 1 2\nf 1 2 3\n")).expect("a warning");
    assert_eq!(scene.shapes.len(), 1);
    assert_eq!(scene.warnings.len(), 1);
    assert_says(
        &scene.warnings[0].to_string(),
        &["m.obj:4", "fewer than three", "left out (2 times"],
    );
}

#[test]
fn obj_triangles_without_area_are_warned_of_by_line() {
    let scene = with_obj(&format!("{CORNERS}f 1 2 3\nf 1 1 2\n")).expect("a warning");
    assert_eq!(scene.shapes.len(), 1);
    assert_says(
        &scene.warnings[0].to_string(),
        &["`model`", "1 of 2", "line 5"],
    );
}

#[test]
fn mtl_with_two_numbers_is_a_warning() {
    let obj = format!("mtllib x.mtl\n{CORNERS}usemtl a\nf 1 2 3\n");
    for line in ["Kd 1 2", "Kd", "Kd 1 2 x", "Ks nan 0 0", "Ns", "d 7"] {
        let mtl = format!("newmtl a\n{line}\n");
        let files = [("m.obj", obj.as_bytes()), ("x.mtl", mtl.as_bytes())];
        let scene = loaded(OBJ, &files).expect(line);
        let [warning] = &scene.warnings[..] else {
            panic!("{:?}", scene.warnings)
        };
        assert_says(
            &warning.to_string(),
            &["x.mtl:2:", &line[..1], "\n  write "],
        );
    }
}

#[test]
fn missing_mtl_is_a_warning() {
    let scene =
        with_obj(&format!("mtllib x.mtl\n{CORNERS}usemtl a\nf 1 2 3\n")).expect("a warning");
    assert_says(
        &format!("{:?}", scene.warnings),
        &[
            "`x.mtl`: there is no such file",
            "position: Some((5, 0))",
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
    assert_eq!(scene.warnings, []);
}
