//! Help: the table of keys, and what the letters mean.

use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Rect};
use ratatui::style::Stylize as _;
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, BorderType, Clear, Widget};

use super::text::{wrap, write};
use super::theme;
use crate::probe::RayKind;
use crate::tui::model::bindings::ACTIONS;
use crate::tui::model::{Context, Model, Overlay, inside};

/// Columns of the keys.
const KEYS: usize = 18;

fn area(screen: Rect) -> Rect {
    let width = screen.width.min(84);
    let lines = lines(width.saturating_sub(2)).len() as u16;
    screen.centered(
        Constraint::Length(width),
        Constraint::Length(screen.height.min(lines + 2)),
    )
}

/// How far the help can be scrolled.
pub fn last_scroll(screen: Rect) -> u16 {
    let room = inside(area(screen));
    (lines(room.width).len() as u16).saturating_sub(room.height)
}

/// All lines of the help, for this width.
pub fn lines(width: u16) -> Vec<Line<'static>> {
    let mut lines = vec![letters()];
    let sections = [
        (Context::Picture, "Choosing a pixel"),
        (Context::Tree, "In the ray tree"),
        (Context::Question, "Before a question of a lesson"),
        (Context::Prompt, "Typing a place or a query"),
        (Context::Effects, "Among the effects"),
        (Context::Places, "In a list"),
        (Context::Text, "In a text over the panes"),
        (Context::Always, "Always"),
    ];
    for (context, heading) in sections {
        lines.push(Line::default());
        lines.push(Line::from(Span::raw(heading).bold()));
        for binding in ACTIONS.iter().filter(|b| b.context == context) {
            lines.extend(key_lines(&binding.labels(), binding.doc, width));
        }
    }
    lines
}

/// Lines for keys and what they do, side by side.
pub fn key_lines(keys: &str, doc: &str, width: u16) -> Vec<Line<'static>> {
    let room = usize::from(width).saturating_sub(KEYS + 1).max(10);
    let (keys, doc) = (wrap(keys, KEYS - 1), wrap(doc, room));
    let lines = (0..keys.len().max(doc.len())).map(|i| {
        let key = keys.get(i).map_or("", String::as_str);
        Line::from(vec![
            Span::styled(format!("{key:<KEYS$}"), theme::keycap()),
            Span::raw(doc.get(i).cloned().unwrap_or_default()),
        ])
    });
    lines.collect()
}

/// What the letters of the rays mean.
fn letters() -> Line<'static> {
    let mut line = Line::from("Rays: ");
    for (kind, name) in
        RayKind::ALL
            .into_iter()
            .zip(["from the eye", "to a light", "reflected", "transmitted"])
    {
        line.push_span(Span::styled(kind.letter(), theme::kind_style(kind)));
        line.push_span(format!(" {name}  "));
    }
    line
}

/// Draws the help over everything else, if it is asked for.
pub fn draw(model: &Model, screen: Rect, buffer: &mut Buffer) {
    let Some(Overlay::Help(scroll)) = model.overlay else {
        return;
    };
    let area = area(screen);
    Clear.render(area, buffer);
    let title = Line::from(" keys (↓ ↑ scroll, q closes) ").bold();
    Block::bordered()
        .border_type(BorderType::Double)
        .title(title)
        .render(area, buffer);
    let room = inside(area);
    let lines = lines(room.width);
    let first = usize::from(scroll.min(last_scroll(screen)));
    for (y, line) in (room.y..room.bottom()).zip(lines.iter().skip(first)) {
        write(buffer, room.x, y, line, room.width);
    }
}
