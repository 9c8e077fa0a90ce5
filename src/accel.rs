//! Acceleration structures: which shapes a ray is tested against, and in which order.
//!
//! All accelerators answer alike, bit for bit: the hit with the smallest t, and of equal t the smallest primitive id.
//! They differ only in how many tests they need. `list` tests everything; it is the reference that the others are
//! tested against.
//!
//! `list`, `bsp`, `bsp_sah`, `kd`, `grid`, `octree` and `bvh` are the structures of the textbooks. What makes them fast
//! (single precision, vector instructions, packets of rays) is in `fast`.

mod all_hits;
mod bounded;
mod bsp;
mod bsp_sah;
mod bvh;
mod collect;
mod fast;
mod grid;
mod inspect;
mod kd;
mod kind;
mod list;
mod octree;
mod packets;
mod query;
mod space;
mod tolerance;
mod volume;

pub use all_hits::further_hits;
pub use fast::PACKET_SIZE;
pub use inspect::{AccelStats, NodeView, Progress};
pub use kind::{AccelKind, clearest, fastest};
pub use volume::Volume;

use crate::geometry::{Hit, Shape};
use crate::math::{DVec3, Interval, Ray};
use crate::probe::Probe;
use bsp::Bsp;
use bvh::Bvh;
use collect::{AnyHit, Collect};
use fast::{Bvh8, CompactTree};
use grid::Grid;
use list::List;
use query::Query;

/// An acceleration structure over a scene's primitives.
#[derive(Clone, Debug)]
pub enum Accel {
    /// Test every shape.
    List(List),
    /// Descend a binary tree of planes. The same tree in single precision is for packets of rays.
    Bsp(Bsp, Option<Box<CompactTree>>),
    /// Descend a binary tree of planes in single precision.
    Compact(CompactTree),
    /// Walk from cell to cell.
    Grid(Grid),
    /// Descend a tree of bounding volumes.
    Bvh(Bvh),
    /// Descend a tree of boxes, eight at once.
    Bvh8(Bvh8),
}

impl Accel {
    /// The structure over `shapes`, whose indices become the primitive ids.
    pub fn build(kind: AccelKind, shapes: &[Shape]) -> Self {
        Self::build_with_progress(kind, shapes, &|_| ())
    }

    /// The structure over `shapes`; `progress` is called while it is built.
    pub fn build_with_progress(kind: AccelKind, shapes: &[Shape], progress: Progress) -> Self {
        match kind {
            AccelKind::List => Self::List(List::build(shapes)),
            AccelKind::Kd => Self::Compact(kd::build(shapes, progress)),
            AccelKind::BspSah => Self::Compact(bsp_sah::build(shapes, progress)),
            AccelKind::Grid => Self::Grid(Grid::build(shapes)),
            AccelKind::Octree => Self::Bvh(octree::build(shapes)),
            AccelKind::Bvh => Self::Bvh(bvh::build(shapes, false)),
            AccelKind::BvhSpheres => Self::Bvh(bvh::build(shapes, true)),
            AccelKind::Wide => Self::Bvh8(Bvh8::build(shapes, progress)),
            AccelKind::Bsp | AccelKind::BspAxis | AccelKind::BspPolygon => {
                let tree = Bsp::build(kind, shapes);
                let compact = CompactTree::from_bsp(&tree, shapes).map(Box::new);
                Self::Bsp(tree, compact)
            }
        }
    }

    /// A node of the tree, the root being 0; `None` if there is none of that number.
    pub fn node(&self, id: u32) -> Option<NodeView<'_>> {
        match self {
            Self::List(_) => None,
            Self::Bsp(bsp, _) => bsp.node(id),
            Self::Compact(tree) => tree.node(id),
            Self::Grid(grid) => grid.node(id),
            Self::Bvh(bvh) => bvh.node(id),
            Self::Bvh8(bvh8) => bvh8.node(id),
        }
    }

    /// The splitting plane n.p = d of a node: its normal n and d. `None` for leaves and for a list.
    pub fn plane(&self, id: u32) -> Option<(DVec3, f64)> {
        self.node(id)?.plane
    }

    /// How large the structure is.
    pub fn stats(&self) -> AccelStats {
        match self {
            Self::List(_) => AccelStats::default(),
            Self::Bsp(bsp, compact) => {
                let mut stats = bsp.stats();
                stats.bytes += compact.as_ref().map_or(0, |tree| tree.stats().bytes);
                stats
            }
            Self::Compact(tree) => tree.stats(),
            Self::Grid(grid) => grid.stats(),
            Self::Bvh(bvh) => bvh.stats(),
            Self::Bvh8(bvh8) => bvh8.stats(),
        }
    }

    /// The closest hit of `ray` inside `interval`.
    pub fn closest<P: Probe>(
        &self,
        shapes: &[Shape],
        ray: &Ray,
        interval: Interval,
        probe: &mut P,
    ) -> Option<Hit> {
        let mut closest = None;
        self.search(&self.query(shapes, ray, interval), &mut closest, probe);
        closest
    }

    /// Some hit of `ray` inside `interval`, the first that turns up: all that a shadow ray asks for. Whether there
    /// is one does not depend on the accelerator; which one it is may.
    pub fn any_hit<P: Probe>(
        &self,
        shapes: &[Shape],
        ray: &Ray,
        interval: Interval,
        probe: &mut P,
    ) -> Option<Hit> {
        let mut hit = AnyHit(None);
        self.search(&self.query(shapes, ray, interval), &mut hit, probe);
        hit.0
    }

    /// A hit of `ray` as [`Accel::closest`] or, for shadow rays, [`Accel::any_hit`] finds it, but with the far child of each node
    /// first: for looking at the order only. `None` if the structure is no BSP tree in double precision.
    pub fn hit_far_first<P: Probe>(
        &self,
        shapes: &[Shape],
        (ray, interval): (&Ray, Interval),
        is_shadow: bool,
        probe: &mut P,
    ) -> Option<Option<Hit>> {
        let Self::Bsp(bsp, _) = self else {
            return None;
        };
        let query = Query::new(shapes, ray, interval);
        let (mut closest, mut any) = (None, AnyHit(None));
        if is_shadow {
            bsp.search_far_first(&query, &mut any, probe);
        } else {
            bsp.search_far_first(&query, &mut closest, probe);
        }
        Some(closest.or(any.0))
    }

    /// The ray as the structure's shapes are tested against it.
    #[inline(always)]
    fn query<'a>(&self, shapes: &'a [Shape], ray: &Ray, interval: Interval) -> Query<'a> {
        match self {
            Self::List(list) if !list.needs_view => Query::without_view(shapes, ray, interval),
            _ => Query::new(shapes, ray, interval),
        }
    }

    /// Traverses the structure; `found` decides which hits are wanted.
    #[inline(always)]
    fn search<C: Collect, P: Probe>(&self, query: &Query, found: &mut C, probe: &mut P) {
        match self {
            Self::List(list) => list.search(query, found, probe),
            Self::Bsp(bsp, _) => bsp.search(query, found, probe),
            Self::Compact(tree) => tree.search(query, found, probe),
            Self::Grid(grid) => grid.search(query, found, probe),
            Self::Bvh(bvh) => bvh.search(query, found, probe),
            Self::Bvh8(bvh8) => bvh8.search(query, found, probe),
        }
    }
}
