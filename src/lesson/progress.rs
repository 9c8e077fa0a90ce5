//! Progress: what a student has done, in one JSON file, `raytree-progress/1`. Answers are not stored, and nothing in it is proof.
//!
//! It is written whole beside the old file and then takes its place, so that nothing is lost whenever the program ends. Each change
//! is made to what the file has then, so that two windows keep each other's.

mod file;
mod report;

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::course::Course;
use super::exercise::Exercise;

pub use file::{ProgressFile, default_folder};
pub use report::{ReportLine, report};

/// What was done of a course.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct CourseProgress {
    /// Always `raytree-progress/1`.
    pub format: String,
    /// The course.
    pub course: String,
    /// By the names of exercises. Those that this version of the course does not have are kept.
    #[serde(default)]
    pub exercises: BTreeMap<String, Done>,
    /// The chapter that was open last.
    #[serde(default)]
    pub chapter: String,
}

/// What was done of an exercise.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Done {
    /// It was answered right, or given up.
    #[serde(default)]
    pub done: bool,
    /// Answers so far.
    #[serde(default)]
    pub tries: u32,
    /// Hints that were read.
    #[serde(default)]
    pub hints: u32,
    /// The solution was read before it was done.
    #[serde(default)]
    pub given_up: bool,
    /// It was skipped, since the chapter is known.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub skipped: bool,
    /// The day it was seen first, as 2026-11-29.
    #[serde(default)]
    pub first_seen: String,
}

impl Done {
    /// Answers that count for which pixel is asked about: who repeats what is done is asked about the first one.
    pub fn asked_before(&self) -> u32 {
        if self.done { 0 } else { self.tries }
    }
}

impl CourseProgress {
    /// Nothing done of a course.
    pub fn new(course: &str) -> Self {
        Self {
            format: "raytree-progress/1".to_owned(),
            course: course.to_owned(),
            ..Self::default()
        }
    }

    /// What was done of an exercise.
    pub fn of(&self, id: &str) -> Done {
        self.exercises.get(id).cloned().unwrap_or_default()
    }

    /// True if an exercise is behind the student: done, or skipped.
    pub fn is_over(&self, id: &str) -> bool {
        self.exercises
            .get(id)
            .is_some_and(|done| done.done || done.skipped)
    }

    /// What is noted of an exercise, seen today for the first time if it is new.
    fn entry(&mut self, id: &str) -> &mut Done {
        let done = self.exercises.entry(id.to_owned()).or_default();
        if done.first_seen.is_empty() {
            done.first_seen = file::today();
        }
        done
    }

    /// Notes an answer. One that comes right without a hint at a gate shows that the chapter is known: if all of its gates are so, what
    /// is open there is skipped. Gives the sentence that says so.
    pub fn answered(&mut self, course: &Course, id: &str, right: bool) -> Option<String> {
        let done = self.entry(id);
        // What is done can be practised.
        done.tries += u32::from(!done.done);
        done.done |= right;
        let (chapter, _) = course.exercise(id).ok()?;
        let gates: Vec<&Exercise> = chapter.exercises.iter().filter(|e| e.gate).collect();
        let known = |exercise: &&Exercise| {
            let done = self.of(&exercise.id);
            done.done && done.hints == 0 && !done.given_up
        };
        if !right || gates.is_empty() || !gates.iter().all(known) {
            return None;
        }
        let mut skipped = Vec::new();
        for exercise in &chapter.exercises {
            if !self.is_over(&exercise.id) && !exercise.optional {
                self.entry(&exercise.id).skipped = true;
                skipped.push(exercise.id.as_str());
            }
        }
        (!skipped.is_empty()).then(|| {
            let names = skipped.join(", ");
            format!(
                "You know this chapter, so the rest of it is skipped and can still be done: {names}"
            )
        })
    }

    /// The next hint of an exercise, with its number from 1; none if there are no more.
    pub fn hint<'a>(&mut self, exercise: &'a Exercise) -> Option<(u32, &'a str)> {
        let done = self.entry(&exercise.id);
        let next = exercise.hints.get(done.hints as usize)?;
        done.hints += 1;
        Some((done.hints, next))
    }

    /// Gives an exercise up: its solution may be read.
    pub fn give_up(&mut self, id: &str) {
        let done = self.entry(id);
        done.given_up |= !done.done;
        done.done = true;
    }

    /// Forgets an exercise.
    pub fn reset(&mut self, id: &str) {
        self.exercises.remove(id);
    }

    /// The first exercise that is open, from the chapter that was open last on, then from the start.
    pub fn next<'a>(&self, course: &'a Course) -> Option<(&'a super::Chapter, &'a Exercise)> {
        let is_open = |(_, exercise): &(&super::Chapter, &Exercise)| {
            !exercise.optional && !self.is_over(&exercise.id)
        };
        let from = course
            .chapters
            .iter()
            .position(|c| c.folder == self.chapter);
        let from = from.unwrap_or(0);
        let mut behind = course.exercises().filter(|(c, _)| c.number > from);
        behind
            .find(is_open)
            .or_else(|| course.exercises().find(is_open))
    }

    /// Exercises that are over and all that count, of a chapter's.
    pub fn count<'a>(&self, exercises: impl IntoIterator<Item = &'a Exercise>) -> (usize, usize) {
        let counted = exercises.into_iter().filter(|e| !e.optional);
        counted.fold((0, 0), |(done, all), exercise| {
            (done + usize::from(self.is_over(&exercise.id)), all + 1)
        })
    }
}
