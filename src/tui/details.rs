//! The current event: what it is, one sentence, the numbers.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Stylize as _;
use ratatui::text::{Line, Span};

use super::draw::write;
use super::session::Session;
use super::theme;
use crate::trace::explain;
use crate::tracer::picture::ColorLevel;

/// Its title: which event of how many.
pub fn title(session: &Session) -> Line<'static> {
    let (here, count) = (session.cursor().position(), session.tree().events.len());
    let ray = session.node().map_or_else(String::new, |id| {
        let sent = &session.tree().node(id).ray;
        format!(", ray {id} ({}), depth {}", sent.kind.letter(), sent.depth)
    });
    Line::raw(format!(
        " event {here} of {}{ray} ",
        count.saturating_sub(1)
    ))
}

/// All its lines, for a pane of this width.
pub fn lines(session: &Session, level: ColorLevel, width: u16) -> Vec<Line<'static>> {
    let explanation = explain(session.view(), session.cursor().position());
    let width = usize::from(width.max(8));
    let mut lines = vec![Line::from(Span::raw(explanation.title).bold())];
    lines.extend(
        wrap(&explanation.sentence, width)
            .into_iter()
            .map(Line::raw),
    );
    lines.push(Line::default());
    // All names in a column as wide as the widest, if that leaves room for the values.
    let names = explanation.rows.iter().map(|row| row.name.chars().count());
    let indent = names.max().unwrap_or(0).min(width / 3);
    for row in explanation.rows {
        let room = width.saturating_sub(indent + 2 + if row.color.is_some() { 3 } else { 0 });
        let name = wrap(&row.name, indent.max(1));
        let text = wrap(&row.text, room.max(4));
        for i in 0..name.len().max(text.len()) {
            let left = name.get(i).map_or("", String::as_str);
            let mut line = Line::from(Span::raw(format!("{left:<indent$}  ")).style(theme::dim()));
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
    lines
}

/// Draws the lines from the scroll position on.
pub fn draw(session: &Session, level: ColorLevel, place: Rect, buffer: &mut Buffer) {
    let lines = lines(session, level, place.width);
    let height = usize::from(place.height);
    let first = usize::from(session.scroll).min(lines.len().saturating_sub(height));
    for (y, line) in (place.y..place.bottom()).zip(lines.iter().skip(first)) {
        write(buffer, place.x, y, line, place.width);
    }
    // Arrows in the frame tell that there is more.
    let x = place.right().saturating_sub(2);
    if first > 0 {
        write(buffer, x, place.y.saturating_sub(1), &Line::raw("▲"), 1);
    }
    if first + height < lines.len() {
        write(buffer, x, place.bottom(), &Line::raw("▼"), 1);
    }
}

/// Breaks a text at its spaces into lines of at most `width` letters; longer words are cut.
pub fn wrap(text: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    let mut used = 0;
    for word in text.split(' ') {
        let mut letters: Vec<char> = word.chars().collect();
        let space = usize::from(used > 0);
        if used + space + letters.len() > width && used > 0 {
            lines.push(String::new());
            used = 0;
        }
        while letters.len() > width.max(1) {
            let rest = letters.split_off(width.max(1));
            if let Some(line) = lines.last_mut() {
                line.extend(letters);
            }
            lines.push(String::new());
            letters = rest;
        }
        if let Some(line) = lines.last_mut() {
            if used > 0 {
                line.push(' ');
                used += 1;
            }
            used += letters.len();
            line.extend(letters);
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrapped_lines_fit() {
        assert_eq!(wrap("one two three", 7), ["one two", "three"]);
        assert_eq!(wrap("abcdefgh ij", 3), ["abc", "def", "gh", "ij"]);
        assert_eq!(wrap("", 5), [""]);
        for width in 1..20 {
            let lines = wrap("the plane is crossed behind the interval", width);
            assert!(
                lines.iter().all(|l| l.chars().count() <= width),
                "{lines:?}"
            );
        }
    }
}
