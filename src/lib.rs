//! raytree: a ray tracer that keeps the answer to "why does this pixel have this colour?".
//!
//! The same function that draws the picture explains it: [`tracer::render`] follows every pixel's rays silently,
//! [`trace::trace_pixel`] follows one pixel's rays again and writes down what happens. The layers, from the ground
//! up, are the modules below; each uses only those before it.

pub mod math;

pub mod sampling;

pub mod geometry;

pub mod probe;

pub mod accel;

pub mod shading;

pub mod scene;

pub mod tracer;

pub mod trace;

pub mod lab;

pub mod debug;

pub mod cli;

pub mod tui;
pub mod world;
