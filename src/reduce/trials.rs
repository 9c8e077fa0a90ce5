//! Trials: whether a pixel has the same tree in a part of its scene.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::ControlFlow;

use super::error::ReduceError;
use super::essence::essence;
use super::task::{ReduceProgress, ReduceTask};
use super::touched::Touched;
use crate::scene::kept::Kept;
use crate::scene::part::{ScenePart, part};
use crate::scene::settings::knobs::knobs;
use crate::scene::{Scene, Settings};
use crate::trace::{PixelTrace, View, document, trace_pixel_here};
use crate::world::World;

/// The tree that must stay, and trials in parts of its scene.
pub struct Trials<'a> {
    /// The task.
    pub task: ReduceTask<'a>,
    /// The number of trials.
    pub count: u64,
    /// The settings that a part of the scene asks for: those of the task, as far as scene files can set them.
    own_settings: Settings,
    /// The tree that must stay.
    original: PixelTrace,
    essence: blake3::Hash,
}

impl<'a> Trials<'a> {
    /// Traces the tree that must stay.
    pub fn new(task: ReduceTask<'a>) -> Result<Self, ReduceError> {
        let original = trace_pixel_here(task.world, task.settings, task.pixel, false);
        if original.tree.dropped > 0 {
            return Err(ReduceError::CutTree);
        }
        let view = View {
            world: task.world,
            settings: task.settings,
            trace: &original,
        };
        Ok(Self {
            essence: essence(document::of(view), &BTreeMap::new()),
            own_settings: own_settings(task.scene, task.settings),
            count: 0,
            task,
            original,
        })
    }

    /// Rays of the tree.
    pub fn rays(&self) -> u64 {
        self.original.pixel.rays
    }

    /// The shapes that its rays met.
    pub fn met(&self) -> BTreeSet<u32> {
        Touched::of(&self.original.tree).met
    }

    /// The shapes that the accelerator tested.
    pub fn tested(&self) -> Result<BTreeSet<u32>, ReduceError> {
        let task = &self.task;
        let trace = trace_pixel_here(task.world, task.settings, task.pixel, true);
        if trace.tree.dropped > 0 {
            return Err(ReduceError::CutTree);
        }
        Ok(Touched::of(&trace.tree).tested)
    }

    /// Whether a part of the scene has the tree.
    pub fn keeps_tree(&mut self, kept: &Kept) -> ControlFlow<(), bool> {
        self.count += 1;
        (self.task.watch)(ReduceProgress {
            trials: self.count,
            shapes: kept.shapes.len(),
        })?;
        let part = self.part(kept);
        ControlFlow::Continue(self.has_tree(part.scene, &part.names))
    }

    /// Whether a scene has the tree; its objects in `names` have the name that is given there.
    pub fn has_tree(&self, scene: Scene, names: &BTreeMap<String, String>) -> bool {
        let settings = (self.task.settings_of)(&scene);
        let world = World::new(scene.computed_with(settings.arithmetic), settings.accel);
        let trace = trace_pixel_here(&world, &settings, self.task.pixel, false);
        let (ours, theirs) = (&self.original, &trace);
        // What is quick to compare first.
        let bits = |trace: &PixelTrace| trace.pixel.color.channels().map(f64::to_bits);
        if bits(ours) != bits(theirs) || ours.tree.events.len() != theirs.tree.events.len() {
            return false;
        }
        let view = View {
            world: &world,
            settings: &settings,
            trace: &trace,
        };
        essence(document::of(view), names) == self.essence
    }

    /// The part of the scene that is kept, with the settings of the task.
    pub fn part(&self, kept: &Kept) -> ScenePart {
        let mut part = part(self.task.scene, kept);
        part.scene.settings = self.own_settings;
        part
    }
}

/// The settings of a scene file that asks for these, as far as it can.
fn own_settings(scene: &Scene, settings: &Settings) -> Settings {
    let mut own = scene.settings;
    for knob in knobs().filter(|knob| knob.in_files) {
        if let Some(value) = (knob.field.get)(settings) {
            (knob.field.set)(&mut own, &value);
        }
    }
    own
}
