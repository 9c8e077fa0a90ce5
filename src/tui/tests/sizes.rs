//! Screens of any size.

use crossterm::event::KeyCode;
use ratatui::layout::Rect;

use super::support::{app, buffer, key, keys, opened, settle, text};
use crate::tui::model::Pane;

#[test]
fn any_size_is_drawn() {
    let sizes = [
        (160, 50),
        (80, 24),
        (72, 13),
        (49, 11),
        (40, 10),
        (10, 6),
        (5, 4),
        (3, 3),
        (2, 1),
        (1, 1),
        (1, 50),
        (200, 2),
        (0, 0),
    ];
    for letters in ["", "z", "?", ":12", "v", "e"] {
        let mut app = opened(120, 36);
        keys(&mut app, "nnnn");
        keys(&mut app, letters);
        let before = text(&app);
        for (width, height) in sizes {
            app.resize(Rect::new(0, 0, width, height));
            if ![":12", "?", "e"].contains(&letters) {
                for _ in Pane::FOCUS {
                    key(&mut app, KeyCode::Tab);
                    key(&mut app, KeyCode::PageDown);
                    key(&mut app, KeyCode::PageUp);
                    if width > 0 {
                        drop(buffer(&app));
                    }
                }
            } else if width > 0 {
                drop(buffer(&app));
            }
        }
        app.resize(Rect::new(0, 0, 120, 36));
        if [":12", "?", "e"].contains(&letters) {
            assert_eq!(text(&app), before, "{letters}");
        }
    }
    let mut app = app(120, 36);
    let before = text(&app);
    for (width, height) in sizes.into_iter().chain([(120, 36)]) {
        app.resize(Rect::new(0, 0, width, height));
        settle(&mut app);
        if width > 0 {
            drop(buffer(&app));
        }
    }
    // The picture and its pixel are those of the session, whatever the window.
    assert_eq!(text(&app), before);
}
