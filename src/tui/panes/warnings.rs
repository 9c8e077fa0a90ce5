//! Panel of warnings: what of the scene can hardly be meant, each with its cure.

use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Rect};
use ratatui::style::Stylize as _;
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, BorderType, Clear, Widget};

use super::text::{wrap, write};
use super::theme;
use crate::tui::model::{Model, Overlay, inside};

/// How far a cure stands in.
const INDENT: usize = 2;

fn area(model: &Model, screen: Rect) -> Rect {
    let width = screen.width.min(84);
    let lines = lines(model, width.saturating_sub(2)).len() as u16;
    screen.centered(
        Constraint::Length(width),
        Constraint::Length(screen.height.min(lines.saturating_add(2))),
    )
}

/// How far the warnings can be scrolled.
pub fn last_scroll(model: &Model, screen: Rect) -> u16 {
    let room = inside(area(model, screen));
    (lines(model, room.width).len() as u16).saturating_sub(room.height)
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
    let area = area(model, screen);
    Clear.render(area, buffer);
    let title = Line::from(" warnings (↓ ↑ scroll, q closes) ").bold();
    Block::bordered()
        .border_type(BorderType::Double)
        .title(title)
        .render(area, buffer);
    let room = inside(area);
    let lines = lines(model, room.width);
    let first = usize::from(scroll.min(last_scroll(model, screen)));
    for (y, line) in (room.y..room.bottom()).zip(lines.iter().skip(first)) {
        write(buffer, room.x, y, line, room.width);
    }
}
