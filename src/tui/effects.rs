//! The effects: which of them the scene calls for, each with its reason, and which are left out all the same.

use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Rect};
use ratatui::style::Stylize as _;
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, BorderType, Clear, Widget};

use super::app::{App, Overlay};
use super::details::wrap;
use super::draw::write;
use super::layout::inside;
use super::theme;

/// Columns before the reasons: the pointer, the state, the name.
const BEFORE: usize = 1 + 9 + 14;

impl App {
    /// Shows the effects, or hides them.
    pub fn show_effects(&mut self) {
        self.overlay = match self.overlay {
            Some(Overlay::Effects(_)) => None,
            _ => Some(Overlay::Effects(0)),
        }
    }

    /// Chooses an effect that stands further down, or up.
    pub fn choose_effect(&mut self, by: i32) {
        let last = self.findings.len().saturating_sub(1);
        if let Some(Overlay::Effects(chosen)) = &mut self.overlay {
            *chosen = chosen.saturating_add_signed(by as isize).min(last);
        }
    }

    /// Leaves the chosen effect out, or takes it in again. What the scene does not call for is off anyway.
    pub fn switch_effect(&mut self) {
        let Some(Overlay::Effects(chosen)) = self.overlay else {
            return;
        };
        let Some(finding) = self.findings.get(chosen) else {
            return;
        };
        let (effect, now) = (finding.effect, self.settings.effects);
        if !finding.on {
            let (name, reason) = (effect.name(), &finding.reason);
            self.message = Some(format!("{name} would change nothing: {reason}"));
            return;
        }
        self.settings.effects = if now.has(effect) {
            now.without(effect)
        } else {
            now.with(effect)
        };
        self.redo();
    }

    /// The lines of every effect, for this width.
    fn effect_lines(&self, chosen: usize, width: u16) -> Vec<Vec<Line<'static>>> {
        let room = usize::from(width).saturating_sub(BEFORE).max(10);
        let each = self.findings.iter().enumerate();
        each.map(|(i, finding)| {
            let kept = self.settings.effects.has(finding.effect);
            let mut texts = wrap(&finding.reason, room);
            let state = match (finding.on, kept) {
                (false, _) => Span::styled("off      ", theme::dim()),
                (true, true) => Span::raw("on       "),
                (true, false) => {
                    texts.extend(wrap(finding.effect.without(), room));
                    Span::styled("left out", theme::warning())
                }
            };
            let here = i == chosen;
            let pointer = if here { theme::POINTER } else { " " };
            let mut lines = Vec::new();
            for (row, text) in texts.into_iter().enumerate() {
                let mut line = Line::default();
                if row == 0 {
                    let gap = 9usize.saturating_sub(state.width());
                    line.push_span(Span::raw(pointer).bold());
                    line.push_span(state.clone());
                    let name = format!("{:gap$}{:14}", "", finding.effect.name());
                    line.push_span(Span::raw(name).bold());
                } else {
                    line.push_span(format!("{:BEFORE$}", ""));
                }
                line.push_span(text);
                lines.push(line);
            }
            lines
        })
        .collect()
    }
}

/// Draws the effects over everything else, if they are asked for. Where there is little room, the chosen one is in sight.
pub fn draw(app: &App, screen: Rect, buffer: &mut Buffer) {
    let Some(Overlay::Effects(chosen)) = app.overlay else {
        return;
    };
    let width = screen.width.min(84);
    let each = app.effect_lines(chosen, width.saturating_sub(2));
    let count: usize = each.iter().map(Vec::len).sum();
    let place = screen.centered(
        Constraint::Length(width),
        Constraint::Length(screen.height.min(count as u16 + 2)),
    );
    Clear.render(place, buffer);
    let title = Line::from(" effects (↓ ↑ choose, Space leaves out, q closes) ").bold();
    Block::bordered()
        .border_type(BorderType::Double)
        .title(title)
        .render(place, buffer);
    let room = inside(place);
    let end: usize = each.iter().take(chosen + 1).map(Vec::len).sum();
    let first = end.saturating_sub(usize::from(room.height));
    let lines = each.iter().flatten().skip(first);
    for (y, line) in (room.y..room.bottom()).zip(lines) {
        write(buffer, room.x, y, line, room.width);
    }
}
