//! One level back: from what lies on top to the picture, and out.

use super::{convergence, image};
use crate::tui::model::{Job, Model, Request};

/// Closes what lies on top; at the bottom, leaves.
pub fn back(model: &mut Model) {
    if model.overlay.take().is_some() {
        return;
    }
    if model.waiting.take().is_some() {
        model.jobs.push(Job::CancelTrace);
    } else if model.convergence.is_some() {
        convergence::hide(model);
    } else if model.layout.zoom && model.session.is_some() {
        model.layout.zoom = false;
    } else if model.session.take().is_some() {
        image::refit(model);
    } else {
        model.request = Request::Quit;
    }
}
