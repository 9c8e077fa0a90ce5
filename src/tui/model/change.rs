//! Changes of the scene and the settings: one that is being made, and what was there before the last one.

use std::time::Instant;

use crate::debug::PartialPicture;
use crate::lab::show::ShowMode;
use crate::scene::{Edit, Patch, Settings};

/// A change of the scene that is being made.
#[derive(Clone, Debug)]
pub struct PendingChange {
    /// Since when.
    pub since: Instant,
    /// All changes, from the scene as it was read.
    pub edits: Vec<Edit>,
    /// The text that was typed; none if a change is taken back.
    pub typed: Option<String>,
}

/// A picture before a change.
#[derive(Clone, Debug)]
pub struct Before {
    /// Its settings.
    pub settings: Settings,
    /// What was changed of the scene.
    pub patch: Patch,
    /// What it showed in the place of colours.
    pub show: Option<ShowMode>,
    /// What was known of it.
    pub picture: PartialPicture,
}
