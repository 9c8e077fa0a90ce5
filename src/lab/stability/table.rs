//! Table of hard cases and what was measured, for reading.

use std::fmt::Write as _;

use super::{Case, Outcome};

/// Whether an outcome is within what is allowed, in a word.
pub fn verdict(outcome: &Outcome) -> &'static str {
    if outcome.is_right() { "right" } else { "wrong" }
}

/// A few lines a case, with its sources where they are wanted. (Writing to a string cannot fail.)
pub fn as_text(measured: &[(Case, Vec<Outcome>)], sources: bool) -> String {
    let mut out = String::new();
    for (case, outcomes) in measured {
        let _ = writeln!(out, "{}\n  {}", case.name, case.hard);
        if sources {
            let _ = writeln!(out, "  from: {}", case.source);
        }
        let unit = outcomes.first().map_or("", |o| o.unit);
        let _ = writeln!(out, "  {unit:44} found   allowed");
        for outcome in outcomes {
            let number = |x: f64| match x {
                0.0 => "0".to_owned(),
                x if x >= 0.01 => format!("{x:.2}"),
                x => format!("{x:.1e}"),
            };
            let _ = writeln!(
                out,
                "    {:37} {:>9} {:>9}  {}",
                outcome.arithmetic,
                number(outcome.found),
                number(outcome.allowed),
                verdict(outcome)
            );
        }
    }
    if !sources {
        out.push_str(
            "\nA picture of one: raytree stability shared-edges\n\
             One of them at work: raytree view whitted --offset none\n",
        );
    }
    out
}
