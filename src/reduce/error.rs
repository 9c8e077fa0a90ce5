//! Why a scene cannot be reduced.

/// Why a scene cannot be reduced.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ReduceError {
    /// The user did not wait until anything was left out.
    #[error("interrupted before anything was left out")]
    Interrupted,
    /// Part of the tree is not known.
    #[error(
        "the log of the pixel is full, so its tree is not known as a whole; try a smaller --depth or fewer samples"
    )]
    CutTree,
    /// Not even the whole scene gives the tree again, shape by shape.
    #[error(
        "the scene cannot be taken apart: built again of all its shapes, it gives another tree"
    )]
    NotApart,
    /// Something of the scene that has to stay cannot be written in a scene file.
    #[error("the reduced scene cannot be written: {0}")]
    NotWritten(String),
    /// The scene was written, and it has another tree.
    #[error(
        "the reduced scene was written and read again, and its tree is another one; nothing is kept of it"
    )]
    NotSame,
}
