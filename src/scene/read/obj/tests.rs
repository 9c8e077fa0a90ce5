//! The reader against what it must do with every line, against itself in other pieces, and against another reader.

use std::fmt::Write;

use super::surface::{ObjSurface, read, read_in_pieces};
use crate::sampling::stream::splitmix64;

const THREE: &str = "v 0 0 0\nv 1 0 0 1\nv 0 1 0 0.5 0.5 0.5\nvn 0 0 1\nvt 0 0\n";

fn error(line: &str) -> Option<usize> {
    read(&format!("{THREE}{line}")).err().map(|e| e.0)
}

#[test]
fn good_lines_pass() {
    for line in [
        "f 1 2 3",
        "f 1/1 2/1 3/1",
        "f 1//1 2//-1 -1//1",
        "f 1/1/1 2/1/1 3/1/1 # end",
    ] {
        assert_eq!(error(line), None, "{line}");
    }
}

#[test]
fn bad_lines_are_told_by_number() {
    for line in [
        "f",
        "f 0 1 2",
        "f 1 2 4",
        "f 1 2 -4",
        "f 1 2 99999999999999999999",
        "f 1 2 x",
        "f 1/2 2/1 3/1",
        "f 1//9223372036854775807 2//1 3//1",
        "f 1/1/1/1 2 3",
        "f / / /",
        "v nan 0 0",
        "v 0 inf 0",
        "v 0 0 1e39",
        "v 0 0",
        "v 0 0 0 0",
        "v 0,5 0 0",
        "vn 0 0",
        "vt 0",
        "f 1 2 \\",
        "usemtl",
    ] {
        assert_eq!(error(line), Some(6), "{line}");
    }
}

#[test]
fn the_first_mistake_counts_whichever_pass_finds_it() {
    for (text, line) in [
        ("v 0 0 0\nf 1 2 3\nv nan 0 0\n", 2),
        ("v 0 0 0\nv nan 0 0\nf 1 2 3\n", 2),
        // What follows a mistake is not read, and nothing may rely on it.
        (
            "v nan 0 0\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4 5\n",
            1,
        ),
    ] {
        for size in [1, 10, 1000] {
            assert_eq!(
                read_in_pieces(text, size).err().map(|e| e.0),
                Some(line),
                "{text:?}"
            );
        }
    }
}

#[test]
fn faces_without_surface_are_counted() {
    let text = format!("{THREE}f 1\nf 1 2\nf 1//1 2//1 3\nl 1 2 3");
    for size in [1, 1000] {
        let found = read_in_pieces(&text, size).expect("good").faces;
        assert_eq!(found.edges, (2, 6));
        assert_eq!(found.triangles, [[0, 1, 2]]);
        // One corner without a normal: the face has none.
        assert_eq!(found.normals, [[u32::MAX; 3]]);
    }
}

/// A file of `count` lines of all kinds, every number from a seed.
fn random(seed: u64, count: u32) -> String {
    let mut state = seed;
    let mut next = |below: u32| {
        state = splitmix64(state);
        (state >> 32) as u32 % below
    };
    let mut text = String::from(THREE);
    let [mut points, mut uvs, mut normals] = [3, 1, 1];
    for line in 0..count {
        match next(12) {
            0..3 => {
                let [x, y, z] = [(); 3].map(|()| f64::from(next(2000)) / 512.0);
                let _ = writeln!(text, "v {x} {y} {z}");
                points += 1;
            }
            3 => {
                let _ = writeln!(text, "vt 0.{} {}", next(100), next(3));
                uvs += 1;
            }
            4 => {
                let _ = writeln!(text, "vn {} 1 {}", next(5), next(5));
                normals += 1;
            }
            5 => {
                let _ = writeln!(text, "g part {line}\r");
            }
            _ => {
                let back = next(2) == 0;
                let kind = next(4);
                let mut any = |count: u32| {
                    let i = i64::from(next(count));
                    if back { i - i64::from(count) } else { i + 1 }
                };
                let corners: Vec<String> = (0..3)
                    .map(|_| match (any(points), any(uvs), any(normals), kind) {
                        (v, _, _, 0) => format!("{v}"),
                        (v, t, _, 1) => format!("{v}/{t}"),
                        (v, _, n, 2) => format!("{v}//{n}"),
                        (v, t, n, _) => format!("{v}/{t}/{n}"),
                    })
                    .collect();
                let _ = writeln!(text, "f {}", corners.join(" "));
            }
        }
    }
    text
}

/// All that was read, to compare.
fn all(surface: &ObjSurface) -> String {
    format!("{surface:?}")
}

#[test]
fn the_size_of_the_pieces_does_not_matter() {
    for seed in 0..20 {
        let text = random(seed, 200);
        let whole = all(&read_in_pieces(&text, usize::MAX >> 1).expect("good"));
        for size in [1, 30, 999] {
            assert_eq!(all(&read_in_pieces(&text, size).expect("good")), whole);
        }
    }
}

/// The crate `tobj` finds the same parts with the same names, and the same triangles in them.
#[test]
fn another_reader_finds_the_same() {
    for seed in 0..50 {
        // It has no file in which some points have a colour and some have none.
        let text = random(seed, 100).replace(" 0.5 0.5 0.5", "");
        let loaded =
            tobj::load_obj_buf(&mut text.as_bytes(), &tobj::LoadOptions::default(), |_| {
                Err(tobj::LoadError::OpenFileFailed)
            });
        let (mut models, _) = loaded.expect("tobj reads it");
        // A name at the end, with no face after it, is a model to it.
        models.retain(|model| !model.mesh.indices.is_empty());
        let parts = super::parts::parts(read(&text).expect("good"), |_| None);
        assert_eq!(parts.len(), models.len());
        for (part, model) in parts.iter().zip(&models) {
            let theirs = &model.mesh;
            assert_eq!(part.name, model.name.replace("unnamed_object", ""));
            assert_eq!(part.mesh.triangles.len(), theirs.indices.len() / 3);
            for (i, corner) in part.mesh.triangles.iter().flatten().enumerate() {
                let at = theirs.indices[i] as usize * 3;
                let point = part.mesh.points[*corner as usize];
                assert_eq!(point.to_array(), theirs.positions[at..at + 3]);
            }
        }
    }
}
