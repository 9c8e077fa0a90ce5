//! Two pictures in turn: this one, and the one before the last change; or how far they are apart.

use super::edit;
use super::undo::{check_ready, remember, take};
use crate::scene::Edit;
use crate::tui::model::Model;

/// What is said where there is one picture only.
const ALONE: &str = "there is no other picture: = changes something";

/// Shows the picture before the last change in the place of this one; once more, this one again.
pub fn flip(model: &mut Model) {
    if let Err(problem) = check_ready(model) {
        model.message = Some(problem);
        return;
    }
    let Some(before) = model.before.take() else {
        model.message = Some(ALONE.to_owned());
        return;
    };
    if before.patch != model.patch {
        let edits = vec![Edit::Patch(before.patch.clone())];
        model.before = Some(before);
        edit::ask(model, edits, Some(String::new()));
        return;
    }
    remember(model);
    take(model, before.settings);
    if before.show == model.show {
        model.picture.adopt(&before.picture);
    }
    model.message = Some(model.open_command());
}

/// Shows how far the picture is from the one before the last change, or the picture again.
pub fn difference(model: &mut Model) {
    match &model.before {
        None => model.message = Some(ALONE.to_owned()),
        Some(before) if before.show != model.show => {
            let told = "the other picture showed something else: s goes through what there is";
            model.message = Some(told.to_owned());
        }
        Some(_) => model.is_difference = !model.is_difference,
    }
}
