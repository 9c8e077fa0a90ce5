//! Cursor in the log of a recorded pixel, and the commands that move it.
//!
//! Every move is arithmetic on one index, so back is the exact inverse of forward.

use crate::probe::{Event, RayKind};
use crate::trace::RayTree;

/// Stepping commands, as debuggers have them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StepCommand {
    /// One event on.
    Forward,
    /// One event back.
    Back,
    /// Over what begins here.
    Over,
    /// Out of the current ray.
    Out,
    /// To the next ray of a kind.
    NextRay(RayKind),
    /// To the ray of a kind before here.
    PreviousRay(RayKind),
    /// To the next ray, of any kind.
    NextSent,
    /// To the ray before here, of any kind.
    PreviousSent,
    /// To the next ray in the order of levels: all rays of a depth, then those that are deeper.
    NextOfLevel,
    /// To the ray before this one in the order of levels.
    PreviousOfLevel,
    /// To the next ray that is not sent.
    NextAbsent,
    /// To the ray that is not sent before here.
    PreviousAbsent,
    /// To the first event.
    Start,
    /// To the last event.
    End,
}

/// Index of the current event in the log of a [`RayTree`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cursor {
    position: usize,
}

impl Cursor {
    /// The index of the current event.
    pub fn position(self) -> usize {
        self.position
    }

    /// At event `n`, or at the last one if there are fewer.
    #[must_use]
    pub fn at(tree: &RayTree, n: usize) -> Self {
        Self {
            position: n.min(Self::last(tree)),
        }
    }

    /// At the first event.
    pub fn start() -> Self {
        Self::default()
    }

    /// At the last event.
    pub fn end(tree: &RayTree) -> Self {
        Self::at(tree, usize::MAX)
    }

    /// After a command; `None` if there is no such ray.
    pub fn after(self, command: StepCommand, tree: &RayTree) -> Option<Self> {
        match command {
            StepCommand::Forward => Some(self.step(tree)),
            StepCommand::Back => Some(self.back()),
            StepCommand::Over => Some(self.over(tree)),
            StepCommand::Out => Some(self.out(tree)),
            StepCommand::Start => Some(Self::start()),
            StepCommand::End => Some(Self::end(tree)),
            StepCommand::NextRay(kind) => self.next_ray(tree, |k| k == kind),
            StepCommand::PreviousRay(kind) => self.previous_ray(tree, |k| k == kind),
            StepCommand::NextSent => self.next_ray(tree, |_| true),
            StepCommand::PreviousSent => self.previous_ray(tree, |_| true),
            StepCommand::NextOfLevel => self.of_level(tree, true),
            StepCommand::PreviousOfLevel => self.of_level(tree, false),
            StepCommand::NextAbsent => self.next_absent(tree),
            StepCommand::PreviousAbsent => self.previous_absent(tree),
        }
    }

    /// One event on.
    #[must_use]
    pub fn step(self, tree: &RayTree) -> Self {
        Self::at(tree, self.position + 1)
    }

    /// One event back.
    #[must_use]
    pub fn back(self) -> Self {
        Self {
            position: self.position.saturating_sub(1),
        }
    }

    /// Over what begins here: from a ray's start to its return, from a traversal step to what the traversal found;
    /// else one event on.
    #[must_use]
    pub fn over(self, tree: &RayTree) -> Self {
        match tree.events.get(self.position) {
            Some(Event::Ray(_)) => self.out(tree),
            Some(event) if is_traversal(event) => {
                Self::at(tree, traversal_end(tree, self.position))
            }
            _ => self.step(tree),
        }
    }

    /// Out of the current ray: to its return; from there to the return of the ray that sent it.
    #[must_use]
    pub fn out(self, tree: &RayTree) -> Self {
        let Some(mut node) = tree.node_of_event(self.position) else {
            return self.step(tree);
        };
        if tree.node(node).last_event as usize == self.position {
            match tree.node(node).parent {
                Some(parent) => node = parent,
                None => return self.step(tree),
            }
        }
        Self::at(tree, tree.node(node).last_event as usize)
    }

    /// The next ray of one of the kinds, if there is one behind here.
    pub fn next_ray(self, tree: &RayTree, kinds: impl Fn(RayKind) -> bool) -> Option<Self> {
        let after = tree
            .nodes
            .partition_point(|n| n.first_event as usize <= self.position);
        let node = tree.nodes[after..].iter().find(|n| kinds(n.ray.kind))?;
        Some(Self::at(tree, node.first_event as usize))
    }

    /// The ray of one of the kinds before here, if there is one.
    pub fn previous_ray(self, tree: &RayTree, kinds: impl Fn(RayKind) -> bool) -> Option<Self> {
        let before = tree
            .nodes
            .partition_point(|n| (n.first_event as usize) < self.position);
        let node = tree.nodes[..before].iter().rfind(|n| kinds(n.ray.kind))?;
        Some(Self::at(tree, node.first_event as usize))
    }

    /// The next ray (the one before, if not `forward`) in the order of levels, if there is one.
    fn of_level(self, tree: &RayTree, forward: bool) -> Option<Self> {
        let place = |n: &u32| (tree.node(*n).ray.depth, *n);
        let here = tree.node_of_event(self.position).map(|n| place(&n));
        let all = 0..tree.nodes.len() as u32;
        let node = if forward {
            all.filter(|n| here.is_none_or(|here| place(n) > here))
                .min_by_key(place)
        } else {
            all.filter(|n| here.is_some_and(|here| place(n) < here))
                .max_by_key(place)
        };
        Some(Self::at_node(tree, node?))
    }

    /// The next ray that is not sent, if there is one behind here.
    pub fn next_absent(self, tree: &RayTree) -> Option<Self> {
        let behind = tree.events.get(self.position + 1..)?;
        let at = behind.iter().position(is_absence)?;
        Some(Self::at(tree, self.position + 1 + at))
    }

    /// The ray that is not sent before here, if there is one.
    pub fn previous_absent(self, tree: &RayTree) -> Option<Self> {
        let before = tree.events.get(..self.position)?;
        let at = before.iter().rposition(is_absence)?;
        Some(Self::at(tree, at))
    }

    /// The start of a node's ray.
    #[must_use]
    pub fn at_node(tree: &RayTree, node: u32) -> Self {
        Self::at(tree, tree.node(node).first_event as usize)
    }

    fn last(tree: &RayTree) -> usize {
        tree.events.len().saturating_sub(1)
    }
}

/// The index behind the run of traversal events that begins at `first`.
pub fn traversal_end(tree: &RayTree, first: usize) -> usize {
    let rest = tree.events.get(first..).unwrap_or_default();
    first + rest.iter().take_while(|e| is_traversal(e)).count()
}

fn is_absence(event: &Event) -> bool {
    matches!(event, Event::Absent { .. })
}

/// True for the steps through the acceleration structure.
fn is_traversal(event: &Event) -> bool {
    matches!(event, Event::Visit(_) | Event::Test { .. })
}
