//! The tree of the same pixel of another scene, to be compared with the open one.

use std::io::Read as _;
use std::path::Path;

use crate::debug::Session;
use crate::debug::edit::in_one_line;
use crate::grade::pixel_tree;
use crate::scene::read::files::regular;
use crate::scene::{is_built_in, load};
use crate::trace::facts::PixelFacts;
use crate::world::World;

/// Bytes of a scene that is read while the user waits, at most.
const MOST_BYTES: u64 = 4 << 20;

/// The tree of the pixel in the scene that a text names, with that scene's own settings in a picture of the same size; `None` if it
/// names no scene.
pub fn tree(session: &Session, text: &str, folder: &Path) -> Option<Result<PixelFacts, String>> {
    let path = folder.join(text);
    let spec = if is_built_in(text) {
        text
    } else {
        path.to_str()?
    };
    if !is_built_in(text) && !is_scene_file(&path) {
        return None;
    }
    Some(traced(session, spec, &path))
}

fn traced(session: &Session, spec: &str, path: &Path) -> Result<PixelFacts, String> {
    let is_large = !is_built_in(spec) && length(path).is_none_or(|bytes| bytes > MOST_BYTES);
    if is_large || spec.contains(':') {
        return Err("this scene is too large to be compared here; use raytree diff".to_owned());
    }
    let scene = load(spec).map_err(|error| in_one_line(&error))?;
    let scene = scene.with_printable_names();
    let (width, height) = session.settings.size();
    let settings = scene
        .settings
        .with(|s| (s.image.width, s.image.height) = (width, height));
    let world = World::new(scene, settings.accel);
    let at = (session.trace.x, session.trace.y);
    Ok(pixel_tree::traced(&world, &settings, at))
}

/// True if a file is a scene: a model, or JSON that says so. Ray trees are JSON, too.
fn is_scene_file(path: &Path) -> bool {
    let ends_in = |ending| {
        path.extension()
            .is_some_and(|e| e.eq_ignore_ascii_case(ending))
    };
    if ends_in("obj") {
        return true;
    }
    let Some((file, _)) = regular(path, "").ok().filter(|_| ends_in("json")) else {
        return false;
    };
    let mut bytes = Vec::new();
    let format = b"raytree-scene/";
    file.take(MOST_BYTES).read_to_end(&mut bytes).is_ok()
        && bytes.windows(format.len()).any(|part| part == format)
}

fn length(path: &Path) -> Option<u64> {
    regular(path, "").ok().map(|(_, length)| length)
}
