//! The class: which check is hardest, which mistakes are made, and those that nothing explains.

use std::collections::BTreeMap;

use super::{cell, escape, number, table};
use crate::grade::output::document::GradeDocument;
use crate::grade::output::text;
use crate::trace::format::counted;

/// The view of the class.
pub fn view(document: &GradeDocument) -> String {
    let count = document.submissions.len();
    if count == 0 {
        return String::new();
    }
    let percents = document.submissions.iter().map(|s| s.percent);
    let mean = percents.sum::<u64>() as f64 / count as f64;
    let head = format!(
        "<h2>The class</h2>\n<p>{}; {mean:.0} % on average.</p>\n",
        counted(count as u64, "submission")
    );
    head + &checks(document) + &mistakes(document) + &unknown(document)
}

/// The mean of each check; the lowest is marked.
fn checks(document: &GradeDocument) -> String {
    let count = document.submissions.len() as u64;
    let ids = document.submissions[0].checks.iter().enumerate();
    let means: Vec<(&str, u64, u64)> = ids
        .map(|(index, check)| {
            let marks = document.submissions.iter().map(|s| &s.checks[index]);
            let full = marks.clone().filter(|c| c.status == "full").count() as u64;
            let score: u64 = marks.map(|c| c.score.0).sum();
            let percent = (100 * score).checked_div(check.max.0 * count);
            (check.id.as_str(), percent.unwrap_or(100), full)
        })
        .collect();
    let lowest = means.iter().map(|(_, percent, _)| *percent).min();
    let rows = means.iter().map(|(id, percent, full)| {
        let is_lowest = Some(*percent) == lowest && *percent < 100;
        let note = if is_lowest { "lowest" } else { "" };
        [
            cell(id),
            number(&percent.to_string()),
            number(&full.to_string()),
            cell(note),
        ]
        .concat()
    });
    let heads = ["check", "mean, %", "all points", ""].map(str::to_owned);
    table("", &heads, rows)
}

/// How many submissions have which mistake, the commonest first.
fn mistakes(document: &GradeDocument) -> String {
    let mut counts: BTreeMap<String, u64> = BTreeMap::new();
    let mut unexplained = 0;
    for submission in &document.submissions {
        match submission.bends.first() {
            Some(bends) => *counts.entry(bends.names.join(" or ")).or_insert(0) += 1,
            None => unexplained += u64::from(submission.score < submission.max),
        }
    }
    let mut counts: Vec<(String, u64)> = counts.into_iter().collect();
    counts.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    if unexplained > 0 {
        counts.push((
            "points lost, and no single mistake explains it".to_owned(),
            unexplained,
        ));
    }
    if counts.is_empty() {
        return String::new();
    }
    let rows = counts
        .iter()
        .map(|(name, count)| cell(name) + &number(&count.to_string()));
    table("", &["mistake", "submissions"].map(str::to_owned), rows)
}

fn unknown(document: &GradeDocument) -> String {
    let groups = document.unknown.iter().map(|group| {
        let who = group.submissions.join(", ");
        format!(
            "<li>{}{}</li>\n",
            escape(text::of_group(group).trim_end()),
            escape(&format!(": {who}"))
        )
    });
    let items: String = groups.collect();
    if items.is_empty() {
        return items;
    }
    format!("<h3>Shared mistakes without a name</h3>\n<ul>\n{items}</ul>\n")
}
