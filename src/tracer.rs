//! The tracer: one function, two doors.
//!
//! [`render()`] follows the rays of every pixel and listens to nothing; [`pixel()`] with a recording probe follows the
//! rays of one pixel and writes them down. Both go through [`whitted`].

pub mod around;
mod direct;
pub mod film;
pub mod light_sampler;
pub mod path_id;
pub mod picture;
pub mod pixel;
pub mod sampled;
pub mod samples;
pub mod shadow_batch;
pub mod spread;
pub mod stack;
mod tell;
pub mod tile;
pub mod tile_batch;
pub mod whitted;

pub use film::{Film, Flow, Spoiled, render};
pub use pixel::{Pixel, pixel, pixel_unless};
pub use stack::on_threads;
