//! The chart of errors over time.

use super::cost;

/// What rounding alone makes wrong does not stretch the axis, and is said to lie on it; each way has a letter of its own.
#[test]
fn errors_of_rounding_lie_on_the_floor_of_the_chart() {
    let folder = tempfile::tempdir().expect("a folder");
    let plot = folder.path().join("plot.svg");
    let path = plot.to_str().expect("a plain path");
    let args = [
        "nested-glass",
        "--size",
        "16x12",
        "--runs",
        "1",
        "--plot",
        path,
    ];
    let knobs = [
        "--knob",
        "offset,triangle,quadratic,depth",
        "--budget",
        "300",
    ];
    let text = cost(&[&args[..], &knobs[..]].concat()).stdout;
    let text = String::from_utf8(text).expect("UTF-8");
    let svg = std::fs::read_to_string(&plot).expect("a picture");
    assert!(
        text.contains("errors below 1e-7, which are rounding, are drawn at 1e-7"),
        "{text}"
    );
    assert!(svg.contains("errors below 1e-7"));
    for tiny in 8..30 {
        let label = format!(">1e-{tiny}<");
        assert!(!svg.contains(&label), "{label}");
        assert!(
            !text.lines().any(|l| l.starts_with(&format!("1e-{tiny}│"))),
            "{text}"
        );
    }
    let legend = svg
        .lines()
        .filter(|l| l.contains("text-anchor=\"end\" fill"));
    let letters: Vec<&str> = legend
        .filter_map(|l| l.split('>').nth(1)?.get(..1))
        .collect();
    let different: std::collections::HashSet<&&str> = letters.iter().collect();
    assert!(
        letters.len() >= 3 && different.len() == letters.len(),
        "{letters:?}"
    );
}
