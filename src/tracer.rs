//! The tracer: one function, two doors.
//!
//! [`render()`] follows the rays of every pixel and listens to nothing; [`pixel()`] with a recording probe follows the
//! rays of one pixel and writes them down. Both go through [`whitted`].

pub mod by_laws;
pub mod corners;
mod direct;
pub mod film;
pub mod image;
pub mod laws;
pub mod light_sampler;
pub mod path_id;
pub mod pixel;
pub mod shadow_batch;
mod state;
pub mod tile;
pub mod tile_batch;
pub mod whitted;

pub use film::{CutShare, Film, NonFinite, draw, render, thread_pool};
pub use pixel::{Pixel, PixelEstimator, pixel};
