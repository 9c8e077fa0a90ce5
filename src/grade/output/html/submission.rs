//! A submission: its checks, and where a law is broken first.

use super::{cell, equation, escape, number, table, tree};
use crate::grade::output::{
    Audience, cause_line, diagnosis, open_command, points, text, told_causes,
};
use crate::grade::report::Marked;
use crate::grade::task::Say;
use crate::grade::value::shown;
use crate::scene::Bends;

/// All that is told of a submission.
pub fn section(audience: Audience, marked: &Marked) -> String {
    let (name, score, most) = (
        shown(&marked.name),
        points(marked.score()),
        points(marked.most()),
    );
    let percent = marked.percent();
    let heading = format!("{name}: {score} of {most} ({percent} %)");
    let told = diagnosis(audience, marked);
    let told = told.map(|text| format!("<p>{}</p>\n", escape(&text)));
    [
        format!("<h2>{}</h2>\n", escape(&heading)),
        told.unwrap_or_default(),
        checks(audience, marked),
        first_cause(audience, marked),
        problems(marked),
    ]
    .concat()
}

fn problems(marked: &Marked) -> String {
    if marked.problems.is_empty() {
        return String::new();
    }
    let problems = marked.problems.iter();
    let items: Vec<String> = problems
        .map(|problem| format!("<li>{}</li>\n", escape(&shown(problem))))
        .collect();
    format!("<h3>Problems</h3>\n<ul>\n{}</ul>\n", items.concat())
}

/// The mistakes by name, as far as the reader may know.
pub fn mistakes(audience: Audience, marked: &Marked) -> String {
    match (&marked.diagnosis, audience.say()) {
        (Some(diagnosis), Say::Bend) => {
            let names: Vec<String> = diagnosis.candidates.iter().map(Bends::to_string).collect();
            names.join(" or ")
        }
        _ => String::new(),
    }
}

fn checks(audience: Audience, marked: &Marked) -> String {
    let rows = audience.task.checks.iter().zip(&marked.marks);
    let rows = rows.map(|(check, mark)| {
        let hidden = if check.visible { "" } else { ", hidden" };
        let status: &str = mark.status.into();
        [
            cell(&check.id),
            number(&format!("{} of {}", points(mark.score), points(mark.most))),
            cell(&format!("{status}{hidden}")),
            cell(&text::about(audience, check, mark)),
        ]
        .concat()
    });
    let heads = ["check", "points", "", ""].map(str::to_owned);
    table("", &heads, rows)
}

/// The tree of the first cause, and the numbers of the equation if it is there.
fn first_cause(audience: Audience, marked: &Marked) -> String {
    let mut marks = marked.marks.iter().zip(&audience.task.checks);
    let first = marks.find_map(|(mark, check)| {
        let ((x, y), cause) = told_causes(mark).first()?;
        Some((check, mark.tree.as_ref()?, (*x, *y), cause))
    });
    let Some((check, kept, (x, y), cause)) = first else {
        return String::new();
    };
    let Some(ours) = tree::ours(check, (x, y)) else {
        return String::new();
    };
    let scene = &audience.task.scenes[check.scene];
    let open = open_command(audience, scene, (x, y), &cause.first.path);
    let heading = format!(
        "Where it breaks first: {}, pixel ({x}, {y})",
        shown(&scene.label)
    );
    [
        format!("<h3>{}</h3>\n", escape(&heading)),
        format!("<p>{}</p>\n", escape(&cause_line(audience, (x, y), cause))),
        format!("<p><code>{}</code></p>\n", escape(&open)),
        equation::table_of(ours, kept, &cause.first),
        tree::table_of(audience.say(), ours, kept),
    ]
    .concat()
}
