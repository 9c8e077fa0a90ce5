//! Report over the panes: the difference of two trees, the samples of a pixel.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::text::Line;

use super::text::wrap;
use super::text_box;
use crate::tui::model::{Model, Overlay};

/// Columns at most: lines are long.
const COLUMNS: u16 = 120;

/// How far it can be scrolled.
pub fn last_scroll(text: &str, screen: Rect) -> u16 {
    text_box::last_scroll(screen, lines(text, text_box::room(screen, COLUMNS)).len())
}

fn lines(text: &str, width: u16) -> Vec<Line<'static>> {
    let wrapped = text.lines().flat_map(|line| {
        let indent = line.len() - line.trim_start().len();
        let room = usize::from(width).saturating_sub(indent).max(10);
        let parts = wrap(line.trim_start(), room).into_iter();
        parts.map(move |part| Line::raw(format!("{:indent$}{part}", "")))
    });
    wrapped.collect()
}

/// Draws it, if it is asked for.
pub fn draw(model: &Model, screen: Rect, buffer: &mut Buffer) {
    let Some(Overlay::Report(title, text, scroll)) = &model.overlay else {
        return;
    };
    let width = text_box::room(screen, COLUMNS);
    let lines = lines(text, width);
    text_box::draw(title, &lines, (width, *scroll), screen, buffer);
}
