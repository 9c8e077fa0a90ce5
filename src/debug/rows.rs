//! TreeRows of a ray tree with their folding state: every ray, every ray that was not spawned and every set of light samples,
//! in the order of the log.
//!
//! A tree may have a million rays. The rows are made from the log once; opening and closing makes a new list of
//! indices; a screen looks at only those rows that it shows.

use crate::probe::{Event, NONE};
use crate::scene::limits::MAX_LIGHT_SAMPLES;
use crate::trace::RayTree;

/// TreeRows that a bundle has at most.
const MAX_BUNDLE: usize = MAX_LIGHT_SAMPLES as usize + 1;

/// A row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TreeRow {
    /// The event that it stands for: a ray's start, an absence, or the start of a bundle.
    pub event: u32,
    /// The last event that it hides when it is closed.
    pub end: u32,
    /// The ray, or the ray whose hit sent the bundle or did not send one.
    pub node: u32,
    /// What it stands for.
    pub kind: RowKind,
    /// The number, among all rows, of the bundle that it belongs to, or [`NONE`].
    bundle: u32,
}

/// What a row stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RowKind {
    /// A ray.
    Ray,
    /// A ray that was not sent.
    Absent,
    /// The rays to an area light.
    LightSamples,
}

impl TreeRow {
    /// The row of a ray.
    pub fn ray(tree: &RayTree, node: u32) -> Self {
        Self {
            event: tree.node(node).first_event,
            end: tree.node(node).last_event,
            node,
            kind: RowKind::Ray,
            bundle: NONE,
        }
    }
}

/// All rows, and which of them can be seen.
#[derive(Clone, Debug, Default)]
pub struct TreeRows {
    all: Vec<TreeRow>,
    visible: Vec<u32>,
    /// Of each row whether it is closed.
    closed: Vec<bool>,
}

impl TreeRows {
    /// The rows of a tree, all open but the bundles.
    pub fn new(tree: &RayTree) -> Self {
        let mut all: Vec<TreeRow> = Vec::new();
        let mut nodes = 0;
        // The bundle that is going on: its row, the ray that sent it, its light.
        let mut bundle: Option<(usize, u32, u32)> = None;
        for (event, what) in (0..).zip(&tree.events) {
            let parent = || tree.node_of_event(event as usize);
            let (node, sender, light, kind) = match what {
                Event::Ray(sent) => {
                    nodes += 1;
                    let sender = tree.node(nodes - 1).parent;
                    (Some(nodes - 1), sender, Some(sent.light), RowKind::Ray)
                }
                Event::Absent { light, .. } => (parent(), parent(), Some(*light), RowKind::Absent),
                Event::LightSamples { .. } => (parent(), None, None, RowKind::LightSamples),
                _ => continue,
            };
            let Some(node) = node else { continue };
            let end = match kind {
                RowKind::Ray => tree.node(node).last_event,
                RowKind::Absent | RowKind::LightSamples => event,
            };
            let mut of_bundle = NONE;
            if let Event::LightSamples { light, .. } = what {
                bundle = Some((all.len(), node, *light));
            } else if let Some((row, sent_by, to)) = bundle
                && (sender, light) == (Some(sent_by), Some(to))
            {
                all[row].end = end;
                of_bundle = row as u32;
            }
            all.push(TreeRow {
                event,
                end,
                node,
                kind,
                bundle: of_bundle,
            });
        }
        let is_bundle = |row: &TreeRow| row.kind == RowKind::LightSamples;
        let mut rows = Self {
            closed: all.iter().map(is_bundle).collect(),
            all,
            visible: Vec::new(),
        };
        rows.list();
        rows
    }

    /// Lists the visible rows anew.
    fn list(&mut self) {
        self.visible.clear();
        let mut next = 0;
        while let Some(row) = self.all.get(next) {
            self.visible.push(next as u32);
            next = if self.closed[next] {
                self.behind(row.end)
            } else {
                next + 1
            };
        }
    }

    /// The number of the first row behind an event.
    fn behind(&self, event: u32) -> usize {
        self.all.partition_point(|row| row.event <= event)
    }

    /// The number of the row of an event.
    fn number(&self, event: u32) -> Option<usize> {
        let number = self.behind(event).checked_sub(1)?;
        (self.all[number].event == event).then_some(number)
    }

    /// Closes or opens the row of an event. True if it was not so before.
    fn set(&mut self, event: u32, closed: bool) -> bool {
        let number = self.number(event);
        number.is_some_and(|n| std::mem::replace(&mut self.closed[n], closed) != closed)
    }

    /// How many rows can be seen.
    pub fn len(&self) -> usize {
        self.visible.len()
    }

    /// True if no row can be seen.
    pub fn is_empty(&self) -> bool {
        self.visible.is_empty()
    }

    /// A visible row.
    pub fn get(&self, row: usize) -> Option<TreeRow> {
        self.all.get(*self.visible.get(row)? as usize).copied()
    }

    /// The visible row that an event belongs to: of its absence, of its ray, of its bundle, or of what is closed around
    /// that.
    pub fn of_event(&self, tree: &RayTree, event: usize) -> usize {
        let target = self.row_event(tree, event);
        let row_event = |row: &u32| self.all[*row as usize].event;
        let after = self.visible.partition_point(|row| row_event(row) <= target);
        // If the row itself is hidden, the last visible one before it is the closed one around it.
        after.saturating_sub(1)
    }

    /// True if what hangs on a row is hidden.
    pub fn is_closed(&self, row: TreeRow) -> bool {
        self.number(row.event).is_some_and(|n| self.closed[n])
    }

    /// Hides or shows what hangs on a row.
    pub fn close(&mut self, row: TreeRow, closed: bool) {
        if self.set(row.event, closed) {
            self.list();
        }
    }

    /// Opens all rays and bundles around an event, so that its row can be seen.
    pub fn reveal(&mut self, tree: &RayTree, event: usize) {
        // The row that the event belongs to may itself stay closed.
        let target = self.row_event(tree, event);
        let mut changed = false;
        let mut node = tree.node_of_event(target as usize);
        while let Some(id) = node {
            let first = tree.node(id).first_event;
            if first != target {
                changed |= self.set(first, false);
            }
            node = tree.node(id).parent;
        }
        // Bundles do not nest, and nothing but their own rays stands in them.
        let before = self.all[..self.behind(target)].iter().rev();
        let bundle = before
            .take(MAX_BUNDLE)
            .find(|row| row.kind == RowKind::LightSamples && row.event < target);
        if let Some(bundle) = bundle.filter(|row| row.end >= target) {
            changed |= self.set(bundle.event, false);
        }
        if changed {
            self.list();
        }
    }

    /// The event of the row that an event belongs to.
    fn row_event(&self, tree: &RayTree, event: usize) -> u32 {
        match self.number(event as u32) {
            Some(number) => self.all[number].event,
            None => tree
                .node_of_event(event)
                .map_or(0, |node| tree.node(node).first_event),
        }
    }

    /// How deep a row stands in the tree.
    pub fn depth(tree: &RayTree, row: TreeRow) -> u32 {
        let in_bundle = u32::from(row.bundle != NONE);
        tree.node(row.node).ray.depth + u32::from(row.kind != RowKind::Ray) + in_bundle
    }

    /// The row on which a row hangs: of its bundle, or of a ray.
    pub fn above(&self, tree: &RayTree, row: TreeRow) -> Option<TreeRow> {
        let bundle = self.all.get(row.bundle as usize).copied();
        bundle.or_else(|| Self::parent(tree, row).map(|parent| TreeRow::ray(tree, parent)))
    }

    /// The ray on whose hit a row hangs.
    pub fn parent(tree: &RayTree, row: TreeRow) -> Option<u32> {
        match row.kind {
            RowKind::Ray => tree.node(row.node).parent,
            RowKind::Absent | RowKind::LightSamples => Some(row.node),
        }
    }

    /// True if no row behind this one hangs on what this one hangs on.
    pub fn is_last(&self, tree: &RayTree, row: TreeRow) -> bool {
        let Some(above) = self.above(tree, row) else {
            return true;
        };
        let next = self.all.get(self.behind(row.end));
        next.is_none_or(|next| next.event > above.end)
    }

    /// True if anything hangs on a row.
    pub fn has_children(&self, row: TreeRow) -> bool {
        let next = self.all.get(self.behind(row.event));
        next.is_some_and(|next| next.event <= row.end)
    }
}
