//! Details pane: the current event, what it is, one sentence, the numbers.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Stylize as _;
use ratatui::text::{Line, Span};

use super::text::{arrows, columns, padded, wrap, write};
use super::theme;
use crate::debug::Session;
use crate::debug::running::running_sum;
use crate::trace::explain;
use crate::trace::explain::UNKNOWN;
use crate::trace::format::{counted, rgb};
use crate::tracer::image::ColorLevel;

/// Its title: which event of how many.
pub fn title(session: &Session) -> Line<'static> {
    let (here, count) = (session.cursor().position(), session.tree().events.len());
    let ray = session.node().map_or_else(String::new, |id| {
        let sent = &session.tree().node(id).ray;
        format!(", ray {id} ({}), depth {}", sent.kind.letter(), sent.depth)
    });
    let last = match session.horizon() {
        Some(_) => UNKNOWN.to_owned(),
        None => count.saturating_sub(1).to_string(),
    };
    Line::raw(format!(" event {here} of {last}{ray} "))
}

/// All its lines, for a pane of this width.
pub fn lines(session: &Session, level: ColorLevel, width: u16) -> Vec<Line<'static>> {
    let mut explanation = explain(session.view(), session.cursor().position());
    if session.horizon() == Some(1) {
        // The direction is asked, and the sample's numbers lead to it.
        explanation.rows.clear();
    }
    let width = usize::from(width.max(8));
    let mut lines = vec![Line::from(Span::raw(explanation.title).bold())];
    lines.extend(
        wrap(&explanation.sentence, width)
            .into_iter()
            .map(Line::raw),
    );
    lines.push(Line::default());
    // All names in a column as wide as the widest, if that leaves room for the values.
    let names = explanation.rows.iter().map(|row| columns(&row.name));
    let indent = names.max().unwrap_or(0).min(width / 3);
    for row in explanation.rows {
        let room = width.saturating_sub(indent + 2 + if row.color.is_some() { 3 } else { 0 });
        let name = wrap(&row.name, indent.max(1));
        let text = wrap(&row.text, room.max(4));
        for i in 0..name.len().max(text.len()) {
            let left = name.get(i).map_or("", String::as_str);
            let mut line = Line::from(Span::raw(padded(left, indent + 2)).style(theme::dim()));
            match row.color {
                Some(color) if i == 0 => {
                    line.push_span(theme::swatch(color, level));
                    line.push_span(" ");
                }
                Some(_) => line.push_span("   "),
                None => {}
            }
            line.push_span(text.get(i).cloned().unwrap_or_default());
            lines.push(line);
        }
    }
    lines.extend(so_far(session, level));
    let source = explanation.source;
    if !source.file.is_empty() {
        let told = format!("code: {} in {}", source.function, source.file);
        lines.push(Line::default());
        let told = wrap(&told, width).into_iter();
        lines.extend(told.map(|line| Line::from(Span::raw(line).style(theme::dim()))));
    }
    lines
}

/// What the current ray has summed up by now.
fn so_far(session: &Session, level: ColorLevel) -> Option<Line<'static>> {
    let running = running_sum(session)?;
    if running.added == 0 {
        return None;
    }
    let color = running.sum * session.settings.image.exposure;
    Some(Line::from(vec![
        Span::raw("sum so far: ").style(theme::dim()),
        theme::swatch(color, level),
        Span::raw(format!(
            " {} of {}",
            rgb(running.sum),
            counted(running.added as u64, "summand")
        )),
    ]))
}

/// Draws the lines from line `scroll` on.
pub fn draw(session: &Session, scroll: u16, level: ColorLevel, area: Rect, buffer: &mut Buffer) {
    let lines = lines(session, level, area.width);
    let height = usize::from(area.height);
    let first = usize::from(scroll).min(lines.len().saturating_sub(height));
    for (y, line) in (area.y..area.bottom()).zip(lines.iter().skip(first)) {
        write(buffer, area.x, y, line, area.width);
    }
    arrows(buffer, area, first > 0, first + height < lines.len());
}
