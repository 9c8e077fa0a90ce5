//! Encodings, line ends, continued lines.

use super::{CORNERS, GREY, RED, SQUARE, drawn, matt, obj};

#[test]
fn bytes_that_are_no_utf_8() {
    let odd = |name: &[u8]| [b"g ", name, b"\n", SQUARE.as_bytes()].concat();
    for name in [&b"T\xfcr"[..], b"\xff", b"a\x80b", b"caf\xe9"] {
        drawn(&[("m.obj", &odd(name))], matt(GREY), &["m.obj:1 not-utf8"]);
    }
    let comment = [SQUARE.as_bytes(), b"# gr\xfc\xdfe\n# \xe4\n"].concat();
    drawn(&[("m.obj", &comment)], matt(GREY), &["m.obj:6 not-utf8 x3"]);
    drawn(&[("m.obj", &odd("T\u{fc}r".as_bytes()))], matt(GREY), &[]);
    // In the name of a material, in both files.
    let model = [b"mtllib m.mtl\nusemtl T\xfcr\n", SQUARE.as_bytes()].concat();
    let files: [(&str, &[u8]); 2] = [
        ("m.obj", &model),
        ("m.mtl", b"# x\nnewmtl T\xfcr\nKd 1 0 0\n"),
    ];
    drawn(&files, matt(RED), &["m.mtl:2 not-utf8", "m.obj:2 not-utf8"]);
}

#[test]
fn marks_and_wide_letters() {
    let wide = |order: fn(u16) -> [u8; 2]| -> Vec<u8> {
        let text = format!("\u{feff}g T\u{fc}r\r\n{SQUARE}");
        text.encode_utf16().flat_map(order).collect()
    };
    drawn(&[("m.obj", &wide(u16::to_le_bytes))], matt(GREY), &[]);
    drawn(&[("m.obj", &wide(u16::to_be_bytes))], matt(GREY), &[]);
    drawn(
        &[("m.obj", format!("\u{feff}{SQUARE}").as_bytes())],
        matt(GREY),
        &[],
    );
    let mut cut = wide(u16::to_le_bytes);
    cut.extend([0x00, 0xd8]);
    drawn(
        &[("m.obj", &cut)],
        matt(GREY),
        &["m.obj:7 left-out", "m.obj:7 not-utf8"],
    );
}

#[test]
fn line_ends() {
    for end in ["\r", "\r\n", "\n", "\n\r", " \r", "\t\r\n"] {
        obj(&SQUARE.replace('\n', end), matt(GREY), &[]);
    }
    obj(SQUARE.trim_end(), matt(GREY), &[]);
    // Each line is counted once, also where files were joined.
    obj(
        &format!("{}odd\n", SQUARE.replace('\n', "\r")),
        matt(GREY),
        &["m.obj:6 left-out"],
    );
    obj(
        &format!("{}odd\n", SQUARE.replace('\n', "\r\n")),
        matt(GREY),
        &["m.obj:6 left-out"],
    );
    let model = format!("mtllib m.mtl\rusemtl paint\r{}", SQUARE.replace('\n', "\r"));
    drawn(
        &[
            ("m.obj", model.as_bytes()),
            ("m.mtl", b"newmtl paint\rKd 1 0 0\rodd 1\r"),
        ],
        matt(RED),
        &["m.mtl:3 left-out"],
    );
}

#[test]
fn continued_lines() {
    for (face, line) in [
        ("f 1 2 \\\n3 4\n", 7),
        ("f 1 2 \\\r\n3 4\r\n", 7),
        ("f 1 2 3\\\n4\n", 7),
        ("f \\\n1 \\\n2 \\ \n3 4\n", 9),
        ("f 1 2 3 4 # no \\\n", 6),
        ("# no \\\nf 1 2 3 4\n", 7),
        ("f 1 2 3 4 \\\n", 6),
    ] {
        let told = format!("m.obj:{line} left-out");
        let odd = if face.ends_with("4 \\\n") {
            "\nodd\n"
        } else {
            "odd\n"
        };
        let told = if face.ends_with("4 \\\n") {
            "m.obj:7 left-out".to_owned()
        } else {
            told
        };
        obj(&format!("{CORNERS}{face}{odd}"), matt(GREY), &[&told]);
    }
    let model = format!("mtllib m.mtl\nusemtl paint\n{SQUARE}");
    drawn(
        &[
            ("m.obj", model.as_bytes()),
            ("m.mtl", b"newmtl \\\npaint\nKd 1 \\\n0 \\\n0\n"),
        ],
        matt(RED),
        &[],
    );
    obj(
        &format!("v -2 -1 \\\n0\n{}", SQUARE.replacen("v -2 -1 0\n", "", 1)),
        matt(GREY),
        &[],
    );
    // The last line may be open.
    obj(&format!("{CORNERS}f 1 2 3 4 \\"), matt(GREY), &[]);
}

#[test]
fn blanks() {
    obj(&SQUARE.replace(' ', "  \t"), matt(GREY), &[]);
    obj(
        &SQUARE.replace("v ", " v\t").replace("f ", "\tf "),
        matt(GREY),
        &[],
    );
}

#[test]
fn names_of_any_length_and_letters() {
    for name in [
        "x".repeat(1000),
        "\u{e4}".repeat(150),
        "\u{1b}[2J".to_owned(),
    ] {
        let text =
            format!("mtllib m.mtl\n{CORNERS}g {name}\nusemtl {name}\nf 1 2 3\ng {name}\nf 1 3 4\n");
        let mtl = format!("newmtl {name}\nKd 1 0 0\n");
        drawn(
            &[("m.obj", text.as_bytes()), ("m.mtl", mtl.as_bytes())],
            matt(RED),
            &["m.obj:0 changed-name x3"],
        );
    }
    // A name that is another's with its number.
    let text = format!("{CORNERS}g a\nf 1 2 3\ng a#2\nf 1 2 3\ng a\nf 1 3 4\ng a#2\nf 1 3 4\n");
    obj(&text, matt(GREY), &[]);
}
