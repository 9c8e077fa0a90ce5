//! Texture coordinates, normals and materials that are missing or broken: the face is drawn without.

use super::{CORNERS, GREY, SQUARE, matt, obj, read};

#[test]
fn texture_coordinates_and_normals_that_are_not_there() {
    for (faces, told) in [
        ("vt 0 0\nf 1/1 2/2 3/3 4/4\n", "m.obj:6 dangling-index x3"),
        ("f 1/1/1 2/2/2 3/3/3 4/4/4\n", ""),
        (
            "vn 0 0 1\nf 1//1 2//1 3//7 4//1\n",
            "m.obj:6 dangling-index",
        ),
        (
            "vn 0.8 0 0.6\nf 1//0 2//1 3//1 4//1\n",
            "m.obj:6 dangling-index",
        ),
        ("vt 0 0\nf 1/-1 2/-2 3/1 4/x\n", "m.obj:6 dangling-index x2"),
        (
            "vn 0.8 0 0.6\nf 1//1 2//1 3//99999999999999999999 4//-9223372036854775808\n",
            "m.obj:6 dangling-index x2",
        ),
    ] {
        let both = ["m.obj:5 dangling-index x4"; 2];
        let told = if told.is_empty() { &both[..] } else { &[told] };
        obj(&format!("{CORNERS}{faces}"), matt(GREY), told);
    }
}

#[test]
fn normals_that_are_none() {
    for normal in [
        "nan nan nan",
        "0 0 0",
        "0 0",
        "",
        "0 inf 0",
        "a b c",
        "1e-320 0 0",
        "1e300 0 0",
    ] {
        let text = format!("{CORNERS}vn {normal}\nvn 0.8 0 0.6\nf 1//2 2//1 3//2 4//2\n");
        obj(&text, matt(GREY), &["m.obj:5 bad-vertex-data"]);
    }
    // A normal that no face names is told all the same, and good ones are used.
    let text = format!("{CORNERS}vn nan 0 0\nvn 0 0 1\nf 1//2 2//2 3//2 4//2\n");
    obj(&text, matt(GREY), &["m.obj:5 bad-vertex-data"]);
    let scene = read(&[("m.obj", text.as_bytes())]).expect("drawn");
    assert!(scene.objects[0].vertices.is_some());
}

#[test]
fn texture_coordinates_of_one_number_or_none() {
    let with = |vt: &str| format!("{CORNERS}{vt}\nvt 0.75\nf 1/1 2/2 3/2 4/1\n");
    obj(&with("vt 0.25"), matt(GREY), &[]);
    obj(&with("vt 0.25 # no v"), matt(GREY), &[]);
    obj(&with("vt 0.25 0.5 0"), matt(GREY), &[]);
    for vt in ["vt", "vt nan", "vt 0 inf", "vt 0,5 0", "vt 1e13 0"] {
        obj(&with(vt), matt(GREY), &["m.obj:5 bad-vertex-data"]);
    }
    let scene = read(&[("m.obj", with("vt 0.25").as_bytes())]).expect("drawn");
    let data = scene.objects[0]
        .vertices
        .as_ref()
        .expect("texture coordinates");
    let uv = data.uv(0, [0.5, 0.5, 0.0]).expect("of the first triangle");
    assert_eq!(uv.to_array(), [0.5, 0.0]);
}

#[test]
fn a_material_without_a_name() {
    for line in ["usemtl", "usemtl  ", "usemtl # none", "usemtl\t"] {
        obj(
            &format!("{CORNERS}{line}\nf 1 2 3 4\n"),
            matt(GREY),
            &["m.obj:5 no-material-name"],
        );
    }
    let text = format!("{CORNERS}usemtl \nf 1 2 3\nusemtl\nf 1 3 4\n");
    obj(&text, matt(GREY), &["m.obj:5 no-material-name x2"]);
}

#[test]
fn a_bare_face_does_not_get_the_normal_of_its_neighbour() {
    for faces in [
        "f 1 2 3\nf 1//1 3//1 4//1\n",
        "f 1//1 2//1 3//1\nf 1 3 4\n",
        "f 1//1 2//1 3 4\n",
    ] {
        let text = format!("{CORNERS}vn 0.8 0 0.6\n{faces}");
        let scene = read(&[("m.obj", text.as_bytes())]).expect("drawn");
        assert_eq!(scene.warnings, []);
        let normals = |i: usize| {
            let data = scene.objects[0].vertices.as_ref()?;
            data.normal(i, [0.4, 0.3, 0.3])
        };
        let smooth = [normals(0).is_some(), normals(1).is_some()];
        let expected = [
            faces.starts_with("f 1//1 2//1 3//1\n"),
            faces.ends_with("4//1\n"),
        ];
        assert_eq!(smooth, expected, "{faces}");
    }
}

#[test]
fn weights_and_what_follows_a_point() {
    let with = |end: &str| SQUARE.replace("v 2 1 0", &format!("v 2 1 0 {end}"));
    obj(&with("1"), matt(GREY), &[]);
    obj(&with("0"), matt(GREY), &["m.obj:3 bad-vertex-data"]);
    obj(&with("nan"), matt(GREY), &["m.obj:3 bad-vertex-data"]);
    obj(&with("1 1"), matt(GREY), &["m.obj:3 extra-numbers"]);
    obj(&SQUARE.replace("v 2 1 0", "v 4 2 0 2"), matt(GREY), &[]);
    obj(
        &SQUARE.replace("f 1 2 3 4", "f 1/// 2 3 4"),
        matt(GREY),
        &["m.obj:5 extra-numbers"],
    );
}

#[test]
fn faces_before_their_points() {
    let text = format!("f 1//1 2//1 3//1 4//1\n{CORNERS}vn 0 0 1\n");
    obj(&text, matt(GREY), &[]);
}
