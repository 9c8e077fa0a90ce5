//! `raytree cost`: bounded, repeatable, and of the order that theory tells.

use std::process::{Command, Output};
use std::time::Instant;

use serde_json::Value;

fn cost(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_raytree"))
        .arg("cost")
        .args(args)
        .output()
        .expect("runs")
}

fn json(args: &[&str]) -> Value {
    let out = cost(&[args, &["--json"]].concat());
    serde_json::from_slice(&out.stdout).expect("JSON")
}

/// What does not depend on time: names, counters, errors.
fn lasting(document: &Value) -> Vec<Value> {
    let sweeps = document["sweeps"].as_array().expect("a list").iter();
    sweeps
        .flat_map(|sweep| {
            let steps = sweep["steps"].as_array().expect("a list").iter();
            steps.map(|s| {
                serde_json::json!([
                    sweep["knob"],
                    s["step"],
                    s["rays"],
                    s["nodes"],
                    s["tests"],
                    s["errors"]
                ])
            })
        })
        .collect()
}

#[test]
fn errors_and_counters_are_the_same_when_it_is_run_again() {
    let first = json(&[
        "soft-shadow",
        "--size",
        "24x18",
        "--runs",
        "1",
        "--budget",
        "100",
    ]);
    let again: Vec<&str> = first["again"]
        .as_str()
        .expect("a command")
        .split(' ')
        .collect();
    assert_eq!(again[..2], ["raytree", "cost"]);
    let second = json(&again[2..]);
    assert!(lasting(&first).len() > 20);
    assert_eq!(lasting(&first), lasting(&second));

    // Better points, smaller errors: at 64 rays a light sobol beats stratified beats random.
    let rmse = |knob: &str| {
        let sweeps = first["sweeps"].as_array().expect("a list");
        let sweep = sweeps.iter().find(|s| s["knob"] == knob).expect("a knob");
        sweep["steps"][3]["errors"]["rmse"]
            .as_f64()
            .expect("a number")
    };
    let [random, stratified, sobol] =
        ["random", "stratified", "sobol"].map(|s| rmse(&format!("light samples, {s}")));
    assert!(
        sobol < stratified && stratified < 0.5 * random,
        "{random} {stratified} {sobol}"
    );
}

#[test]
fn only_the_knobs_that_a_scene_has_are_turned() {
    let knobs = |scene: &str| -> Vec<String> {
        let document = json(&[scene, "--size", "8x6", "--runs", "1"]);
        let sweeps = document["sweeps"].as_array().expect("a list").iter();
        sweeps
            .map(|s| s["knob"].as_str().expect("a name").to_owned())
            .collect()
    };
    assert_eq!(
        knobs("triangle"),
        ["pixel samples, jittered", "accelerator"]
    );
    assert_eq!(
        knobs("mirrors"),
        [
            "pixel samples, jittered",
            "depth",
            "min weight",
            "accelerator"
        ]
    );
}

#[test]
fn a_budget_ends_it_and_keeps_what_is_measured() {
    let start = Instant::now();
    let out = cost(&[
        "soft-shadow",
        "--size",
        "320x240",
        "--budget",
        "0.5",
        "--json",
    ]);
    assert!(start.elapsed().as_secs_f64() < 5.0);
    assert_eq!(out.status.code(), Some(3));
    let said = String::from_utf8_lossy(&out.stderr);
    assert!(said.contains("--budget"), "{said}");
    for budget in ["0", "-1", "x", "inf"] {
        assert_eq!(
            cost(&["triangle", "--budget", budget]).status.code(),
            Some(2)
        );
    }
}

#[test]
fn tables_lines_and_a_plot_are_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let plot = folder.path().join("plot.svg");
    let path = plot.to_str().expect("a plain path");
    let out = cost(&["triangle", "--size", "16x12", "--runs", "1", "--plot", path]);
    let text = String::from_utf8(out.stdout).expect("UTF-8");
    assert!(
        text.contains("the next halving of the error costs"),
        "{text}"
    );
    assert!(
        text.contains("again: raytree cost triangle --size 16x12"),
        "{text}"
    );
    let svg = std::fs::read_to_string(&plot).expect("a picture");
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
    assert_eq!(svg.matches("<circle").count(), 4, "one point a setting");
    let csv = cost(&["triangle", "--size", "16x12", "--runs", "1", "--csv"]).stdout;
    let csv = String::from_utf8(csv).expect("UTF-8");
    let columns: Vec<usize> = csv
        .lines()
        .map(|line| line.replace("samples, jittered", "").split(',').count())
        .collect();
    assert!(
        columns.len() > 10 && columns.iter().all(|n| *n == columns[0]),
        "{csv}"
    );
}
