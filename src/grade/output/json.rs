//! Marks for programs: `raytree-grade/1`. The order is that of the task; no time, no path, no host: the same bytes everywhere.

use serde_json::{Value, json};

use super::text::shows;
use super::{Audience, points};
use crate::grade::diff::Cause;
use crate::grade::marks::CheckMark;
use crate::grade::report::{Marked, Report};
use crate::grade::task::{Check, Say};
use crate::grade::value::{json_value, shown};
use crate::scene::Bends;

/// All submissions.
pub fn report(audience: Audience, report: &Report) -> Value {
    let task = audience.task;
    let submissions = report
        .submissions
        .iter()
        .map(|marked| submission(audience, marked));
    let unknown = report.unknown.iter().map(|group| {
        json!({
            "law": group.law,
            "quantity": group.quantity,
            "ratio": group.ratio,
            "submissions": group.names.iter().map(|name| shown(name)).collect::<Vec<_>>(),
            "address": shown(&group.address),
        })
    });
    json!({
        "format": "raytree-grade/1",
        "task": {"name": shown(&task.name), "hash": task.hash},
        "program": concat!("raytree ", env!("CARGO_PKG_VERSION")),
        "submissions": submissions.collect::<Vec<_>>(),
        "unknown": if audience.for_students { Vec::new() } else { unknown.collect::<Vec<_>>() },
    })
}

/// One submission.
pub fn submission(audience: Audience, marked: &Marked) -> Value {
    let task = audience.task;
    let checks = task.checks.iter().zip(&marked.marks);
    let bends = marked
        .diagnosis
        .iter()
        .filter(|_| task.say != Say::Nothing)
        .map(|diagnosis| {
            json!({
                "names": diagnosis.candidates.iter().map(Bends::to_string).collect::<Vec<_>>(),
                "telling": diagnosis.telling,
                "explained": diagnosis.explained,
            })
        });
    json!({
        "name": shown(&marked.name),
        "score": number(marked.score()),
        "max": number(marked.most()),
        "percent": marked.percent(),
        "checks": checks.map(|(check, mark)| self::check(audience, check, mark)).collect::<Vec<_>>(),
        "bends": bends.collect::<Vec<_>>(),
        "problems": marked.problems.iter().map(|problem| shown(problem)).collect::<Vec<_>>(),
    })
}

fn check(audience: Audience, check: &Check, mark: &CheckMark) -> Value {
    let counts = mark.counts;
    let status: &str = mark.status.into();
    let mut value = json!({
        "id": check.id,
        "title": shown(&check.title),
        "score": number(mark.score),
        "max": number(mark.most),
        "status": status,
        "visible": check.visible,
    });
    if shows(audience, check) {
        value["counts"] = json!({
            "right": counts.right,
            "right-given": counts.right_given,
            "wrong": counts.wrong,
            "follows": counts.follows,
            "missing": counts.missing,
            "extra": counts.extra,
        });
        value["note"] = json!(shown(&mark.note));
        value["causes"] = mark
            .causes
            .iter()
            .map(|(at, cause)| self::cause(*at, cause))
            .collect();
    }
    value
}

fn cause(at: (u32, u32), cause: &Cause) -> Value {
    let first = &cause.first;
    let (off, unit) = first.off().unzip();
    json!({
        "address": shown(&first.address(at)),
        "law": first.law.name(),
        "ours": json_value(&first.ours),
        "theirs": first.theirs.as_ref().map_or(Value::Null, json_value),
        "off": off,
        "unit": unit.filter(|unit| !unit.is_empty()),
        "as_if": cause.as_if.iter().map(|bend| bend.name()).collect::<Vec<_>>(),
    })
}

/// Points as a number: whole thousandths, so that it prints as people write it.
fn number(thousandths: u64) -> Value {
    let text = points(thousandths);
    if text.contains('.') {
        json!(thousandths as f64 / 1000.0)
    } else {
        json!(thousandths / 1000)
    }
}
