//! Scenes from the text of a scene file.

#![allow(dead_code)] // Not every program that includes this file needs all of it.

use raytree::scene::{Scene, SceneError, load_from_memory};

/// The scene that a text describes.
pub fn scene(text: &str) -> Scene {
    read(text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

/// The scene that a text describes, if it does.
pub fn read(text: &str) -> Result<Scene, SceneError> {
    let file = ("test.json".to_string(), text.as_bytes().to_vec());
    load_from_memory("test.json", [file].into())
}
