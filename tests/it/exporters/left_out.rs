//! What is not drawn yet is told once, with a count.

#![expect(
    clippy::format_collect,
    reason = "texts are made line by line, as they read"
)]

use super::{CORNERS, GREY, SQUARE, drawn, matt, obj, paint, read};

#[test]
fn textures() {
    let black = [0.0; 3];
    paint(
        "Kd 0 0 0\nmap_Kd -s 2 2 1 planks.png\n",
        black,
        &["m.mtl:3 texture"],
    );
    paint(
        "Kd 0 0 0\nmap_Kd planks.png\nmap_Kd other.png\n",
        black,
        &["m.mtl:3 texture x2"],
    );
    for line in [
        "bump -bm 0.2 x.png",
        "map_Bump x.png",
        "norm x.png",
        "disp x.png",
        "map_Ka",
        "refl -type sphere x.hdr",
        "decal x.png",
    ] {
        paint(&format!("{line}\nKd 0 0 0\n"), black, &["m.mtl:2 texture"]);
    }
    for line in ["Pr 0.5", "sharpness 60", "aniso 0.1", "KD 1 0 0"] {
        paint(&format!("{line}\nKd 0 0 0\n"), black, &["m.mtl:2 left-out"]);
    }
}

#[test]
fn colours_of_points() {
    for colour in ["1 0 0", "1 0 0 1", "255 0 0", "1 red 0", "0.5 0.5 0.5 1 1"] {
        let text = SQUARE.replace(" 0\n", &format!(" 0 {colour}\n"));
        obj(&text, matt(GREY), &["m.obj:1 vertex-colors x4"]);
        let once = SQUARE.replace("v 2 1 0", &format!("v 2 1 0 {colour}"));
        obj(&once, matt(GREY), &["m.obj:3 vertex-colors"]);
    }
}

#[test]
fn smoothing_groups() {
    for on in ["1", "on", "32"] {
        let text = format!("{CORNERS}s {on}\nf 1 2 3\nf 1 3 4\n");
        obj(&text, matt(GREY), &["m.obj:6 smoothing-group x2"]);
    }
    for off in ["0", "off", ""] {
        obj(
            &format!("{CORNERS}s 1\ns {off}\nf 1 2 3 4\n"),
            matt(GREY),
            &[],
        );
    }
    let with_normals = format!("{CORNERS}vn 0 0 1\ns 1\nf 1//1 2//1 3//1 4//1\n");
    obj(&with_normals, matt(GREY), &[]);
    let one_bare = format!("{CORNERS}vn 0 0 1\ns 1\nf 1//1 2//1 3//1\nf 1 3 4\n");
    obj(&one_bare, matt(GREY), &["m.obj:8 smoothing-group"]);
}

#[test]
fn statements_that_draw_nothing_here() {
    let text = format!(
        "{SQUARE}l 1 2\nl 2 3\np 1\ncstype bezier\ncurv 0 1 1 2\nvp 0 0\nend\ncall x.obj\n"
    );
    let told = [
        "m.obj:6 left-out x2",
        "m.obj:8 left-out",
        "m.obj:9 left-out",
        "m.obj:10 left-out",
        "m.obj:11 left-out",
        "m.obj:12 left-out",
        "m.obj:13 left-out",
    ];
    obj(&text, matt(GREY), &told);
    obj(
        &format!("{SQUARE}f 1\nf 1 2\nf\n"),
        matt(GREY),
        &["m.obj:6 few-corners x3"],
    );
    // The old name of a face.
    obj(&SQUARE.replace("f ", "fo "), matt(GREY), &[]);
}

#[test]
fn a_message_for_many_lines_is_one_line() {
    let text = format!("{SQUARE}{}", "f 1//1 2//1 3//1\n".repeat(1000));
    let scene = read(&[("m.obj", text.as_bytes())]).expect("drawn");
    assert_eq!(super::warnings(&scene), ["m.obj:6 dangling-index x3000"]);
    // Many kinds are bounded, and counted all the same.
    let text: String = (0..1000).map(|i| format!("odd{i} 1\n")).collect();
    let scene = read(&[("m.obj", format!("{SQUARE}{text}").as_bytes())]).expect("drawn");
    let counts: u64 = scene.warnings.iter().map(|warning| warning.count).sum();
    let last = scene.warnings.last().expect("many").to_string();
    assert!(
        scene.warnings.len() <= 21 && last.contains("more warnings"),
        "{last}"
    );
    assert_eq!(counts, 21);
}

#[test]
fn faces_that_are_no_polygons() {
    // A bow crosses itself; its triangles are a guess.
    let bow = "v -1 -1 0\nv 1 1 0\nv 1 -1 0\nv -1 1 0\nf 1 2 3 4\n";
    let scene = read(&[("m.obj", bow.as_bytes())]).expect("drawn");
    assert_eq!(super::warnings(&scene), ["m.obj:5 guessed-face"]);
    // A convex face of any number of corners is no guess.
    let count = 3000;
    let corner = |i: i32| {
        let angle = std::f64::consts::TAU * f64::from(i) / f64::from(count);
        format!("v {} {} 0\n", libm::cos(angle), libm::sin(angle))
    };
    let corners: String = (0..count).map(corner).collect();
    let face: String = (1..=count).map(|i| format!(" {i}")).collect();
    let scene = read(&[("m.obj", format!("{corners}f{face}\n").as_bytes())]).expect("drawn");
    assert_eq!((scene.shapes.len(), scene.warnings.len()), (2998, 0));
    let notch = corners.replacen("v 1 0 0", "v 0 0 0", 1);
    let text = format!("{notch}f{face}\n");
    let scene = read(&[("m.obj", text.as_bytes())]).expect("drawn");
    assert_eq!(super::warnings(&scene), ["m.obj:3001 guessed-face"]);
    drawn(
        &[("m.obj", format!("{CORNERS}f 1 2 3 4 1\n").as_bytes())],
        matt(GREY),
        &["m.obj:0 no-area"],
    );
}
