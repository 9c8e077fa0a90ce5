//! Marks as JUnit XML, for continuous integration: a test suite a submission, a test case a check.

use std::fmt::Write as _;

use super::{Audience, cause_line, points, text};
use crate::grade::marks::{CheckMark, CheckStatus};
use crate::grade::report::{Marked, Report};
use crate::grade::task::Check;
use crate::grade::value::shown;
use crate::trace::export::xml::escape;

/// All submissions.
pub fn suites(audience: Audience, report: &Report) -> String {
    let all = || report.submissions.iter().flat_map(|m| &m.marks);
    let mut out = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\">\n",
        escape(&shown(&audience.task.name)),
        all().count(),
        all().filter(|mark| is_failure(mark)).count()
    );
    for marked in &report.submissions {
        suite(&mut out, audience, marked);
    }
    out + "</testsuites>\n"
}

fn suite(out: &mut String, audience: Audience, marked: &Marked) {
    let of = |is: &dyn Fn(&CheckMark) -> bool| marked.marks.iter().filter(|m| is(m)).count();
    let name = escape(&shown(&marked.name));
    // Writing to a string cannot fail.
    let _ = writeln!(
        out,
        "<testsuite name=\"{name}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\">",
        marked.marks.len(),
        of(&is_failure),
        of(&is_skipped)
    );
    for (check, mark) in audience.task.checks.iter().zip(&marked.marks) {
        let title = escape(&shown(&format!("{}: {}", check.id, check.title)));
        let _ = write!(out, "<testcase classname=\"{name}\" name=\"{title}\"");
        let rest = match mark.status {
            _ if is_failure(mark) => failure(audience, check, mark),
            CheckStatus::Skipped => {
                let why = escape(&text::about(audience, check, mark));
                format!("><skipped message=\"{why}\"/></testcase>\n")
            }
            _ => "/>\n".to_owned(),
        };
        out.push_str(&rest);
    }
    let told = super::diagnosis(audience, marked).into_iter();
    let problems = marked.problems.iter().map(|p| shown(p));
    let lines: Vec<String> = told.chain(problems).map(|line| escape(&line)).collect();
    if !lines.is_empty() {
        let _ = writeln!(out, "<system-out>{}</system-out>", lines.join("\n"));
    }
    out.push_str("</testsuite>\n");
}

/// The rest of a test case that failed: the first cause is its message.
fn failure(audience: Audience, check: &Check, mark: &CheckMark) -> String {
    let earned = format!("{} of {}", points(mark.score), points(mark.most));
    let causes = mark.causes.iter();
    let causes: Vec<String> = causes.map(|(at, c)| cause_line(audience, *at, c)).collect();
    let about = text::about(audience, check, mark);
    let message = match causes.first() {
        Some(first) => format!("{earned}: {first}"),
        None => format!("{earned}: {about}"),
    };
    let kind: &str = mark.status.into();
    let lines: Vec<String> = std::iter::once(&about)
        .chain(&causes)
        .map(|line| escape(line))
        .collect();
    format!(
        "><failure type=\"{kind}\" message=\"{}\">{}</failure></testcase>\n",
        escape(&message),
        lines.join("\n")
    )
}

fn is_failure(mark: &CheckMark) -> bool {
    mark.score < mark.most && !is_skipped(mark)
}

fn is_skipped(mark: &CheckMark) -> bool {
    mark.status == CheckStatus::Skipped
}
