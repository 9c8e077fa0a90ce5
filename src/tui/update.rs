//! Update of the model by a message. What takes long is asked of the worker: see [`crate::tui::model::Job`].

mod action;
mod convergence;
mod dispatch;
mod effects;
mod image;
mod keys;
mod mouse;
mod output;
mod rows;

pub use dispatch::{start, update};
