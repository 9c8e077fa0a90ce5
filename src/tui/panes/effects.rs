//! Panel of effects: which of them the scene calls for, each with its reason, and which are left out all the same.

use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Rect};
use ratatui::style::Stylize as _;
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, BorderType, Clear, Widget};

use super::text::{wrap, write};
use super::theme;
use crate::scene::Settings;
use crate::scene::effects::Finding;
use crate::tui::model::{Model, Overlay, inside};

/// Columns before the reasons: the pointer, the state, the name.
const BEFORE: usize = 1 + 9 + 14;

/// The lines of an effect, for a panel of so many columns.
fn lines(finding: &Finding, settings: &Settings, chosen: bool, width: usize) -> Vec<Line<'static>> {
    let room = width.saturating_sub(BEFORE).max(10);
    let kept = settings.effects.has(finding.effect);
    let mut texts = wrap(&finding.reason, room);
    let state = match (finding.on, kept) {
        (false, _) => Span::styled("off      ", theme::dim()),
        (true, true) => Span::raw("on       "),
        (true, false) => {
            texts.extend(wrap(finding.effect.without(), room));
            Span::styled("left out", theme::warning())
        }
    };
    let gap = 9usize.saturating_sub(state.width());
    let name = format!("{:gap$}{:14}", "", finding.effect.name());
    let pointer = if chosen { theme::POINTER } else { " " };
    let first = [Span::raw(pointer).bold(), state, Span::raw(name).bold()];
    let mut lines = Vec::new();
    for (row, text) in texts.into_iter().enumerate() {
        let mut line = match row {
            0 => Line::from(first.to_vec()),
            _ => Line::raw(format!("{:BEFORE$}", "")),
        };
        line.push_span(text);
        lines.push(line);
    }
    lines
}

/// Draws the effects over everything else, if they are asked for. Where there is little room, the chosen one is in sight.
pub fn draw(model: &Model, screen: Rect, buffer: &mut Buffer) {
    let Some(Overlay::Effects(chosen)) = model.overlay else {
        return;
    };
    let width = screen.width.min(84);
    let room = usize::from(width.saturating_sub(2));
    let each: Vec<_> = model
        .findings
        .iter()
        .enumerate()
        .map(|(i, finding)| lines(finding, &model.settings, i == chosen, room))
        .collect();
    let count: usize = each.iter().map(Vec::len).sum();
    let area = screen.centered(
        Constraint::Length(width),
        Constraint::Length(screen.height.min(count as u16 + 2)),
    );
    Clear.render(area, buffer);
    let title = Line::from(" effects (↓ ↑ choose, Space leaves out, q closes) ").bold();
    Block::bordered()
        .border_type(BorderType::Double)
        .title(title)
        .render(area, buffer);
    let room = inside(area);
    let end: usize = each.iter().take(chosen + 1).map(Vec::len).sum();
    let first = end.saturating_sub(usize::from(room.height));
    let lines = each.iter().flatten().skip(first);
    for (y, line) in (room.y..room.bottom()).zip(lines) {
        write(buffer, room.x, y, line, room.width);
    }
}
