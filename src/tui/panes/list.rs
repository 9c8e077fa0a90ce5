//! List of places over the panes, with one of them chosen.

use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Rect};
use ratatui::style::Stylize as _;
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, BorderType, Clear, Widget};

use super::text::{columns, shortened, wrap, write};
use super::theme;
use crate::tui::model::{Model, Overlay, inside};

/// Columns at most.
const COLUMNS: u16 = 124;

/// Draws the list over everything else, if there is one. The chosen line is in sight.
pub fn draw(model: &Model, screen: Rect, buffer: &mut Buffer) {
    let Some(Overlay::Places(list)) = &model.overlay else {
        return;
    };
    let most = screen.width.min(COLUMNS);
    let head = if list.head.is_empty() {
        Vec::new()
    } else {
        list.head
            .lines()
            .flat_map(|line| wrap(line, usize::from(most.saturating_sub(2))))
            .collect()
    };
    let texts = list.lines.iter().map(|line| columns(&line.text) + 2);
    let texts = texts.chain(head.iter().map(|line| columns(line)));
    let wide = texts.max().unwrap_or(0).max(columns(&list.title) + 34) + 2;
    let width = most.min(wide as u16);
    let height = (list.lines.len() + head.len() + 2).min(usize::from(screen.height));
    let area = screen.centered(Constraint::Length(width), Constraint::Length(height as u16));
    Clear.render(area, buffer);
    let title = format!(
        " {} (↓ ↑ choose, Enter {}, q closes) ",
        list.title,
        list.verb()
    );
    let title = shortened(&title, usize::from(width.saturating_sub(2)));
    Block::bordered()
        .border_type(BorderType::Double)
        .title(Line::from(title).bold())
        .render(area, buffer);
    let room = inside(area);
    // The head makes room where there is little.
    let head_rows = head.len().min(usize::from(room.height / 2)) as u16;
    for (y, line) in (room.y..room.y + head_rows).zip(&head) {
        write(buffer, room.x, y, &Line::raw(line.as_str()), room.width);
    }
    let rows = usize::from(room.height - head_rows);
    let first = (list.chosen + 1).saturating_sub(rows);
    let lines = list.lines.iter().enumerate().skip(first);
    for (y, (number, line)) in (room.y + head_rows..room.bottom()).zip(lines) {
        let chosen = number == list.chosen;
        let pointer = if chosen { theme::POINTER } else { " " };
        let text = Line::from(vec![
            Span::raw(pointer).bold(),
            Span::raw(line.text.as_str()),
        ]);
        write(buffer, room.x, y, &text, room.width);
        if chosen {
            let row = Rect::new(room.x + 1, y, room.width.saturating_sub(1), 1);
            buffer.set_style(row.intersection(buffer.area), theme::current());
        }
    }
}
