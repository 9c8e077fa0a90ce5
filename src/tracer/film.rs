//! The whole picture: a buffer of pixels, and its rendering, tile by tile, on all cores.

pub mod buffer;
mod cut_share;
pub mod render;
pub mod thread_pool;
mod tile_pass;

pub use buffer::{Film, NonFinite};
pub use cut_share::CutShare;
pub use render::{draw, render};
