//! Files that commands write: none that is read is replaced, and what cannot be written is told before the work.

use std::fs;
use std::path::Path;

use super::{refused, run};

const SCENE: &str = r#"{"format": "raytree-scene/1", "camera": {"eye": [0, 0, 4], "look_at": [0, 0, 0]},
  "objects": [{"obj": {"name": "a", "file": "a.obj"}}]}"#;

/// A folder with a scene, its model and the model's materials.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("a file");
    write("in.json", SCENE);
    write(
        "a.obj",
        "mtllib a.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    );
    write("a.mtl", "newmtl m\nKd 1 0 0\n");
    folder
}

fn path(folder: &Path, name: &str) -> String {
    folder.join(name).display().to_string()
}

/// Names and texts of all files of a folder.
fn content(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let entries = fs::read_dir(folder)
        .expect("a folder")
        .map(|e| e.expect("an entry").path());
    let mut all: Vec<_> = entries
        .map(|path| {
            (
                path.display().to_string(),
                fs::read(&path).unwrap_or_default(),
            )
        })
        .collect();
    all.sort();
    all
}

const SMALL: [&str; 2] = ["--size", "8x6"];

#[test]
fn no_output_replaces_what_is_read() {
    let folder = folder();
    let at = |name: &str| path(folder.path(), name);
    // Other names of the same files.
    fs::hard_link(at("a.mtl"), at("hard.png")).expect("a link");
    #[cfg(unix)]
    std::os::unix::fs::symlink("in.json", at("soft.png")).expect("a link");
    let before = content(folder.path());
    let scene = at("in.json");
    let read = "this file is read";
    for file in [
        "in.json", "a.obj", "a.mtl", "./a.mtl", "hard.png", "soft.png",
    ] {
        if !Path::new(&at(file)).exists() {
            continue;
        }
        let file = at(file);
        let size = &SMALL[..];
        refused(
            &[&["render", &scene, "-o", &file], size].concat(),
            2,
            &["--output", read],
        );
        let map = ["render", &scene, "--error-map", &file];
        refused(&[&map, size].concat(), 2, &["--error-map", read]);
        let samples = ["render", &scene, "--adaptive", "0.1", "--sample-map", &file];
        refused(&[&samples, size].concat(), 2, &["--sample-map", read]);
        let trace = ["trace", &scene, "--pixel", "1,1", "-o", &file];
        refused(&[&trace, size].concat(), 2, &["--output", read]);
        for flag in ["--plot", "--strip"] {
            refused(&["cost", &scene, flag, &file], 2, &[flag, read]);
        }
        refused(&["render", &at("a.obj"), "-o", &at("a.mtl")], 2, &[read]);
    }
    let reference = at("r.pfm");
    fs::write(&reference, "PF\n1 1\n-1\n123456789012").expect("a file");
    let cost = ["cost", "triangle", "--reference", &reference];
    refused(
        &[&cost[..], &["--strip", &reference]].concat(),
        2,
        &["--strip", read],
    );
    fs::remove_file(reference).expect("it is there");
    assert_eq!(content(folder.path()), before);
}

#[test]
fn two_results_do_not_share_a_file() {
    let folder = folder();
    let at = |name: &str| path(folder.path(), name);
    fs::write(at("old.png"), "old").expect("a file");
    fs::hard_link(at("old.png"), at("other.png")).expect("a link");
    let twice = |a: &str, b: &str| {
        let render = ["render", "triangle", "-o", &at(a), "--error-map", &at(b)];
        refused(
            &[&render, &SMALL[..]].concat(),
            2,
            &["--error-map", "file of --output"],
        );
    };
    twice("new.png", "new.png");
    twice("new.png", "./new.png");
    twice("old.png", "other.png");
    assert!(!Path::new(&at("new.png")).exists());
    let cost = ["cost", "triangle", "--plot", &at("x"), "--strip", &at("x")];
    refused(&cost, 2, &["--strip", "file of --plot"]);
    // Nothing is lost in a device.
    let null = [
        "render",
        "triangle",
        "-o",
        "/dev/null",
        "--error-map",
        "/dev/null",
    ];
    #[cfg(unix)]
    assert_eq!(run(&[&null, &SMALL[..]].concat()).code, 0);
}

#[test]
fn a_name_says_what_is_in_the_file() {
    let folder = folder();
    let at = |name: &str| path(folder.path(), name);
    for name in ["a.jpg", "a.JPEG", "a.svg", "a.gif", "new.obj", "new.json"] {
        let words = ["--output", name, ".png or .pfm"];
        refused(&["render", "triangle", "-o", &at(name)], 2, &words);
    }
    let map = ["--adaptive", "0.1", "--sample-map", &at("a.pfm")];
    refused(
        &[&["render", "triangle"], &map[..]].concat(),
        2,
        &["--sample-map", ".png"],
    );
    let trace = ["trace", "triangle", "--pixel", "0,0", "-o", &at("a.svg")];
    refused(&trace, 2, &["--output", ".json"]);
    assert_eq!(run(&[&trace[..], &["--format", "svg"]].concat()).code, 0);
    refused(
        &["cost", "triangle", "--plot", &at("a.png")],
        2,
        &["--plot", ".svg"],
    );
    // What says nothing is not wrong.
    for name in ["picture", "picture.new"] {
        assert_eq!(
            run(&[&["render", "triangle", "-o", &at(name)], &SMALL[..]].concat()).code,
            0
        );
        assert!(fs::read(at(name)).expect("written").starts_with(b"\x89PNG"));
    }
}

/// As many rays as one likes: what cannot be written must be told before them.
const ENDLESS: [&str; 8] = [
    "--size",
    "4000x4000",
    "--samples",
    "4096",
    "--max-rays",
    "1000000000000",
    "--sampling",
    "random",
];

#[test]
fn what_cannot_be_written_is_told_before_the_first_ray() {
    let folder = folder();
    let at = |name: &str| path(folder.path(), name);
    fs::write(at("old.png"), "old").expect("a file");
    let mut mode = fs::metadata(at("old.png")).expect("a file").permissions();
    mode.set_readonly(true);
    fs::set_permissions(at("old.png"), mode).expect("a mode");
    let before = content(folder.path());
    let long = "n".repeat(300);
    for (name, words) in [
        ("missing/a.png", "its folder does not exist"),
        ("old.png", "read-only"),
        ("in.json/a.png", "cannot be written"),
        (".", "this is a folder"),
        ("new/", "this is a folder"),
        (long.as_str(), "cannot be written"),
    ] {
        let words = ["cannot be written", words];
        for flag in ["-o", "--error-map"] {
            refused(
                &[&["render", "whitted", flag, &at(name)], &ENDLESS[..]].concat(),
                1,
                &words,
            );
        }
    }
    refused(&["render", "whitted", "-o", ""], 2, &["--output"]);
    let cost = [
        "cost",
        "whitted",
        "--budget",
        "1000",
        "--plot",
        &at("missing/a.svg"),
    ];
    refused(&cost, 1, &["its folder does not exist"]);
    assert_eq!(content(folder.path()), before);
}

#[test]
#[cfg(unix)]
fn a_replaced_file_keeps_its_mode_and_links_are_followed() {
    use std::os::unix::fs::{PermissionsExt as _, symlink};
    let folder = folder();
    let at = |name: &str| path(folder.path(), name);
    let mode = |name: &str| {
        let metadata = fs::metadata(at(name)).expect("a file");
        metadata.permissions().mode() & 0o777
    };
    let render = |name: &str| {
        let ran = run(&[&["render", "triangle", "-o", &at(name)], &SMALL[..]].concat());
        assert_eq!((ran.code, ran.err.as_str()), (0, ""), "{name}");
    };
    let is_link = |name: &str| fs::symlink_metadata(at(name)).expect("there").is_symlink();
    let is_png = |name: &str| fs::read(at(name)).is_ok_and(|b| b.starts_with(b"\x89PNG"));
    for wanted in [0o600, 0o640, 0o777] {
        fs::write(at("secret.png"), "old").expect("a file");
        fs::set_permissions(at("secret.png"), fs::Permissions::from_mode(wanted)).expect("a mode");
        render("secret.png");
        assert!(is_png("secret.png"));
        assert_eq!(mode("secret.png"), wanted);
    }
    // To a file, to one that is not there yet, and over another link into a folder.
    fs::create_dir(at("folder")).expect("a folder");
    fs::write(at("target.png"), "old").expect("a file");
    for (link, to) in [
        ("link.png", "target.png"),
        ("dangling.png", "new.png"),
        ("first.png", "folder/second.png"),
        ("folder/second.png", "third.png"),
    ] {
        symlink(to, at(link)).expect("a link");
    }
    for (link, file) in [
        ("link.png", "target.png"),
        ("dangling.png", "new.png"),
        ("first.png", "folder/third.png"),
    ] {
        render(link);
        assert!(is_link(link) && !is_link(file) && is_png(file), "{link}");
    }
    assert!(is_link("folder/second.png"));
    symlink("round.png", at("round.png")).expect("a link");
    refused(
        &["render", "triangle", "-o", &at("round.png")],
        1,
        &["cannot be written"],
    );
}

/// A command that is ended while it works leaves nothing beside its result, and the old one untouched.
#[test]
#[cfg(unix)]
fn an_ended_command_leaves_nothing_behind() {
    let folder = folder();
    let at = |name: &str| path(folder.path(), name);
    fs::write(at("t.json"), "old").expect("a file");
    let before = content(folder.path());
    for signal in ["INT", "TERM", "HUP", "KILL"] {
        for wait in [50, 400] {
            let trace = [
                "trace",
                "spd:balls:3",
                "--pixel",
                "160,120",
                "--samples",
                "4096",
                "--max-rays",
                "1000000000000",
                "-o",
            ];
            let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_raytree"))
                .args(trace)
                .arg(at("t.json"))
                .stderr(std::process::Stdio::null())
                .spawn()
                .expect("runs");
            std::thread::sleep(std::time::Duration::from_millis(wait));
            let id = child.id().to_string();
            let kill = std::process::Command::new("kill")
                .args(["-s", signal, &id])
                .status();
            assert!(kill.expect("kill").success());
            let status = child.wait().expect("it ends");
            assert!(!status.success(), "{signal} ends it");
            assert_eq!(content(folder.path()), before, "{signal} after {wait} ms");
        }
    }
}

/// No message shows a name that the user never gave.
#[test]
#[cfg(target_os = "linux")]
fn a_full_device_is_told_by_its_own_name() {
    let render = ["render", "triangle", "-o", "/dev/full"];
    let words = ["/dev/full: cannot be written", "No space left"];
    refused(&[&render, &SMALL[..]].concat(), 1, &words);
}
