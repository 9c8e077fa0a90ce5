//! Checks of what a scene says by itself: what is accepted and can hardly be meant.
//!
//! Each warns only where it is sure. What needs the surfaces in space is checked in `world`.

mod angles;
mod colors;
mod light;
mod materials;

pub use angles::{cone, rotations};
pub use materials::material;

use super::Scene;
use super::read::error::FieldPath;
use super::warning::Warnings;

/// Warns about a whole scene; `path` is that of its file. Its materials are checked by [`material`], where they are read.
pub fn scene(scene: &Scene, path: &FieldPath, warnings: &mut Warnings) {
    angles::field_of_view(scene, path, warnings);
    colors::radiances(scene, path, warnings);
    light::nothing_shines(scene, path, warnings);
    light::of_no_use(scene, path, warnings);
}

/// A number as a message shows it: four digits behind the point at most.
fn short(x: f64) -> String {
    if x.abs() < 1e6 {
        format!("{}", (x * 1e4).round() / 1e4)
    } else {
        format!("{x:e}")
    }
}

/// Colour as a file writes it.
fn written([r, g, b]: [f64; 3]) -> String {
    format!("[{}, {}, {}]", short(r), short(g), short(b))
}
