//! Text over the panes, which scrolls: warnings, differences.

use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Rect};
use ratatui::style::Stylize as _;
use ratatui::text::Line;
use ratatui::widgets::{Block, BorderType, Clear, Widget};

use super::text::write;
use crate::tui::model::inside;

/// Columns of the box at most.
const COLUMNS: u16 = 84;

/// The columns that a text has on a screen.
pub fn room(screen: Rect, most: u16) -> u16 {
    screen.width.min(most.max(COLUMNS)).saturating_sub(2)
}

/// How far a text of so many lines can be scrolled.
pub fn last_scroll(screen: Rect, lines: usize) -> u16 {
    (lines as u16).saturating_sub(screen.height.saturating_sub(2))
}

/// Draws lines of at most `width` columns from line `scroll` on.
pub fn draw(
    title: &str,
    lines: &[Line],
    (width, scroll): (u16, u16),
    screen: Rect,
    buffer: &mut Buffer,
) {
    let height = (lines.len() as u16).saturating_add(2);
    let area = screen.centered(
        Constraint::Length(width.saturating_add(2)),
        Constraint::Length(screen.height.min(height)),
    );
    Clear.render(area, buffer);
    let title = Line::from(format!(" {title} (↓ ↑ scroll, q closes) ")).bold();
    Block::bordered()
        .border_type(BorderType::Double)
        .title(title)
        .render(area, buffer);
    let room = inside(area);
    let first = usize::from(scroll.min(last_scroll(screen, lines.len())));
    for (y, line) in (room.y..room.bottom()).zip(lines.iter().skip(first)) {
        write(buffer, room.x, y, line, room.width);
    }
}
