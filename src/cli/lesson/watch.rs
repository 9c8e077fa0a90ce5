//! `raytree lesson watch`: an exercise checked again whenever its files have changed.

mod keyboard;

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use clap::Args;

use self::keyboard::{Keyboard, WatchKey};
use crate::cli::output::to_stdout;
use crate::cli::{Completion, Failure};
use crate::grade::run::RunOptions;
use crate::lesson::Course;
use crate::lesson::progress::ProgressFile;
use crate::lesson::reader::markdown;
use crate::lesson::watch::FolderWatch;
use crate::lesson::worked::{WorkedExercise, next_worked};
use crate::scene::printable::printable;

/// Columns of hints.
const WIDTH: usize = 80;

#[derive(Args)]
pub struct WatchCourse {
    /// The exercise; without, the next open one that changes a scene or, with --run, is a program
    id: Option<String>,
    /// The folder that `raytree lesson start` has filled
    #[arg(long, value_name = "DIR", default_value = ".")]
    folder: PathBuf,
    /// How your program is run, in a copy of the folder; the blanks {flat} {flat-text} {scene} {pixels} {x} {y} {width}
    /// {height} {out} are filled in
    #[arg(long, value_name = "COMMAND")]
    run: Option<String>,
}

/// What goes on after a key.
enum Next {
    /// Wait.
    Wait,
    /// Check again.
    Check,
    /// Another exercise.
    Exercise(String),
    /// The end.
    Quit,
}

impl WatchCourse {
    pub fn run(&self, course: &Course, state: &mut ProgressFile) -> Result<Completion, Failure> {
        let stop = Arc::new(AtomicBool::new(false));
        let keyboard = Keyboard::new(&stop).map_err(Failure::Terminal)?;
        let next = || next_worked(course, state.progress(), None, self.run.is_some());
        let mut id = match self.id.as_deref().or_else(next) {
            Some(id) => id.to_owned(),
            None => return to_stdout(b"no exercise that is done in files is open\n"),
        };
        while let Some(next) = self.watch(course, state, (&id, &stop), &keyboard)? {
            id = next;
        }
        keyboard.end();
        Ok(Completion::Whole)
    }

    /// Watches an exercise; the next one, if one is asked for.
    fn watch(
        &self,
        course: &Course,
        state: &mut ProgressFile,
        (id, stop): (&str, &Arc<AtomicBool>),
        keyboard: &Keyboard,
    ) -> Result<Option<String>, Failure> {
        let run = self.run.clone().map(|command| RunOptions {
            command,
            stop: Arc::clone(stop),
            ..RunOptions::default()
        });
        let worked = WorkedExercise::new(course, id, &self.folder, run).map_err(Failure::Usage)?;
        let mut watch = FolderWatch::new(worked.watched());
        check(course, state, &worked, keyboard)?;
        loop {
            let next = match keyboard.wait(watch.pause()).map_err(Failure::Terminal)? {
                None => Next::Wait,
                Some(key) => self.obey(course, state, &worked, key)?,
            };
            // Looked at in any case: what a check follows is not told again.
            let has_changed = watch.poll(Instant::now());
            match next {
                Next::Quit => return Ok(None),
                Next::Exercise(id) => return Ok(Some(id)),
                Next::Wait if !has_changed => {}
                _ => check(course, state, &worked, keyboard)?,
            }
        }
    }

    fn obey(
        &self,
        course: &Course,
        state: &mut ProgressFile,
        worked: &WorkedExercise,
        key: WatchKey,
    ) -> Result<Next, Failure> {
        let exercise = worked.exercise;
        match key {
            WatchKey::Quit => return Ok(Next::Quit),
            WatchKey::Again => return Ok(Next::Check),
            WatchKey::Next => {
                let (progress, runs) = (state.progress(), self.run.is_some());
                match next_worked(course, progress, Some(&exercise.id), runs) {
                    Some(id) if id != exercise.id => return Ok(Next::Exercise(id.to_owned())),
                    _ => to_stdout(b"no other exercise that is done in files is open\n")?,
                };
            }
            WatchKey::Hint => {
                let hint = state.change(|progress| {
                    let hint = progress.hint(exercise);
                    hint.map(|(number, hint)| (number, hint.to_owned()))
                });
                let count = exercise.hints.len();
                let told = match hint {
                    Some((number, hint)) => {
                        format!("hint {number} of {count}: {}", markdown(&hint, WIDTH))
                    }
                    None if count == 0 => "this exercise has no hints".to_owned(),
                    None => "these are all hints".to_owned(),
                };
                to_stdout((told.trim_end().to_owned() + "\n").as_bytes())?;
            }
        }
        Ok(Next::Wait)
    }
}

/// Checks an exercise and prints what comes of it.
fn check(
    course: &Course,
    state: &mut ProgressFile,
    worked: &WorkedExercise,
    keyboard: &Keyboard,
) -> Result<(), Failure> {
    let (chapter, exercise) = (worked.chapter, worked.exercise);
    let checked = worked.check();
    let mut out = format!(
        "{} ({}), chapter {}, {}\n",
        exercise.id,
        exercise.kind.name(),
        chapter.number,
        chapter.title
    );
    let (right, lines) = match checked {
        Ok(verdict) => (verdict.right, verdict.lines),
        Err(why) => (false, vec![why]),
    };
    for line in lines {
        out += &printable(&line);
        out.push('\n');
    }
    if right {
        // What is saved on the way is no try.
        if !state.progress().of(&exercise.id).done {
            let skipped = state.change(|progress| progress.answered(course, &exercise.id, true));
            out.extend(skipped.map(|told| told + "\n"));
        }
        out += "done\n";
    }
    if keyboard.is_there() {
        let hints = state.progress().of(&exercise.id).hints;
        let count = exercise.hints.len();
        out = format!(
            "{}{out}h hint ({hints} of {count})  n next  r again  q quit\n",
            keyboard::CLEAR
        );
    }
    for notice in state.take_notices() {
        eprintln!("warning: {notice}");
    }
    to_stdout(out.as_bytes()).map(|_| ())
}
