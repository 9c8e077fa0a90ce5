//! Built-in scenes: those in files inside the program, those that are computed, and the scene around a bare model.

pub mod builder;
pub mod builtin;
mod lecture;
pub mod model_scene;
pub mod procedural;
mod slanted;
mod spd;
