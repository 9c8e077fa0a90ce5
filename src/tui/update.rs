//! Update of the model by a message. What takes long is asked of the worker: see [`crate::tui::model::Job`].

mod action;
pub mod ask;
mod caret;
mod compare;
mod compare_scene;
mod compare_steps;
mod convergence;
mod dispatch;
mod edit;
mod effects;
mod flip;
mod history;
mod image;
mod keys;
mod marks;
mod mouse;
mod output;
mod places;
mod play;
mod prompt;
mod ranking;
mod rows;
mod run;
mod search;
mod set;
mod undo;

pub use dispatch::{start, update};
