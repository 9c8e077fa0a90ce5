//! The ledger: every colour accounted for, to the last bit.
//!
//! For each node, its terms and its weighted children, added in the order in which the tracer added them, are its
//! radiance; the weighted roots are the pixel. Where something is no finite number there is nothing to add up: such a
//! sample counts as black.

use super::{PixelTrace, RayTree};
use crate::math::Rgb;
use crate::probe::{Event, RayKind, Term};

/// One summand of a node's radiance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Summand {
    /// A term of the shading equation.
    Term {
        /// Which.
        term: Term,
        /// The light that it comes from, or [`crate::probe::NONE`].
        light: u32,
    },
    /// What an R or T ray brought back.
    Child {
        /// The node.
        node: u32,
        /// R or T.
        kind: RayKind,
        /// Its factor.
        weight: Rgb,
        /// What it brought back.
        radiance: Rgb,
    },
}

impl Summand {
    /// What it adds.
    pub fn value(&self) -> Rgb {
        match *self {
            Self::Term { term, .. } => term.value(),
            Self::Child {
                weight, radiance, ..
            } => weight * radiance,
        }
    }
}

/// The summands of a node's radiance, in the order in which they were added.
pub fn summands(tree: &RayTree, id: u32) -> Vec<Summand> {
    let terms = tree.own_events(id).filter_map(|(_, event)| match *event {
        Event::Term { term, light, .. } => Some(Summand::Term { term, light }),
        _ => None,
    });
    let children = tree.children(id).filter_map(|node| {
        let child = tree.node(node);
        (child.ray.kind != RayKind::Light).then_some(Summand::Child {
            node,
            kind: child.ray.kind,
            weight: child.ray.weight,
            radiance: child.radiance,
        })
    });
    // All terms come before the first R or T ray, so this is the tracer's order.
    terms.chain(children).collect()
}

/// The sum of a node's terms and weighted children.
pub fn sum(tree: &RayTree, id: u32) -> Rgb {
    summands(tree, id)
        .iter()
        .fold(Rgb::BLACK, |sum, summand| sum + summand.value())
}

/// The first node whose ledger does not close, if there is one. A log that was cut need not close.
pub fn first_open(tree: &RayTree) -> Option<u32> {
    (0..tree.nodes.len() as u32).find(|&id| {
        let node = tree.node(id);
        let sum = sum(tree, id);
        node.ray.kind != RayKind::Light && sum != node.radiance && sum.is_finite()
    })
}

/// The pixel's colour by its samples' roots.
pub fn pixel_sum(trace: &PixelTrace) -> Rgb {
    trace.tree.samples.iter().fold(Rgb::BLACK, |sum, sample| {
        let radiance = sample
            .root
            .map_or(Rgb::BLACK, |root| trace.tree.node(root).radiance);
        sum + radiance.finite_or_black() * sample.weight
    })
}
