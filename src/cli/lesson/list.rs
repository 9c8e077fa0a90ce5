//! `raytree lesson list` and `report`: what there is, and what is done.

use std::fmt::Write as _;

use clap::Args;
use serde_json::json;

use crate::cli::output::{to_stdout, to_stdout_by};
use crate::cli::{Completion, Failure};
use crate::lesson::Course;
use crate::lesson::progress::{ProgressFile, report as lines};
use crate::trace::export::json;

#[derive(Args, Default)]
pub struct ListCourse {
    /// As JSON
    #[arg(long)]
    json: bool,
    /// The exercises of each chapter, too
    #[arg(long)]
    exercises: bool,
}

impl ListCourse {
    pub fn run(&self, course: &Course, state: &ProgressFile) -> Result<Completion, Failure> {
        let progress = state.progress();
        if self.json {
            return report(course, state, true);
        }
        let (done, all) = progress.count(course.exercises().map(|(_, e)| e));
        let mut out = format!("{}: {done} of {all} exercises done\n\n", course.title);
        for chapter in &course.chapters {
            let (done, all) = progress.count(&chapter.exercises);
            let _ = writeln!(
                out,
                "{:3}  {:44} {done}/{all}",
                chapter.number, chapter.title
            );
            for exercise in chapter.exercises.iter().filter(|_| self.exercises) {
                let sign = if progress.is_over(&exercise.id) {
                    "x"
                } else {
                    " "
                };
                let kind = exercise.kind.name();
                let optional = if exercise.optional { ", optional" } else { "" };
                let _ = writeln!(out, "     [{sign}] {:24} {kind}{optional}", exercise.id);
            }
        }
        let next = progress.next(course).map_or(
            "\nAll is done.\n".to_owned(),
            |(chapter, exercise)| {
                format!(
                    "\nNext: exercise {} of chapter {}.\nRead the chapter: raytree lesson read {}\n",
                    exercise.id, chapter.number, chapter.number
                )
            },
        );
        to_stdout((out + &next).as_bytes())
    }
}

/// What was done, exercise by exercise.
pub fn report(course: &Course, state: &ProgressFile, as_json: bool) -> Result<Completion, Failure> {
    let progress = state.progress();
    let lines = lines(course, progress);
    let (done, all) = progress.count(course.exercises().map(|(_, e)| e));
    if as_json {
        let chapters: Vec<_> = course
            .chapters
            .iter()
            .map(|chapter| {
                let (done, all) = progress.count(&chapter.exercises);
                json!({ "chapter": chapter.folder, "title": chapter.title, "done": done, "exercises": all })
            })
            .collect();
        let whole = json!({
            "format": "raytree-report/1", "course": course.id, "title": course.title,
            "done": done, "exercises": all, "chapters": chapters, "lines": lines,
        });
        to_stdout_by(|out| json::write(out, &whole))?;
        return Ok(Completion::Whole);
    }
    let mut out = format!("{}: {done} of {all} exercises done\n", course.title);
    out += "exercise                  kind          state     tries  hints  first seen\n";
    for line in lines
        .iter()
        .filter(|line| !line.first_seen.is_empty() || line.skipped)
    {
        let state = match (line.done, line.given_up, line.skipped) {
            (_, true, _) => "given up",
            (true, ..) => "done",
            (_, _, true) => "skipped",
            _ => "open",
        };
        let _ = writeln!(
            out,
            "{:25} {:13} {state:9} {:5}  {:5}  {}",
            line.exercise, line.kind, line.tries, line.hints, line.first_seen
        );
    }
    to_stdout(out.as_bytes())
}
