//! Texts to begin with, where one is typed.

use super::overlay::Prompt;
use crate::debug::{breaks, edit, search, watch};
use crate::scene::Scene;

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
const COMPARISONS: [&str; 9] = [
    "bend=eta-inverted",
    "bend=reflect-plus",
    "bend=shadow-none",
    "without=refraction",
    "fresnel=none",
    "depth=1",
    "accel=kd",
    "accel=list",
    "order=far-first",
];

/// Those of a prompt: for changes first the values of the scene as they are.
pub fn examples(prompt: Prompt, scene: &Scene) -> Vec<String> {
    let texts: &[&str] = match prompt {
        Prompt::Search => &search::READY,
        Prompt::Compare => &COMPARISONS,
        Prompt::Set => &SETTINGS,
        Prompt::Break => &breaks::READY,
        Prompt::Watch => &watch::FIELDS,
        Prompt::GoTo | Prompt::Note | Prompt::Write | Prompt::WritePatch => &[],
    };
    let of_scene = match prompt {
        Prompt::Set => edit::examples(scene),
        _ => Vec::new(),
    };
    let texts = texts.iter().map(ToString::to_string);
    of_scene.into_iter().chain(texts).collect()
}

/// True if a prompt has any.
pub fn has_any(prompt: Prompt) -> bool {
    use Prompt::{Break, Compare, Search, Set, Watch};
    matches!(prompt, Search | Compare | Set | Break | Watch)
}
