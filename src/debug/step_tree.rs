//! A ray's steps through the accelerator as a tree: below which visit each step stands. Derived from the visits; a test
//! belongs to the leaf visited last, or to the node on whose plane its shape lies.

use std::collections::HashMap;

use crate::accel::Accel;
use crate::probe::{Choice, Event, NONE, Verdict, Visit};

/// Where a step stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct StepPlace {
    /// The step above it, or [`NONE`].
    parent: u32,
    /// Steps above it in all.
    depth: u16,
    /// Whether no step with that parent comes after it.
    last: bool,
}

/// The steps of one ray, by their number among them.
#[derive(Clone, Debug, Default)]
pub struct StepTree {
    places: Vec<StepPlace>,
    /// The tests that found a closer hit, and its t.
    hits: Vec<(usize, f64)>,
    /// Nodes that are visited.
    pub visited: usize,
    /// Shapes that are tested.
    pub tested: usize,
}

impl StepTree {
    /// The tree of some steps: one pass over them.
    pub fn new(accel: &Accel, steps: &[Event]) -> Self {
        let mut maker = Maker {
            accel,
            tree: Self::default(),
            above: HashMap::new(),
            pending: Vec::new(),
            leaf: None,
        };
        for (step, event) in steps.iter().enumerate() {
            match event {
                Event::Visit(visit) => maker.visit(step as u32, visit),
                Event::Test { verdict, t, .. } => {
                    maker.test();
                    if *verdict == Verdict::Hit {
                        maker.tree.hits.push((step, *t));
                    }
                }
                _ => maker.push(NONE),
            }
        }
        let mut tree = maker.tree;
        let mut has_later = vec![false; tree.places.len()];
        for place in tree.places.iter_mut().rev() {
            if let Some(later) = has_later.get_mut(place.parent as usize) {
                place.last = !*later;
                *later = true;
            }
        }
        tree
    }

    /// The visit that a step stands below; `None` at the top.
    pub fn parent(&self, step: usize) -> Option<usize> {
        let place = self.places.get(step)?;
        (place.parent != NONE).then_some(place.parent as usize)
    }

    /// How many visits are above a step.
    pub fn depth(&self, step: usize) -> usize {
        self.places.get(step).map_or(0, |p| usize::from(p.depth))
    }

    /// A line for each visit above a step that has more to come, and the branch to the step: `│├` or `│└`.
    pub fn guides(&self, step: usize) -> String {
        let mut guides = Vec::new();
        let mut at = step;
        while let (Some(parent), Some(place)) = (self.parent(at), self.places.get(at)) {
            guides.push(match (at == step, place.last) {
                (true, false) => '├',
                (true, true) => '└',
                (false, false) => '│',
                (false, true) => ' ',
            });
            at = parent;
        }
        guides.iter().rev().collect()
    }

    /// The t of the closest hit that is known before a step.
    pub fn closest_before(&self, step: usize) -> Option<f64> {
        let known = self.hits.partition_point(|(at, _)| *at < step);
        known.checked_sub(1).map(|at| self.hits[at].1)
    }

    /// The t of the hit that the steps lead to.
    pub fn found(&self) -> Option<f64> {
        self.hits.last().map(|(_, t)| *t)
    }
}

/// Places steps one after the other.
struct Maker<'a> {
    accel: &'a Accel,
    tree: StepTree,
    /// For each node that is a child of a visited one, that visit.
    above: HashMap<u32, u32>,
    /// The visits whose far child is still to come, and that child.
    pending: Vec<(u32, u32)>,
    /// The leaf visited last, and how many of its shapes are still to be tested.
    leaf: Option<(u32, usize)>,
}

impl Maker<'_> {
    fn push(&mut self, parent: u32) {
        let above = self.tree.places.get(parent as usize);
        self.tree.places.push(StepPlace {
            parent,
            depth: above.map_or(0, |place| place.depth.saturating_add(1)),
            last: true,
        });
    }

    fn visit(&mut self, step: u32, visit: &Visit) {
        self.push(self.above.get(&visit.node).copied().unwrap_or(NONE));
        self.tree.visited += usize::from(!visit.is_skipped());
        if self
            .pending
            .last()
            .is_some_and(|(_, far)| *far == visit.node)
        {
            self.pending.pop();
        }
        match visit.choice {
            Choice::Leaf | Choice::Cell => {
                let node = self.accel.node(visit.node);
                self.leaf = Some((step, node.map_or(0, |node| node.primitives.len())));
            }
            Choice::Both | Choice::BothInDoubt => {
                self.pending.push((step, visit.far));
                self.above.extend([(visit.near, step), (visit.far, step)]);
            }
            Choice::NearSplitBeyond | Choice::NearRunsAway | Choice::FarSplitBefore => {
                self.above.extend([(visit.near, step), (visit.far, step)]);
            }
            Choice::Children => {
                let children = self.accel.children(visit.node);
                self.above
                    .extend(children.into_iter().map(|child| (child, step)));
            }
            Choice::SkippedCloserHit | Choice::SkippedOutside | Choice::SkippedMissed => {}
        }
    }

    /// What follows the tests of a leaf lies on the plane of the node whose far child comes next.
    fn test(&mut self) {
        self.tree.tested += 1;
        let parent = match (&mut self.leaf, self.pending.last()) {
            (Some((leaf, left)), _) if *left > 0 => {
                *left -= 1;
                *leaf
            }
            (Some(_), Some((node, _))) => *node,
            (Some((leaf, _)), None) => *leaf,
            (None, _) => NONE,
        };
        self.push(parent);
    }
}
