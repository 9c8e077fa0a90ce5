//! Update of the model by a message. What takes long is asked of the worker: see [`crate::tui::model::Job`].

mod action;
mod compare;
mod convergence;
mod dispatch;
mod edit;
mod effects;
mod history;
mod image;
mod keys;
mod marks;
mod mouse;
mod output;
mod play;
mod prompt;
mod rows;
mod search;
mod set;

pub use dispatch::{start, update};
