//! What of a scene is kept.

use super::Scene;

/// What of a scene is kept: shapes and lights by number, ascending.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Kept {
    /// Primitives.
    pub shapes: Vec<u32>,
    /// Lights.
    pub lights: Vec<u32>,
    /// Whether the background has its colour; else it is black.
    pub background: bool,
    /// Whether there is ambient light.
    pub ambient: bool,
}

impl Kept {
    /// All of a scene.
    pub fn all(scene: &Scene) -> Self {
        Self {
            shapes: (0..scene.shapes.len() as u32).collect(),
            lights: (0..scene.lights.len() as u32).collect(),
            background: true,
            ambient: true,
        }
    }

    /// What is kept, with these shapes alone, in any order.
    #[must_use]
    pub fn with_shapes(&self, shapes: impl IntoIterator<Item = u32>) -> Self {
        let mut shapes: Vec<u32> = shapes.into_iter().collect();
        shapes.sort_unstable();
        shapes.dedup();
        Self {
            shapes,
            ..self.clone()
        }
    }

    /// The number of objects that any shape is kept of.
    pub fn objects(&self, scene: &Scene) -> usize {
        let owner = |shape: &u32| scene.owners[*shape as usize];
        self.shapes.chunk_by(|a, b| owner(a) == owner(b)).count()
    }
}
