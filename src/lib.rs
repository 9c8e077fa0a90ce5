//! raytree: a ray tracer that keeps the answer to "why does this pixel have this colour?".
//!
//! The same function that draws the picture explains it: [`tracer::draw`] follows every pixel's rays silently,
//! [`trace::trace_pixel`] follows one pixel's rays again and writes down what happens. `examples/` has a program for each.
//!
//! What others build on are the modules [`scene`], [`world`], [`tracer`] and [`trace`], with the numbers of [`math`]. The rest is
//! public for the tests and the benches, and changes without notice. The modules stand here from the ground up; each uses only
//! those before it.

#[doc(hidden)]
pub mod accel;
#[doc(hidden)]
pub mod cli;
#[doc(hidden)]
pub mod debug;
#[doc(hidden)]
pub mod geometry;
#[doc(hidden)]
pub mod grade;
#[doc(hidden)]
pub mod lab;
pub mod lesson;
pub mod math;
#[doc(hidden)]
pub mod probe;
#[doc(hidden)]
pub mod reduce;
#[doc(hidden)]
pub mod sampling;
pub mod scene;
#[doc(hidden)]
pub mod shading;
pub mod trace;
pub mod tracer;
#[doc(hidden)]
pub mod tui;
pub mod world;
