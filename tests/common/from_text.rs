//! Scenes from the text of a scene file.

#![allow(dead_code)] // Not every program that includes this file needs all of it.

use raytree::scene::Scene;
pub use raytree::scene::from_json as read;

/// The scene that a text describes.
pub fn scene(text: &str) -> Scene {
    read(text).unwrap_or_else(|error| panic!("{error}: {text}"))
}
