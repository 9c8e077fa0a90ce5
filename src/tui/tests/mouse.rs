//! The mouse in the debugger.

use ratatui::layout::Position;

use super::support::{app, settle};
use crate::tui::model::Mouse;

#[test]
fn the_mouse_picks_opens_and_selects() {
    let mut app = app(120, 36);
    app.mouse(Mouse::Press, Position::new(10, 5));
    assert_eq!(app.model.picture.cursor, (10, 10));
    app.mouse(Mouse::Drag, Position::new(50, 20));
    assert_eq!(app.model.picture.cursor, (50, 40));
    assert!(!app.is_busy());
    app.mouse(Mouse::Press, Position::new(50, 20));
    settle(&mut app);
    assert!(app.model.session.is_some(), "a second click opens");
    // The third row of the tree.
    let tree = app.model.panes().tree;
    app.mouse(Mouse::Press, Position::new(tree.x + 5, tree.y + 3));
    assert_eq!(app.model.session.as_ref().map(|s| s.row()), Some(2));
    // The small picture picks another pixel.
    let before = app.model.picture.cursor;
    let picture = app.model.panes().picture;
    app.mouse(Mouse::Press, Position::new(picture.x + 20, picture.y + 9));
    settle(&mut app);
    assert_ne!(app.model.picture.cursor, before);
    let traced = app.model.session.as_ref().map(|s| (s.trace.x, s.trace.y));
    assert_eq!(traced, Some(app.model.picture.cursor));
}
