//! Options of the command line for the lesson screen.

use crate::tracer::image::ColorLevel;

/// What the command line chooses.
#[derive(Clone, Debug)]
pub struct LessonOptions {
    /// How many colours the terminal has.
    pub color: ColorLevel,
    /// Whether the mouse is caught.
    pub mouse: bool,
    /// Threads that render; 0: one a core.
    pub threads: usize,
    /// The exercise that is begun at once.
    pub run: Option<String>,
}
