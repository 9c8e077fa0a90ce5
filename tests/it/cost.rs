//! `raytree cost`: bounded, repeatable, and of the order that theory tells.

mod chart;
mod reference;

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

fn sweep<'a>(document: &'a Value, knob: &str) -> &'a Value {
    let sweeps = document["sweeps"].as_array().expect("a list");
    let found = sweeps.iter().find(|s| s["knob"] == knob);
    found.unwrap_or_else(|| panic!("no {knob} in {document:#}"))
}

#[test]
fn errors_and_counters_are_the_same_when_it_is_run_again() {
    // Every setting differs from the scene's own, and the effort follows from the budget.
    let first = json(&[
        "soft-shadow",
        "--size",
        "24x18",
        "--runs",
        "1",
        "--samples",
        "2",
        "--light-samples",
        "3",
        "--sampler",
        "random",
        "--sampling",
        "jittered",
        "--without",
        "highlights",
        "--seed",
        "7",
        "--budget",
        "8",
    ]);
    let again: Vec<&str> = first["again"]
        .as_str()
        .expect("a command")
        .split(' ')
        .collect();
    assert_eq!(again[..2], ["raytree", "cost"]);
    for part in ["3", "random", "highlights", "--most"] {
        assert!(again.contains(&part), "no {part} in {again:?}");
    }
    let longer = [&again[2..], &["--budget", "100"]].concat();
    let longer: Vec<&str> = drop_budget(&longer);
    let second = json(&longer);
    // A busy machine may leave out some of the first, and none of the second.
    let (first, second) = (lasting(&first), lasting(&second));
    assert!(first.len() > 20);
    for one in first {
        assert!(second.contains(&one), "{one} is not in {second:#?}");
    }
}

/// Without the first of two budgets.
fn drop_budget<'a>(args: &[&'a str]) -> Vec<&'a str> {
    let at = args.iter().position(|a| *a == "--budget").expect("there");
    [&args[..at], &args[at + 2..]].concat()
}

#[test]
fn slopes_and_the_front_are_those_of_theory() {
    let document = json(&[
        "soft-shadow",
        "--size",
        "40x30",
        "--runs",
        "1",
        "--knob",
        "light-samples",
        "--most",
        "64",
        "--budget",
        "100",
    ]);
    let all = document["sweeps"].as_array().expect("a list");
    assert_eq!(all.len(), 5, "only what was asked for");
    let slope = |way: &str| {
        let sweep = sweep(&document, &format!("light samples, {way}"));
        sweep["slope_over_samples"].as_f64().expect("a slope")
    };
    assert!((slope("random") + 0.5).abs() < 0.05, "{}", slope("random"));
    assert!((-0.95..-0.65).contains(&slope("stratified")));
    assert!(slope("sobol") < slope("random") - 0.15);
    let last = |way: &str| &sweep(&document, &format!("light samples, {way}"))["steps"][3];
    let rmse = |way: &str| last(way)["errors"]["rmse"].as_f64().expect("a number");
    assert!(rmse("sobol") < rmse("stratified") && rmse("stratified") < 0.5 * rmse("random"));
    let flip = |way: &str| last(way)["errors"]["flip"].as_f64().expect("a number");
    assert!(flip("sobol") < flip("random"));
    assert_eq!(last("random")["on_front"], false);
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
        [
            "pixel samples, regular",
            "pixel samples, random",
            "pixel samples, jittered",
            "pixel samples, sobol",
            "pixel samples, adaptive",
            "pixel samples, around",
            "accelerator",
            "triangle",
            "offset",
            "precision"
        ]
    );
    assert_eq!(
        knobs("mirrors"),
        [
            "pixel samples, regular",
            "pixel samples, random",
            "pixel samples, jittered",
            "pixel samples, sobol",
            "pixel samples, adaptive",
            "pixel samples, around",
            "depth",
            "min weight",
            "accelerator",
            "triangle",
            "offset",
            "quadratic",
            "precision"
        ]
    );
}

#[test]
fn a_budget_ends_it_and_every_knob_shows_something() {
    let start = Instant::now();
    let args = ["soft-shadow", "--size", "24x18", "--budget", "8", "--json"];
    let out = cost(&args);
    assert!(start.elapsed().as_secs_f64() < 10.0);
    let document: Value = serde_json::from_slice(&out.stdout).expect("JSON");
    for sweep in document["sweeps"].as_array().expect("a list") {
        assert!(
            !sweep["steps"].as_array().expect("a list").is_empty(),
            "{sweep}"
        );
    }
}

#[test]
fn what_does_not_fit_into_the_budget_is_left_out_and_told() {
    let start = Instant::now();
    let out = cost(&[
        "soft-shadow",
        "--size",
        "320x240",
        "--budget",
        "1",
        "--most",
        "256",
        "--json",
    ]);
    assert!(start.elapsed().as_secs_f64() < 6.0);
    assert_eq!(out.status.code(), Some(3));
    let said = String::from_utf8_lossy(&out.stderr);
    assert!(said.contains("--budget"), "{said}");
}

#[test]
fn wrong_asking_is_told() {
    for budget in ["0", "-1", "x", "inf"] {
        let out = cost(&["triangle", "--budget", budget]);
        assert_eq!(out.status.code(), Some(2));
    }
    // A scene without area lights has no samples of them.
    let out = cost(&["triangle", "--knob", "light-samples"]);
    assert_eq!(out.status.code(), Some(2));
    let said = String::from_utf8_lossy(&out.stderr);
    assert!(
        said.contains("has no such knob; it has pixel-samples, accelerator"),
        "{said}"
    );
}

#[test]
fn tables_lines_and_a_plot_are_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let plot = folder.path().join("plot.svg");
    let path = plot.to_str().expect("a plain path");
    let args = ["triangle", "--size", "16x12", "--runs", "1", "--most", "64"];
    let out = cost(&[&args[..], &["--plot", path]].concat());
    let text = String::from_utf8(out.stdout).expect("UTF-8");
    for part in [
        "slope of log error, jittered",
        "again: raytree cost triangle --size 16x12",
        "  c  pixel samples, jittered",
    ] {
        assert!(text.contains(part), "no {part} in\n{text}");
    }
    // The axis of the chart: which powers of ten there are depends on the machine.
    assert!(
        text.lines()
            .any(|l| l.starts_with("1e-") && l.contains(" s ")),
        "{text}"
    );
    let mut tables = text
        .lines()
        .filter(|l| !l.contains(':') && !l.contains("halving"));
    assert!(tables.all(|l| l.chars().count() <= 80), "{text}");
    for words in [format!(" --plot {path}"), "seconds a picture".to_owned()] {
        assert!(text.contains(&words), "{words} in\n{text}");
    }
    let svg = std::fs::read_to_string(&plot).expect("a picture");
    assert!(svg.contains("seconds a picture") && svg.contains(">c  pixel samples, jittered<"));
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
    let csv = cost(&[&args[..], &["--csv"]].concat()).stdout;
    let csv = String::from_utf8(csv).expect("UTF-8");
    let columns: Vec<usize> = csv.lines().map(|line| line.split(',').count()).collect();
    assert!(
        columns.len() > 10 && columns.iter().all(|n| *n == columns[0]),
        "{csv}"
    );
    let head = csv.lines().next().expect("a head").split(',');
    let rmse = head.clone().position(|name| name == "rmse");
    let errs = |line: &&str| {
        let value = line.split(',').nth(rmse.expect("a column"));
        value
            .and_then(|x| x.parse().ok())
            .is_some_and(|x: f64| x > 0.0)
    };
    let points = csv.lines().filter(errs).count();
    assert!(points >= 20, "{csv}");
    assert_eq!(
        svg.matches("<circle").count(),
        points,
        "one point a setting that errs"
    );
}

#[test]
fn robust_choices_err_by_nothing_and_others_show_what_they_are_for() {
    let step = |scene: &str, knob: &str| -> Vec<(String, f64)> {
        let args = [scene, "--size", "40x30", "--runs", "1", "--knob", knob];
        let document = json(&args);
        let steps = sweep(&document, knob)["steps"].as_array().expect("a list");
        let rmse = |s: &Value| s["errors"]["rmse"].as_f64().expect("a number");
        let name = |s: &Value| s["step"].as_str().expect("a name").to_owned();
        steps.iter().map(|s| (name(s), rmse(s))).collect()
    };
    for (scene, knob, robust) in [
        ("teapot", "triangle", "watertight"),
        ("nested-glass", "triangle", "watertight"),
        ("nested-glass", "offset", "bounded"),
        ("nested-glass", "quadratic", "stable"),
        ("nested-glass", "precision", "double"),
    ] {
        let steps = step(scene, knob);
        let (name, rmse) = steps.last().expect("a position");
        assert_eq!((name.as_str(), *rmse), (robust, 0.0), "{scene} {knob}");
    }
    let offsets = step("whitted", "offset");
    let names: Vec<&str> = offsets.iter().map(|(name, _)| name.as_str()).collect();
    let all = ["none", "fixed:1e-9", "fixed:1e-4", "fixed:1e-2", "bounded"];
    assert_eq!(names, all);
    assert!(offsets[0].1 > 0.01 && offsets[4].1 == 0.0, "{offsets:?}");
}

#[test]
fn a_strip_has_each_way_and_the_reference_side_by_side() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("strip.png");
    let path = path.to_str().expect("a plain path");
    let args = [
        "soft-shadow",
        "--size",
        "24x18",
        "--runs",
        "1",
        "--most",
        "4",
        "--budget",
        "60",
    ];
    let knob = ["--knob", "light-samples", "--strip", path];
    let out = cost(&[&args[..], &knob[..]].concat());
    let text = String::from_utf8(out.stdout).expect("UTF-8");
    assert!(
        text.contains(&format!(" --strip {path}")),
        "the line to do it again: {text}"
    );
    let (_, told) = text.split_once("crops in").expect("what the crops are");
    let names: Vec<&str> = told
        .lines()
        .filter_map(|line| line.strip_prefix("    ")?.split(' ').next())
        .collect();
    let ways = ["grid", "random", "stratified", "sobol", "projected", "the"];
    assert_eq!(names, ways, "{text}");
    // 24 x 18 pixels, 4 times as large, with 4 pixels around.
    let png = std::fs::read(path).expect("a picture");
    let film = raytree::tracer::image::png::decode(&png, 1.0).expect("a picture");
    assert_eq!((film.width, film.height), (6 * 100 + 4, 76 + 4));
    // Grey between, and crops that differ from each other in noise only.
    let grey = film.at(102, 40);
    assert_eq!(grey, film.at(2, 40));
    let mean = |tile: u32| {
        let places = (4..76).flat_map(|y| (4..100).map(move |x| (x, y)));
        let sum: f64 = places
            .map(|(x, y)| film.at(100 * tile + x, y).luminance())
            .sum();
        sum / (96.0 * 72.0)
    };
    for tile in 0..5 {
        let off = (mean(tile) / mean(5) - 1.0).abs();
        assert!(off < 0.05 && off > 0.0, "{tile}: {off}");
    }
}
