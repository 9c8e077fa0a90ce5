//! Options of the command line for the debugger.

use std::path::PathBuf;
use std::sync::Arc;

use super::ask::AskState;
use crate::debug::marks::Marks;
use crate::lab::show::ShowMode;
use crate::scene::{Patch, SceneSource};
use crate::trace::Address;
use crate::tracer::image::ColorLevel;

/// What the command line chooses.
#[derive(Clone, Debug)]
pub struct Options {
    /// The scene as the user named it, for the command line that traces a pixel again.
    pub scene: String,
    /// Where it comes from.
    pub source: Arc<SceneSource>,
    /// What was changed of it.
    pub patch: Patch,
    /// How many colours the terminal has.
    pub color: ColorLevel,
    /// Whether the mouse picks pixels and scrolls; if not, the terminal selects text with it.
    pub mouse: bool,
    /// Threads that render the picture; 0: one a core.
    pub threads: usize,
    /// Width and height of the image; `None`: as many pixels as the screen shows.
    pub size: Option<(u32, u32)>,
    /// The ray at which a tree is opened at the start; none once it is.
    pub at: Option<Address>,
    /// What the first tree that is opened is compared with, as key `d` takes it; none once it is.
    pub compare: Option<String>,
    /// Marks of a file.
    pub marks: Option<Marks>,
    /// What the picture shows in the place of colours.
    pub show: Option<ShowMode>,
    /// A question of a lesson.
    pub ask: Option<Box<AskState>>,
    /// Where files that are named in the debugger lie.
    pub folder: PathBuf,
}
