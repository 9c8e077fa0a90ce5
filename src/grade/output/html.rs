//! Marks as pages for a browser: an index with the whole class, and a page a submission. They need nothing else: no script, no
//! link out, no request.

mod class;
mod difference;
mod equation;
mod submission;
mod tree;

pub use difference::difference;

use super::{Audience, json, points};
use crate::grade::report::Report;
use crate::grade::value::shown;
use crate::trace::export::xml::escape;

/// A page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Page {
    /// The name of its file.
    pub file: String,
    /// All of it.
    pub text: String,
}

/// What all pages look like. Words, not colours alone, tell right from wrong.
const STYLE: &str = "\
body{font:16px/1.45 system-ui,sans-serif;margin:2rem auto;max-width:70rem;padding:0 1rem;color:#1b1b1b;background:#fff}
h1{font-size:1.5rem}h2{font-size:1.25rem;margin-top:2rem}h3{font-size:1.05rem}
table{border-collapse:collapse;margin:.6rem 0}th,td{border:1px solid #ccc;padding:.2rem .6rem;text-align:left;vertical-align:top}
th{background:#f2f2f2}td.n{text-align:right;font-variant-numeric:tabular-nums}
.wrong{background:#fde3e0}.follows{background:#fdf3d8}.right{color:#2f6b2f}.missing{background:#eee}
pre{white-space:pre-wrap}code,pre,.tree td{font-family:ui-monospace,monospace;font-size:.87rem}section{border-top:2px solid #888;margin-top:2.5rem}
@media(prefers-color-scheme:dark){body{color:#e6e6e6;background:#161616}th{background:#2a2a2a}th,td{border-color:#444}
.wrong{background:#5a2420}.follows{background:#50431a}.missing{background:#333}.right{color:#8fce8f}a{color:#8ab4f8}}";

/// The index and the pages of the submissions, for a folder.
pub fn pages(audience: Audience, report: &Report) -> Vec<Page> {
    let view = audience
        .for_students
        .then(|| report.for_students(audience.task));
    let report = view.as_ref().unwrap_or(report);
    let name = |index: usize| format!("{:04}.html", index + 1);
    let mut pages = vec![Page {
        file: "index.html".to_owned(),
        text: page(&title(audience), &index(audience, report, &name)),
    }];
    for (index, marked) in report.submissions.iter().enumerate() {
        let body = submission::section(audience, marked);
        let back = "<p><a href=\"index.html\">All submissions</a></p>\n";
        pages.push(Page {
            file: name(index),
            text: page(&shown(&marked.name), &format!("{back}{body}")),
        });
    }
    pages
}

/// All in one page.
pub fn one_page(audience: Audience, report: &Report) -> String {
    let sections = (1..).zip(&report.submissions).map(|(number, marked)| {
        let section = submission::section(audience, marked);
        format!("<section id=\"s{number}\">\n{section}</section>\n")
    });
    let sections: Vec<String> = sections.collect();
    let index = index(audience, report, &|index| format!("#s{}", index + 1));
    page(&title(audience), &(index + &sections.concat()))
}

fn title(audience: Audience) -> String {
    shown(&audience.task.name)
}

/// A whole page. What it may load is written into it: nothing.
fn page(title: &str, body: &str) -> String {
    let title = escape(title);
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n\
<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n\
<meta name=\"viewport\" content=\"width=device-width\">\n<title>{title}</title>\n<style>\n{STYLE}\n</style></head>\n\
<body>\n<h1>{title}</h1>\n{body}</body></html>\n"
    )
}

/// The class, and all submissions with where to find them.
fn index(audience: Audience, report: &Report, link: &dyn Fn(usize) -> String) -> String {
    let mut out = String::new();
    if !audience.for_students {
        out += &class::view(&json::document(audience, report));
    }
    out += "<h2>Submissions</h2>\n";
    let mut heads = vec!["submission".to_owned(), "points".to_owned(), "%".to_owned()];
    heads.extend(audience.task.checks.iter().map(|check| check.id.clone()));
    heads.push("mistake".to_owned());
    let rows = report
        .submissions
        .iter()
        .enumerate()
        .map(|(index, marked)| {
            let name = escape(&shown(&marked.name));
            let id = marked
                .id
                .as_deref()
                .map_or(String::new(), |id| format!(" ({})", escape(&shown(id))));
            let mut cells = vec![
                format!("<td><a href=\"{}\">{name}</a>{id}</td>", link(index)),
                number(&points(marked.score())),
                number(&marked.percent().to_string()),
            ];
            cells.extend(marked.marks.iter().map(|mark| number(&points(mark.score))));
            cells.push(cell(&submission::mistakes(audience, marked)));
            cells.concat()
        });
    out + &table("", &heads, rows)
}

/// A table of rows that are cells already.
fn table(class: &str, heads: &[String], rows: impl Iterator<Item = String>) -> String {
    let heads = heads.iter().map(|h| format!("<th>{}</th>", escape(h)));
    let heads = heads.collect::<Vec<_>>().concat();
    let rows = rows.map(|row| format!("<tr>{row}</tr>\n"));
    let rows = rows.collect::<Vec<_>>().concat();
    format!("<table class=\"{class}\"><tr>{heads}</tr>\n{rows}</table>\n")
}

/// A cell of text.
fn cell(text: &str) -> String {
    format!("<td>{}</td>", escape(text))
}

/// A cell of a number.
fn number(text: &str) -> String {
    format!("<td class=\"n\">{}</td>", escape(text))
}
