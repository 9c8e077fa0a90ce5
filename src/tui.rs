//! Terminal debugger: the picture, a pixel, and its ray tree to walk through.
//!
//! `model` is the state; `update` changes it by messages; `panes` draw it and cannot change it; `terminal` runs the three
//! on a real terminal with a worker in the background. What can be known without a screen is in [`crate::debug`].

mod lesson;
mod model;
mod panes;
mod terminal;
#[cfg(test)]
mod tests;
mod update;

pub use lesson::{LessonOptions, run_lesson};
pub use model::options::Options;
pub use terminal::main_loop::run;
