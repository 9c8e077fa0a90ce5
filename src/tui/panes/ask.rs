//! Question beside the panes: its text, the hints that are shown, what is typed, what came of it.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::style::Stylize as _;
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, BorderType, Clear, Widget};

use super::text::{arrows, shortened, write};
use super::theme;
use crate::tui::model::ask::AskState;
use crate::tui::model::ask_lines::{AskPart, ask_lines};
use crate::tui::model::inside;

/// Draws it. Where there is no room for all lines, the last ones are seen: there the answer is given.
pub fn draw(ask: &AskState, area: Rect, buffer: &mut Buffer) {
    if area.height < 3 || area.width < 3 {
        return;
    }
    Clear.render(area, buffer);
    let title = match &ask.told {
        None => "before the answer",
        Some(told) if told.is_right => "right",
        Some(_) => "not yet",
    };
    let title = format!(" {title}: {} ", ask.title);
    let title = shortened(&title, usize::from(area.width.saturating_sub(2)));
    let mut block = Block::bordered()
        .border_type(BorderType::Double)
        .title(Line::from(title).bold());
    if !ask.remark.is_empty() {
        let remark = format!(" {} ", ask.remark);
        let remark = shortened(&remark, usize::from(area.width.saturating_sub(4)));
        block = block.title_bottom(Line::from(remark).style(theme::dim()));
    }
    block.render(area, buffer);
    let room = inside(area);
    let lines = ask_lines(ask, room.width);
    let first = lines.len().saturating_sub(usize::from(room.height));
    for (y, (part, text)) in (room.y..room.bottom()).zip(lines.into_iter().skip(first)) {
        let line = Line::from(Span::styled(text, style(part)));
        write(buffer, room.x, y, &line, room.width);
    }
    arrows(buffer, room, first > 0, false);
}

fn style(part: AskPart) -> Style {
    match part {
        AskPart::Question | AskPart::Typed => Style::new().bold(),
        AskPart::Hint => theme::dim(),
        AskPart::Verdict => theme::warning(),
        AskPart::Told | AskPart::Choice => Style::new(),
    }
}
