//! Search for the smallest part of a scene in which a pixel has the same tree.

use std::collections::BTreeSet;
use std::ops::ControlFlow;

use super::ddmin::ddmin;
use super::error::ReduceError;
use super::task::ReduceTask;
use super::trials::Trials;
use crate::scene::kept::Kept;
use crate::scene::{Scene, flat};

/// Search for the smallest part.
pub struct Search<'a> {
    /// The trials that decide.
    pub trials: Trials<'a>,
    /// The shapes of each light with an area.
    shining: Vec<Vec<u32>>,
    /// Shapes that stay whatever the tree says.
    asked_for: BTreeSet<u32>,
}

impl<'a> Search<'a> {
    /// Traces the tree that must stay.
    pub fn new(task: ReduceTask<'a>) -> Result<Self, ReduceError> {
        let trials = Trials::new(task)?;
        let asked_for = if task.keep_tests {
            trials.tested()?
        } else {
            BTreeSet::new()
        };
        Ok(Self {
            trials,
            shining: shining(task.scene),
            asked_for,
        })
    }

    /// Leaves out what can be left out, until without any one thing the tree is another.
    pub fn shrink(&mut self, kept: &mut Kept) -> ControlFlow<()> {
        loop {
            let before = kept.clone();
            self.leave_out_objects(kept)?;
            self.leave_out_shapes(kept)?;
            self.leave_out_lights(kept)?;
            self.leave_out_sky(kept)?;
            if *kept == before {
                return ControlFlow::Continue(());
            }
        }
    }

    fn leave_out_objects(&mut self, kept: &mut Kept) -> ControlFlow<()> {
        let (fixed, loose) = self.parted(kept);
        let owner = |shape: &u32| self.trials.task.scene.owners[*shape as usize];
        let groups = loose.chunk_by(|a, b| owner(a) == owner(b));
        let mut groups: Vec<Vec<u32>> = groups.map(<[u32]>::to_vec).collect();
        let all = kept.clone();
        let with =
            |groups: &[Vec<u32>]| all.with_shapes(fixed.iter().copied().chain(groups.concat()));
        let flow = ddmin(&mut groups, |some| self.trials.keeps_tree(&with(some)));
        *kept = with(&groups);
        flow
    }

    /// Leaves out shapes of objects that more than one is kept of.
    fn leave_out_shapes(&mut self, kept: &mut Kept) -> ControlFlow<()> {
        let (_, loose) = self.parted(kept);
        let owner = |shape: &u32| self.trials.task.scene.owners[*shape as usize];
        let groups = loose.chunk_by(|a, b| owner(a) == owner(b));
        let groups: Vec<Vec<u32>> = groups.map(<[u32]>::to_vec).collect();
        for mut group in groups.into_iter().filter(|group| group.len() > 1) {
            let all = kept.clone();
            let is_other = |shape: &u32| group.binary_search(shape).is_err();
            let others: Vec<u32> = all.shapes.iter().copied().filter(is_other).collect();
            let with = |some: &[u32]| all.with_shapes([&others[..], some].concat());
            let flow = ddmin(&mut group, |some| self.trials.keeps_tree(&with(some)));
            *kept = with(&group);
            flow?;
        }
        ControlFlow::Continue(())
    }

    fn leave_out_lights(&mut self, kept: &mut Kept) -> ControlFlow<()> {
        let all = kept.clone();
        let with = |lights: &[u32]| Kept {
            lights: lights.to_vec(),
            ..all.clone()
        };
        ddmin(&mut kept.lights, |some| self.trials.keeps_tree(&with(some)))
    }

    /// Leaves out background and ambient light.
    fn leave_out_sky(&mut self, kept: &mut Kept) -> ControlFlow<()> {
        for background in [true, false] {
            let mut fewer = kept.clone();
            if background {
                fewer.background = false;
            } else {
                fewer.ambient = false;
            }
            if fewer != *kept && self.trials.keeps_tree(&fewer)? {
                *kept = fewer;
            }
        }
        ControlFlow::Continue(())
    }

    /// The shapes that are kept, parted into those that must be and all others.
    fn parted(&self, kept: &Kept) -> (BTreeSet<u32>, Vec<u32>) {
        let fixed = self.fixed(kept);
        let loose = kept.shapes.iter().copied();
        let loose = loose.filter(|shape| !fixed.contains(shape)).collect();
        (fixed, loose)
    }

    /// Shapes that must be kept with these lights.
    pub fn fixed(&self, kept: &Kept) -> BTreeSet<u32> {
        let shining = kept.lights.iter().flat_map(|l| &self.shining[*l as usize]);
        shining.chain(&self.asked_for).copied().collect()
    }
}

/// For each light the shapes that it shines from: none for lights without area.
fn shining(scene: &Scene) -> Vec<Vec<u32>> {
    let shapes = |object: u32| {
        let owners = scene.owners.iter();
        let all = (0..).zip(owners).filter(|(_, owner)| **owner == object);
        all.map(|(shape, _)| shape).collect()
    };
    let lights = scene.lights.iter();
    lights
        .map(|light| {
            let object = light
                .kind
                .area()
                .and_then(|area| flat::shining(scene, area));
            object.map_or(Vec::new(), shapes)
        })
        .collect()
}
