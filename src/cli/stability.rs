//! `raytree stability`: hard cases, measured with common arithmetic and with ours.

use std::fmt::Write as _;

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use serde_json::json;

use super::{Done, Failure, output};
use crate::lab::stability::{CASES, Case, Outcome};

#[derive(Args)]
pub struct Stability {
    /// Only this case, with where it is known from
    #[arg(value_name = "CASE", value_parser = cases())]
    case: Option<Case>,
    /// As JSON
    #[arg(long)]
    json: bool,
}

impl Stability {
    pub fn run(&self) -> Result<Done, Failure> {
        let asked = CASES
            .into_iter()
            .filter(|case| self.case.is_none_or(|only| only.name == case.name));
        let measured: Vec<(Case, Vec<Outcome>)> =
            asked.map(|case| (case, (case.measure)())).collect();
        let text = if self.json {
            format!("{:#}\n", as_json(&measured))
        } else {
            as_text(&measured, self.case.is_some())
        };
        output::to_stdout(text.as_bytes())
    }
}

fn cases() -> impl TypedValueParser<Value = Case> {
    let names = CASES.map(|case| PossibleValue::new(case.name).help(case.hard));
    PossibleValuesParser::new(names).map(|name| {
        let case = CASES.into_iter().find(|case| case.name == name);
        case.unwrap_or(CASES[0])
    })
}

fn verdict(outcome: &Outcome) -> &'static str {
    if outcome.is_right() { "right" } else { "wrong" }
}

/// A few lines a case. (Writing to a string cannot fail.)
fn as_text(measured: &[(Case, Vec<Outcome>)], sources: bool) -> String {
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
        out.push_str("\nOne of them at work: raytree view whitted --offset none\n");
    }
    out
}

fn as_json(measured: &[(Case, Vec<Outcome>)]) -> serde_json::Value {
    let outcome = |o: &Outcome| {
        json!({
            "arithmetic": o.arithmetic, "ours": o.ours, "found": o.found, "allowed": o.allowed,
            "unit": o.unit, "verdict": verdict(o),
        })
    };
    let case = |(case, outcomes): &(Case, Vec<Outcome>)| {
        json!({
            "case": case.name, "hard": case.hard, "source": case.source,
            "outcomes": outcomes.iter().map(outcome).collect::<Vec<_>>(),
        })
    };
    measured.iter().map(case).collect()
}
