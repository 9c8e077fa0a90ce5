//! A film as something to look at: a PNG file, or text on a terminal.

pub mod png;
pub mod text;

pub use text::ColorLevel;
