//! Shapes, and where a ray meets them.
//!
//! Finding and describing are two steps: [`Shape::intersect`] says only *where* on the ray, as often as there are
//! candidates; [`Shape::surface`] describes the one point that was chosen.

pub mod aabb;
pub mod arithmetic;
pub mod cuboid;
pub mod disc;
mod edge;
mod intersection;
pub mod patch;
pub mod pieces;
pub mod plane;
pub mod polygon;
pub mod quadric;
pub mod quartic;
mod shape;
pub mod shared_mesh;
mod spans;
pub mod sphere;
#[cfg(test)]
mod test_rays;
pub mod torus;
pub mod triangle;

pub use aabb::Aabb;
pub use arithmetic::{
    Arithmetic, Offset, PatchMethod, Precision, Quadratic, QuarticMethod, TriangleTest,
};
pub use cuboid::Cuboid;
pub use disc::Disc;
pub use intersection::{Hit, Intersection, SurfacePoint};
pub use patch::{BezierSurface, NurbsSurface, PatchArithmetic, PatchCrossing, SurfacePatch};
pub use plane::Plane;
pub use polygon::Polygon;
pub use quadric::{BoxedQuadric, Quadric, QuadricForm, QuadricKind, QuadricSteps, Sheets};
pub use quartic::{Quartic, QuarticSteps};
pub use shape::{
    Body, Csg, CsgCut, CsgCuts, CsgNode, CsgOp, CsgTree, HalfSpace, Naive, Polyhedron, Shape,
    Solid, Transformed,
};
pub use shared_mesh::{MeshSteps, SharedMesh};
pub use spans::{Cut, Span, Spans};
pub use sphere::Sphere;
pub use torus::{Torus, TorusMiss, TorusSteps};
pub use triangle::{Shear, Triangle};
