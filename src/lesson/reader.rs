//! A chapter and its exercises as plain text: for pipes, for screen readers, for who is not on the screen.

use std::fmt::Write as _;

use super::answer::letter;
use super::chapter::Chapter;
use super::course::Course;
use super::exercise::{Choices, Exercise, ExerciseKind, Goal, Must};
use super::files::CourseError;
use super::markdown::blocks;
use super::off::off;
use super::page::{PagePart, PagePicture, page};
use super::plain::lines;
use super::progress::CourseProgress;
use super::question::Question;
use super::value::LessonValue;
use super::workspace::work_path;
use crate::scene::printable::printable;
use crate::trace::format::num;

/// A chapter as text of so many columns; `picture` draws the pictures.
pub fn read(
    course: &Course,
    chapter: &Chapter,
    progress: &CourseProgress,
    width: usize,
    picture: &dyn Fn(&PagePicture) -> Result<String, CourseError>,
) -> Result<String, CourseError> {
    let mut out = String::new();
    for part in page(course, chapter)? {
        match part {
            PagePart::Text(text) => out += &markdown(&text, width),
            PagePart::Block(title, text) => {
                let _ = writeln!(out, "{title}\n");
                for line in text.lines() {
                    let _ = writeln!(out, "    {}", printable(line));
                }
                out.push('\n');
            }
            PagePart::Picture(asked) => {
                let _ = writeln!(out, "[picture of {}]", asked.caption());
                out += &picture(&asked)?;
                out.push('\n');
            }
            PagePart::Exercise(id) => {
                if let Some(exercise) = chapter.exercise(&id) {
                    out += &offered(course, chapter, exercise, progress, width);
                }
            }
        }
    }
    out += &features(course, chapter);
    Ok(out)
}

/// Text in Markdown as plain lines; what is not in the subset stays as it is.
pub fn markdown(text: &str, width: usize) -> String {
    let Ok(blocks) = blocks(text) else {
        return text.to_owned();
    };
    let mut out = String::new();
    let mut in_list = false;
    for block in &blocks {
        let is_item = matches!(block, super::markdown::TextBlock::Item(..));
        if in_list && !is_item {
            out.push('\n');
        }
        in_list = is_item;
        for line in lines(block, width) {
            out += &printable(&line);
            out.push('\n');
        }
    }
    if in_list {
        out.push('\n');
    }
    out
}

/// An exercise where it is offered: its state, what is asked, and how it is answered.
fn offered(
    course: &Course,
    chapter: &Chapter,
    exercise: &Exercise,
    progress: &CourseProgress,
    width: usize,
) -> String {
    let state = if progress.is_over(&exercise.id) {
        "done"
    } else {
        "open"
    };
    let mut out = format!(
        "--- exercise {} ({}, {state})\n\n",
        exercise.id,
        exercise.kind.name()
    );
    out += &asked(
        course,
        chapter,
        exercise,
        progress.of(&exercise.id).asked_before(),
        width,
    );
    let (id, usage) = (&exercise.id, usage(&exercise.kind));
    let _ = writeln!(out, "Answer: raytree lesson answer {id} {usage}");
    if !exercise.hints.is_empty() {
        let _ = writeln!(out, "Hint:   raytree lesson hint {id}");
    }
    out += "---\n\n";
    out
}

/// What an exercise asks, in full.
pub fn asked(
    course: &Course,
    chapter: &Chapter,
    exercise: &Exercise,
    tries: u32,
    width: usize,
) -> String {
    let mut out = markdown(&exercise.text, width);
    match &exercise.kind {
        ExerciseKind::Predict { asked, .. } => {
            out += &of_question(course, chapter, exercise, asked, tries);
        }
        ExerciseKind::Find(wanted) => {
            if !wanted.text.is_empty() {
                let _ = writeln!(out, "Find a pixel for which holds: {}", wanted.text);
            }
            for (name, value) in &wanted.differs {
                let _ = writeln!(
                    out,
                    "Find a pixel whose colour changes with {name} {value}."
                );
            }
            if let Some((mode, [least, most])) = wanted.shown {
                let (unit, least, most) = (mode.unit(), num(least), num(most));
                let _ = writeln!(out, "Find a pixel with {unit} from {least} to {most}.");
            }
        }
        ExerciseKind::Change(task) => {
            out += "Change the scene until all goals hold:\n";
            for goal in &task.goals {
                let _ = writeln!(out, "  - {}", goal.words());
            }
            if !task.keep.is_empty() {
                let _ = writeln!(out, "\nWhat stays as it is: {}.", task.keep.join(", "));
            }
        }
        ExerciseKind::Bug { among, at, .. } => {
            let _ = writeln!(
                out,
                "The tracer is broken. Look at pixel {},{}. One of these it is:",
                at.0, at.1
            );
            for bend in among {
                let _ = writeln!(out, "  {:22} {}", bend.name(), bend.entry().note);
            }
        }
        ExerciseKind::Choose {
            says,
            bend,
            options,
        } => {
            out += &choices(says, bend.is_some(), options, width);
        }
        ExerciseKind::Write { .. } => {
            let folder = work_path(chapter, &exercise.id, &exercise.kind).unwrap_or_default();
            let _ = writeln!(
                out,
                "Write a program. `raytree lesson start DIR` makes a folder for it, DIR/{folder}. The task.toml there says which \
                 pixels and values are asked; the scene stands beside it. Put what your program prints into the folder, as a file \
                 that ends in .json; DIR/hello/README.md shows its form."
            );
        }
    }
    out.push('\n');
    out
}

/// What a slide says, and the answers to choose among.
fn choices(says: &str, is_slide: bool, options: &[Choices], width: usize) -> String {
    let mut out = String::new();
    if !says.is_empty() {
        out += "A slide says:\n\n";
        out += &markdown(&format!("> {says}"), width);
    }
    if is_slide {
        out += "First find a pixel where the slide is wrong. Then choose what is right:\n";
    }
    for (index, option) in options.iter().enumerate() {
        let text = markdown(&option.text, width.saturating_sub(5));
        let text = text.trim_end().replace('\n', "\n     ");
        let _ = writeln!(out, "  {}) {text}", letter(index));
    }
    out
}

/// The question of an exercise that asks for a value, as it stands after so many tries; empty for other kinds.
pub fn question(course: &Course, chapter: &Chapter, exercise: &Exercise, tries: u32) -> String {
    match &exercise.kind {
        ExerciseKind::Predict { asked, .. } => of_question(course, chapter, exercise, asked, tries),
        _ => String::new(),
    }
}

/// A question with what is known before its answer.
fn of_question(
    course: &Course,
    chapter: &Chapter,
    exercise: &Exercise,
    asked: &LessonValue,
    tries: u32,
) -> String {
    let question = course
        .stage_of(chapter, exercise)
        .map_err(|e| e.to_string())
        .and_then(|stage| Question::new(&stage, asked, tries));
    match question {
        Err(why) => format!("({why})\n"),
        Ok(question) => {
            let place = question.ray.as_ref().map_or(String::new(), |ray| {
                format!("About pixel {},{}{}: ", ray.pixel.0, ray.pixel.1, ray.path)
            });
            let again = match tries {
                0 => "",
                _ => "This is another pixel than in the text: take the numbers from its tree.\n",
            };
            format!("{place}{}\n{again}", question.form.asks())
        }
    }
}

impl Goal {
    /// The goal in words.
    pub fn words(&self) -> String {
        let what = self.asked.name();
        match &self.must {
            Must::Word(word) => format!("{what} is {word}"),
            Must::Near(x, off) => format!("{what} is {}, or at most {} off", num(*x), num(*off)),
            Must::Between([least, most]) => {
                format!("{what} is from {} to {}", num(*least), num(*most))
            }
            Must::Same => format!("{what} is as before"),
        }
    }
}

/// How an answer is typed.
fn usage(kind: &ExerciseKind) -> &'static str {
    match kind {
        ExerciseKind::Predict { .. } => "VALUE",
        ExerciseKind::Find(_) => "X,Y",
        ExerciseKind::Change(_) => "SCENE.json",
        ExerciseKind::Bug { .. } => "MISTAKE RAY",
        ExerciseKind::Choose { bend: Some(_), .. } => "X,Y LETTER",
        ExerciseKind::Choose { .. } => "LETTER",
        ExerciseKind::Write { .. } => "FOLDER",
    }
}

/// What is on in a chapter, and what its scene calls for and is off.
pub fn features(course: &Course, chapter: &Chapter) -> String {
    let on: Vec<&str> = chapter.features.iter().map(super::Feature::name).collect();
    let mut out = format!("on: {}\n", on.join(", "));
    let scene = course
        .source(&chapter.scene)
        .ok()
        .and_then(|source| source.scene().ok());
    for off in scene.iter().flat_map(|scene| off(course, chapter, scene)) {
        let until = off
            .until
            .map_or(String::new(), |n| format!(" until chapter {n}"));
        let _ = writeln!(
            out,
            "off{until}: {} ({})",
            off.feature.name(),
            printable(&off.reason)
        );
    }
    out
}
