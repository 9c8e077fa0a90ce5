//! Shapes, and where a ray meets them.
//!
//! Finding and describing are two steps: [`Shape::intersect`] says only *where* on the ray, as often as there are
//! candidates; [`Shape::surface`] describes the one point that was chosen.

pub mod aabb;
pub mod arithmetic;
pub mod cuboid;
pub mod disc;
mod intersection;
pub mod plane;
mod shape;
pub mod sphere;
pub mod triangle;

pub use aabb::Aabb;
pub use arithmetic::{Arithmetic, Offset, Precision, Quadratic, TriangleTest};
pub use cuboid::Cuboid;
pub use disc::Disc;
pub use intersection::{Hit, Intersection, SurfacePoint};
pub use plane::Plane;
pub use shape::{Naive, Shape, Transformed};
pub use sphere::Sphere;
pub use triangle::{Shear, Triangle};
