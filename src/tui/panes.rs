//! View: draws the model, and only reads it.

pub mod ask;
pub mod bars;
pub mod convergence;
pub mod details;
pub mod effects;
pub mod help;
pub mod hints;
pub mod list;
pub mod paths;
pub mod picture;
pub mod report;
pub mod screen;
pub mod steps;
pub mod text;
pub mod text_box;
pub mod theme;
pub mod tree;
pub mod warnings;
pub mod watches;

pub use screen::draw;
