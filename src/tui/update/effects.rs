//! Panel of effects: shown, chosen, switched.

use super::image;
use super::undo::{check_ready, remember};
use crate::debug::effects::switched;
use crate::tui::model::{Model, Overlay};

/// Shows the effects, or hides them.
pub fn show_or_hide(model: &mut Model) {
    model.overlay = match model.overlay {
        Some(Overlay::Effects(_)) => None,
        _ => Some(Overlay::Effects(0)),
    }
}

/// Chooses an effect that stands further down, or up.
pub fn choose(model: &mut Model, by: i32) {
    let last = model.findings.len().saturating_sub(1);
    if let Some(Overlay::Effects(chosen)) = &mut model.overlay {
        *chosen = chosen.saturating_add_signed(by as isize).min(last);
    }
}

/// Leaves the chosen effect out, or takes it in again, and renders anew.
pub fn switch(model: &mut Model) {
    let Some(Overlay::Effects(chosen)) = model.overlay else {
        return;
    };
    let Some(finding) = model.findings.get(chosen) else {
        return;
    };
    match switched(model.settings.effects, finding) {
        Ok(effects) => {
            if let Err(problem) = check_ready(model) {
                model.message = Some(problem);
                return;
            }
            remember(model);
            model.settings.effects = effects;
            image::redo(model);
        }
        Err(message) => model.message = Some(message),
    }
}
