//! What grading writes: one file a kind of output, all made from the same [`Report`].

mod classroom50;
mod csv;
mod document;
mod gradescope;
mod html;
mod json;
mod junit;
mod merge;
pub mod text;
mod unknown;

use super::diff::Cause;
use super::marks::CheckMark;
use super::report::{Marked, Report};
use super::task::{Check, Say, Task, TaskScene};
use super::value::shown;
use crate::scene::printable::shell_word;
use crate::trace::facts::TreePath;

pub use classroom50::{Classroom, is_datetime, utc};
pub use csv::table;
pub use document::GradeDocument;
pub use html::{Page, difference, pages};
pub use merge::{merge, parse};

pub use super::value::points;

/// What an output is made for.
#[derive(Clone, Copy)]
pub struct Audience<'a> {
    /// The task.
    pub task: &'a Task,
    /// Whether it is for students: what is hidden has neither values nor addresses there.
    pub for_students: bool,
}

impl Audience<'_> {
    /// How much is told of mistakes: a teacher reads their names whatever the task tells students.
    fn say(&self) -> Say {
        if self.for_students {
            self.task.say
        } else {
            Say::Bend
        }
    }
}

/// Kinds of output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum OutputKind {
    /// For reading
    Text,
    /// For programs: format raytree-grade/1
    Json,
    /// A table for spreadsheets, a line a submission
    Csv,
    /// JUnit XML, for continuous integration
    Junit,
    /// Pages for a browser: a folder, or one file if the name ends in .html
    Html,
    /// results.json of Gradescope's autograder
    Gradescope,
    /// result.json of Classroom 50's autograder
    Classroom50,
}

impl OutputKind {
    /// Endings of files that say what is in them.
    pub fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Text => &["txt"],
            Self::Csv => &["csv"],
            Self::Junit => &["xml"],
            Self::Html => &["html", "htm"],
            Self::Json | Self::Gradescope | Self::Classroom50 => &["json"],
        }
    }

    /// True if students read it, whoever asks for it.
    fn is_for_students(self) -> bool {
        matches!(self, Self::Gradescope | Self::Classroom50)
    }

    /// The output as one file; `classroom` is asked for what Classroom 50 needs. An error says what to do.
    pub fn write(
        self,
        audience: Audience,
        report: &Report,
        classroom: &dyn Fn() -> Result<Classroom, String>,
    ) -> Result<String, String> {
        let audience = Audience {
            for_students: audience.for_students || self.is_for_students(),
            ..audience
        };
        // Made of what students may see, so that nothing else can be forgotten in it.
        let view = audience
            .for_students
            .then(|| report.for_students(audience.task));
        let report = view.as_ref().unwrap_or(report);
        let pretty = |value: serde_json::Value| Ok(format!("{value:#}\n"));
        match self {
            Self::Text => Ok(text::all(audience, report)),
            Self::Json => json(&json::document(audience, report)),
            Self::Csv => Ok(csv::table(&json::document(audience, report))),
            Self::Junit => Ok(junit::suites(audience, report)),
            Self::Html => Ok(html::one_page(audience, report)),
            Self::Gradescope => {
                let marked = self.only(report)?;
                pretty(gradescope::results(audience, marked, report))
            }
            Self::Classroom50 => {
                let marked = self.only(report)?;
                pretty(classroom50::result(audience, &classroom()?, marked))
            }
        }
    }

    /// The one submission of an output that has room for one.
    fn only(self, report: &Report) -> Result<&Marked, String> {
        let [marked] = &report.submissions[..] else {
            let name = if self == Self::Gradescope {
                "gradescope"
            } else {
                "classroom50"
            };
            return Err(format!(
                "--output {name} is the result of one submission, and there are {}; run `raytree grade` once for each",
                report.submissions.len()
            ));
        };
        Ok(marked)
    }
}

/// A document as text.
pub fn json(document: &GradeDocument) -> Result<String, String> {
    let text = serde_json::to_string_pretty(document).map_err(|error| error.to_string())?;
    Ok(text + "\n")
}

/// True if values and addresses of a check are told.
fn shows(audience: Audience, check: &Check) -> bool {
    check.visible || !audience.for_students
}

/// The causes of a check that are told: where all points are earned, what is wrong is not what was asked.
fn told_causes(mark: &CheckMark) -> &[((u32, u32), Cause)] {
    if mark.score < mark.most {
        &mark.causes
    } else {
        &[]
    }
}

/// A cause in a line: where, both values, how far off, the law, and the mistake that gives just that.
fn cause_line(audience: Audience, at: (u32, u32), cause: &Cause) -> String {
    use super::value::text;
    let first = &cause.first;
    let theirs = first.theirs.as_ref().map_or("nothing".to_owned(), text);
    let off = first.off().filter(|(_, unit)| !unit.is_empty());
    let off = off.map_or(String::new(), |(off, unit)| {
        format!(", {off:.2} {unit}s off")
    });
    let law = match audience.say() {
        Say::Nothing => String::new(),
        _ => format!("; law {}", first.law),
    };
    let as_if = cause.as_if.iter().filter(|_| audience.say() == Say::Bend);
    let as_if: Vec<&str> = as_if.map(|bend| bend.name()).collect();
    let as_if = match &as_if[..] {
        [] => String::new(),
        names => format!("; as if {}", names.join(" or ")),
    };
    let address = shown(&first.address(at));
    let ours = text(&first.ours);
    format!("{address}: expected {ours}, handed in {theirs}{off}{law}{as_if}")
}

/// The command that opens our tree at a ray. A student has the scene under the name that the task gives it, not where the teacher
/// keeps it.
fn open_command(
    audience: Audience,
    scene: &TaskScene,
    (x, y): (u32, u32),
    path: &TreePath,
) -> String {
    let label = scene.label.split(" without ").next();
    let name = label.filter(|_| audience.for_students);
    let name = shell_word(name.unwrap_or(&scene.path));
    let (width, height) = scene.settings.size();
    let path = shown(&path.to_string());
    format!("raytree view {name} --size {width}x{height} --at {x},{y}{path}")
}

/// What is said about the mistakes of a submission; none where the task says nothing.
pub fn diagnosis(audience: Audience, marked: &Marked) -> Option<String> {
    let diagnosis = marked.diagnosis.as_ref()?;
    let names: Vec<String> = diagnosis
        .candidates
        .iter()
        .map(ToString::to_string)
        .collect();
    let first = diagnosis.candidates.first()?;
    let numbers = format!(
        "{} of {} telling numbers",
        diagnosis.explained, diagnosis.telling
    );
    match audience.say() {
        Say::Nothing => None,
        Say::Law => {
            let laws: Vec<&str> = first.iter().map(|bend| bend.law().name()).collect();
            Some(format!(
                "look at the law `{}` ({numbers})",
                laws.join("` and `")
            ))
        }
        Say::Bend if names.len() > 1 => {
            Some(format!("as if one of: {} ({numbers})", names.join("; ")))
        }
        Say::Bend => {
            let notes: Vec<String> = first
                .iter()
                .map(|bend| {
                    format!(
                        "{}: {} [{}]",
                        bend.name(),
                        bend.entry().note,
                        bend.entry().formula
                    )
                })
                .collect();
            Some(format!("as if: {} ({numbers})", notes.join("; and ")))
        }
    }
}
