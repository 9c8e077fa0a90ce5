//! The ray tree of a pixel as facts: traced by us, or read from a file.

use std::io::{self, Read as _};
use std::path::Path;

use thiserror::Error;

use crate::scene::Settings;
use crate::scene::error::{Problem, SceneError};
use crate::scene::read::files::{regular, unreadable};
use crate::trace::facts::{PixelFacts, pixel_facts};
use crate::trace::read::limits::MAX_TREE_FILE_BYTES;
use crate::trace::read::read_trees;
use crate::trace::{PixelTrace, View, document, trace_pixel, trace_pixel_here};
use crate::world::World;

/// Pixels of a file that a message lists.
const LISTED: usize = 8;

/// Why a file gives no tree.
#[derive(Debug, Error)]
pub enum TreeFileError {
    /// It cannot be read.
    #[error(transparent)]
    Unread(SceneError),
    /// Something in it is wrong, or the tree is not there.
    #[error("{0}")]
    Content(String),
}

/// Our tree of a pixel, traced on a thread whose stack is deep enough.
pub fn traced(world: &World, settings: &Settings, at: (u32, u32)) -> PixelFacts {
    facts(world, settings, &trace_pixel(world, settings, at, false))
}

/// Our tree of a pixel, traced on this thread: one of a pool of `tracer::thread_pool`.
pub fn traced_here(world: &World, settings: &Settings, at: (u32, u32)) -> PixelFacts {
    let trace = trace_pixel_here(world, settings, at, false);
    facts(world, settings, &trace)
}

fn facts(world: &World, settings: &Settings, trace: &PixelTrace) -> PixelFacts {
    pixel_facts(&document::of(View {
        world,
        settings,
        trace,
    }))
}

/// The tree of a pixel in a file, or in standard input (-): of the only pixel there if the file or we do not tell which.
pub fn in_file(path: &str, pixel: Option<(u32, u32)>) -> Result<PixelFacts, TreeFileError> {
    let bytes = bytes_of(path).map_err(|problem| TreeFileError::Unread(problem.in_file(path)))?;
    let trees = read_trees(&bytes, path);
    let mut problem = None;
    let mut found = Vec::new();
    for tree in trees {
        match tree {
            Ok(tree) => found.push(tree),
            Err(error) => problem = problem.or(Some(error.to_string())),
        }
    }
    let (only, there) = (found.len() == 1, pixels_of(&found));
    let is_it = |tree: &PixelFacts| match (tree.pixel, pixel) {
        (Some(there), Some(wanted)) => there == wanted,
        _ => only,
    };
    let missing = || match pixel {
        Some((x, y)) => format!("{path}: has no tree of pixel {x},{y}; {there}"),
        None => format!("{path}: has trees of several pixels; name a scene and a pixel: SCENE@X,Y"),
    };
    let tree = found.into_iter().find(is_it);
    tree.ok_or_else(|| TreeFileError::Content(problem.unwrap_or_else(missing)))
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
    let read = if path == "-" {
        io::stdin().lock().take(most).read_to_end(&mut bytes)
    } else {
        let instead = ".json, or give its bytes to - for standard input";
        let (file, _) = regular(Path::new(path), instead)?;
        file.take(most).read_to_end(&mut bytes)
    };
    read.map_err(|error| unreadable(&error))?;
    Ok(bytes)
}
