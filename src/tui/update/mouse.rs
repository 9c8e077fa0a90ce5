//! Mouse: picks pixels, selects rows and steps, scrolls.

use ratatui::layout::Position;

use super::{image, rows};
use crate::debug::horizon::BEHIND;
use crate::tui::model::ask::AskState;
use crate::tui::model::first::{first_row, first_step, step_rows};
use crate::tui::model::{Model, Mouse, Pane, inside};

/// The mouse did something at a cell of the screen.
pub fn point(model: &mut Model, mouse: Mouse, at: Position) {
    model.message = None;
    if model.overlay.is_some() {
        if let Mouse::Wheel(by) = mouse {
            rows::scroll_text(model, by);
        }
        return;
    }
    let Some(pane) = model.panes().at(at) else {
        return;
    };
    match (pane, mouse) {
        (Pane::Picture, Mouse::Press | Mouse::Drag) => pick(model, mouse, at),
        (Pane::Picture, Mouse::Wheel(_)) | (_, Mouse::Drag) => {}
        (_, Mouse::Wheel(by)) => {
            model.layout.focus = pane;
            rows::move_by(model, by);
        }
        (_, Mouse::Press) => {
            // Where the line stands is told by the layout before the click.
            let area = inside(model.panes().area(pane));
            model.layout.focus = pane;
            if area.contains(at) {
                select(model, pane, area.height, usize::from(at.y - area.y));
            }
        }
    }
}

/// A line of a pane of `height` lines was clicked: its row or step becomes the current one. A second click on a row
/// opens or closes it.
fn select(model: &mut Model, pane: Pane, height: u16, line: usize) {
    let Some(session) = &mut model.session else {
        return;
    };
    if pane == Pane::Tree {
        let row = first_row(session, height) + line;
        let again = row == session.row();
        session.go_to_row(row);
        if again {
            session.toggle();
        }
    } else if pane == Pane::Steps {
        let step = first_step(session, height) + line;
        let shown = line < usize::from(step_rows(height));
        if shown && session.steps().contains(&step) {
            session.go_to_event(step);
        }
    }
}

/// A pixel was clicked: the cursor goes there. A second click opens its tree; if one is open, the first does.
fn pick(model: &mut Model, mouse: Mouse, at: Position) {
    let Some(pixel) = model.placement(&model.panes()).pixel(at) else {
        return;
    };
    if model.ask.as_ref().is_some_and(AskState::hides) {
        model.message = Some(BEHIND.to_owned());
        return;
    }
    let again = pixel == model.picture.cursor && mouse == Mouse::Press;
    model.picture.cursor = pixel;
    image::moved(model);
    if model.session.is_some() || again {
        image::open(model);
    }
}
