//! Help of the lesson screen: its keys, with what they do.

use ratatui::layout::Rect;
use ratatui::text::{Line, Span};

use super::keys::LESSON_KEYS;
use crate::tui::model::layout::covered;
use crate::tui::panes::text::wrap;
use crate::tui::panes::{text_box, theme};

/// Columns of the keys.
const KEYS: usize = 18;

/// All keys, with what they do.
pub fn help(width: u16) -> Vec<Line<'static>> {
    let room = usize::from(width).saturating_sub(KEYS + 1).max(10);
    let mut lines = vec![
        Line::raw("✓ done   » skipped, the chapter is known   - given up   · tried"),
        Line::default(),
    ];
    for binding in LESSON_KEYS {
        let keys = wrap(&binding.labels(), KEYS - 1);
        let doc = wrap(binding.doc, room);
        for i in 0..keys.len().max(doc.len()) {
            let key = keys.get(i).map_or("", String::as_str);
            lines.push(Line::from(vec![
                Span::styled(format!("{key:<KEYS$}"), theme::keycap()),
                Span::raw(doc.get(i).cloned().unwrap_or_default()),
            ]));
        }
    }
    lines
}

/// How far the help can be scrolled.
pub fn last_help(screen: Rect) -> u16 {
    let screen = covered(screen);
    text_box::last_scroll(screen, help(text_box::room(screen, 0)).len())
}
