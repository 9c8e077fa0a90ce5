//! Report of what was done, for a teacher.

use serde::Serialize;

use super::CourseProgress;
use crate::lesson::course::Course;

/// A line of the report: an exercise.
#[allow(clippy::struct_excessive_bools)] // Each is a column.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ReportLine {
    /// The folder of its chapter.
    pub chapter: String,
    /// Its name.
    pub exercise: String,
    /// Its kind.
    pub kind: &'static str,
    /// Whether it counts.
    pub optional: bool,
    /// Answered right, or given up.
    pub done: bool,
    /// Answers.
    pub tries: u32,
    /// Hints that were read.
    pub hints: u32,
    /// The solution was read first.
    pub given_up: bool,
    /// Skipped, since the chapter is known.
    pub skipped: bool,
    /// The day it was seen first; empty if it was not.
    pub first_seen: String,
}

/// What was done of a course, exercise by exercise.
pub fn report(course: &Course, progress: &CourseProgress) -> Vec<ReportLine> {
    let lines = course.exercises().map(|(chapter, exercise)| {
        let done = progress.of(&exercise.id);
        ReportLine {
            chapter: chapter.folder.clone(),
            exercise: exercise.id.clone(),
            kind: exercise.kind.name(),
            optional: exercise.optional,
            done: done.done,
            tries: done.tries,
            hints: done.hints,
            given_up: done.given_up,
            skipped: done.skipped,
            first_seen: done.first_seen,
        }
    });
    lines.collect()
}
