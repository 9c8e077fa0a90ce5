//! Marks for reading.

use std::fmt::Write as _;

use super::document::UnknownGroup;
use super::{Audience, diagnosis, json, open_command, points, shows, told_causes, unknown};
use crate::grade::diff::Cause;
use crate::grade::marks::{CheckMark, CheckStatus};
use crate::grade::quantity::field;
use crate::grade::report::{Marked, Report};
use crate::grade::task::{Check, Say};
use crate::grade::value::shown;
use crate::trace::format::counted;

/// Problems that are told.
const TOLD: usize = 5;

/// All submissions.
pub fn all(audience: Audience, report: &Report) -> String {
    let submissions = report.submissions.iter();
    let out: String = submissions.map(|m| submission(audience, m)).collect();
    if audience.for_students {
        return out;
    }
    let groups = unknown::groups(&json::document(audience, report).submissions);
    out + &groups.iter().map(of_group).collect::<String>()
}

/// One submission.
pub fn submission(audience: Audience, marked: &Marked) -> String {
    let task = audience.task;
    let (score, most) = (points(marked.score()), points(marked.most()));
    let mut out = format!(
        "{}, {}: {score} of {most} ({} %)\n",
        shown(&task.name),
        shown(&marked.name),
        marked.percent()
    );
    let width = task
        .checks
        .iter()
        .map(|check| check.id.len())
        .max()
        .unwrap_or(0);
    for (check, mark) in task.checks.iter().zip(&marked.marks) {
        let hidden = if check.visible { "" } else { ", hidden" };
        let earned = format!("{} of {}{hidden}", points(mark.score), points(mark.most));
        let _ = writeln!(
            out,
            "  {:width$}  {earned:22}{}",
            check.id,
            about(audience, check, mark)
        );
    }
    if let Some(counted) = &marked.counted {
        let _ = writeln!(out, "{}", counted.why);
    }
    if let Some(text) = diagnosis(audience, marked) {
        let _ = writeln!(out, "{text}");
    }
    let first = marked.causes().find(|(check, ..)| {
        shows(audience, &task.checks[*check]) && !told_causes(&marked.marks[*check]).is_empty()
    });
    if let Some((check, at, cause)) = first {
        let (x, y) = at;
        let first = &cause.first;
        let off = first.off().filter(|(_, unit)| !unit.is_empty());
        let off = off.map_or(String::new(), |(off, unit)| {
            format!(
                ": {off:.2} {unit}{} off",
                if unit == "degree" { "s" } else { "" }
            )
        });
        let scene = &task.scenes[task.checks[check].scene];
        let _ = writeln!(
            out,
            "  first at {x},{y}{} {}{off}      {}",
            shown(&first.path.to_string()),
            field(&first.name),
            open_command(audience, scene, at, &first.path)
        );
    }
    for problem in marked.problems.iter().take(TOLD) {
        // Where programs were run, the sandbox is told among the problems, and is none.
        let is_sandbox = problem.starts_with("sandbox: ");
        let label = if is_sandbox { "" } else { "problem: " };
        let _ = writeln!(out, "  {label}{}", shown(problem));
    }
    if marked.problems.len() > TOLD {
        let more = counted((marked.problems.len() - TOLD) as u64, "more problem");
        let _ = writeln!(out, "  and {more}");
    }
    out
}

/// A cause that several submissions share and that nothing explains.
pub fn of_group(group: &UnknownGroup) -> String {
    format!(
        "{} submissions share a mistake that no bend explains: law {}, {}, {} times ours; first at {}\n",
        group.submissions.len(),
        group.law,
        group.quantity,
        group.ratio,
        shown(&group.address)
    )
}

/// What a check came to, in a few words.
pub fn about(audience: Audience, check: &Check, mark: &CheckMark) -> String {
    let counts = mark.counts;
    let right = counts.right + counts.right_given;
    let asked = right + counts.wrong + counts.follows + counts.missing + counts.extra;
    let title = shown(&check.title);
    if !shows(audience, check) {
        return title;
    }
    match mark.status {
        CheckStatus::Skipped | CheckStatus::Broken => format!("{title}: {}", shown(&mark.note)),
        _ if asked == 0 => format!("{title}: {}", shown(&mark.note)),
        _ => {
            let law = told_causes(mark)
                .first()
                .map(|(_, cause)| law(audience, cause))
                .unwrap_or_default();
            let missing = if counts.missing > 0 {
                format!(", {} not told", counts.missing)
            } else {
                String::new()
            };
            let note = if mark.note.is_empty() {
                String::new()
            } else {
                format!("; {}", shown(&mark.note))
            };
            format!("{title}: {right} of {asked}{missing}{law}{note}")
        }
    }
}

fn law(audience: Audience, cause: &Cause) -> String {
    if audience.say() == Say::Nothing {
        return String::new();
    }
    let places = std::iter::once(&cause.first).chain(&cause.also).take(3);
    let places = places.map(|compared| match shown(&compared.path.to_string()) {
        eye if eye.is_empty() => "the eye ray".to_owned(),
        path => path,
    });
    let places: Vec<String> = places.collect();
    format!(": {} is wrong at {}", cause.first.law, places.join(", "))
}
