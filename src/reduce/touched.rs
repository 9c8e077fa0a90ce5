//! Shapes that a pixel's rays met.

use std::collections::BTreeSet;

use crate::probe::Event;
use crate::trace::RayTree;

/// Shapes that a pixel's rays met, by number.
#[derive(Clone, Debug, Default)]
pub struct Touched {
    /// Those that a ray ended on, was blocked by, or went straight through.
    pub met: BTreeSet<u32>,
    /// Those that the accelerator tested, if the log tells.
    pub tested: BTreeSet<u32>,
}

impl Touched {
    /// The shapes in the log of a pixel.
    pub fn of(tree: &RayTree) -> Self {
        let mut touched = Self::default();
        for event in &tree.events {
            match *event {
                Event::Hit(hit) | Event::Blocked(hit) | Event::Passed { hit, .. } => {
                    touched.met.insert(hit.primitive);
                }
                Event::Test { primitive, .. } => {
                    touched.tested.insert(primitive);
                }
                _ => {}
            }
        }
        touched
    }
}
