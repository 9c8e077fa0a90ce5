//! Answers to exercises, judged by the tracer.

mod bug;
mod change;
mod choose;
mod find;
mod predict;
mod write;

use super::chapter::Chapter;
use super::course::Course;
use super::exercise::{Exercise, ExerciseKind};
use crate::grade::submission::Submission;
use crate::trace::facts::TreePath;
use crate::tracer::thread_pool;

pub use bug::first_wrong;
pub use change::start_text;
pub use choose::{is_right, letter};
pub use find::{FoundPart, parts};
pub use write::load as load_task;

/// What a student answers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum StudentAnswer {
    /// A value, as it is typed.
    Value(String),
    /// A pixel.
    Pixel((u32, u32)),
    /// The letter of an option, and for a slide the pixel where it fails.
    Choice(Option<(u32, u32)>, char),
    /// A mistake by name, and the ray where it first shows.
    Bug(String, TreePath),
    /// A scene file: its text.
    Scene(String),
    /// What a program printed.
    HandedIn(Submission),
}

/// What is said of an answer.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct AnswerVerdict {
    /// Whether it is right.
    pub right: bool,
    /// What is said, a sentence or a line each.
    pub lines: Vec<String>,
}

impl AnswerVerdict {
    /// Right, and what is said.
    pub fn right(line: impl Into<String>) -> Self {
        Self {
            right: true,
            lines: vec![line.into()],
        }
    }

    /// Wrong, and what is said.
    pub fn wrong(line: impl Into<String>) -> Self {
        Self {
            right: false,
            lines: vec![line.into()],
        }
    }

    /// With one line more.
    #[must_use]
    pub fn line(mut self, line: impl Into<String>) -> Self {
        self.lines.push(line.into());
        self
    }
}

/// Judges an answer; `tries` counts those before it. An error if the answer cannot be read, which is no try.
pub fn judge(
    course: &Course,
    chapter: &Chapter,
    exercise: &Exercise,
    given: &StudentAnswer,
    tries: u32,
) -> Result<AnswerVerdict, String> {
    let stage = || {
        let stage = course.stage_of(chapter, exercise);
        stage.map_err(|e| e.to_string())
    };
    match (&exercise.kind, given) {
        (ExerciseKind::Predict { asked, tolerance }, StudentAnswer::Value(text)) => {
            predict::judge(&stage()?, asked, *tolerance, text, tries)
        }
        (ExerciseKind::Find(wanted), StudentAnswer::Pixel(at)) => {
            find::judge(&stage()?, wanted, *at)
        }
        (ExerciseKind::Change(task), StudentAnswer::Scene(text)) => {
            change::judge((chapter, exercise), &stage()?, task, text)
        }
        (ExerciseKind::Bug { bend, at, .. }, StudentAnswer::Bug(law, path)) => {
            bug::judge(&stage()?, *bend, *at, law, path)
        }
        (ExerciseKind::Choose { bend, options, .. }, StudentAnswer::Choice(pixel, letter)) => {
            choose::judge(
                course,
                chapter,
                &stage()?,
                (*bend, options),
                *pixel,
                *letter,
            )
        }
        (ExerciseKind::Write { task }, StudentAnswer::HandedIn(submission)) => {
            thread_pool::install(0, || write::judge(course, task, submission.clone()))
        }
        (kind, _) => Err(format!(
            "this is no answer to an exercise of the kind {}; {}",
            kind.name(),
            kind.answered_by()
        )),
    }
}

impl ExerciseKind {
    /// How an answer is given to `raytree lesson answer`.
    pub fn answered_by(&self) -> &'static str {
        match self {
            Self::Predict { .. } => "answer with a value, such as 2.71, or 0.1,0.2,0.3, or a word",
            Self::Find(_) => "answer with a pixel, such as 120,80",
            Self::Change(_) => "answer with the path of the scene file that you changed",
            Self::Bug { .. } => {
                "answer with the name of the mistake and the ray where it first shows: / or I for the eye ray, /T/T, /L:lamp"
            }
            Self::Choose { bend: Some(_), .. } => {
                "answer with a pixel where the slide fails and the letter or number of an option, such as 120,80 b"
            }
            Self::Choose { .. } => "answer with the letter or number of an option, such as b or 2",
            Self::Write { .. } => {
                "answer with the path of what your program printed, a folder or a file"
            }
        }
    }
}
