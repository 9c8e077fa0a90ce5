//! Tree pane: the ray tree, a row a ray. Only the rows on the screen are made, however large the tree is.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Stylize as _;
use ratatui::text::{Line, Span};

use super::text::{arrows, write};
use super::theme;
use crate::debug::{RowText, Session, TreeRow, TreeRows};
use crate::trace::explain::UNKNOWN;
use crate::trace::format::counted;
use crate::tracer::image::ColorLevel;
use crate::tui::model::first::first_row;

/// Columns that a level of the tree takes.
const INDENT: usize = 2;

/// Columns behind the names: t, share, colour.
const COLUMNS: usize = 24;

/// Its title.
pub fn title(session: &Session) -> Line<'static> {
    let rays = counted(session.tree().nodes.len() as u64, "ray");
    let known = session.horizon().map_or("", |_| " before the question");
    Line::raw(format!(" ray tree: {rays}{known} "))
}

/// The rows around the current one that a pane of `height` rows shows, with their numbers.
pub fn shown(session: &Session, height: u16) -> impl Iterator<Item = (usize, TreeRow)> {
    let first = first_row(session, height);
    let numbers = first..first + usize::from(height);
    numbers.map_while(|number| Some((number, session.rows.get(number)?)))
}

/// Draws them.
pub fn draw(session: &Session, level: ColorLevel, area: Rect, buffer: &mut Buffer) {
    let current = session.row();
    let shift = shift(session, current, area.width);
    let first = first_row(session, area.height);
    let below = first + usize::from(area.height) < session.rows.len();
    arrows(buffer, area, first > 0, below);
    for (y, (number, row)) in (area.y..).zip(shown(session, area.height)) {
        let line = Rect {
            y,
            height: 1,
            ..area
        };
        let text = RowText::new(session, row, shift);
        draw_row(text, number == current, level, line, buffer);
    }
}

/// Levels that are left out at the left side, so that a deep current row has room for its name.
fn shift(session: &Session, current: usize, width: u16) -> usize {
    let depth = session
        .rows
        .get(current)
        .map_or(0, |row| TreeRows::depth(session.tree(), row));
    let room = usize::from(width).saturating_sub(COLUMNS + 20) / INDENT;
    (depth as usize).saturating_sub(room.max(2))
}

fn draw_row(text: RowText, current: bool, level: ColorLevel, area: Rect, buffer: &mut Buffer) {
    let mut line = Line::from(Span::raw(if current { theme::POINTER } else { " " }).bold());
    line.push_span(Span::raw(text.guides).style(theme::dim()));
    if let Some(kind) = text.kind {
        line.push_span(Span::raw(text.fold));
        line.push_span(Span::styled(kind.letter(), theme::kind_style(kind)));
        line.push_span(Span::raw(text.name));
    } else {
        line.push_span(Span::styled(text.name, theme::dim()));
    }
    let has_end = !text.columns.is_empty();
    let end = if has_end {
        let unknown = Span::raw(UNKNOWN.repeat(2)).style(theme::dim());
        let color = text.color.map(|color| theme::swatch(color, level));
        Line::from(vec![
            Span::raw(text.columns),
            color.unwrap_or(unknown),
            Span::raw(" "),
        ])
    } else {
        Line::default()
    };
    let width = area.width.saturating_sub(end.width() as u16);
    write(buffer, area.x, area.y, &line, width);
    write(buffer, area.x + width, area.y, &end, area.width - width);
    if current {
        // The colours at the end stay as they are: reversed they would lie.
        let unmarked = if has_end { 4 } else { 1 };
        let marked = Rect {
            x: area.x + 1,
            width: area.width.saturating_sub(unmarked),
            ..area
        };
        buffer.set_style(marked.intersection(buffer.area), theme::current());
    }
}
