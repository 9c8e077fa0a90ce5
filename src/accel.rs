//! Which shapes to test, and in which order.
//!
//! All accelerators answer alike, bit for bit: the hit with the smallest t, and of equal t the smallest primitive id.
//! They differ only in how many tests they need. [`List`] tests everything; it is the slow twin that the others are
//! tested against.

mod auto;
mod boxes;
pub mod bsp;
mod bvh;
pub mod crossings;
mod filter;
pub mod grid;
mod kd;
mod lanes;
pub mod list;
mod local;
mod oblique;
mod octree;
mod packet;
pub mod planes;
mod sift;
mod simd;
mod slack;
pub mod wide;

pub use auto::{clearest, fastest};
pub use boxes::Boxes;
pub use bsp::Bsp;
pub use grid::Grid;
pub use list::List;
pub use packet::RAYS;
pub use planes::Planes;
pub use wide::Wide;

use crate::geometry::{Hit, Intersection, Shape, Shear};
use crate::math::{DVec3, Interval, Ray};
use crate::probe::{Event, Probe, Verdict, tell};

/// Is told from time to time which part of a structure stands, from 0 to 1: by those that are built part by part, `kd`
/// and `wide` of large scenes.
pub type Watch<'a> = &'a (dyn Fn(f64) + Sync);

/// Which accelerator to build.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AccelKind {
    /// Test every shape.
    List,
    /// A BSP tree; which planes split is decided by the scene.
    #[default]
    Bsp,
    /// A BSP tree split along the axes by the surface area heuristic.
    BspAxis,
    /// A BSP tree split by the planes of the scene's own polygons, as in the lectures.
    BspPolygon,
    /// A BSP tree split by planes along the axes or at any angle, by the surface area heuristic.
    BspSah,
    /// A kd-tree: the best planes along the axes that there are.
    Kd,
    /// A grid of cells.
    Grid,
    /// An octree.
    Octree,
    /// A binary tree of boxes.
    Bvh,
    /// The same tree of spheres.
    BvhSpheres,
    /// A tree of boxes, eight to a node: the fast one.
    Wide,
}

impl AccelKind {
    /// Every kind.
    pub const ALL: [Self; 11] = [
        Self::List,
        Self::Bsp,
        Self::BspAxis,
        Self::BspPolygon,
        Self::BspSah,
        Self::Kd,
        Self::Grid,
        Self::Octree,
        Self::Bvh,
        Self::BvhSpheres,
        Self::Wide,
    ];

    /// Its name on the command line and in JSON.
    pub fn name(self) -> &'static str {
        self.words().0
    }

    /// What it does, in a line.
    pub fn note(self) -> &'static str {
        self.words().1
    }

    fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::List => ("list", "Test every shape"),
            Self::Bsp => ("bsp", "A BSP tree; the scene decides which planes split"),
            Self::BspAxis => ("bsp-axis", "A BSP tree split along the axes"),
            Self::BspPolygon => (
                "bsp-polygon",
                "A BSP tree split by the scene's own polygons",
            ),
            Self::BspSah => ("bsp-sah", "A BSP tree: the best planes at any angle"),
            Self::Kd => ("kd", "A kd-tree: the best planes along the axes"),
            Self::Grid => ("grid", "A uniform grid of cells"),
            Self::Octree => ("octree", "An octree: cubes halved along all axes"),
            Self::Bvh => ("bvh", "A binary tree of boxes"),
            Self::BvhSpheres => (
                "bvh-spheres",
                "The same tree of spheres, to see why boxes win",
            ),
            Self::Wide => ("wide", "A tree of boxes, eight to a node: the fast one"),
        }
    }
}

/// An acceleration structure over a scene's primitives.
#[derive(Clone, Debug)]
pub enum Accel {
    /// Test every shape.
    List(List),
    /// Descend a tree of planes.
    Bsp(Bsp),
    /// Descend a tree of planes, for speed.
    Planes(Planes),
    /// Walk from cell to cell.
    Grid(Grid),
    /// Descend a tree of bounding volumes.
    Boxes(Boxes),
    /// Descend a tree of boxes, eight at once.
    Wide(Wide),
}

/// A node of a tree, for readers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodeView<'a> {
    /// The splitting plane n.p = d as (n, d), n unit, in world space; `None` for a leaf.
    pub plane: Option<(DVec3, f64)>,
    /// The axis that the plane's normal is, if it is one.
    pub axis: Option<usize>,
    /// The children in front of the plane (where n points) and behind it; `None` for a leaf.
    pub children: Option<[u32; 2]>,
    /// The primitives of a leaf, or those that lie on the plane.
    pub primitives: &'a [u32],
}

/// How large an acceleration structure is; all zero for the list.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AccelStats {
    /// Nodes, leaves included.
    pub nodes: usize,
    /// Nodes that are leaves.
    pub leaves: usize,
    /// Nodes that are split by a polygon's own plane, or by one through its edge.
    pub polygon_planes: usize,
    /// Planes on the longest way down.
    pub depth: u32,
    /// How often a primitive is referred to.
    pub references: usize,
    /// Memory.
    pub bytes: usize,
}

/// A ray with what is computed once for all the tests that it goes through.
#[derive(Clone, Copy, Debug)]
pub struct Query<'a> {
    shapes: &'a [Shape],
    /// The ray.
    pub ray: Ray,
    shear: Shear,
    /// The part of it that counts.
    pub interval: Interval,
}

impl Accel {
    /// Builds the structure over `shapes`, whose indices become the primitive ids.
    pub fn build(kind: AccelKind, shapes: &[Shape]) -> Self {
        Self::build_watched(kind, shapes, &|_| ())
    }

    /// The same under the eyes of somebody who waits for it.
    pub fn build_watched(kind: AccelKind, shapes: &[Shape], watch: Watch) -> Self {
        match kind {
            AccelKind::List => Self::List(List::build(shapes)),
            AccelKind::Kd => Self::Planes(kd::build(shapes, watch)),
            AccelKind::BspSah => Self::Planes(oblique::build(shapes, watch)),
            AccelKind::Grid => Self::Grid(Grid::build(shapes)),
            AccelKind::Octree => Self::Boxes(octree::build(shapes)),
            AccelKind::Bvh => Self::Boxes(bvh::build(shapes, false)),
            AccelKind::BvhSpheres => Self::Boxes(bvh::build(shapes, true)),
            AccelKind::Wide => Self::Wide(Wide::build(shapes, watch)),
            _ => Self::Bsp(Bsp::build(kind, shapes)),
        }
    }

    /// A node of the tree, the root being 0; `None` if there is none of that number.
    pub fn node(&self, id: u32) -> Option<NodeView<'_>> {
        match self {
            Self::List(_) => None,
            Self::Bsp(bsp) => bsp.node(id),
            Self::Planes(planes) => planes.node(id),
            Self::Grid(grid) => grid.node(id),
            Self::Boxes(boxes) => boxes.node(id),
            Self::Wide(wide) => wide.node(id),
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
            Self::Bsp(bsp) => bsp.stats(),
            Self::Planes(planes) => planes.stats(),
            Self::Grid(grid) => grid.stats(),
            Self::Boxes(boxes) => boxes.stats(),
            Self::Wide(wide) => wide.stats(),
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
        let query = Query::new(shapes, ray, interval);
        match self {
            Self::List(list) => list.closest(&query, probe),
            Self::Bsp(bsp) => bsp.closest(&query, probe),
            Self::Planes(planes) => planes.closest(&query, probe),
            Self::Grid(grid) => grid.search::<false, P>(&query, probe),
            Self::Boxes(boxes) => boxes.search::<false, P>(&query, probe),
            Self::Wide(wide) => wide.closest(&query, probe),
        }
    }

    /// Some hit of `ray` inside `interval`, the first that turns up: all that a shadow ray asks for. Whether there
    /// is one does not depend on the accelerator; which one it is may.
    pub fn any<P: Probe>(
        &self,
        shapes: &[Shape],
        ray: &Ray,
        interval: Interval,
        probe: &mut P,
    ) -> Option<Hit> {
        let query = Query::new(shapes, ray, interval);
        match self {
            Self::List(list) => list.any(&query, probe),
            Self::Bsp(bsp) => bsp.any(&query, probe),
            Self::Planes(planes) => planes.any(&query, probe),
            Self::Grid(grid) => grid.search::<true, P>(&query, probe),
            Self::Boxes(boxes) => boxes.search::<true, P>(&query, probe),
            Self::Wide(wide) => wide.any(&query, probe),
        }
    }
}

impl<'a> Query<'a> {
    /// Prepares `ray` for tests against `shapes`.
    #[inline]
    pub fn new(shapes: &'a [Shape], ray: &Ray, interval: Interval) -> Self {
        Self {
            shapes,
            ray: *ray,
            shear: Shear::new(ray),
            interval,
        }
    }

    /// Tests primitives in order; true if no more need be: any hit will do and there is one.
    #[inline]
    pub fn test_all<const ANY: bool, P: Probe>(
        &self,
        primitives: &[u32],
        best: &mut Option<Hit>,
        probe: &mut P,
    ) -> bool {
        for &primitive in primitives {
            self.test(primitive, best, probe);
            if ANY && best.is_some() {
                return true;
            }
        }
        false
    }

    /// Tests one primitive; if it is hit closer than `best`, or as close with a smaller id, it becomes the best.
    #[inline]
    pub fn test<P: Probe>(&self, primitive: u32, best: &mut Option<Hit>, probe: &mut P) {
        let shape = &self.shapes[primitive as usize];
        let found = shape.intersect(&self.ray, &self.shear, self.interval);
        let (verdict, t) = match found {
            Intersection::Hit { t, barycentric } => {
                let closer = best.is_none_or(|b| (t, primitive) < (b.t, b.primitive));
                if closer {
                    let hit = Hit {
                        t,
                        primitive,
                        barycentric,
                    };
                    if P::EVERY {
                        probe.crossing(hit);
                    } else {
                        *best = Some(hit);
                    }
                    (Verdict::Hit, t)
                } else {
                    (Verdict::TooFar, t)
                }
            }
            Intersection::Behind(t) => (Verdict::Behind, t),
            Intersection::TooFar(t) => (Verdict::TooFar, t),
            Intersection::Miss => (Verdict::Miss, f64::NAN),
        };
        if P::TRAVERSAL {
            tell!(
                probe,
                Event::Test {
                    primitive,
                    verdict,
                    t,
                }
            );
        }
    }
}
