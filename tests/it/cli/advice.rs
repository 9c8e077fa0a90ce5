//! What is said about a command line that is wrong: what to do, and no advice that does not help.

use std::fs;

use super::{refused, run};

/// A folder of a test, in which the program runs.
fn folder() -> (tempfile::TempDir, impl Fn(&str) -> String) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().to_owned();
    let file = move |name: &str| path.join(name).to_str().expect("UTF-8").to_owned();
    (folder, file)
}

/// Every flag that takes a number says itself which are possible: no dash is taken for a flag.
#[test]
fn a_number_below_0_is_met_with_the_range_of_its_flag() {
    let help = String::from_utf8(run(&["render", "--help"]).out).expect("UTF-8");
    let flags: Vec<&str> = help
        .lines()
        .filter_map(|line| line.trim_start().strip_prefix("--"))
        .filter_map(|line| line.split_once(" <"))
        .filter(|(_, rest)| !rest.starts_with("FILE") && !rest.starts_with("PATH"))
        .map(|(flag, _)| flag)
        .collect();
    for flag in [
        "depth",
        "exposure",
        "seed",
        "filter-radius",
        "size",
        "until-error",
    ] {
        assert!(flags.contains(&flag), "{flag} in {flags:?}");
    }
    for flag in flags {
        let ran = run(&["render", "triangle", &format!("--{flag}"), "-1"]);
        assert_eq!(ran.code, 2, "{flag}: {}", ran.err);
        assert!(
            ran.err.contains(&format!("'-1' for '--{flag}")),
            "{}",
            ran.err
        );
        assert!(!ran.err.contains("-- -1"), "{}", ran.err);
    }
    for (args, words) in [
        (&["trace", "whitted", "--pixel", "-1,0"][..], "160,120"),
        (&["trace", "whitted", "--at", "-1,0"], "160,120"),
        (&["cost", "triangle", "--budget", "-1"], "above 0"),
        (&["find", "triangle", "hit", "--first", "-1"], "-1"),
        (&["diff", "whitted@1,1", "whitted@1,1", "--max", "-1"], "-1"),
    ] {
        refused(args, 2, &[words]);
        assert!(!run(args).err.contains("-- -1"), "{args:?}");
    }
}

#[test]
fn a_flag_that_does_not_exist_is_not_called_a_value() {
    for args in [
        &["render", "triangle", "--foo"][..],
        &["trace", "--foo", "triangle"],
        &["grade", "--foo=1"],
        &["--foo"],
    ] {
        let ran = run(args);
        assert_eq!(ran.code, 2);
        assert!(ran.err.contains("'--foo"), "{}", ran.err);
        assert!(!ran.err.contains("-- --foo"), "{}", ran.err);
    }
    refused(&["render", "triangle", "--dept", "3"], 2, &["'--depth'"]);
}

#[test]
fn what_is_no_command_is_met_with_the_command_that_takes_it() {
    let (_folder, file) = folder();
    let scene = file("my scene.json");
    fs::write(&scene, "{}").expect("written");
    let quoted = format!("raytree view '{scene}'");
    for (word, said) in [
        ("whitted", "`raytree view whitted`"),
        ("spd:balls:2", "`raytree view spd:balls:2`"),
        ("whitted@160,120", "`raytree view whitted@160,120`"),
        (scene.as_str(), quoted.as_str()),
        ("rendr", "did you mean `raytree render`?"),
        ("whited", "did you mean `raytree view whitted`?"),
        ("foo", "view, render, raster, trace"),
    ] {
        refused(&[word], 2, &[word, said]);
    }
}

/// A file that is not there is the same mistake wherever it is named.
#[test]
fn a_file_that_is_not_there_is_told_in_one_way() {
    let (_folder, file) = folder();
    let none = file("none.json");
    let task = concat!(env!("CARGO_MANIFEST_DIR"), "/lessons/tasks/hits.toml");
    for args in [
        &["render", &none][..],
        &["diff", "triangle@1,1", &none, "--size", "4x3"],
        &["diff", &none, "triangle@1,1"],
        &["grade", &none, "."],
        &["grade", task, &none],
        &["grade", task, "--students", &none],
        &["grade", "--merge", &none],
        &["view", "triangle", "--marks", &none],
        &["cost", "triangle", "--reference", &none],
    ] {
        refused(
            args,
            1,
            &[&none, "there is no such file", "check the spelling"],
        );
        assert!(!run(args).err.contains("os error"), "{args:?}");
    }
}

#[test]
fn a_file_of_another_kind_is_met_with_the_command_that_takes_it() {
    let (_folder, file) = folder();
    let [tree, flat, marks] = ["t.json", "f.json", "m.json"].map(file);
    let ran = run(&[
        "trace", "whitted", "--size", "8x6", "--pixel", "4,3", "-o", &tree,
    ]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    let ran = run(&["scenes", "whitted", "--flat=json"]);
    fs::write(&flat, ran.out).expect("written");
    fs::write(&marks, r#"{"format": "raytree-marks/1"}"#).expect("written");
    for (path, said) in [
        (&tree, ["a ray tree", "raytree diff SCENE@X,Y FILE"]),
        (&flat, ["a flat scene", "for other programs"]),
        (&marks, ["marks", "--marks FILE"]),
    ] {
        refused(&["render", path], 1, &said);
        let told = run(&["render", path]).err;
        assert!(!told.contains("write \"format\""), "{told}");
    }
}

#[test]
fn a_size_in_the_help_is_that_of_the_command() {
    for (command, words) in [
        ("view", "that of the window"),
        ("cost", "120x90"),
        ("render", "320x240"),
        ("trace", "320x240"),
    ] {
        let help = String::from_utf8(run(&[command, "-h"]).out).expect("UTF-8");
        let lines: Vec<&str> = help.lines().map(str::trim).collect();
        let at = lines.iter().position(|l| l.starts_with("--size"));
        let text = lines[at.expect("a flag")..].join(" ");
        let text = text.split(" --").next().unwrap_or_default();
        assert!(text.contains(words), "{command}: {text}");
        assert!(command != "view" || !text.contains("320x240"), "{text}");
    }
}

#[test]
fn an_event_behind_the_last_one_is_told() {
    let trace = |at: &str| ["trace", "triangle", "--size", "8x6", "--at", at].map(str::to_owned);
    let run_at = |at: &str| {
        let args = trace(at);
        run(&args.each_ref().map(String::as_str))
    };
    let far = run_at("4,3#9999");
    assert_eq!(far.code, 2, "{}", far.err);
    assert!(far.out.is_empty());
    let (_, last) = far.err.trim().rsplit_once('#').expect("the last event");
    let last: usize = last.parse().expect("a number");
    assert!(
        far.err.contains("no event #9999 of pixel 4,3"),
        "{}",
        far.err
    );
    assert_eq!(run_at(&format!("4,3#{last}")).code, 0);
    assert_eq!(run_at(&format!("4,3#{}", last + 1)).code, 2);
}

#[test]
fn a_name_of_another_format_is_met_with_its_flag() {
    let (_folder, file) = folder();
    let base = ["trace", "triangle", "--size", "8x6", "--pixel", "4,3", "-o"];
    for (name, format) in [
        ("a.svg", "svg"),
        ("a.htm", "html"),
        ("a.gv", "dot"),
        ("a.txt", "text"),
        ("a.OBJ", "obj"),
    ] {
        let path = file(name);
        let args = [&base[..], &[&path]].concat();
        refused(&args, 2, &[&path, &format!("--format {format}")]);
        let ran = run(&[&args[..], &["--format", format]].concat());
        assert_eq!(ran.code, 0, "{}", ran.err);
    }
    for args in [
        &["render", "triangle", "-o", &file("a.txt")][..],
        &["find", "triangle", "hit", "--mask", &file("a.txt")],
    ] {
        refused(args, 2, &["a.txt", ".png"]);
    }
}

#[test]
#[cfg(target_os = "linux")]
fn where_no_file_can_be_made_is_told_in_plain_words() {
    let args = ["render", "triangle", "--size", "4x3", "-o", "/proc/x.png"];
    refused(&args, 1, &["/proc/x.png", "no file can be made there"]);
}

/// A black picture has a reason, which is told.
#[test]
fn a_mode_that_has_nothing_to_show_says_why() {
    let show = |more: &[&str]| {
        let ran = run(&[&["render", "whitted", "--size", "8x6"][..], more].concat());
        assert_eq!(ran.code, 0, "{}", ran.err);
        ran.err
    };
    let warned = show(&["--show", "error"]);
    assert!(
        warned.contains("at least 2") && warned.contains("1 sample "),
        "{warned}"
    );
    let many = ["--show", "error", "--samples", "4", "--sampling", "sobol"];
    assert!(!show(&many).contains("warning"));
    let nodes = show(&["--show", "nodes", "--accel", "list"]);
    assert!(nodes.contains("`list` has no nodes"), "{nodes}");
    assert!(!show(&["--show", "nodes", "--accel", "bvh"]).contains("warning"));
    assert!(!show(&["--show", "nodes", "--accel", "list", "-q"]).contains("warning"));
    refused(
        &["render", "triangle", "--until-error", "0.1", "--stats"],
        2,
        &["several pictures", "leave --stats out"],
    );
}

/// What is left out is told beside the reason why the scene needs it; what it does not need changes nothing.
#[test]
fn effects_say_what_is_left_out() {
    let out = |more: &[&str]| {
        let ran = run(&[&["effects", "soft-shadow"][..], more].concat());
        assert_eq!((ran.code, ran.err.as_str()), (0, ""));
        String::from_utf8(ran.out).expect("UTF-8")
    };
    let line = |text: &str, effect: &str| {
        let mut lines = text.lines();
        lines
            .find(|l| l.starts_with(effect))
            .expect(effect)
            .to_owned()
    };
    let plain = out(&[]);
    let text = out(&["--without", "soft-shadows,refraction"]);
    let soft = line(&text, "soft-shadows");
    assert!(soft.starts_with(&line(&plain, "soft-shadows")), "{soft}");
    assert!(
        soft.ends_with("left out: one shadow ray to the middle of each area light: hard shadows"),
        "{soft}"
    );
    assert!(
        line(&text, "refraction").ends_with("without it nothing changes"),
        "{text}"
    );
    assert_eq!(line(&text, "shadows "), line(&plain, "shadows "));
    let json = out(&["--without", "soft-shadows", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let left_out = |index: usize| json["effects"][index]["left_out"].is_string();
    let effects = json["effects"].as_array().expect("a list");
    for (index, effect) in effects.iter().enumerate() {
        assert_eq!(left_out(index), effect["effect"] == "soft-shadows");
    }
    refused(
        &["effects", "whitted", "--without", "shadow"],
        2,
        &["soft-shadows"],
    );
}
