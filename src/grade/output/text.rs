//! Marks for reading.

use std::fmt::Write as _;

use super::{Audience, diagnosis, points};
use crate::grade::diff::Cause;
use crate::grade::marks::{CheckMark, CheckStatus};
use crate::grade::quantity::field;
use crate::grade::report::{Marked, Report};
use crate::grade::task::{Check, Say};
use crate::grade::value::shown;
use crate::scene::printable::shell_word;

/// Problems that are told.
const TOLD: usize = 5;

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
    if let Some(text) = diagnosis(task, marked) {
        let _ = writeln!(out, "{text}");
    }
    let first = marked
        .causes()
        .find(|(check, ..)| shows(audience, &task.checks[*check]));
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
        let (width, height) = scene.settings.size();
        let _ = writeln!(
            out,
            "  first at {x},{y}{} {}{off}      raytree view {} --size {width}x{height} --at {x},{y}{}",
            shown(&first.path.to_string()),
            field(&first.name),
            shell_word(&scene.path),
            shown(&first.path.to_string()),
        );
    }
    for problem in marked.problems.iter().take(TOLD) {
        // Where programs were run, the sandbox is told among the problems, and is none.
        let is_sandbox = problem.starts_with("sandbox: ");
        let label = if is_sandbox { "" } else { "problem: " };
        let _ = writeln!(out, "  {label}{}", shown(problem));
    }
    if marked.problems.len() > TOLD {
        let _ = writeln!(out, "  and {} problems more", marked.problems.len() - TOLD);
    }
    out
}

/// Causes that several submissions share and that nothing explains.
pub fn unknown(audience: Audience, report: &Report) -> String {
    if audience.for_students {
        return String::new();
    }
    let groups = report.unknown.iter().map(|group| {
        format!(
            "{} submissions share a mistake that no bend explains: law {}, {}, {} times ours; first at {}\n",
            group.names.len(),
            group.law,
            group.quantity,
            group.ratio,
            shown(&group.address)
        )
    });
    groups.collect()
}

/// True if values and addresses of a check are told.
pub fn shows(audience: Audience, check: &Check) -> bool {
    check.visible || !audience.for_students
}

/// What a check came to, in a few words.
fn about(audience: Audience, check: &Check, mark: &CheckMark) -> String {
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
            let law = mark
                .causes
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
    if audience.task.say == Say::Nothing {
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
