//! Lines of MTL files that the specification allows, or that exporters write.

use raytree::math::Rgb;

use super::{GREY, RED, grey, material, matt, paint};

#[test]
fn comments_at_the_end_of_a_line() {
    for lines in [
        "Kd 1 0 0 # tomato\n",
        "Kd 1 0 0 #tomato\n",
        "Kd 1 0 0\t# 0.5\n",
        "# Kd 0 1 0\nKd 1 0 0\nillum 2 # model\n",
    ] {
        paint(lines, matt(RED), &[]);
    }
}

#[test]
fn colours_of_one_number() {
    paint("Kd 0.5\n", matt([0.5; 3]), &[]);
    paint("Kd 0.5 # grey\n", matt([0.5; 3]), &[]);
    paint("Kd 1 0 0\nKs 0\n", matt(RED), &[]);
    assert_eq!(material("Ke 0.25\n").0.emission, grey(0.25));
}

#[test]
fn lines_that_cannot_be_read_are_left_out() {
    for line in [
        "Kd",
        "Kd 1 2",
        "Kd 1 0 x",
        "Kd nan 0 0",
        "Kd 1e999 0 0",
        "Kd spectral red.rfl 1",
        "Kd xyz 1 1 1",
        "Kd 0,8 0 0",
    ] {
        paint(&format!("{line}\n"), matt(GREY), &["m.mtl:2 unread-line"]);
        paint(
            &format!("Kd 1 0 0\n{line}\n"),
            matt(RED),
            &["m.mtl:3 unread-line"],
        );
    }
    for line in [
        "Ns",
        "Ns x",
        "Ni",
        "Ni -1",
        "d",
        "d nan",
        "Tr inf",
        "illum",
        "illum 11",
        "illum -1",
        "illum red",
        "Ka 1 2",
        "Tf 1 2",
    ] {
        paint(
            &format!("{line}\nKd 1 0 0\n"),
            matt(RED),
            &["m.mtl:2 unread-line"],
        );
    }
    paint("Kd 1 0 0 1\n", matt(RED), &["m.mtl:2 extra-numbers"]);
    paint(
        "Kd 1 0 0\nd -halo 1\n",
        matt(RED),
        &["m.mtl:3 extra-numbers"],
    );
}

#[test]
fn an_index_of_refraction_of_zero_is_not_said() {
    for zero in ["0", "0.0", "0.000000", "-0", "0e5"] {
        paint(&format!("Kd 1 0 0\nNi {zero}\n"), matt(RED), &[]);
        assert_eq!(material(&format!("Ni {zero}\n")).0.ior, 1.0);
    }
}

#[test]
fn numbers_beyond_their_range_are_clamped() {
    for lines in ["Kd 1 0 -0.0000001\n", "Kd 1 -1e-7 -1e-7\n"] {
        paint(lines, matt(RED), &["m.mtl:2 clamped"]);
    }
    for line in [
        "d 1.0000001",
        "Tr -1e-9",
        "Ks -0.001 0 0",
        "d 7",
        "Ke 0 0 -1",
        "Ns -1",
        "Ni 0.001",
    ] {
        paint(
            &format!("Kd 1 0 0\n{line}\n"),
            matt(RED),
            &["m.mtl:3 clamped"],
        );
    }
    let (beyond, told) = material("Ns 1e10\nNi 1e3\n");
    assert_eq!((beyond.shininess, beyond.ior), (1e9, 100.0));
    assert_eq!(told, ["m.mtl:2 clamped", "m.mtl:3 clamped"]);
}

#[test]
fn model_0_is_a_constant_colour() {
    paint("Kd 1 0 0\nillum 0\n", RED, &[]);
    paint("illum 0\nKd 1 0 0\nKs 1 1 1\nKa 1 1 1\n", RED, &[]);
    paint("illum 0.0\nKd 0.5\nKe 0.25 0 0\n", [0.75, 0.5, 0.5], &[]);
    paint("illum 1\nKd 1 0 0\nKs 1 1 1\n", matt(RED), &[]);
}

#[test]
fn what_stands_before_a_material_or_twice() {
    let (first, told) = material("Kd 1 0 0\nnewmtl paint\nKd 0 1 0\n");
    assert_eq!((first.diffuse, told.len()), (Rgb::from(RED), 0));
    let model = format!("mtllib m.mtl\nusemtl paint\n{}", super::SQUARE);
    for mtl in [
        "Kd 0 1 0\nKd 0 0 1\nnewmtl paint\nKd 1 0 0\n",
        "hello\nhello\nnewmtl paint\nKd 1 0 0\n",
    ] {
        let files = [("m.obj", model.as_bytes()), ("m.mtl", mtl.as_bytes())];
        super::drawn(&files, matt(RED), &["m.mtl:1 left-out x2"]);
    }
    // A material that nothing uses may say anything.
    let unused = "newmtl other\nKd\nmap_Kd x.png\nnewmtl paint\nKd 1 0 0\n";
    super::drawn(
        &[("m.obj", model.as_bytes()), ("m.mtl", unused.as_bytes())],
        matt(RED),
        &[],
    );
}

#[test]
fn names_with_blanks_and_signs() {
    for name in [
        "red paint",
        "Material #25",
        "01 - Default",
        "#25",
        "r\u{f6}d",
        "a/b\\c",
        "newmtl",
    ] {
        for comment in ["", " # a comment", " #comment"] {
            let model = format!("mtllib m.mtl\nusemtl {name}{comment}\n{}", super::SQUARE);
            let mtl = format!("newmtl   {name}\nKd 1 0 0\n");
            super::drawn(
                &[("m.obj", model.as_bytes()), ("m.mtl", mtl.as_bytes())],
                matt(RED),
                &[],
            );
        }
    }
}
