//! Ray trees that commands take: those of a pixel of a scene, and those in files.

use std::path::Path;

use super::Failure;
use crate::grade::pixel_tree::{self, TreeFileError};
use crate::scene::printable::shell_word;
use crate::scene::{Settings, is_built_in};
use crate::trace::Address;
use crate::trace::facts::{PixelFacts, TreePath};
use crate::world::World;

/// One side of a comparison.
pub enum TreeSource {
    /// A file of ray trees, or - for standard input.
    File(String),
    /// A pixel of a scene.
    Scene {
        /// As on the command line.
        scene: String,
        /// Column and row.
        pixel: (u32, u32),
    },
}

/// A side from its text: `SCENE@X,Y`, or a file.
pub fn parse_side(text: &str) -> Result<TreeSource, Failure> {
    if !text.contains('@') && !Path::new(text).exists() && is_built_in(text) {
        return Err(Failure::Usage(format!(
            "`{text}` is a scene, and trees are compared; name a pixel of it, as in {}@160,120",
            shell_word(text)
        )));
    }
    if !text.contains('@') || Path::new(text).is_file() {
        return Ok(TreeSource::File(text.to_owned()));
    }
    let address: Address = text.parse().map_err(Failure::Usage)?;
    if address.path != TreePath::default() || address.part.is_some() {
        let pixel = format!("{},{}", address.pixel.0, address.pixel.1);
        return Err(Failure::Usage(format!(
            "`{text}` names a part of a tree, and whole trees are compared; end it after {pixel}"
        )));
    }
    Ok(TreeSource::Scene {
        scene: address.scene.unwrap_or_default(),
        pixel: address.pixel,
    })
}

/// The facts of a traced pixel.
pub fn facts_of(
    world: &World,
    settings: &Settings,
    pixel: (u32, u32),
) -> Result<PixelFacts, Failure> {
    let (width, height) = settings.size();
    if pixel.0 >= width || pixel.1 >= height {
        let (x, y) = pixel;
        let what = format!("pixel {x},{y} is outside the picture of {width}x{height} (see --size)");
        return Err(Failure::Usage(what));
    }
    Ok(pixel_tree::traced(world, settings, pixel))
}

/// The facts of a pixel in a file: of the only one there if it does not tell its pixel.
pub fn read_file(path: &str, pixel: Option<(u32, u32)>) -> Result<PixelFacts, Failure> {
    pixel_tree::in_file(path, pixel).map_err(|error| match error {
        TreeFileError::Unread(error) => Failure::Scene(error),
        TreeFileError::Content(what) => Failure::Input(what),
    })
}
