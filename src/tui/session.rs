//! An open ray tree: the recorded pixel, the place in its log, and what panes need of it often.

use std::ops::Range;
use std::sync::Arc;

use super::rows::Rows;
use crate::geometry::Aabb;
use crate::math::{DVec3, Ray};
use crate::probe::{Event, RayKind};
use crate::scene::{Scene, Settings};
use crate::trace::{Cursor, Outcome, PixelTrace, RayTree, View, trace_pixel};
use crate::world::World;

/// Rays that the drawing of the path shows at most.
pub const MAX_DRAWN: usize = 2000;

/// The open tree of a pixel.
pub struct Session {
    /// Scene and accelerator.
    pub world: Arc<World>,
    /// As the picture was rendered.
    pub settings: Settings,
    /// The recording.
    pub trace: PixelTrace,
    /// Rows of the tree.
    pub rows: Rows,
    /// A box around all that the drawing of the path shows.
    pub extent: Aabb,
    /// First line of the details that is shown.
    pub scroll: u16,
    cursor: Cursor,
    steps: Range<usize>,
}

impl Session {
    /// Traces a pixel with all steps through the acceleration structure.
    pub fn new(world: Arc<World>, settings: Settings, at: (u32, u32)) -> Self {
        let trace = trace_pixel(&world, &settings, at, true);
        Self::of(world, settings, trace)
    }

    /// The tree of a recording.
    pub fn of(world: Arc<World>, settings: Settings, trace: PixelTrace) -> Self {
        let rows = Rows::new(&trace.tree);
        let mut session = Self {
            world,
            settings,
            trace,
            rows,
            extent: Aabb::EMPTY,
            scroll: 0,
            cursor: Cursor::start(),
            steps: 0..0,
        };
        session.extent = extent(session.view());
        session.go(Cursor::start());
        session
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

    /// The place in the log.
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

    /// The events of the current ray's way through the acceleration structure.
    pub fn steps(&self) -> Range<usize> {
        self.steps.clone()
    }

    /// Goes to a place in the log.
    pub fn go(&mut self, cursor: Cursor) {
        if cursor != self.cursor {
            self.scroll = 0;
        }
        self.cursor = cursor;
        self.rows.reveal(&self.trace.tree, cursor.position());
        let first = self
            .node()
            .map(|n| self.tree().node(n).first_event as usize + 1);
        if self.steps.start != first.unwrap_or(0) {
            self.steps = first.map_or(0..0, |first| steps(self.tree(), first));
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

    /// Hides or shows what hangs on the current ray; a ray that hides nothing more leads to its parent.
    pub fn fold(&mut self, close: bool) {
        let Some(row) = self.rows.get(self.row()) else {
            return;
        };
        let tree = &self.trace.tree;
        let foldable = self.rows.has_children(row);
        if close && (!foldable || self.rows.is_closed(row)) {
            if let Some(parent) = Rows::parent(tree, row) {
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

/// The run of traversal events that begins at `first`.
fn steps(tree: &RayTree, first: usize) -> Range<usize> {
    let is_step = |event: &&Event| matches!(event, Event::Visit(_) | Event::Test { .. });
    let rest = tree.events.get(first..).unwrap_or_default();
    first..first + rest.iter().take_while(is_step).count()
}

/// The least share of the pixel of a ray that the drawing of the path makes room for.
const VISIBLE_SHARE: f64 = 0.01;

/// A box around the paths that matter to the pixel, and around what they hit if that is not much larger. Lights may
/// be far away: rays to them leave the drawing.
fn extent(view: View) -> Aabb {
    let tree = &view.trace.tree;
    let nodes = (0..tree.nodes.len().min(MAX_DRAWN) as u32).filter(|id| {
        let node = tree.node(*id);
        node.ray.kind != RayKind::Light
            && (node.parent.is_none() || view.fraction(*id) >= VISIBLE_SHARE)
    });
    let (mut points, mut met) = (Aabb::EMPTY, Vec::new());
    for id in nodes {
        let node = tree.node(id);
        points = points.union(Aabb::around([node.ray.origin]));
        if let Some(Outcome::Hit(hit)) = node.outcome {
            let ray = Ray::new(node.ray.origin, node.ray.direction);
            points = points.union(Aabb::around([ray.at(hit.t)]));
            met.push(view.world.scene.owners[hit.primitive as usize]);
        }
    }
    met.sort_unstable();
    met.dedup();
    let objects = met
        .into_iter()
        .filter_map(|object| bounds(&view.world.scene, object));
    let near = objects.filter(|bounds| bounds.size().length() < points.size().length());
    let all = near.fold(points, Aabb::union);
    let margin = 0.05 * all.size().length().max(0.1);
    all.padded(DVec3::splat(margin))
}

/// A box around an object; `None` if a part of it has no end.
fn bounds(scene: &Scene, object: u32) -> Option<Aabb> {
    let first = scene.objects.get(object as usize)?.first_primitive as usize;
    let count = scene
        .owners
        .get(first..)?
        .iter()
        .take_while(|o| **o == object)
        .count();
    let mut shapes = scene.shapes.get(first..first + count)?.iter();
    shapes.try_fold(Aabb::EMPTY, |all, shape| Some(all.union(shape.bounds()?)))
}
