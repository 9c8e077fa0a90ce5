//! Landmarks of a tree: what break points have to know of all of it.

use crate::probe::{Event, RayKind};
use crate::trace::View;

/// What is to be known of a whole tree for some break points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Landmarks {
    /// The largest depth of a ray.
    pub deepest: u32,
    /// The R or T ray that brings the pixel most of its light.
    pub largest: Option<u32>,
    /// The first hit on each object that is hit, as events in order.
    pub new_objects: Vec<u32>,
}

impl Landmarks {
    /// Those of a tree.
    pub fn new(view: View) -> Self {
        let tree = &view.trace.tree;
        let brought = |n: u32| tree.node(n).total().luminance() * view.sample_weight(n);
        let sent_on = |n: &u32| {
            let kind = tree.node(*n).ray.kind;
            matches!(kind, RayKind::Reflected | RayKind::Transmitted)
        };
        let scene = &view.world.scene;
        let mut met = vec![false; scene.objects.len()];
        let mut is_new = |event: &Event| {
            let Event::Hit(hit) = event else { return false };
            let object = scene.owners.get(hit.primitive as usize);
            let met = object.and_then(|object| met.get_mut(*object as usize));
            met.is_some_and(|met| !std::mem::replace(met, true))
        };
        let new_objects = (0..).zip(&tree.events);
        Self {
            deepest: tree.nodes.iter().map(|n| n.ray.depth).max().unwrap_or(0),
            largest: (0..tree.nodes.len() as u32)
                .filter(sent_on)
                .max_by(|a, b| brought(*a).total_cmp(&brought(*b)).then(b.cmp(a))),
            new_objects: new_objects
                .filter_map(|(at, event)| is_new(event).then_some(at))
                .collect(),
        }
    }
}
