//! A scene of a task, and our trees of it.

use std::sync::Arc;

use crate::grade::pixel_tree;
use crate::scene::Settings;
use crate::trace::facts::PixelFacts;
use crate::world::World;

/// Pixels of a check at most.
pub const MAX_PIXELS: usize = 10_000;

/// A scene of a task.
#[derive(Clone)]
pub struct TaskScene {
    /// As the task names it.
    pub label: String,
    /// As `raytree view` takes it.
    pub path: String,
    /// The scene and its accelerator.
    pub world: Arc<World>,
    /// The settings.
    pub settings: Settings,
}

/// Our tree of a pixel.
pub fn reference(scene: &TaskScene, settings: &Settings, at: (u32, u32)) -> PixelFacts {
    pixel_tree::traced_here(&scene.world, settings, at)
}
