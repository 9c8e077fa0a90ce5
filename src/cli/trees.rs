//! Ray trees that commands take: those of a pixel of a scene, and those in files.

use std::io::{self, Read as _};
use std::path::Path;

use super::Failure;
use crate::scene::error::Problem;
use crate::scene::printable::shell_word;
use crate::scene::read::files::{regular, unreadable};
use crate::scene::{Settings, is_built_in};
use crate::trace::facts::{PixelFacts, TreePath, pixel_facts};
use crate::trace::read::limits::MAX_TREE_FILE_BYTES;
use crate::trace::read::read_trees;
use crate::trace::{Address, View, document, trace_pixel};
use crate::world::World;

/// Pixels of a file that a message lists.
const LISTED: usize = 8;

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
    let trace = trace_pixel(world, settings, pixel, false);
    let view = View {
        world,
        settings,
        trace: &trace,
    };
    Ok(pixel_facts(&document::of(view)))
}

/// The facts of a pixel in a file: of the only one there if it does not tell its pixel.
pub fn read_file(path: &str, pixel: Option<(u32, u32)>) -> Result<PixelFacts, Failure> {
    let bytes = bytes_of(path).map_err(|problem| Failure::Scene(problem.in_file(path)))?;
    let mut problems = Vec::new();
    let mut trees = Vec::new();
    for tree in read_trees(&bytes, path) {
        match tree {
            Ok(tree) => trees.push(tree),
            Err(error) => problems.push(error.to_string()),
        }
    }
    let only = trees.len() == 1;
    let there = pixels_of(&trees);
    let wanted = |tree: &PixelFacts| match (tree.pixel, pixel) {
        (Some(there), Some(wanted)) => there == wanted,
        _ => only,
    };
    let found = trees.into_iter().find(wanted);
    found.ok_or_else(|| {
        Failure::Input(match (problems.first(), pixel) {
            (Some(problem), _) => problem.clone(),
            (None, Some((x, y))) => format!("{path}: has no tree of pixel {x},{y}; {there}"),
            (None, None) => {
                format!("{path}: has trees of several pixels; name a scene and a pixel: SCENE@X,Y")
            }
        })
    })
}

/// The pixels of which there are trees.
fn pixels_of(trees: &[PixelFacts]) -> String {
    let all: Vec<String> = trees
        .iter()
        .filter_map(|tree| tree.pixel)
        .map(|(x, y)| format!("{x},{y}"))
        .collect();
    match &all[..] {
        [] => "it tells of no pixel".to_owned(),
        [one] => format!("it has that of {one}"),
        all => {
            let more = if all.len() > LISTED {
                " and others"
            } else {
                ""
            };
            let listed = &all[..all.len().min(LISTED)];
            format!("it has those of {}{more}", listed.join("  "))
        }
    }
}

/// The bytes of a regular file, or of standard input; one more than is allowed where there are more. A pipe or a device could be
/// read for ever.
fn bytes_of(path: &str) -> Result<Vec<u8>, Problem> {
    let most = MAX_TREE_FILE_BYTES as u64 + 1;
    let mut bytes = Vec::new();
    if path == "-" {
        let read = io::stdin().lock().take(most).read_to_end(&mut bytes);
        read.map_err(|error| unreadable(&error))?;
        return Ok(bytes);
    }
    let (file, _) = regular(
        Path::new(path),
        ".json, or give its bytes to - for standard input",
    )?;
    let read = file.take(most).read_to_end(&mut bytes);
    read.map_err(|error| unreadable(&error))?;
    Ok(bytes)
}
