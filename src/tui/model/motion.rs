//! How the cursor moves other than by a key a step: by itself, back over its jumps.

use std::time::{Duration, Instant};

use crate::debug::breaks::BreakPoint;
use crate::debug::log_run::LogRun;
use crate::debug::ray_search::RaySearch;
use crate::trace::Address;

/// How long a key waits for a run or a search; it goes on afterwards.
pub const AT_ONCE: Duration = Duration::from_millis(5);

/// Steps that run by themselves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Play {
    /// Whether forwards through the log, or backwards.
    pub forward: bool,
    /// Steps in a second.
    pub speed: u32,
    /// When the next one is due.
    pub due: Instant,
}

/// What a step is that runs by itself.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PlayUnit {
    /// An event.
    #[default]
    Events,
    /// A ray, in the order in which they are sent.
    Rays,
    /// A ray, in the order of the tree's levels.
    Levels,
}

/// What takes long: it goes on between frames until it ends or a key stops it.
#[derive(Clone, Debug)]
pub enum LongRun {
    /// A run through the log to the first of these break points.
    ToBreak(LogRun, Vec<BreakPoint>),
    /// A search for the next ray that satisfies a query.
    ToRay(RaySearch),
}

/// Places that were left by a jump, and those that were left by going back; the nearest at the end.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct History {
    /// To go back to.
    pub past: Vec<Address>,
    /// To go forward to.
    pub future: Vec<Address>,
}
