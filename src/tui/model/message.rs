//! Messages that change the model, and jobs that it asks of the worker.

use std::time::Instant;

use crossterm::event::KeyEvent;
use ratatui::layout::{Position, Rect};

#[cfg(test)]
use super::action::Action;
use crate::debug::Session;
use crate::debug::edit::EditedWorld;
use crate::debug::progressive::Pixels;
use crate::tracer::Pixel;

/// An input of the update.
pub enum Message {
    /// An action, whatever key it has.
    #[cfg(test)]
    Action(Action),
    /// A key was pressed.
    Key(KeyEvent),
    /// A text was pasted.
    Paste(String),
    /// The mouse did something at a cell of the screen.
    Mouse(Mouse, Position),
    /// The screen has another size.
    Resize(Rect),
    /// The worker has done something.
    Output(JobOutput),
    /// Time has passed.
    Tick(Instant),
}

/// A mouse event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mouse {
    /// Pressed.
    Press,
    /// Moved while pressed.
    Drag,
    /// The wheel was turned, down by so many rows.
    Wheel(i32),
}

/// Work for the background, for the model as it is after the update. A new job replaces the one before of its kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Job {
    /// Render the missing pixels of the picture.
    Render,
    /// Record the pixel under the cursor.
    Trace,
    /// Trace no pixel any more.
    CancelTrace,
    /// Trace the pixel under the cursor with more and more samples.
    Converge,
    /// No more samples.
    CancelConverge,
    /// Search the picture for the query.
    Search,
    /// No more search.
    CancelSearch,
    /// Read the scene with the changes that are asked for, and build it.
    Change,
    /// Change nothing.
    CancelChange,
}

/// A result of a job.
pub enum JobOutput {
    /// Pixels of the picture.
    Pixels(Pixels),
    /// The last pixel is done.
    Rendered,
    /// A pixel was recorded.
    Traced(Box<Session>),
    /// A pixel with more samples than before.
    Converged(Pixel),
    /// No more samples will come, and why.
    ConvergenceEnd(&'static str),
    /// Pixels that satisfy the query, among the next so many.
    Found(Vec<(u32, u32)>, u64),
    /// The whole picture was searched.
    Searched,
    /// The scene was changed, or cannot be.
    Changed(Result<Box<EditedWorld>, String>),
}
