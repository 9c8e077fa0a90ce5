//! Convergence of the pixel under the cursor: shown, hidden, begun anew.

use crate::debug::Convergence;
use crate::debug::convergence::has_chance;
use crate::tui::model::{Job, Model};

/// Shows the convergence, or hides it.
pub fn show_or_hide(model: &mut Model) {
    if model.convergence.is_some() {
        return hide(model);
    }
    model.convergence = Some(Convergence::default());
    restart(model);
}

/// Hides it.
pub fn hide(model: &mut Model) {
    model.convergence = None;
    model.jobs.push(Job::CancelConverge);
}

/// Begins anew if it is shown: the pixel or the settings are others.
pub fn restart(model: &mut Model) {
    if model.convergence.is_none() {
        return;
    }
    if !has_chance(&model.world, &model.settings) {
        hide(model);
        model.message = Some(
            "nothing is left to chance here: one sample a pixel and no area light (try --samples 4)"
                .to_owned(),
        );
        return;
    }
    model.convergence = Some(Convergence::default());
    model.jobs.push(Job::Converge);
}
