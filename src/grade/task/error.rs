//! What is wrong with a task.

use crate::scene::SceneError;

/// What is wrong with a task.
#[derive(Debug, thiserror::Error)]
pub enum TaskError {
    /// The task file.
    #[error("{file}: {what}")]
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
