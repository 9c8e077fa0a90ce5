//! Large courses: shards merged are one run, byte for byte; threads change nothing.

use std::fs;

use serde_json::Value;

use super::class::{Class, Mistake};
use super::satisfies;

/// A class in which five share a mistake that has no name.
fn large() -> Class {
    let class = Class::new();
    for name in ["u1", "u2", "u3", "u4", "u5"] {
        class.hand_in(name, Mistake::Scaled(1.37));
    }
    class.hand_in("v", Mistake::Scaled(1.9));
    class
}

#[test]
fn merged_shards_are_one_run_byte_for_byte() {
    let class = large();
    let all = class.submissions().join(" ");
    for threads in [1, 8] {
        let arguments = format!("task.toml {all} --threads {threads}");
        let outputs = format!("--output json=all{threads}.json --output csv=all{threads}.csv");
        let (status, _, told) = class.run(&format!("{arguments} {outputs}"));
        assert_eq!(status, 0, "{told}");
    }
    let read = |name: &str| fs::read(class.path(name)).expect(name);
    assert_eq!(read("all1.json"), read("all8.json"));
    for shard in 1..=3 {
        let output = format!("--shard {shard}/3 --output json=part{shard}.json");
        let (status, _, told) = class.run(&format!("task.toml {all} {output}"));
        assert_eq!(status, 0, "{told}");
        let part: Value =
            serde_json::from_slice(&read(&format!("part{shard}.json"))).expect("JSON");
        satisfies(&part, "raytree-grade-1.json");
        // No shard alone has five of them.
        assert_eq!(
            part["unknown"].as_array().map(Vec::len),
            Some(0),
            "{part:#}"
        );
    }
    // In whatever order they come.
    let files = "part3.json part1.json part2.json";
    let outputs = "--output json=merged.json --output csv=merged.csv";
    let (status, _, told) = class.run(&format!("--merge {files} {outputs}"));
    assert_eq!(status, 0, "{told}");
    assert_eq!(read("merged.json"), read("all1.json"));
    assert_eq!(read("merged.csv"), read("all1.csv"));
    let merged: Value = serde_json::from_slice(&read("merged.json")).expect("JSON");
    let unknown = merged["unknown"].as_array().expect("a list");
    assert_eq!(unknown.len(), 1, "{unknown:#?}");
    assert_eq!(unknown[0]["ratio"], "1.4e0");
    assert_eq!(unknown[0]["submissions"].as_array().map(Vec::len), Some(5));
}

#[test]
fn what_does_not_belong_together_is_not_merged() {
    let class = Class::new();
    let all = class.submissions().join(" ");
    let part = |file: &str, flags: &str| {
        let (status, _, told) = class.run(&format!("task.toml {all} --output json={file} {flags}"));
        assert_eq!(status, 0, "{told}");
    };
    part("a.json", "--shard 1/2");
    part("b.json", "--shard 2/2 --student");
    part("c.json", "--shard 2/3");
    part("d.json", "");
    let task = fs::read_to_string(class.path("task.toml")).expect("a task");
    fs::write(class.path("task.toml"), task + "\n# changed\n").expect("written");
    part("e.json", "--shard 2/2");
    fs::write(class.path("f.json"), "{\"format\": \"raytree/1\"}").expect("written");
    for (files, what) in [
        ("a.json", "shard 2/2 is missing"),
        ("a.json a.json", "twice"),
        ("a.json b.json", "--student"),
        ("a.json c.json", "different --shard"),
        ("a.json d.json", "some are not"),
        ("a.json e.json", "two versions"),
        ("f.json", "is no raytree-grade/1"),
        ("none.json", "there is no such file"),
    ] {
        let (status, _, told) = class.run(&format!("--merge {files}"));
        assert_eq!(status, 1, "{files}: {told}");
        assert!(told.contains(what), "{files}: {told}");
    }
}
