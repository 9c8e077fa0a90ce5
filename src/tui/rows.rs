//! The rows of the tree pane: every ray and every ray that was not sent, in the order of the log.
//!
//! A tree may have a million rays. The rows are folded from the log once; opening and closing makes a new list of
//! numbers; a screen looks at only those rows that it shows.

use std::collections::HashSet;

use crate::probe::Event;
use crate::trace::RayTree;

/// A row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// The event that it stands for: a ray's start, or an absence.
    pub event: u32,
    /// The ray, or the ray whose hit did not send one.
    pub node: u32,
    /// True for a ray that was not sent.
    pub absent: bool,
}

/// All rows, and which of them can be seen.
#[derive(Clone, Debug, Default)]
pub struct Rows {
    all: Vec<Row>,
    visible: Vec<u32>,
    closed: HashSet<u32>,
}

impl Rows {
    /// The rows of a tree, all open.
    pub fn new(tree: &RayTree) -> Self {
        let mut all = Vec::new();
        let mut nodes = 0;
        for (event, what) in (0..).zip(&tree.events) {
            let (node, absent) = match what {
                Event::Ray(_) => {
                    nodes += 1;
                    (Some(nodes - 1), false)
                }
                Event::Absent { .. } => (tree.node_of_event(event as usize), true),
                _ => continue,
            };
            all.extend(node.map(|node| Row {
                event,
                node,
                absent,
            }));
        }
        let mut rows = Self {
            all,
            ..Self::default()
        };
        rows.list(tree);
        rows
    }

    /// Lists the visible rows anew.
    fn list(&mut self, tree: &RayTree) {
        self.visible.clear();
        let mut next = 0;
        while let Some(row) = self.all.get(next) {
            self.visible.push(next as u32);
            next = if !row.absent && self.closed.contains(&row.node) {
                self.behind(tree.node(row.node).last_event)
            } else {
                next + 1
            };
        }
    }

    /// The number of the first row behind an event.
    fn behind(&self, event: u32) -> usize {
        self.all.partition_point(|row| row.event <= event)
    }

    /// How many rows can be seen.
    pub fn len(&self) -> usize {
        self.visible.len()
    }

    /// A visible row.
    pub fn get(&self, row: usize) -> Option<Row> {
        self.all.get(*self.visible.get(row)? as usize).copied()
    }

    /// The visible row that an event belongs to: of its absence, of its ray, or of the closed ray around that.
    pub fn of_event(&self, tree: &RayTree, event: usize) -> usize {
        let event = event as u32;
        let own = |row: &&Row| row.event == event;
        let target = match self.all.get(self.behind(event).wrapping_sub(1)).filter(own) {
            Some(row) => row.event,
            None => tree
                .node_of_event(event as usize)
                .map_or(0, |node| tree.node(node).first_event),
        };
        let row_event = |row: &u32| self.all[*row as usize].event;
        let after = self.visible.partition_point(|row| row_event(row) <= target);
        // If the row itself is hidden, the last visible one before it is the closed ray around it.
        after.saturating_sub(1)
    }

    /// True if what hangs on a ray is hidden.
    pub fn is_closed(&self, node: u32) -> bool {
        self.closed.contains(&node)
    }

    /// Hides or shows what hangs on a ray.
    pub fn close(&mut self, tree: &RayTree, node: u32, closed: bool) {
        let changed = if closed {
            self.closed.insert(node)
        } else {
            self.closed.remove(&node)
        };
        if changed {
            self.list(tree);
        }
    }

    /// Opens all rays around an event, so that its row can be seen.
    pub fn reveal(&mut self, tree: &RayTree, event: usize) {
        if self.closed.is_empty() {
            return;
        }
        let mut node = tree.node_of_event(event);
        // The ray itself may stay closed while the event is its start.
        if let Some(id) = node
            && tree.node(id).first_event as usize == event
        {
            node = tree.node(id).parent;
        } else if !matches!(tree.events.get(event), Some(Event::Absent { .. })) {
            node = node.and_then(|id| tree.node(id).parent);
        }
        let mut changed = false;
        while let Some(id) = node {
            changed |= self.closed.remove(&id);
            node = tree.node(id).parent;
        }
        if changed {
            self.list(tree);
        }
    }

    /// How deep a row stands in the tree.
    pub fn depth(tree: &RayTree, row: Row) -> u32 {
        tree.node(row.node).sent.depth + u32::from(row.absent)
    }

    /// True if no row behind this one hangs on the same ray.
    pub fn is_last(&self, tree: &RayTree, row: Row) -> bool {
        let parent = if row.absent {
            Some(row.node)
        } else {
            tree.node(row.node).parent
        };
        let end = if row.absent {
            row.event
        } else {
            tree.node(row.node).last_event
        };
        let Some(parent) = parent else {
            return true;
        };
        let next = self.all.get(self.behind(end));
        next.is_none_or(|next| next.event > tree.node(parent).last_event)
    }

    /// True if anything hangs on a ray.
    pub fn has_children(&self, tree: &RayTree, node: u32) -> bool {
        let node = tree.node(node);
        let next = self.all.get(self.behind(node.first_event));
        next.is_some_and(|next| next.event <= node.last_event)
    }
}
