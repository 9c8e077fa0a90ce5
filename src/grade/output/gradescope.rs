//! `results.json` of Gradescope's autograder, for one submission; its student reads it.

use serde_json::{Value, json};

use super::document::Milli;
use super::{Audience, cause_line, json, points, text, told_causes};
use crate::grade::marks::{CheckMark, CheckStatus};
use crate::grade::report::{Marked, Report};
use crate::grade::task::{Check, Say};
use crate::grade::value::shown;

/// Bold, green, red and plain text of a terminal: the only control sequences, all of them ours.
const BOLD: &str = "\u{1b}[1m";
const GREEN: &str = "\u{1b}[32m";
const RED: &str = "\u{1b}[31m";
const PLAIN: &str = "\u{1b}[0m";

/// The result of a submission; `report` has no other.
pub fn results(audience: Audience, marked: &Marked, report: &Report) -> Value {
    let checks = audience.task.checks.iter().zip(&marked.marks);
    let tests = checks
        .zip(1..)
        .map(|((c, mark), n)| test(audience, c, mark, n));
    let counted = marked.counted.as_ref();
    let score = counted.map_or(marked.score(), |counted| counted.score);
    json!({
        "score": Milli(score),
        "output": headed(&text::submission(audience, marked)),
        "output_format": "ansi",
        "visibility": "visible",
        "tests": tests.collect::<Vec<_>>(),
        "extra_data": {"raytree": json::document(audience, report)},
    })
}

fn test(audience: Audience, check: &Check, mark: &CheckMark, number: usize) -> Value {
    let laws: &[_] = if audience.say() == Say::Nothing {
        &[]
    } else {
        told_causes(mark)
    };
    let mut tags: Vec<&str> = laws.iter().map(|(_, c)| c.first.law.name()).collect();
    tags.sort_unstable();
    tags.dedup();
    json!({
        "name": format!("{}: {}", check.id, shown(&check.title)),
        "number": number.to_string(),
        "score": Milli(mark.score),
        "max_score": Milli(mark.most),
        "status": if mark.status == CheckStatus::Full { "passed" } else { "failed" },
        "visibility": if check.visible { "visible" } else { "hidden" },
        "output": output(audience, check, mark),
        "output_format": "ansi",
        "tags": tags,
    })
}

/// What is told of a check.
fn output(audience: Audience, check: &Check, mark: &CheckMark) -> String {
    let color = if mark.score == mark.most { GREEN } else { RED };
    let earned = format!("{} of {}", points(mark.score), points(mark.most));
    let mut lines = vec![
        format!("{color}{earned}{PLAIN}"),
        text::about(audience, check, mark),
    ];
    let causes = told_causes(mark).iter();
    lines.extend(causes.map(|(at, cause)| cause_line(audience, *at, cause)));
    lines.join("\n")
}

/// A text whose first line is bold.
fn headed(text: &str) -> String {
    let (first, rest) = text.split_once('\n').unwrap_or((text, ""));
    format!("{BOLD}{first}{PLAIN}\n{rest}")
}
