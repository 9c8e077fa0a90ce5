//! A film as something to look at, a PNG file or text on a terminal, or to measure: a PFM file.

pub mod pfm;
pub mod png;
pub mod text;

pub use text::ColorLevel;
