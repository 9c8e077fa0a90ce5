//! What students hand in, and what nobody should: each hostile file is refused in words, soon and in bounded memory, and the
//! others are read.

use std::time::{Duration, Instant};

use raytree::grade::submission::Submission;
use raytree::grade::submission::picture::{picture, picture_size};
use raytree::scene::printable::is_printable;

use super::bytes;
use super::dice::Dice;
use super::laws::{catch_panics, without_panic};
use super::memory::counted;
use super::zips::{Packed, archive};

/// The longest that a hostile submission may take; more where the program is not optimised.
const SOON: Duration = Duration::from_secs(if cfg!(debug_assertions) { 10 } else { 2 });
/// Bytes of memory: what a submission may have unpacked, twice, since room grows by doubling, and a little.
const MOST: usize = (2 * 256 + 32) << 20;

fn good() -> Packed {
    Packed::new("good.json", br#"{"root":{"kind":"I"}}"#)
}

/// Reads an archive with a good file beside bad ones: it is read, and `said` is told.
#[track_caller]
fn refused(bad: Vec<Packed>, overlapping: bool, said: &str) {
    let zip = if overlapping {
        archive(&bad, true)
    } else {
        archive(&[good()].into_iter().chain(bad).collect::<Vec<_>>(), false)
    };
    let start = Instant::now();
    let (read, memory) = counted(|| Submission::of_bytes("alice.zip", zip));
    let took = start.elapsed();
    let has_good = read.files.iter().any(|file| file.name == "good.json");
    let names: Vec<&str> = read.files.iter().map(|file| file.name.as_str()).collect();
    assert!(
        has_good || overlapping,
        "{said}: {names:?} {:?}",
        read.problems
    );
    assert!(
        read.problems.iter().any(|problem| problem.contains(said)),
        "{said}: {names:?} {:?}",
        read.problems
    );
    assert!(memory.peak <= MOST, "{said}: {memory:?}");
    assert!(took < SOON, "{said}: {took:?}");
    let total: usize = read.files.iter().map(|file| file.bytes.len()).sum();
    assert!(total <= 256 << 20 && read.files.len() <= 2000);
}

#[test]
fn archives_that_grow_are_refused() {
    let bomb = |mib: usize| Packed::new("bomb.json", &vec![b' '; mib << 20]);
    refused(
        vec![bomb(63)],
        false,
        "`bomb.json` is refused: it unpacks to more than 200 times",
    );
    // Nothing that it says of itself helps.
    let small = Packed {
        claimed: 10,
        ..bomb(63)
    };
    refused(vec![small], false, "`bomb.json` is refused");
    let large = Packed {
        claimed: u32::MAX,
        ..bomb(8)
    };
    refused(vec![large], false, "`bomb.json` is refused");
    let stored = Packed {
        data: vec![b' '; 65 << 20],
        method: 0,
        claimed: 65 << 20,
        ..good()
    };
    refused(
        vec![Packed {
            name: b"long.json".to_vec(),
            ..stored
        }],
        false,
        "more than 64 MiB",
    );
    // Many that are allowed one by one.
    let part = |n: usize| Packed {
        name: format!("{n}.json").into_bytes(),
        ..Packed::new("", &vec![b' '; 1 << 20])
    };
    refused(
        (0..300).map(part).collect(),
        false,
        "the submission has more than 256 MiB",
    );
    // All of them the same bytes of the archive.
    refused((0..1500).map(part).collect(), true, "more than 256 MiB");
    refused(
        (0..2100)
            .map(|n| Packed {
                name: n.to_string().into_bytes(),
                ..good()
            })
            .collect(),
        true,
        "2000 files at most",
    );
    refused(
        (0..10_100)
            .map(|n| Packed {
                name: n.to_string().into_bytes(),
                ..good()
            })
            .collect(),
        true,
        "more than 10000 entries",
    );
}

#[test]
fn entries_that_are_no_files_of_their_own_are_refused() {
    let named = |name: &[u8]| Packed {
        name: name.to_vec(),
        ..good()
    };
    for (name, said) in [
        (&b"../out.json"[..], "leads out of its folder"),
        (b"a/../../out.json", "leads out of its folder"),
        (b"a\\..\\..\\out.json", "leads out of its folder"),
        (b"/etc/passwd", "starts at the root"),
        (b"\\\\server\\share", "starts at the root"),
        (b"C:\\out.json", "colon"),
        (b"C:out.json", "colon"),
        (b"\xff\xfe.json", "not UTF-8"),
        (b"a\0b.json", "control character"),
        (b"\x1b[2J.json", "control character"),
        (b"GOOD.json", "nothing but capitals"),
        (&[b'a'; 201], "more than 200 bytes"),
    ] {
        // The twin is the one that comes later.
        refused(vec![named(name)], false, said);
    }
    for (mode, said) in [
        (0o120_777, "is a link"),
        (0o020_644, "no regular file"),
        (0o060_644, "no regular file"),
        (0o010_644, "no regular file"),
    ] {
        refused(
            vec![Packed {
                mode,
                ..named(b"odd.json")
            }],
            false,
            said,
        );
    }
    let inner = archive(&[good()], false);
    refused(
        vec![Packed::new("inner.zip", &inner)],
        false,
        "`inner.zip` is refused: it is an archive (zip)",
    );
    refused(
        vec![Packed::new("inner.json", &inner)],
        false,
        "is an archive (zip)",
    );
    refused(
        vec![Packed::new("inner.tar.gz", b"\x1f\x8b")],
        false,
        "is an archive (gzip)",
    );
    refused(
        vec![Packed {
            sum: 7,
            ..named(b"sum.json")
        }],
        false,
        "`sum.json` is refused",
    );
    refused(
        vec![Packed {
            data: vec![0xff; 9],
            ..named(b"torn.json")
        }],
        false,
        "`torn.json` is refused",
    );
    refused(
        vec![Packed {
            method: 99,
            ..named(b"method.json")
        }],
        false,
        "`method.json` is refused: it cannot be read: compression method",
    );
    let cut = archive(&[good()], false);
    let read = Submission::of_bytes("a.zip", cut[..cut.len() - 30].to_vec());
    assert!(
        read.files.is_empty() && read.problems[0].contains("the archive cannot be read"),
        "{read:?}"
    );
}

#[cfg(unix)]
#[test]
fn links_pipes_and_odd_names_in_a_folder_are_refused() {
    use std::ffi::OsStr;
    use std::fs;
    use std::os::unix::ffi::OsStrExt as _;
    use std::os::unix::fs::symlink;

    let folder = tempfile::tempdir().expect("a folder");
    let outside = tempfile::tempdir().expect("a folder");
    fs::write(outside.path().join("secret.json"), "secret").expect("a file");
    let top = folder.path();
    fs::create_dir_all(top.join("part/.git")).expect("folders");
    for name in [
        "good.json",
        "part/two.json",
        "part/.git/hidden",
        "GOOD.json",
        "a.zip",
    ] {
        fs::write(top.join(name), "{}").expect("a file");
    }
    symlink(outside.path().join("secret.json"), top.join("link.json")).expect("a link");
    symlink(outside.path(), top.join("folder")).expect("a link");
    symlink("/dev/zero", top.join("zero.json")).expect("a link");
    symlink(top, top.join("part/circle")).expect("a link");
    let pipe = std::process::Command::new("mkfifo")
        .arg(top.join("pipe.json"))
        .status();
    let has_pipe = pipe.is_ok_and(|status| status.success());
    fs::write(top.join(OsStr::from_bytes(b"\xff.json")), "{}").expect("a file");
    let deep = top.join("d/".repeat(40));
    fs::create_dir_all(&deep).expect("folders");
    fs::File::create(top.join("long.json"))
        .and_then(|file| file.set_len(65 << 20))
        .expect("a file");
    let start = Instant::now();
    let read = Submission::read(top);
    assert!(start.elapsed() < SOON, "{:?}", start.elapsed());
    let names: Vec<&str> = read.files.iter().map(|file| file.name.as_str()).collect();
    assert_eq!(names, ["GOOD.json", "part/two.json"]);
    let all = read.problems.join("\n");
    for said in [
        "`good.json` is refused: its name differs from `GOOD.json`",
        "`link.json` is refused: it is a link",
        "`folder` is refused: it is a link",
        "`zero.json` is refused: it is a link",
        "`part/circle` is refused: it is a link",
        "not UTF-8",
        "32 folders deep",
        "`long.json` is refused: it has more than 64 MiB",
        "`a.zip` is refused: it is an archive (zip)",
    ] {
        assert!(all.contains(said), "{said} is not in {all}");
    }
    assert!(
        !has_pipe || all.contains("`pipe.json` is refused: it is no regular file"),
        "{all}"
    );
    assert!(!all.contains("hidden"));
}

#[test]
fn a_submission_is_a_folder_an_archive_or_a_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("alice");
    std::fs::create_dir(&path).expect("a folder");
    std::fs::write(path.join("a.json"), "{}").expect("a file");
    let zip = archive(
        &[
            Packed::new("b/", b""),
            Packed::new("b/a.json", b"{}"),
            Packed::new("__MACOSX/b/._a.json", b"x"),
        ],
        false,
    );
    std::fs::write(folder.path().join("bob.zip"), zip).expect("a file");
    std::fs::write(folder.path().join("carol.ndjson"), "{}").expect("a file");
    for (name, student, file) in [
        ("alice", "alice", "a.json"),
        ("bob.zip", "bob", "b/a.json"),
        ("carol.ndjson", "carol", "carol.ndjson"),
    ] {
        let read = Submission::read(&folder.path().join(name));
        assert_eq!(
            (read.name.as_str(), read.problems.len()),
            (student, 0),
            "{:?}",
            read.problems
        );
        assert_eq!(read.files.len(), 1);
        assert_eq!(
            (read.files[0].name.as_str(), &read.files[0].bytes[..]),
            (file, &b"{}"[..])
        );
        assert_eq!(read.file(file), Some(&read.files[0]));
    }
    let missing = Submission::read(&folder.path().join("dave.zip"));
    assert_eq!((missing.name.as_str(), missing.problems.len()), ("dave", 1));
    let null = Submission::read(std::path::Path::new("/dev/null"));
    assert!(null.files.is_empty() && null.problems.len() == 1);
}

fn check(zip: &[u8]) -> Result<bool, String> {
    let read = || Ok(counted(|| Submission::of_bytes("a.zip", zip.to_vec())));
    let start = Instant::now();
    let (read, memory) = without_panic(read).map_err(|broken| broken.how)?;
    if memory.peak > MOST || start.elapsed() > SOON {
        return Err(format!("{memory:?}, {:?}", start.elapsed()));
    }
    let clean = read
        .problems
        .iter()
        .all(|p| p.chars().all(is_printable) && p.chars().count() < 800);
    let inside = read
        .files
        .iter()
        .all(|f| !f.name.starts_with('/') && !f.name.split('/').any(|part| part == ".."));
    if !clean || !inside {
        return Err(format!("{:?}", read.problems));
    }
    for file in &read.files {
        let size = picture_size(&file.bytes);
        if let Ok(size) = size
            && size.0 < 100
            && size.1 < 100
        {
            let _ =
                without_panic(|| Ok(picture(&file.bytes, size))).map_err(|broken| broken.how)?;
        }
    }
    Ok(!read.files.is_empty())
}

#[test]
fn whatever_is_in_an_archive_it_is_files_or_problems() {
    catch_panics();
    let ppm = Packed::new("a.ppm", b"P3 2 1 255\n1 2 3 4 5 6\n");
    let raw = Packed {
        method: 0,
        data: b"P6 2 1 255\n123456".to_vec(),
        ..Packed::new("b.ppm", b"P6 2 1 255\n123456")
    };
    let known = [
        archive(&[good(), ppm], false),
        archive(&[raw, Packed::new("c/", b"")], false),
        archive(&[good(), good()], true),
    ];
    for zip in &known {
        assert_eq!(check(zip), Ok(true));
    }
    let many = super::environment("RAYTREE_FUZZ_TREES").unwrap_or(6000);
    let (mut taken, mut refused) = (0, 0);
    for number in 0..many {
        let dice = &mut Dice::new(14, number);
        let mut file = known[dice.below(known.len())].clone();
        let other = &known[dice.below(known.len())];
        bytes::change(dice, &mut file, other);
        match check(&file) {
            Ok(true) => taken += 1,
            Ok(false) => refused += 1,
            Err(how) => panic!("archive {number}: {how}: {file:?}"),
        }
    }
    println!("{taken} with files, {refused} without");
    assert!(taken > 200 && refused > 200, "{taken}, {refused}");
}
