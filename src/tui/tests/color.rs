//! Terminals with few colours.

use crossterm::event::KeyCode;
use ratatui::style::Color;

use super::support::{app_with, buffer, key, keys, settle, text};
use crate::tracer::image::ColorLevel;
use crate::tui::terminal::program::Program;

#[test]
fn without_colour_there_is_none_and_the_current_row_is_marked() {
    let mut app = app_with(120, 36, |o| o.color = ColorLevel::Never);
    settle(&mut app);
    let plain = |app: &Program| {
        buffer(app)
            .content
            .iter()
            .all(|c| c.fg == Color::Reset && c.bg == Color::Reset)
    };
    assert!(plain(&app));
    key(&mut app, KeyCode::Enter);
    keys(&mut app, "nr");
    assert!(plain(&app));
    assert!(text(&app).contains("▶├─"), "{}", text(&app));
}

#[test]
fn few_colours_are_those_of_the_palette() {
    let mut app = app_with(80, 24, |o| o.color = ColorLevel::Palette);
    settle(&mut app);
    let rgb = |c: Color| matches!(c, Color::Rgb(..));
    assert!(
        buffer(&app)
            .content
            .iter()
            .all(|c| !rgb(c.fg) && !rgb(c.bg))
    );
}
