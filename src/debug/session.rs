//! Debugging session of a pixel: its recording, the cursor in its log, and the rows of its tree.

use std::cell::OnceCell;
use std::ops::Range;
use std::sync::Arc;

use super::cursor::{Cursor, StepCommand, traversal_end};
use super::extent;
use super::horizon::{BEHIND, is_behind};
use super::landmarks::Landmarks;
use super::rows::TreeRows;
use super::step_tree::StepTree;
use crate::geometry::Aabb;
use crate::scene::Settings;
use crate::trace::address::{Address, AddressPart, node_at};
use crate::trace::facts::TreePath;
use crate::trace::{PixelTrace, RayTree, View, trace_pixel};
use crate::world::World;

/// The open ray tree of a pixel.
pub struct Session {
    /// Scene and accelerator.
    pub world: Arc<World>,
    /// As the picture was rendered.
    pub settings: Settings,
    /// The recording, with the picked pixel; before a question is answered only what is known by then.
    pub trace: PixelTrace,
    /// All of the recording, while only its beginning is known.
    whole: Option<Box<PixelTrace>>,
    /// TreeRows of the tree.
    pub rows: TreeRows,
    /// A box around all that the drawing of the paths shows.
    pub extent: Aabb,
    /// Nodes of the accelerator.
    pub nodes: usize,
    /// The current ray's traversal steps as a tree.
    pub step_tree: StepTree,
    cursor: Cursor,
    steps: Range<usize>,
    landmarks: OnceCell<Landmarks>,
}

impl Session {
    /// Traces a pixel with all steps through the acceleration structure.
    pub fn new(world: Arc<World>, settings: Settings, at: (u32, u32)) -> Self {
        let trace = trace_pixel(&world, &settings, at, true);
        Self::of(world, settings, trace)
    }

    /// The session of a recording, at its first event.
    pub fn of(world: Arc<World>, settings: Settings, trace: PixelTrace) -> Self {
        let rows = TreeRows::new(&trace.tree);
        let nodes = world.accel.stats().nodes;
        let mut session = Self {
            world,
            settings,
            trace,
            whole: None,
            rows,
            extent: Aabb::EMPTY,
            nodes,
            step_tree: StepTree::default(),
            cursor: Cursor::start(),
            steps: 0..0,
            landmarks: OnceCell::new(),
        };
        session.extent = extent::extent(session.view());
        session.go(Cursor::start());
        session
    }

    /// Where what is known ends: an index into the whole log; none if all of it is known.
    pub fn horizon(&self) -> Option<usize> {
        self.whole.is_some().then(|| self.tree().events.len())
    }

    /// The whole recording, for whoever asks and checks; no pane draws it.
    pub fn whole(&self) -> &PixelTrace {
        self.whole.as_deref().unwrap_or(&self.trace)
    }

    /// Lets nothing be known of the event at an index of the whole log and of those behind it; of `None`, lets all be known.
    ///
    /// What is not known is not there: the tree ends, and the pixel has no colour. So no pane can show it by mistake.
    pub fn set_horizon(&mut self, horizon: Option<usize>) {
        let whole = match self.whole.take() {
            Some(whole) => *whole,
            None => self.trace.clone(),
        };
        match horizon.filter(|end| *end < whole.tree.events.len()) {
            Some(end) => {
                self.trace = whole.until(end.max(1));
                self.whole = Some(Box::new(whole));
            }
            None => self.trace = whole,
        }
        self.rows = TreeRows::new(&self.trace.tree);
        self.landmarks = OnceCell::new();
        self.extent = extent::extent(self.view());
        (self.steps, self.step_tree) = (0..0, StepTree::default());
        self.go(Cursor::at(self.tree(), self.cursor.position()));
    }

    /// The recording with all that explains it.
    pub fn view(&self) -> View<'_> {
        View {
            world: &self.world,
            settings: &self.settings,
            trace: &self.trace,
        }
    }

    /// The tree.
    pub fn tree(&self) -> &RayTree {
        &self.trace.tree
    }

    /// What break points have to know of the whole tree; found once.
    pub fn landmarks(&self) -> &Landmarks {
        self.landmarks.get_or_init(|| Landmarks::new(self.view()))
    }

    /// The current event.
    pub fn cursor(&self) -> Cursor {
        self.cursor
    }

    /// The ray that the current event belongs to; between the samples there is none.
    pub fn node(&self) -> Option<u32> {
        self.tree().node_of_event(self.cursor.position())
    }

    /// The current row of the tree.
    pub fn row(&self) -> usize {
        self.rows.of_event(self.tree(), self.cursor.position())
    }

    /// The current ray's traversal steps, as indices of their events.
    pub fn steps(&self) -> Range<usize> {
        self.steps.clone()
    }

    /// The number of an event among the current ray's traversal steps, if it is one of them.
    pub fn step_number(&self, event: usize) -> Option<usize> {
        self.steps
            .contains(&event)
            .then(|| event - self.steps.start)
    }

    /// Follows a command; an error says why the cursor stays.
    pub fn step(&mut self, command: StepCommand) -> Result<(), String> {
        if self.whole.is_some() && is_behind(self.cursor, command, self.tree()) {
            if command == StepCommand::End {
                self.go(Cursor::end(self.tree()));
            }
            return Err(BEHIND.to_owned());
        }
        if let Some(cursor) = self.cursor.after(command, self.tree()) {
            let stays = cursor == self.cursor;
            self.go(cursor);
            return match command {
                StepCommand::Back if stays => Err("this is the first event".to_owned()),
                StepCommand::Forward | StepCommand::Over | StepCommand::Out if stays => {
                    Err("this is the last event".to_owned())
                }
                _ => Ok(()),
            };
        }
        match command {
            StepCommand::NextRay(kind) => Err(format!("no {} ray comes after this", kind.letter())),
            StepCommand::PreviousRay(kind) => {
                Err(format!("no {} ray comes before this", kind.letter()))
            }
            StepCommand::NextSent | StepCommand::NextOfLevel => {
                Err("this is the last ray".to_owned())
            }
            StepCommand::PreviousSent | StepCommand::PreviousOfLevel => {
                Err("this is the first ray".to_owned())
            }
            StepCommand::NextAbsent => Err("all rays after this are sent".to_owned()),
            StepCommand::PreviousAbsent => Err("all rays before this are sent".to_owned()),
            _ => Ok(()),
        }
    }

    /// Moves the cursor, and opens the rows around it.
    pub fn go(&mut self, cursor: Cursor) {
        self.cursor = cursor;
        self.rows.reveal(&self.trace.tree, cursor.position());
        let first = self
            .node()
            .map(|n| self.tree().node(n).first_event as usize + 1);
        if self.steps.start != first.unwrap_or(0) {
            self.steps = first.map_or(0..0, |first| first..traversal_end(self.tree(), first));
            let steps = self.tree().events.get(self.steps()).unwrap_or_default();
            self.step_tree = StepTree::new(&self.world.accel, steps);
        }
    }

    /// Goes to an event, or to the last one if there are fewer.
    pub fn go_to_event(&mut self, n: usize) {
        self.go(Cursor::at(self.tree(), n));
    }

    /// Goes to a ray, or to the event that the address names; an error says what is there instead, and the cursor stays.
    pub fn go_to_address(&mut self, address: &Address) -> Result<(), String> {
        let node = node_at(self.view(), &address.path).map_err(|told| {
            if self.may_be_behind(&address.path) {
                BEHIND.to_owned()
            } else {
                told
            }
        })?;
        match address.part {
            Some(AddressPart::Event(event)) if self.horizon().is_some_and(|end| event >= end) => {
                return Err(BEHIND.to_owned());
            }
            Some(AddressPart::Event(event)) => self.go_to_event(event),
            _ => self.go(Cursor::at_node(self.tree(), node)),
        }
        Ok(())
    }

    /// True if a ray that is not there may still be sent: the ray nearest to it that is there is not done.
    fn may_be_behind(&self, path: &TreePath) -> bool {
        let mut near = path.clone();
        while self.whole.is_some() && near.steps.pop().is_some() {
            if let Ok(node) = node_at(self.view(), &near) {
                return !self.tree().is_done(node);
            }
        }
        self.whole.is_some()
    }

    /// Goes to a ray, or to the nearest of those that lead to it and are there; false if the ray itself is not.
    pub fn go_to_nearest(&mut self, path: &TreePath) -> bool {
        let mut near = path.clone();
        loop {
            if let Ok(node) = node_at(self.view(), &near) {
                self.go(Cursor::at_node(self.tree(), node));
                return near == *path;
            }
            if near.steps.pop().is_none() {
                return false;
            }
        }
    }

    /// Goes to a row of the tree.
    pub fn go_to_row(&mut self, row: usize) {
        let row = row.min(self.rows.len().saturating_sub(1));
        if let Some(row) = self.rows.get(row) {
            self.go(Cursor::at(self.tree(), row.event as usize));
        }
    }

    /// Goes to the ray before or behind the current one that is `by` rays away.
    pub fn go_by_rays(&mut self, by: i32) {
        let count = self.tree().nodes.len();
        let node = self.node().unwrap_or(0).saturating_add_signed(by);
        if count > 0 {
            let node = node.min(count as u32 - 1);
            self.go(Cursor::at_node(self.tree(), node));
        }
    }

    /// Goes `by` traversal steps of the current ray further; from outside of them, to the nearest.
    pub fn go_by_steps(&mut self, by: i32) {
        let Range { start, end } = self.steps;
        if start == end {
            return;
        }
        let here = self.cursor.position();
        let nearest = here.clamp(start, end - 1);
        let by = if nearest == here { by as isize } else { 0 };
        self.go_to_event(nearest.saturating_add_signed(by).clamp(start, end - 1));
    }

    /// Hides or shows what hangs on the current ray; a ray that hides nothing more leads to its parent.
    pub fn fold(&mut self, close: bool) {
        let Some(row) = self.rows.get(self.row()) else {
            return;
        };
        let tree = &self.trace.tree;
        let foldable = self.rows.has_children(row);
        if close && (!foldable || self.rows.is_closed(row)) {
            if let Some(parent) = TreeRows::parent(tree, row) {
                self.go(Cursor::at_node(&self.trace.tree, parent));
            }
            return;
        }
        if !foldable {
            return;
        }
        // On a closed row the current event must be one that it stands for.
        if close {
            self.go(Cursor::at(&self.trace.tree, row.event as usize));
        }
        self.rows.close(row, close);
    }

    /// Shows what hangs on the current ray if it is hidden, else hides it.
    pub fn toggle(&mut self) {
        if let Some(row) = self.rows.get(self.row())
            && self.rows.has_children(row)
        {
            self.fold(!self.rows.is_closed(row));
        }
    }
}
