//! Panel of warnings: what of the scene can hardly be meant, each with its cure.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Stylize as _;
use ratatui::text::{Line, Span};

use super::text::wrap;
use super::{text_box, theme};
use crate::tui::model::{Model, Overlay};

/// How far a cure stands in.
const INDENT: usize = 2;

/// How far the warnings can be scrolled.
pub fn last_scroll(model: &Model, screen: Rect) -> u16 {
    text_box::last_scroll(screen, lines(model, text_box::room(screen, 0)).len())
}

/// All lines: of each warning what is strange, then what to do.
fn lines(model: &Model, width: u16) -> Vec<Line<'static>> {
    let room = usize::from(width).max(INDENT + 10);
    let warnings = model.warnings();
    if warnings.is_empty() {
        return vec![Line::raw("nothing is strange about this scene")];
    }
    let mut lines = Vec::new();
    for warning in warnings {
        let text = warning.to_string();
        let (what, cure) = text.split_once('\n').unwrap_or((&text, ""));
        for (row, part) in wrap(what, room).into_iter().enumerate() {
            let span = Span::raw(part);
            lines.push(Line::from(if row == 0 { span.bold() } else { span }));
        }
        for part in wrap(cure.trim_start(), room - INDENT) {
            lines.push(Line::from(vec![
                Span::raw(" ".repeat(INDENT)),
                Span::styled(part, theme::dim()),
            ]));
        }
    }
    lines
}

/// Draws the warnings over everything else, if they are asked for.
pub fn draw(model: &Model, screen: Rect, buffer: &mut Buffer) {
    let Some(Overlay::Warnings(scroll)) = model.overlay else {
        return;
    };
    let width = text_box::room(screen, 0);
    let lines = lines(model, width);
    text_box::draw("warnings", &lines, (width, scroll), screen, buffer);
}
