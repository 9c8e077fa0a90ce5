//! What grading writes: one file a kind of output, all made from the same [`Report`].

mod json;
mod text;

use super::report::{Marked, Report};
use super::task::{Say, Task};

/// What an output is made for.
#[derive(Clone, Copy)]
pub struct Audience<'a> {
    /// The task.
    pub task: &'a Task,
    /// Whether it is for students: what is hidden has neither values nor addresses there.
    pub for_students: bool,
}

/// Kinds of output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum OutputKind {
    /// For reading
    Text,
    /// For programs: format raytree-grade/1
    Json,
}

impl OutputKind {
    /// The output as text.
    pub fn write(self, audience: Audience, report: &Report) -> String {
        match self {
            Self::Text => {
                report
                    .submissions
                    .iter()
                    .map(|marked| text::submission(audience, marked))
                    .collect::<String>()
                    + &text::unknown(audience, report)
            }
            Self::Json => format!("{:#}\n", json::report(audience, report)),
        }
    }
}

/// Points as people read them: `2.75`.
pub fn points(thousandths: u64) -> String {
    let text = format!("{}.{:03}", thousandths / 1000, thousandths % 1000);
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// What is said about the mistakes of a submission; none where the task says nothing.
pub fn diagnosis(task: &Task, marked: &Marked) -> Option<String> {
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
    match task.say {
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
