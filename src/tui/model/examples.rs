//! Texts to begin with, where one is typed.

use super::state::Prompt;
use crate::debug::{breaks, search};

/// Settings to begin with.
const SETTINGS: [&str; 7] = [
    "samples=16",
    "light-samples=1",
    "sampling=random",
    "depth=2",
    "fresnel=schlick",
    "exposure=2",
    "accel=kd",
];

/// Comparisons to begin with.
const COMPARISONS: [&str; 6] = [
    "bend=eta-inverted",
    "bend=reflect-plus",
    "bend=shadow-none",
    "without=refraction",
    "fresnel=none",
    "depth=1",
];

/// Those of a prompt.
pub fn examples(prompt: Prompt) -> &'static [&'static str] {
    match prompt {
        Prompt::Search => &search::READY,
        Prompt::Compare => &COMPARISONS,
        Prompt::Set => &SETTINGS,
        Prompt::Break => &breaks::READY,
        Prompt::GoTo | Prompt::Note | Prompt::Write => &[],
    }
}
