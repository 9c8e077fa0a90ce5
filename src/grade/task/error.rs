//! What is wrong with a task.

use crate::scene::SceneError;
use crate::scene::read::error::shown;

/// What is wrong with a task.
#[derive(Debug, thiserror::Error)]
pub enum TaskError {
    /// The task file. What it says steers no terminal.
    #[error("{}: {}", shown(file), shown(what))]
    Task {
        /// Its path.
        file: String,
        /// What is wrong, and what to do.
        what: String,
    },
    /// A scene that it names.
    #[error("{0}")]
    Scene(#[from] SceneError),
}
