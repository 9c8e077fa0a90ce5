//! The cost of accuracy as tables to read, with what follows from them in words.

use std::fmt::Write as _;
use std::path::Path;

use crate::lab::{EqualTime, Measured, Slopes, Sweep};
use crate::scene::printable::printable;

/// The tables, a group of knobs each. (Writing to a string cannot fail.)
pub fn text(sweeps: &[Sweep]) -> String {
    let mut out = String::new();
    for group in sweeps.chunk_by(|a, b| a.parameter.group == b.parameter.group) {
        let head = group[0].parameter.group;
        let _ = writeln!(
            out,
            "\n  {head:15} {:>7} {:>8} {:>6} {:>6} {:>6} {:>8} {:>6} {:>8}",
            "time/ms", "spread/%", "rays", "nodes", "tests", "RMSE", "FLIP", "RMSE s"
        );
        for sweep in group {
            for step in &sweep.steps {
                let variant = sweep
                    .parameter
                    .variant
                    .map_or(String::new(), |variant| format!("{variant} "));
                let _ = writeln!(out, "{}", row(&format!("{variant}{}", step.step), step));
            }
            if sweep.steps.is_empty() {
                let _ = writeln!(
                    out,
                    "  {}: there was no time for it",
                    sweep.parameter.name()
                );
            }
        }
        if group[0].parameter.is_arithmetic() {
            let _ = writeln!(out, "  shapes are tested one by one in all of these");
        }
        for line in sentences(group) {
            let _ = writeln!(out, "  {line}");
        }
    }
    out
}

/// What the crops in a file are, from left to right.
pub fn comparisons(comparisons: &[EqualTime], path: &Path) -> String {
    let mut out = format!(
        "  crops in {}, from left to right:\n",
        printable(&path.to_string_lossy())
    );
    for equal_time in comparisons {
        let [x, y, w, h] = equal_time.crop;
        let _ = writeln!(
            out,
            "  {}, {:.1} ms each, {w}x{h} pixels from ({x}, {y}):",
            equal_time.group,
            equal_time.seconds * 1e3
        );
        for tile in &equal_time.tiles {
            let _ = writeln!(
                out,
                "    {:17} {:>7.1} ms, RMSE {:.1e}",
                tile.name,
                tile.seconds * 1e3,
                tile.rmse
            );
        }
        let _ = writeln!(out, "    the reference");
    }
    out + "\n"
}

fn row(name: &str, step: &Measured) -> String {
    let mark = if step.on_front { '*' } else { ' ' };
    let percent = |t: f64| (t / step.seconds - 1.0) * 100.0;
    let [low, high] = step.spread.map(percent);
    let counts = [step.counts.rays(), step.counts.nodes, step.counts.tests];
    let [rays, nodes, tests] = counts.map(short);
    let end = match (step.errors, step.built) {
        (Some(e), _) => format!(
            "{:>8.1e} {:>6.4} {:>8.1e}",
            e.rmse,
            e.flip,
            e.rmse * step.seconds
        ),
        (None, Some(built)) => format!("same, built in {:.1} ms", built * 1e3),
        (None, None) => "same picture".to_owned(),
    };
    format!(
        "{mark} {name:15} {:>7.1} {:>8} {rays:>6} {nodes:>6} {tests:>6} {end}",
        step.seconds * 1e3,
        format!("{low:+.0} {high:+.0}")
    )
}

/// A count in at most six letters.
pub fn short(count: u64) -> String {
    let x = count as f64;
    match count {
        0..10_000 => count.to_string(),
        10_000..1_000_000 => format!("{:.1}k", x / 1e3),
        1_000_000..1_000_000_000 => format!("{:.1}M", x / 1e6),
        _ => format!("{:.1}G", x / 1e9),
    }
}

/// What the next halving of the error costs, and the slopes beside those of theory.
fn sentences(group: &[Sweep]) -> Vec<String> {
    let found: Vec<(&Sweep, Slopes)> = group
        .iter()
        .filter_map(|sweep| sweep.parameter.theory.and(Some((sweep, sweep.slopes?))))
        .collect();
    let variant = |sweep: &Sweep| sweep.parameter.variant.unwrap_or(sweep.parameter.group);
    let costs: Vec<String> = found
        .iter()
        .filter_map(|(sweep, slopes)| {
            Some(format!(
                "{:.1}x the time with {}",
                slopes.halving()?,
                variant(sweep)
            ))
        })
        .collect();
    let mut lines = Vec::new();
    if !costs.is_empty() {
        lines.push(format!(
            "the next halving of the error costs {}",
            costs.join(", ")
        ));
    }
    for (sweep, slopes) in found {
        let samples = slopes.samples.map_or(String::new(), |s| {
            format!(
                "{s:.2} over samples (theory: {}), ",
                sweep.parameter.theory.unwrap_or_default()
            )
        });
        lines.push(format!(
            "slope of log error, {}: {samples}{:.2} over rays, {:.2} over time",
            variant(sweep),
            slopes.rays,
            slopes.seconds
        ));
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_short() {
        let shown = [0, 9999, 10_000, 999_949, 1_234_567, 98_765_432_100].map(short);
        assert_eq!(shown, ["0", "9999", "10.0k", "999.9k", "1.2M", "98.8G"]);
    }
}
