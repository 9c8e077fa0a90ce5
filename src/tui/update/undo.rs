//! What was before each change, of a setting or of the scene.

use std::sync::Arc;

use super::image;
use crate::scene::Settings;
use crate::tui::model::{Before, Model};
use crate::world::World;

/// Changes that can be undone.
const MOST_UNDONE: usize = 1000;

/// An error while a change is being made: the next one would be made to another scene than the user sees.
pub fn check_ready(model: &Model) -> Result<(), String> {
    match model.changing {
        Some(_) => Err("the scene is being changed; Esc gives that up".to_owned()),
        None => Ok(()),
    }
}

/// Keeps what can be gone back to.
pub fn remember(model: &mut Model) {
    if model.undone.len() >= MOST_UNDONE {
        model.undone.remove(0);
    }
    model.undone.push((model.settings, model.patch.clone()));
    model.before = Some(Box::new(Before {
        settings: model.settings,
        patch: model.patch.clone(),
        show: model.show,
        picture: model.picture.clone(),
    }));
}

/// Goes on with these settings.
pub fn take(model: &mut Model, settings: Settings) {
    if settings.accel != model.settings.accel {
        let scene = model.world.scene.clone();
        model.world = Arc::new(World::new(scene, settings.accel));
    }
    // The size belongs to the picture, which may have been fitted to the screen meanwhile.
    let size = model.settings.size();
    model.settings = settings.with(|s| (s.image.width, s.image.height) = size);
    image::redo(model);
}
