//! Watched numbers above the details: what each is at the cursor, what it was before, and whether it changes here.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Stylize as _;
use ratatui::text::{Line, Span};

use super::text::write;
use super::theme;
use crate::debug::watch::{Watch, WatchState};
use crate::tui::model::Model;

/// How many lines they take of a pane of this height: a third at most.
pub fn rows(model: &Model, height: u16) -> u16 {
    (model.watches.len() as u16).min(height / 3)
}

/// Draws them at the top of the pane and gives the rest of it.
pub fn draw(model: &Model, area: Rect, buffer: &mut Buffer) -> Rect {
    let count = rows(model, area.height);
    if let Some(session) = &model.session {
        let here = session.cursor().position();
        // The last ones: they were asked for most recently.
        let skipped = model.watches.len().saturating_sub(usize::from(count));
        let watches = model.watches.iter().skip(skipped);
        for (y, watch) in (area.y..area.y + count).zip(watches) {
            let line = line(model, watch, watch.state(session, here));
            write(buffer, area.x, y, &line, area.width);
        }
    }
    Rect {
        y: area.y + count,
        height: area.height - count,
        ..area
    }
}

/// Name, value, the value before.
fn line(model: &Model, watch: &Watch, state: WatchState) -> Line<'static> {
    let name = format!("{} ", watch.text);
    let sign = if state.changes { "≠ " } else { "  " };
    let mut line = Line::from(vec![
        Span::raw(sign).bold(),
        Span::raw(name).style(theme::dim()),
    ]);
    let Some(now) = state.now else {
        line.push_span(Span::raw("not told yet").style(theme::dim()));
        return line;
    };
    if let Some(color) = now.color {
        let exposure = model.settings.image.exposure;
        line.push_span(theme::swatch(color * exposure, model.options.color));
        line.push_span(" ");
    }
    let value = Span::raw(now.text);
    line.push_span(if state.changes { value.bold() } else { value });
    if let Some(before) = state.before {
        line.push_span(Span::raw(format!(", before {}", before.text)).style(theme::dim()));
    }
    line
}
