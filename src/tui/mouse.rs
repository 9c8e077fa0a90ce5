//! What the mouse does: picks pixels, selects rows and steps, scrolls.

use ratatui::layout::Position;

use super::app::App;
use super::layout::{Pane, inside};
use super::{picture_pane, steps_pane, tree_pane};
use crate::trace::Cursor;

/// What was done with the mouse.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mouse {
    /// Pressed.
    Press,
    /// Moved while pressed.
    Drag,
    /// The wheel was turned, down by so many notches.
    Wheel(i32),
}

impl App {
    /// The mouse did something at a place on the screen.
    pub fn point(&mut self, mouse: Mouse, at: Position) {
        self.message = None;
        if self.overlay.is_some() {
            if let Mouse::Wheel(by) = mouse {
                self.scrolls_help(by);
            }
            return;
        }
        let panes = self.panes();
        let Some(pane) = panes.at(at) else {
            return;
        };
        let place = inside(panes.place(pane));
        match (pane, mouse) {
            (Pane::Picture, Mouse::Press | Mouse::Drag) => self.pick(mouse, at),
            (Pane::Picture, Mouse::Wheel(_)) | (_, Mouse::Drag) => {}
            (_, Mouse::Wheel(by)) => {
                self.focus = pane;
                self.by_rows(by);
            }
            (_, Mouse::Press) => {
                self.focus = pane;
                let Some(session) = &mut self.session else {
                    return;
                };
                if !place.contains(at) {
                    return;
                }
                let line = usize::from(at.y - place.y);
                if pane == Pane::Tree {
                    let row = tree_pane::first_row(session, place.height) + line;
                    let again = row == session.row();
                    session.go_to_row(row);
                    if again {
                        session.toggle();
                    }
                } else if pane == Pane::Steps {
                    let step = steps_pane::first_step(session, place.height) + line;
                    if session.steps().contains(&step) {
                        session.go(Cursor::at(session.tree(), step));
                    }
                }
            }
        }
    }

    /// A pixel was clicked: the cursor goes there. A second click opens its tree; if one is open, the first does.
    fn pick(&mut self, mouse: Mouse, at: Position) {
        let placement = picture_pane::placement(self, &self.panes());
        let Some(pixel) = placement.pixel(at) else {
            return;
        };
        let again = pixel == self.picture.cursor && mouse == Mouse::Press;
        self.picture.cursor = pixel;
        self.moved();
        if self.session.is_some() || again {
            self.open();
        }
    }
}
