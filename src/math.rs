//! The conventions that everything else stands on.
//!
//! Space is right-handed with y up; lengths are metres, angles radians (degrees only in scene files and in what a
//! user reads). Colours are linear RGB radiance. All numbers are `f64`. Elementary functions come from `libm`, so
//! that a ray tree has the same bits on every machine.

pub mod frame;
pub mod interval;
pub mod polynomial;
pub mod ray;
pub mod rgb;
pub mod rounding;
pub mod srgb;
pub mod transform;

pub use frame::Frame;
pub use glam::{DVec2, DVec3};
pub use interval::Interval;
pub use ray::Ray;
pub use rgb::Rgb;
pub use transform::Transform;
