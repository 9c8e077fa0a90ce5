//! The tracer: one function, two doors.
//!
//! [`render()`] follows the rays of every pixel and listens to nothing; [`pixel()`] with a recording probe follows the
//! rays of one pixel and writes them down. Both go through [`whitted`].

pub mod area;
pub mod around;
pub mod film;
pub mod foresight;
pub mod lights;
pub mod picture;
pub mod pixel;
pub mod sampled;
pub mod samples;
pub mod shadow;
pub mod spread;
pub mod stack;
pub mod tile;
pub mod whitted;

pub use film::{Film, Flow, Spoiled, render};
pub use pixel::{Pixel, pixel, pixel_unless};
pub use stack::on_threads;
