//! Image formats of a film: PNG and text on a terminal to look at, PFM to measure.

pub mod pfm;
pub mod png;
pub mod terminal;

pub use terminal::ColorLevel;
