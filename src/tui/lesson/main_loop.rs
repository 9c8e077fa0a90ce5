//! Main loop of the lesson screen: events in, frames out.

use std::io::{self, IsTerminal};

use super::options::LessonOptions;
use super::program::LessonProgram;
use crate::lesson::Course;
use crate::lesson::progress::ProgressFile;
use crate::tui::terminal::main_loop::on_a_terminal;

/// Shows a course until the reader leaves.
///
/// An error if stdout is no terminal, or if it fails. The terminal is given back in any case.
pub fn run_lesson(
    course: Course,
    progress: ProgressFile,
    options: LessonOptions,
) -> io::Result<()> {
    if !io::stdout().is_terminal() {
        return Err(io::Error::new(
            io::ErrorKind::Unsupported,
            "the lessons need a terminal, and stdout is none; `raytree lesson list` and `raytree lesson read CHAPTER` write them as text",
        ));
    }
    on_a_terminal(|screen| LessonProgram::new(course, progress, options, screen))
}
