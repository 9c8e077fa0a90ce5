//! What a step tells of a watched number, and what was told last before it. Jumps over whole rays where it can, and looks at a bounded
//! number of steps: a screen waits for it.

use super::{Watch, WatchField, WatchValue};
use crate::debug::running::running_sum_at;
use crate::debug::session::Session;
use crate::math::Rgb;
use crate::probe::{Event, RayKind};
use crate::trace::format::rgb;
use crate::trace::{RayTree, explain};

/// Rays that are passed over at most on the way to a step that may tell the number.
const PASSED: usize = 2000;

/// Steps before another one that are looked at for a term.
const LOOKED_BACK: usize = 300;

impl Watch {
    /// The value that was told last, up to a step.
    pub(super) fn known(
        &self,
        session: &Session,
        event: usize,
        left: &mut usize,
    ) -> Option<WatchValue> {
        let mut at = self.teller(session, event)?;
        loop {
            *left = left.checked_sub(1)?;
            if let Some(value) = self.told(session, at) {
                return Some(value);
            }
            at = self.teller(session, at.checked_sub(1)?)?;
        }
    }

    /// The last step up to this one that may tell the number.
    fn teller(&self, session: &Session, event: usize) -> Option<usize> {
        let tree = session.tree();
        let mut at = event;
        for _ in 0..PASSED {
            let id = tree.node_of_event(at);
            let first = |id: u32| tree.node(id).first_event as usize;
            let is_light = |id: u32| tree.node(id).ray.kind == RayKind::Light;
            at = match (self.ray, id) {
                (Some(ray), _) if at > tree.nodes.get(ray as usize)?.last_event as usize => {
                    tree.node(ray).last_event as usize
                }
                (Some(ray), _) if at < first(ray) => return None,
                // Out of the rays that it sent.
                (Some(ray), Some(id)) if id != ray => first(id).checked_sub(1)?,
                (_, Some(id)) if self.field == WatchField::Sum && is_light(id) => {
                    first(id).checked_sub(1)?
                }
                _ if self.field == WatchField::Radiance && !is_return(tree, at) => {
                    match (ended_before(tree, at), id) {
                        (Some(ended), _) => tree.node(ended).last_event as usize,
                        (None, Some(id)) => first(id).checked_sub(1)?,
                        (None, None) => return None,
                    }
                }
                _ => return Some(at),
            };
        }
        None
    }

    /// A step from which on to `event` the number has surely been the same.
    pub(super) fn start_of(&self, session: &Session, event: usize) -> usize {
        let tree = session.tree();
        match self.field {
            WatchField::Radiance | WatchField::Detail(_) => event,
            WatchField::Throughput | WatchField::Depth => entered(tree, event),
            WatchField::Sum => {
                let mut back = (0..=event).rev().take(LOOKED_BACK);
                let found = back.find(|at| self.may_change(session, *at));
                found.unwrap_or_else(|| entered(tree, event))
            }
        }
    }

    /// False if the number is surely what it was one step before.
    pub(super) fn may_change(&self, session: &Session, event: usize) -> bool {
        let tree = session.tree();
        let what = tree.events.get(event);
        let leaves = || event.checked_sub(1).is_some_and(|at| is_return(tree, at));
        let enters = || matches!(what, Some(Event::Ray(_))) || leaves();
        match self.field {
            WatchField::Radiance => is_return(tree, event),
            WatchField::Throughput | WatchField::Depth => enters(),
            WatchField::Sum => enters() || matches!(what, Some(Event::Term { .. })),
            WatchField::Detail(_) => true,
        }
    }

    /// The value that a step tells.
    pub(super) fn told(&self, session: &Session, event: usize) -> Option<WatchValue> {
        let tree = session.tree();
        let value = |color: Rgb| WatchValue {
            text: rgb(color),
            color: Some(color),
            event,
        };
        let id = tree.node_of_event(event);
        if self.ray.is_some() && id != self.ray {
            return None;
        }
        if let WatchField::Detail(name) = &self.field {
            let rows = explain(session.view(), event).rows;
            let row = rows.into_iter().find(|row| row.name == *name)?;
            return Some(WatchValue {
                text: row.text,
                color: row.color,
                event,
            });
        }
        let node = tree.node(id?);
        match (&self.field, tree.events.get(event)?) {
            (WatchField::Radiance, Event::Return { radiance }) => Some(value(*radiance)),
            (WatchField::Throughput, _) => Some(value(node.throughput)),
            (WatchField::Sum, _) => running_sum_at(session, event).map(|sum| value(sum.sum)),
            (WatchField::Depth, _) => Some(WatchValue {
                text: node.ray.depth.to_string(),
                color: None,
                event,
            }),
            _ => None,
        }
    }
}

fn is_return(tree: &RayTree, event: usize) -> bool {
    matches!(tree.events.get(event), Some(Event::Return { .. }))
}

/// Of the rays that the ray of an event sent, the last one that is done before it; between the samples the eye ray that is.
fn ended_before(tree: &RayTree, event: usize) -> Option<u32> {
    let here = tree.node_of_event(event);
    let sent = tree
        .nodes
        .partition_point(|n| n.first_event as usize <= event);
    let mut id = sent.checked_sub(1)? as u32;
    if Some(id) == here {
        return None;
    }
    while tree.node(id).parent != here {
        id = tree.node(id).parent?;
    }
    Some(id)
}

/// The first step of the ray of an event behind the last ray that it sent before it.
fn entered(tree: &RayTree, event: usize) -> usize {
    match (ended_before(tree, event), tree.node_of_event(event)) {
        (Some(ended), _) => tree.node(ended).last_event as usize + 1,
        (None, Some(id)) => tree.node(id).first_event as usize,
        (None, None) => event,
    }
}
