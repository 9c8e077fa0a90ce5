//! `raytree stability`: hard cases, measured with common arithmetic and with ours.

mod picture;

use std::path::PathBuf;

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use serde_json::json;

use super::output::{self, Destination, Target};
use super::{ColorArg, Completion, Failure};
use crate::lab::stability::table::{as_text, verdict};
use crate::lab::stability::{CASES, Case, Outcome};

#[derive(Args)]
pub struct Stability {
    /// Only this case, with where it is known from, and a picture
    #[arg(value_name = "CASE", value_parser = cases())]
    case: Option<Case>,
    /// As JSON
    #[arg(long)]
    json: bool,
    /// Write the case's picture to a PNG file, larger; without, it is drawn as text
    #[arg(short, long, value_name = "FILE.png", requires = "case")]
    output: Option<PathBuf>,
    /// Colours of the text picture
    #[arg(long, value_enum, default_value_t = ColorArg::Auto)]
    color: ColorArg,
}

impl Stability {
    pub fn run(&self) -> Result<Completion, Failure> {
        let target = Target {
            flag: "--output",
            path: self.output.as_deref(),
            endings: &["png"],
        };
        let [file] = output::open(&[], [target])?;
        let asked = CASES
            .into_iter()
            .filter(|case| self.case.is_none_or(|only| only.name == case.name));
        let measured: Vec<(Case, Vec<Outcome>)> =
            asked.map(|case| (case, (case.measure)())).collect();
        let seen = self.picture(&measured, file)?;
        if self.json {
            output::to_stdout(format!("{:#}\n", as_json(&measured)).as_bytes())?;
            // Where the picture is must not stand among the data.
            eprint!("{seen}");
            return Ok(Completion::Whole);
        }
        let text = as_text(&measured, self.case.is_some()) + &seen;
        output::to_stdout(text.as_bytes())
    }

    /// The picture of the one case that was asked for: what is to be said of it, after it was written where it should be.
    fn picture(
        &self,
        measured: &[(Case, Vec<Outcome>)],
        file: Option<Destination>,
    ) -> Result<String, Failure> {
        let (Some(_), [(case, outcomes)]) = (self.case, measured) else {
            return Ok(String::new());
        };
        match file {
            Some(file) => picture::to_file(&case.picture, file),
            None if self.json => Ok(String::new()),
            None => {
                let level = self.color.level();
                Ok(picture::as_text(&case.picture, outcomes.len(), level))
            }
        }
    }
}

fn cases() -> impl TypedValueParser<Value = Case> {
    let names = CASES.map(|case| PossibleValue::new(case.name).help(case.hard));
    PossibleValuesParser::new(names).map(|name| {
        let case = CASES.into_iter().find(|case| case.name == name);
        case.unwrap_or(CASES[0])
    })
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
