//! `raytree lesson`: the chapters, in a pipe as well as on the screen.

mod answer;
mod check;
mod files;
mod list;
mod read;
mod watch;

use std::io::IsTerminal as _;
use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};

use super::{ColorArg, Completion, Failure};
use crate::lesson::files::CourseError;
use crate::lesson::progress::{ProgressFile, default_folder};
use crate::lesson::{Chapter, Course, Exercise};
use crate::tui::{LessonOptions, run_lesson};

#[derive(Args)]
pub struct Lesson {
    #[command(subcommand)]
    command: Option<LessonCommand>,
    /// Another course: its folder, or a .zip archive of it
    #[arg(long, global = true, value_name = "COURSE")]
    lessons: Option<PathBuf>,
    /// Another file of progress
    #[arg(long, global = true, value_name = "FILE")]
    state: Option<PathBuf>,
    /// Colours
    #[arg(long, global = true, value_enum, default_value_t = ColorArg::Auto)]
    color: ColorArg,
    /// Leave the mouse to the terminal
    #[arg(long, global = true)]
    no_mouse: bool,
}

#[derive(Subcommand)]
enum LessonCommand {
    /// List chapters and exercises, and what is done
    List(list::ListCourse),
    /// Print a chapter with its numbers, pictures and exercises
    Read(read::Read),
    /// Do an exercise in the debugger; without a name, the next open one
    Run {
        /// The exercise
        id: Option<String>,
    },
    /// Answer an exercise without the screen
    Answer(answer::Answer),
    /// Print the next of three hints
    Hint {
        /// The exercise
        id: String,
    },
    /// Print the solution of an exercise that is done, or given up
    Solution(answer::ShowSolution),
    /// Put the files of exercises that change scenes and write programs into a folder
    Start {
        /// The folder; nothing in it is replaced
        dir: PathBuf,
    },
    /// Check an exercise again whenever its files have changed
    Watch(watch::WatchCourse),
    /// Forget what was done of an exercise, or of all
    Reset(answer::Reset),
    /// Report what was done, with tries and hints, for a teacher
    Report {
        /// As JSON
        #[arg(long)]
        json: bool,
    },
    /// Make a small course to fill in
    New {
        /// The folder, which is not there yet
        dir: PathBuf,
    },
    /// Check a course: that its numbers, pictures, exercises and answers hold
    Check(check::CheckCourse),
    /// Write the chapters as pages for mdBook
    Book {
        /// The folder for the pages
        dir: PathBuf,
    },
}

impl Lesson {
    pub fn run(&self) -> Result<Completion, Failure> {
        match &self.command {
            Some(LessonCommand::New { dir }) => return files::new(dir),
            Some(LessonCommand::Check(check)) => return check.run(self.lessons.as_deref()),
            _ => {}
        }
        let course = self.course()?;
        match &self.command {
            Some(LessonCommand::Book { dir }) => return files::book(&course, dir),
            Some(LessonCommand::Start { dir }) => return files::start(&course, dir),
            _ => {}
        }
        let mut state = self.state(&course);
        match &self.command {
            None => return self.open(course, state, None),
            Some(LessonCommand::Run { id }) => return self.open(course, state, id.clone()),
            _ => {}
        }
        let result = match &self.command {
            Some(LessonCommand::List(list)) => list.run(&course, &state),
            Some(LessonCommand::Read(read)) => read.run(&course, &state, self.color.level()),
            Some(LessonCommand::Answer(answer)) => answer.run(&course, &mut state),
            Some(LessonCommand::Hint { id }) => answer::hint(&course, &mut state, id),
            Some(LessonCommand::Solution(solution)) => solution.run(&course, &mut state),
            Some(LessonCommand::Reset(reset)) => reset.run(&course, &mut state),
            Some(LessonCommand::Watch(watch)) => watch.run(&course, &mut state),
            Some(LessonCommand::Report { json }) => list::report(&course, &state, *json),
            None
            | Some(
                LessonCommand::Run { .. }
                | LessonCommand::New { .. }
                | LessonCommand::Check(_)
                | LessonCommand::Book { .. }
                | LessonCommand::Start { .. },
            ) => Ok(Completion::Whole),
        };
        tell(&mut state);
        result
    }

    /// The course on the screen, at an exercise; not on a terminal, its list.
    fn open(
        &self,
        course: Course,
        mut state: ProgressFile,
        run: Option<String>,
    ) -> Result<Completion, Failure> {
        if let Some(id) = &run {
            exercise(&course, id)?;
        }
        if !std::io::stdout().is_terminal() {
            let done = match &run {
                Some(id) => read::exercise(&course, &state, id),
                None => list::ListCourse::default().run(&course, &state),
            };
            tell(&mut state);
            return done;
        }
        let options = LessonOptions {
            color: self.color.level(),
            mouse: !self.no_mouse,
            threads: 0,
            run,
        };
        run_lesson(course, state, options).map_err(Failure::Terminal)?;
        Ok(Completion::Whole)
    }

    fn course(&self) -> Result<Course, Failure> {
        course(self.lessons.as_deref())
    }

    fn state(&self, course: &Course) -> ProgressFile {
        let folder = default_folder(|name| std::env::var_os(name).map(PathBuf::from));
        let usual = folder.map(|folder| folder.join(format!("{}.json", course.id)));
        ProgressFile::open(self.state.clone().or(usual), &course.id)
    }
}

/// Tells what became of the file of progress.
fn tell(state: &mut ProgressFile) {
    for notice in state.take_notices() {
        eprintln!("warning: {notice}");
    }
}

/// The course at a path; without one, that of the program.
fn course(path: Option<&Path>) -> Result<Course, Failure> {
    let course = match path {
        None => Course::embedded(),
        Some(path) => Course::read(path),
    };
    course.map_err(|e| wrong(&e))
}

/// A course that is wrong.
fn wrong(error: &CourseError) -> Failure {
    Failure::Input(error.to_string())
}

/// The exercise of this name.
fn exercise<'a>(course: &'a Course, id: &str) -> Result<(&'a Chapter, &'a Exercise), Failure> {
    course.exercise(id).map_err(Failure::Usage)
}
