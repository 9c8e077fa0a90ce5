//! The cost of accuracy for machines: JSON and CSV.

use std::fmt::Write as _;

use serde_json::{Value, json};

use crate::lab::{Measured, Sweep};
use crate::scene::Warning;
use crate::trace::document;

/// All of it. Times are seconds; what does not depend on time is the same when `again` is run.
pub fn json(sweeps: &[Sweep], again: &str, warnings: &[Warning]) -> Value {
    let step = |s: &Measured| {
        json!({
            "step": s.step, "samples": s.samples, "seconds": s.seconds, "spread": s.spread, "runs": s.runs,
            "build_seconds": s.built,
            "rays": { "I": s.counts.incident, "L": s.counts.light, "R": s.counts.reflected, "T": s.counts.transmitted, "passed": s.counts.passed },
            "nodes": s.counts.nodes, "tests": s.counts.tests, "on_front": s.on_front,
            "errors": s.errors.map(|e| json!({
                "rmse": e.rmse, "relative_mse": e.relative_mse, "max": e.max, "seen": e.seen, "flip": e.flip,
            })),
        })
    };
    let sweep = |s: &Sweep| {
        json!({
            "knob": s.parameter.name(), "group": s.parameter.group, "theory": s.parameter.theory,
            "steps": s.steps.iter().map(step).collect::<Vec<_>>(),
            "slope_over_samples": s.slopes.and_then(|slopes| slopes.samples),
            "slope_over_rays": s.slopes.map(|slopes| slopes.rays),
            "slope_over_time": s.slopes.map(|slopes| slopes.seconds),
            "next_halving_costs": s.slopes.and_then(|slopes| slopes.halving()),
        })
    };
    json!({
        "again": again, "sweeps": sweeps.iter().map(sweep).collect::<Vec<_>>(),
        "warnings": document::list(warnings),
    })
}

/// A line a setting. (Writing to a string cannot fail.)
pub fn csv(sweeps: &[Sweep]) -> String {
    let mut out =
        "group,way,step,seconds,min,max,runs,rays,nodes,tests,rmse,relative_mse,max_error,seen,flip,on_front\n"
            .to_owned();
    let rows = sweeps
        .iter()
        .flat_map(|s| s.steps.iter().map(move |t| (s, t)));
    for (sweep, step) in rows {
        let errors = step.errors.map_or(",,,,".to_owned(), |e| {
            [e.rmse, e.relative_mse, e.max, e.seen, e.flip]
                .map(|x| x.to_string())
                .join(",")
        });
        let [low, high] = step.spread;
        let _ = writeln!(
            out,
            "{},{},{},{},{low},{high},{},{},{},{},{errors},{}",
            sweep.parameter.group,
            sweep.parameter.variant.unwrap_or_default(),
            step.step,
            step.seconds,
            step.runs,
            step.counts.rays(),
            step.counts.nodes,
            step.counts.tests,
            step.on_front,
        );
    }
    out
}
