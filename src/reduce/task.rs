//! Task of a reduction: which scene, which pixel, and how it is traced.

use std::ops::ControlFlow;

use crate::scene::{Scene, Settings};
use crate::world::World;

/// Task of a reduction.
#[derive(Clone, Copy)]
pub struct ReduceTask<'a> {
    /// The scene as it was read, before its shapes are prepared for an arithmetic.
    pub scene: &'a Scene,
    /// The world of this scene in which the pixel is traced.
    pub world: &'a World,
    /// The settings with which it is traced.
    pub settings: &'a Settings,
    /// The settings with which a part of the scene is traced: what the part asks for, and what the user asks for beside it.
    pub settings_of: &'a (dyn Fn(&Scene) -> Settings + Sync),
    /// Column and row of the pixel.
    pub pixel: (u32, u32),
    /// Whether every shape stays that the accelerator tested.
    pub keep_tests: bool,
    /// Threads; 0 for one a core.
    pub threads: usize,
    /// Told after each trial; may stop the search.
    pub watch: &'a (dyn Fn(ReduceProgress) -> ControlFlow<()> + Sync),
}

/// How far a reduction has come.
#[derive(Clone, Copy, Debug)]
pub struct ReduceProgress {
    /// Scenes that were traced.
    pub trials: u64,
    /// Shapes of the last of them.
    pub shapes: usize,
}
