//! Moves by rows of the focused pane, and scrolling of the help and the warnings.

use crate::debug::horizon::BEHIND;
use crate::tui::model::layout::covered;
use crate::tui::model::{Model, Overlay, Pane, inside};
use crate::tui::panes::{details, help, report, warnings, watches};

/// Goes down (up, if negative) by so many rows of the focused pane.
pub fn move_by(model: &mut Model, by: i32) {
    let mut details = inside(model.panes().details);
    details.height -= watches::rows(model, details.height);
    let Some(session) = &mut model.session else {
        return;
    };
    let before = session.cursor();
    match model.layout.focus {
        Pane::Tree | Pane::Picture => {
            let row = session.row().saturating_add_signed(by as isize);
            session.go_to_row(row);
        }
        Pane::Details => {
            let lines = details::lines(session, model.options.color, details.width).len();
            let last = lines.saturating_sub(usize::from(details.height)) as u16;
            let scroll = &mut model.layout.scroll;
            *scroll = scroll.saturating_add_signed(by as i16).min(last);
        }
        Pane::Steps => session.go_by_steps(by),
        Pane::Path => session.go_by_rays(by),
    }
    let stays = session.cursor() == before && model.layout.focus != Pane::Details;
    if stays && by > 0 && session.horizon().is_some() {
        model.message = Some(BEHIND.to_owned());
    }
}

/// Scrolls the help or the warnings. False if neither is shown.
pub fn scroll_text(model: &mut Model, by: i32) -> bool {
    let screen = covered(model.layout.screen);
    let last = match &model.overlay {
        Some(Overlay::Help(_)) => help::last_scroll(screen),
        Some(Overlay::Report(_, text, _)) => report::last_scroll(text, screen),
        _ => warnings::last_scroll(model, screen),
    };
    let Some(Overlay::Help(scroll) | Overlay::Warnings(scroll) | Overlay::Report(_, _, scroll)) =
        &mut model.overlay
    else {
        return false;
    };
    *scroll = scroll.saturating_add_signed(by as i16).min(last);
    true
}
