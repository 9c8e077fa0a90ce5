//! Help of the lesson screen: its keys, with what they do.

use ratatui::layout::Rect;
use ratatui::text::Line;

use super::keys::LESSON_KEYS;
use crate::tui::model::layout::covered;
use crate::tui::panes::help::key_lines;
use crate::tui::panes::text_box;

/// What the signs of exercises mean.
const SIGNS: &str = "✓ done   » skipped, the chapter is known   - given up   · tried";

/// All keys, with what they do.
pub fn help(width: u16) -> Vec<Line<'static>> {
    let keys = LESSON_KEYS.iter();
    let keys = keys.flat_map(|binding| key_lines(&binding.labels(), binding.doc, width));
    let signs = [Line::raw(SIGNS), Line::default()];
    signs.into_iter().chain(keys).collect()
}

/// How far the help can be scrolled.
pub fn last_help(screen: Rect) -> u16 {
    let screen = covered(screen);
    text_box::last_scroll(screen, help(text_box::room(screen, 0)).len())
}
