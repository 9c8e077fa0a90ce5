//! The document of a report.

use serde_json::Value;

use super::document::{
    FORMAT, GradeDocument, GradedCause, GradedCheck, GradedSubmission, Milli, NamedBends, Readers,
    ShownCheck, TaskName,
};
use super::{Audience, diagnosis, shows, unknown};
use crate::grade::diff::Cause;
use crate::grade::finder::unknown_key;
use crate::grade::marks::CheckMark;
use crate::grade::report::{Marked, Report};
use crate::grade::task::{Check, Say};
use crate::grade::value::{json_value, shown};
use crate::scene::Bends;

/// All submissions.
pub fn document(audience: Audience, report: &Report) -> GradeDocument {
    let task = audience.task;
    let submissions = report.submissions.iter();
    let submissions: Vec<_> = submissions.map(|m| submission(audience, m)).collect();
    let (readers, unknown) = if audience.for_students {
        (Readers::Students, Vec::new())
    } else {
        (Readers::Teachers, unknown::groups(&submissions))
    };
    GradeDocument {
        format: FORMAT.to_owned(),
        r#for: readers,
        shard: report.shard,
        task: TaskName {
            name: shown(&task.name),
            hash: task.hash.clone(),
        },
        program: concat!("raytree ", env!("CARGO_PKG_VERSION")).to_owned(),
        submissions,
        unknown,
    }
}

/// One submission.
fn submission(audience: Audience, marked: &Marked) -> GradedSubmission {
    let checks = audience.task.checks.iter().zip(&marked.marks);
    let says = audience.say() == Say::Bend;
    let bends = marked.diagnosis.iter().filter(|_| says);
    let bends = bends.map(|diagnosis| NamedBends {
        names: diagnosis.candidates.iter().map(Bends::to_string).collect(),
        telling: diagnosis.telling,
        explained: diagnosis.explained,
    });
    GradedSubmission {
        name: shown(&marked.name),
        id: marked.id.as_deref().map(shown),
        score: Milli(marked.score()),
        max: Milli(marked.most()),
        percent: marked.percent(),
        checks: checks.map(|(c, mark)| check(audience, c, mark)).collect(),
        bends: bends.collect(),
        message: diagnosis(audience, marked),
        problems: marked.problems.iter().map(|p| shown(p)).collect(),
    }
}

fn check(audience: Audience, check: &Check, mark: &CheckMark) -> GradedCheck {
    let causes = mark.causes.iter();
    let shown_check = ShownCheck {
        counts: mark.counts,
        note: shown(&mark.note),
        causes: causes.map(|(at, c)| cause(audience, *at, c)).collect(),
    };
    GradedCheck {
        id: check.id.clone(),
        title: shown(&check.title),
        score: Milli(mark.score),
        max: Milli(mark.most),
        status: <&str>::from(mark.status).to_owned(),
        visible: check.visible,
        shown: shows(audience, check).then_some(shown_check),
    }
}

fn cause(audience: Audience, at: (u32, u32), cause: &Cause) -> GradedCause {
    let first = &cause.first;
    let (off, unit) = first.off().unzip();
    let unit = unit.filter(|unit| !unit.is_empty());
    let (law, quantity, ratio) = unknown_key(cause);
    let as_if = cause.as_if.iter().filter(|_| audience.say() == Say::Bend);
    GradedCause {
        address: shown(&first.address(at)),
        law: (audience.say() != Say::Nothing).then(|| law.name().to_owned()),
        quantity,
        ours: json_value(&first.ours),
        theirs: first.theirs.as_ref().map_or(Value::Null, json_value),
        ratio,
        off: off.filter(|x| x.is_finite()),
        unit: unit.map(str::to_owned),
        as_if: as_if.map(|bend| bend.name().to_owned()).collect(),
    }
}
