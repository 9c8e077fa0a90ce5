//! Changes of the scene: made in the background, taken back in one order with those of the settings, shown and written.

use std::sync::Arc;
use std::time::Instant;

use super::undo::{check_ready, remember, take};
use super::{caret, image, marks};
use crate::debug::edit::{EditedWorld, kept_effects, told};
use crate::scene::Edit;
use crate::scene::printable::shell_word;
use crate::tui::model::{Job, Model, Overlay, PendingChange, Prompt};

/// Begins to change the scene as it was typed.
pub fn start(model: &mut Model, text: &str) {
    let edits = vec![
        Edit::Patch(model.patch.clone()),
        Edit::Typed(text.to_owned()),
    ];
    ask(model, edits, Some(text.to_owned()));
}

/// Asks for a world that is changed in this way; `typed` is what a user typed for it, none if a change is taken back.
pub fn ask(model: &mut Model, edits: Vec<Edit>, typed: Option<String>) {
    model.changing = Some(PendingChange {
        since: Instant::now(),
        edits,
        typed,
    });
    model.jobs.push(Job::Change);
}

/// Gives up the change that is being made. False if there is none.
pub fn give_up(model: &mut Model) -> bool {
    if model.changing.take().is_none() {
        return false;
    }
    model.jobs.push(Job::CancelChange);
    true
}

/// Takes the last change back, of a setting or of the scene.
pub fn undo(model: &mut Model) {
    if let Err(problem) = check_ready(model) {
        model.message = Some(problem);
        return;
    }
    match model.undone.last() {
        None => model.message = Some("nothing was changed".to_owned()),
        Some((_, patch)) if *patch != model.patch => {
            let edits = vec![Edit::Patch(patch.clone())];
            ask(model, edits, None);
        }
        Some((settings, _)) => {
            let settings = *settings;
            model.undone.pop();
            take(model, settings);
            model.message = Some(TAKEN_BACK.to_owned());
        }
    }
}

const TAKEN_BACK: &str = "the last change is taken back";

/// The scene was changed, or cannot be.
pub fn take_in(model: &mut Model, changed: Result<Box<EditedWorld>, String>) {
    let typed = model.changing.take().and_then(|change| change.typed);
    match (changed, typed) {
        (Ok(edited), Some(_)) if edited.patch == model.patch => {
            model.message = Some("it is so already".to_owned());
        }
        (Ok(edited), typed) => {
            if typed.is_some() {
                remember(model);
            }
            let (before, after) = (&model.world.scene, &edited.world.scene);
            model.settings.effects = kept_effects(&model.settings, before, after);
            model.world = Arc::new(edited.world);
            (model.findings, model.outlines) = (edited.findings, edited.outlines);
            model.patch = edited.patch;
            match (typed, model.undone.last()) {
                (None, Some((settings, _))) => {
                    let settings = *settings;
                    model.undone.pop();
                    take(model, settings);
                    model.message = Some(TAKEN_BACK.to_owned());
                }
                _ => image::redo(model),
            }
        }
        (Err(problem), typed) => {
            model.message = Some(problem);
            if let (Some(text), None) = (typed, &model.overlay) {
                caret::show(model, Prompt::Set, text);
            }
        }
    }
}

/// Shows what is changed.
pub fn show(model: &mut Model) {
    let command = model.open_command();
    let text = told(&model.world.scene, &model.settings, &model.patch, &command);
    model.overlay = Some(Overlay::Report("changes", text, 0));
}

/// Writes the changes of the scene into a new file.
pub fn write(model: &mut Model, path: &str) -> Result<(), String> {
    if model.patch.is_empty() {
        return Err("nothing of the scene is changed: = changes it".to_owned());
    }
    marks::write_new(&model.options.folder.join(path), &model.patch.to_json())?;
    let scene = shell_word(&model.options.scene);
    let patch = shell_word(path);
    model.message = Some(format!(
        "written: raytree view {scene} --patch {patch} opens the scene as it is now"
    ));
    Ok(())
}
