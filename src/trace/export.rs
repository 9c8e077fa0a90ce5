//! What a tree document is written as: JSON, text, a page, a Graphviz diagram, a picture, lines. Each is made of the document alone.

mod dot;
mod html;
pub mod json;
mod phrases;
mod ray_lines;
mod svg;
mod text;
mod tree_layout;
pub mod xml;

pub use dot::Dot;
pub use html::Html;
pub use ray_lines::RayLines;
pub use svg::Svg;
pub use text::Text;

use super::document::Document;

/// The title of a diagram.
fn heading(document: &Document) -> String {
    let (pixel, image) = (document.pixel, document.image);
    format!(
        "{}, pixel ({}, {}) of {} x {}",
        document.scene.name, pixel.x, pixel.y, image.width, image.height
    )
}
