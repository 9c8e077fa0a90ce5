//! Check of a course by its author: everything that a student would stumble over.

mod answers;
mod numbers;
mod scenes;
mod texts;

use std::time::Instant;

use serde::Serialize;

pub use answers::{found, slide_pixel, solution_text};

use super::chapter::Chapter;
use super::course::Course;
use super::exercise::{Exercise, ExerciseKind};

/// Seconds that a chapter may take to be checked, in a program that is optimised.
pub const MAX_SECONDS: f64 = 5.0;

/// A check, by its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum CheckName {
    /// 1: files are read, names are unique, limits are kept.
    Files,
    /// 2: every directive evaluates, and the text is of the subset of Markdown.
    Directives,
    /// 3: every predict has an answer that is finite and that nobody guesses.
    Predict,
    /// 4: a find holds for at least one pixel and at most half of them.
    Find,
    /// 5: the start of a change fails, its solution passes, and keeps what is to be kept.
    Change,
    /// 6: a bug changes the tree of its pixel, and no other mistake that is offered gives the same tree.
    Bug,
    /// 7: a slide fails at a pixel or more, and one option is right.
    Choose,
    /// 8: a task earns nothing for nothing, and all for what our tracer hands in.
    Write,
    /// 9: three hints, the third without the digits of the answer.
    Hints,
    /// 10: a scene has what that of the chapter before has.
    Grows,
    /// 11: what a chapter uses is enabled.
    Enabled,
    /// 12: a chapter is checked in time.
    Time,
}

/// What is wrong.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct CourseFinding {
    /// The check.
    pub check: CheckName,
    /// The file.
    pub file: String,
    /// The exercise, if it is one's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub exercise: Option<String>,
    /// What is wrong, and what to do.
    pub what: String,
}

impl std::fmt::Display for CourseFinding {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: ", self.file)?;
        if let Some(exercise) = &self.exercise {
            write!(f, "{exercise}: ")?;
        }
        write!(f, "{} (check {})", self.what, self.check as u8 + 1)
    }
}

/// Checks a course, chapter by chapter, each of which may take so many seconds; `told` hears of each that is done.
pub fn check(course: &Course, most: f64, told: &mut dyn FnMut(&Chapter)) -> Vec<CourseFinding> {
    let mut findings = Vec::new();
    let mut before: Option<&Chapter> = None;
    for chapter in &course.chapters {
        let start = Instant::now();
        findings.extend(of_chapter(course, chapter, before));
        let seconds = start.elapsed().as_secs_f64();
        if seconds > most {
            findings.push(CourseFinding {
                check: CheckName::Time,
                file: format!("{}/chapter.toml", chapter.folder),
                exercise: None,
                what: format!(
                    "it takes {seconds:.1} s to check, more than {most}; use smaller pictures or fewer samples"
                ),
            });
        }
        told(chapter);
        before = Some(chapter);
    }
    findings
}

/// Checks a chapter.
fn of_chapter(course: &Course, chapter: &Chapter, before: Option<&Chapter>) -> Vec<CourseFinding> {
    let file = format!("{}/chapter.toml", chapter.folder);
    let mut findings = Vec::new();
    let mut tell = |check: CheckName, file: &str, exercise: Option<&str>, what: String| {
        findings.push(CourseFinding {
            check,
            file: file.to_owned(),
            exercise: exercise.map(str::to_owned),
            what,
        });
    };
    for (check, what) in texts::wrong(course, chapter) {
        tell(check, &format!("{}/text.md", chapter.folder), None, what);
    }
    for (check, what) in scenes::wrong(course, chapter, before) {
        tell(check, &file, None, what);
    }
    for exercise in &chapter.exercises {
        for (check, what) in of_exercise(course, chapter, exercise) {
            tell(check, &file, Some(&exercise.id), what);
        }
    }
    findings
}

/// Checks an exercise.
fn of_exercise(
    course: &Course,
    chapter: &Chapter,
    exercise: &Exercise,
) -> Vec<(CheckName, String)> {
    let name = match &exercise.kind {
        ExerciseKind::Predict { .. } => CheckName::Predict,
        ExerciseKind::Find(_) => CheckName::Find,
        ExerciseKind::Change(_) => CheckName::Change,
        ExerciseKind::Bug { .. } => CheckName::Bug,
        ExerciseKind::Choose { .. } => CheckName::Choose,
        ExerciseKind::Write { .. } => CheckName::Write,
    };
    let mut wrong: Vec<(CheckName, String)> = Vec::new();
    if let Err(what) = answers::check(course, chapter, exercise) {
        wrong.push((name, what));
    }
    let hints = numbers::hints(course, chapter, exercise);
    wrong.extend(hints.into_iter().map(|what| (CheckName::Hints, what)));
    wrong
}
