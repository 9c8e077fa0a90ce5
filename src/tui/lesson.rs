//! Lesson screen: chapters and exercises, the text with today's numbers, the picture; exercises are done in the debugger.
//!
//! `model` is the state, `update` and `answering` change it, `panes` draw it. The debugger knows no course: it shows a question
//! ([`crate::tui::model::ask`]), and this screen takes the answer to the course.

mod answering;
mod attempt;
mod help;
mod keys;
mod layout;
mod main_loop;
mod model;
mod options;
mod outside;
mod page_lines;
mod pages;
mod panes;
mod picture;
mod program;
mod update;
mod words;

#[cfg(test)]
pub use keys::LESSON_KEYS;
pub use main_loop::run_lesson;
#[cfg(test)]
pub use model::LessonOverlay;
pub use options::LessonOptions;
#[cfg(test)]
pub use program::LessonProgram;
