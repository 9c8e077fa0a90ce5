//! `raytree reduce` on the command line.

use std::fs;

use serde_json::Value;

use crate::cli::{refused, run};

#[test]
fn the_reduced_scene_has_the_tree_on_the_command_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("small.json");
    let file = file.to_str().expect("UTF-8");
    let size = ["--size", "80x60", "--samples", "2"];
    let ran = run(&[
        &["reduce", "whitted", "--at", "40,30", "-o", file][..],
        &size,
    ]
    .concat());
    assert_eq!((ran.code, ran.err.as_str()), (0, ""));
    let line = String::from_utf8(ran.out).expect("UTF-8");
    let words = [
        " of 3 objects, ",
        " shapes, ",
        "1 of 1 lights; the tree of 40,30 is the same: ",
        " rays\n",
    ];
    for word in words {
        assert!(line.contains(word), "{line}");
    }
    // With the settings in the file; its tree stands under another name.
    let tree = |args: &[&str]| -> Value {
        let ran = run(args);
        assert_eq!(ran.code, 0, "{}", ran.err);
        serde_json::from_slice(&ran.out).expect("JSON")
    };
    let before = tree(&[&["trace", "whitted@40,30"][..], &size].concat());
    let after = tree(&["trace", file, "--pixel", "40,30"]);
    assert_eq!(after["samples"], before["samples"]);
    assert_eq!(after["color"], before["color"]);
    // It may be made again in the same place, but never of itself.
    let again = run(&[&["reduce", "whitted@40,30", "-o", file][..], &size].concat());
    assert_eq!(again.code, 0, "{}", again.err);
    let text = fs::read_to_string(file).expect("a file");
    refused(
        &["reduce", file, "--at", "40,30", "-o", file],
        2,
        &["this file is read"],
    );
    assert_eq!(fs::read_to_string(file).expect("a file"), text);
    // What is small is as small as that again.
    let twice = run(&["reduce", file, "--at", "40,30"]);
    let count = |line: &str| line.split(' ').next().and_then(|n| n.parse::<u32>().ok());
    assert_eq!(count(&twice.err), count(&line), "{}", twice.err);
}

#[test]
fn without_a_file_the_scene_goes_to_standard_output() {
    let ran = run(&["reduce", "room@10,10", "--size", "32x24", "--keep-tests"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    let scene: Value = serde_json::from_slice(&ran.out).expect("JSON");
    assert_eq!(scene["format"], "raytree-scene/1");
    assert_eq!(scene["settings"]["size"], serde_json::json!([32, 24]));
    assert!(
        ran.err.contains("of 36 triangles") && ran.err.lines().count() == 1,
        "{}",
        ran.err
    );
    let quiet = run(&[
        "reduce",
        "room@10,10",
        "--size",
        "32x24",
        "--keep-tests",
        "-q",
    ]);
    assert_eq!((quiet.out, quiet.err.as_str()), (ran.out, ""));
}

#[test]
fn settings_without_a_field_are_told() {
    let flags = ["--size", "32x24", "--bend", "fov-full"];
    let told = run(&[&["reduce", "room@10,10"][..], &flags].concat());
    assert_eq!(told.code, 0, "{}", told.err);
    let words = "the tree is the same with --bend fov-full";
    assert!(told.err.contains(words), "{}", told.err);
    let flags = [
        "--size",
        "32x24",
        "--without",
        "shadows",
        "--offset",
        "none",
    ];
    let told = run(&[&["reduce", "room@10,10"][..], &flags].concat());
    assert_eq!(told.code, 0, "{}", told.err);
    assert!(
        told.err.contains("--offset none") && told.err.contains("--without shadows"),
        "{}",
        told.err
    );
}

#[test]
fn what_cannot_be_reduced_is_told() {
    refused(&["reduce", "whitted"], 2, &["no pixel is told", "--at X,Y"]);
    refused(
        &["reduce", "whitted", "--at", "320,0"],
        2,
        &["outside the picture of 320x240"],
    );
    refused(&["reduce", "whitted", "--at", "1"], 2, &["is no pixel"]);
    refused(
        &["reduce", "whitted@1,1", "--at", "1,1"],
        2,
        &["told twice"],
    );
    refused(
        &["reduce", "whitted", "--at", "0,0/R"],
        2,
        &["there is no step R"],
    );
    refused(
        &["reduce", "whited", "--at", "0,0"],
        1,
        &["did you mean `whitted`?"],
    );
    refused(
        &["reduce", "whitted@0,0", "-o", "a.png"],
        2,
        &["is no .png file", "ends in .json"],
    );
    refused(
        &["reduce", "whitted@0,0", "-o", "no/such/folder/a.json"],
        1,
        &["folder does not exist"],
    );
    let help = run(&["reduce", "--help"]);
    let help = String::from_utf8(help.out).expect("UTF-8");
    for word in [
        "--keep-tests",
        "--at <ADDRESS>",
        "Ctrl-C",
        "The tree that stays",
    ] {
        assert!(help.contains(word), "{help}");
    }
}
