//! OBJ and MTL files, made by chance.

use super::dice::Dice;

const NUMBERS: [&str; 22] = [
    "0",
    "-0.0",
    "1",
    "-1",
    "0.5",
    "2",
    "1e-320",
    "1e-9",
    "1e6",
    "1e12",
    "-1e12",
    "1e13",
    "nan",
    "inf",
    "-Infinity",
    "1e999",
    "0,5",
    "1.",
    ".5",
    "+1",
    "1e",
    "0x1p3",
];

const INDICES: [&str; 16] = [
    "0",
    "-1",
    "-4",
    "4294967296",
    "9223372036854775807",
    "-9223372036854775808",
    "10000000000000000000",
    "1.0",
    "1/1",
    "1//1",
    "1/1/1",
    "1/1/1/1",
    "/1",
    "1/",
    "//",
    "-0",
];

/// The text of an OBJ file.
pub fn obj(dice: &mut Dice) -> String {
    let wrong = [20, 300, 1_000_000, 1_000_000][dice.below(4)];
    let end = dice.pick(&["\n", "\n", "\n", "\r\n", " \n", "\n\n", "\r", " # end\n"]);
    let mut counts = [0; 3];
    let mut text = String::new();
    for _ in 0..dice.below(4) + dice.few(60) {
        text += &line(dice, wrong, &mut counts);
        text += end;
    }
    if counts[0] > 2 {
        text += "f 1 2 3\n";
    }
    text
}

fn line(dice: &mut Dice, wrong: usize, counts: &mut [usize; 3]) -> String {
    match dice.below(20) {
        0..7 => {
            counts[0] += 1;
            format!(
                "v {} {} {}",
                number(dice, wrong),
                number(dice, wrong),
                number(dice, wrong)
            )
        }
        7 => {
            counts[1] += 1;
            format!("vt {} {}", number(dice, wrong), number(dice, wrong))
        }
        8 => {
            counts[2] += 1;
            format!(
                "vn {} {} {}",
                number(dice, wrong),
                number(dice, wrong),
                number(dice, wrong)
            )
        }
        9..16 if counts[0] > 0 => {
            let corners: Vec<_> = (0..1 + dice.below(5) + dice.few(20))
                .map(|_| corner(dice, wrong, *counts))
                .collect();
            format!("f {}", corners.join(" "))
        }
        16 => format!("usemtl {}", dice.pick(&["a", "b", "c d", "#", "\u{e4}"])),
        17 => dice
            .pick(&["o a", "g", "g b c", "o \u{1b}[2J", "s off", "# comment \\"])
            .to_string(),
        18 if dice.one_in(2) => format!(
            "mtllib {}",
            dice.pick(&["x.mtl", "./x.mtl", "y.mtl", "m.obj"])
        ),
        19 if dice.one_in(wrong) => dice
            .pick(&[
                "mtllib ../x.mtl",
                "mtllib /etc/passwd",
                "v 1 2 \\",
                "mtllib .\\x.mtl",
                "mtllib y.mtl x.mtl",
                "f",
                "f 1 2 \\",
                "usemtl",
                "\u{0}",
                "v 1 2 3 0",
            ])
            .to_string(),
        _ => dice
            .pick(&[
                "l 1 2",
                "p 1",
                "vp 1 2",
                "call other.obj",
                "",
                "v 0 0 0 2",
                "v 1 0 0 1 0 0",
                "v 1 0 \\\n0",
                "vt 0.5",
                "vn 0 0 0",
                "s 1",
                "curv 0 1 1 2",
            ])
            .to_string(),
    }
}

fn number(dice: &mut Dice, wrong: usize) -> String {
    if dice.one_in(wrong) {
        dice.pick(&NUMBERS).to_string()
    } else if dice.one_in(3) {
        dice.pick(&NUMBERS[..8]).to_string()
    } else {
        format!("{:.2}", dice.between(-3.0, 3.0))
    }
}

fn corner(dice: &mut Dice, wrong: usize, counts: [usize; 3]) -> String {
    if dice.one_in(wrong) {
        return dice.pick(&INDICES).to_string();
    }
    let [v, t, n] = counts.map(|count| {
        let index = 1 + dice.below(count);
        if dice.one_in(9) {
            format!("-{index}")
        } else {
            index.to_string()
        }
    });
    match dice.below(8) {
        0 if counts[1] > 0 => format!("{v}/{t}"),
        1 if counts[2] > 0 => format!("{v}//{n}"),
        2 if counts[1] > 0 && counts[2] > 0 => format!("{v}/{t}/{n}"),
        _ => v,
    }
}

/// The text of an MTL file.
pub fn mtl(dice: &mut Dice) -> String {
    let wrong = [10, 300, 1_000_000][dice.below(3)];
    let mut text = String::new();
    for name in 0..dice.few(8) {
        text += &format!(
            "newmtl {}\n",
            ["a", "b", "c d", "", "a", "\u{7}", "d", "e"][name % 8]
        );
        for _ in 0..dice.few(10) {
            let key = dice.pick(&[
                "Ka", "Kd", "Ks", "Ke", "Ns", "Ni", "d", "Tr", "illum", "map_Kd", "Tf", "Pr",
            ]);
            let size = match key {
                "Ka" | "Kd" | "Ks" | "Ke" | "Tf" => 3,
                _ => 1,
            };
            let size = if dice.one_in(wrong) {
                dice.below(5)
            } else {
                size
            };
            let numbers: Vec<_> = (0..size)
                .map(|_| {
                    if dice.one_in(wrong) {
                        dice.pick(&NUMBERS).to_string()
                    } else if key == "illum" {
                        dice.below(11).to_string()
                    } else {
                        format!("{:.2}", dice.between(0.1, 1.0))
                    }
                })
                .collect();
            text += &format!("{key} {}\n", numbers.join(" "));
        }
    }
    text
}
