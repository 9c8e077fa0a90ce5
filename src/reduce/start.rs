//! Start of a search: a part of the scene that has the tree and is likely to be small.

use std::collections::BTreeSet;
use std::ops::ControlFlow;

use super::error::ReduceError;
use super::search::Search;
use crate::scene::kept::Kept;

/// Shapes that are tried as helpers, of those that were tested and of all.
const HELPERS: usize = 64;

impl Search<'_> {
    /// A part of the scene that has the tree: the first of a few, each larger than those before it.
    pub fn first(&mut self) -> Result<Kept, ReduceError> {
        let all = Kept::all(self.trials.task.scene);
        let mut shapes = self.trials.met();
        shapes.extend(self.fixed(&all));
        if let Some(kept) = self.tried(&all, &shapes)? {
            return Ok(kept);
        }
        shapes.extend(self.media());
        if let Some(kept) = self.tried(&all, &shapes)? {
            return Ok(kept);
        }
        // Which of several blockers a shadow ray meets first is a matter of the accelerator, and so of what else there is: any
        // shape may help.
        let tested = self.trials.tested().unwrap_or_default();
        let (count, spread) = (all.shapes.len(), all.shapes.len().div_ceil(HELPERS));
        let helpers = tested.difference(&shapes).copied().take(HELPERS);
        let helpers: Vec<u32> = helpers
            .chain((0..count as u32).step_by(spread.max(1)))
            .collect();
        for helper in helpers {
            let mut more = shapes.clone();
            if more.insert(helper)
                && let Some(kept) = self.tried(&all, &more)?
            {
                return Ok(kept);
            }
        }
        shapes.extend(tested);
        let mut step = spread.max(1);
        loop {
            if let Some(kept) = self.tried(&all, &shapes)? {
                return Ok(kept);
            }
            if shapes.len() == count {
                return Err(ReduceError::NotApart);
            }
            shapes.extend((0..count as u32).step_by(step));
            step = (step / 4).max(1);
        }
    }

    /// What is kept with these shapes, if that has the tree.
    fn tried(&mut self, all: &Kept, shapes: &BTreeSet<u32>) -> Result<Option<Kept>, ReduceError> {
        let kept = all.with_shapes(shapes.iter().copied());
        match self.trials.keeps_tree(&kept) {
            ControlFlow::Break(()) => Err(ReduceError::Interrupted),
            ControlFlow::Continue(same) => Ok(same.then_some(kept)),
        }
    }

    /// The shapes of all transparent objects.
    fn media(&self) -> Vec<u32> {
        let scene = self.trials.task.scene;
        let shapes = 0..scene.shapes.len() as u32;
        shapes
            .filter(|shape| scene.material_of(*shape).is_transmissive())
            .collect()
    }
}
