//! Results that cannot be written, and messages about numbers.

use super::{refused, run};

/// A full disk must not look like success, whatever was to be written.
#[test]
#[cfg(target_os = "linux")]
fn what_standard_output_does_not_take_is_status_1() {
    for args in [
        &["help"][..],
        &["--help"],
        &["--version"],
        &["render", "--help"],
        &["scenes"],
        &["scenes", "triangle", "--flat"],
        &["scenes", "triangle", "--flat=text"],
        &["schema", "scene"],
        &["completions", "bash"],
        &["effects", "whitted"],
        &["render", "triangle", "--size", "8x6"],
        &["trace", "triangle", "--pixel", "0,0"],
    ] {
        let full = std::fs::File::create("/dev/full").expect("a device");
        let output = std::process::Command::new(env!("CARGO_BIN_EXE_raytree"))
            .args(args)
            .stdout(full)
            .output()
            .expect("runs");
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{args:?}: {said}");
        assert!(
            said.contains("standard output: cannot be written"),
            "{said}"
        );
    }
}

#[test]
fn a_number_that_is_not_possible_is_told_in_plain_words() {
    let render = |flag: &str, value: &str, words: &str| {
        refused(&["render", "triangle", flag, value], 2, &[flag, words]);
    };
    render("--max-rays", "0", "must be a whole number, at least 1");
    render("--max-rays", "many", "must be a whole number, at least 1");
    render("--max-rays", "1e9", "must be a whole number, at least 1");
    render("--samples", "0", "must be a whole number from 1 to 4096");
    render("--samples", "2.5", "must be a whole number from 1 to 4096");
    render(
        "--seed",
        "one",
        "must be a whole number, 18446744073709551615 at most",
    );
    render("--threads", "1025", "must be a whole number from 0 to 1024");
    for (flag, words) in [("--runs", "from 1 to 99"), ("--most", "from 1 to 4096")] {
        refused(&["cost", "triangle", flag, "0"], 2, &[flag, words]);
    }
}

/// Each pixel takes an eye ray: fewer rays than pixels would be a promise that is broken.
#[test]
fn a_ray_budget_holds_for_the_picture() {
    let words = ["--max-rays 47", "8x6", "at least 48 rays"];
    let size = ["--size", "8x6", "--max-rays"];
    let render = ["render", "triangle", "-o", "/dev/null", "--stats", "--json"];
    refused(&[&render[..], &size, &["47"]].concat(), 2, &words);
    let trace = ["trace", "triangle", "--pixel", "4,3"];
    refused(&[&trace[..], &size, &["47"]].concat(), 2, &words);
    refused(
        &[&["cost", "triangle"][..], &size, &["47"]].concat(),
        2,
        &words,
    );
    for most in [48, 49, 95, 96, 100] {
        let ran = run(&[&render[..], &size, &[&most.to_string()]].concat());
        let stats: serde_json::Value = serde_json::from_slice(&ran.out).expect("JSON");
        let rays = ["I", "L", "R", "T"].map(|kind| stats["rays"][kind].as_u64().expect("a number"));
        let rays: u64 = rays.iter().sum();
        assert!(rays <= most, "{rays} rays of {most}");
        // Where each pixel has a second one, for the light, nothing is left out.
        assert_eq!(ran.code, if most < 96 { 3 } else { 0 }, "{}", ran.err);
    }
}

/// A scene of others comes out in the form that is asked for, or not at all.
#[test]
fn a_flat_scene_is_printed_whole_or_refused() {
    let json = run(&["scenes", "shadows", "--flat"]);
    assert_eq!((json.code, json.err.as_str()), (0, ""));
    let flat: serde_json::Value = serde_json::from_slice(&json.out).expect("JSON");
    assert_eq!(flat["format"], "raytree-flat/1");
    let text = run(&["scenes", "triangle", "--flat=text"]);
    assert!(
        text.out
            .starts_with(b"format raytree-flat/1\nname triangle\n")
    );
    let words = ["`pillar`", "stretched or turned", "--flat"];
    refused(&["scenes", "shadows", "--flat=text"], 1, &words);
    refused(&["scenes", "triangle"], 2, &["--flat"]);
    refused(&["scenes", "--flat"], 2, &["SCENE"]);
    refused(&["scenes", "triangle", "--flat", "--json"], 2, &["--json"]);
    refused(
        &["scenes", "trangle", "--flat"],
        1,
        &["did you mean `triangle`?"],
    );
}
