//! Texts that are changed where they are typed, and the pane of the scene where there is no room for it.

use crossterm::event::KeyCode;

use super::support::{enter, key, keys, opened, text};
use crate::tui::model::{Message, Overlay, Pane};
use crate::tui::terminal::program::Program;

/// What is typed so far.
fn typed(app: &Program) -> &str {
    match &app.model.overlay {
        Some(Overlay::Prompt(_, text)) => text,
        other => panic!("no prompt: {other:?}"),
    }
}

fn press(app: &mut Program, codes: &[KeyCode]) {
    for code in codes {
        key(app, *code);
    }
}

#[test]
fn letters_go_where_the_bar_stands() {
    use KeyCode::{Backspace, Delete, End, Home, Left, Right};
    let mut app = opened(120, 36);
    keys(&mut app, "bdpest");
    press(&mut app, &[Left, Left, Left, Left]);
    keys(&mut app, "ée");
    assert_eq!(typed(&app), "déepest");
    assert!(text(&app).contains("dée▏pest"), "{}", text(&app));
    press(&mut app, &[Left, Backspace]);
    keys(&mut app, "e");
    assert_eq!(typed(&app), "deepest");
    press(&mut app, &[Home]);
    keys(&mut app, "xy");
    assert_eq!(typed(&app), "xydeepest");
    press(&mut app, &[Home, Left, Delete, Delete]);
    assert_eq!(typed(&app), "deepest");
    press(&mut app, &[Right, End, Right, Delete, Backspace]);
    assert_eq!(typed(&app), "deepes");
    // What is wrong stays, and so does the place in it.
    press(&mut app, &[Left, Left, KeyCode::Enter]);
    assert!(text(&app).contains("deep▏es"), "{}", text(&app));
    press(&mut app, &[End]);
    enter(&mut app, "t");
    assert_eq!(app.model.breaks.len(), 1);
    // The next prompt begins anew.
    keys(&mut app, "btir");
    assert_eq!(typed(&app), "tir");
}

#[test]
fn of_a_long_text_what_is_around_the_bar_is_shown() {
    let mut app = opened(80, 24);
    keys(&mut app, "/");
    let long = format!("start {} middle {} end", "a".repeat(70), "b".repeat(70));
    app.send(Message::Paste(long.clone()));
    assert!(text(&app).contains("b end▏"), "{}", text(&app));
    key(&mut app, KeyCode::Home);
    assert!(text(&app).contains(": ▏start aaa"), "{}", text(&app));
    for _ in 0..80 {
        key(&mut app, KeyCode::Right);
    }
    let shown = text(&app);
    let line = shown.lines().last().expect("a line");
    assert!(
        line.contains("mid▏dle b") && line.matches('…').count() == 2,
        "{line}"
    );
    assert_eq!(typed(&app), long);
}

#[test]
fn a_scene_that_is_hidden_is_shown_when_it_is_asked_for() {
    for letter in ["v", "V"] {
        let mut app = opened(80, 24);
        assert!(app.model.panes().path.is_empty());
        let axis = app.model.layout.axis;
        keys(&mut app, letter);
        assert_eq!(app.model.layout.focus, Pane::Path);
        assert!(text(&app).contains("scene from the side"), "{}", text(&app));
        assert_eq!(app.model.layout.axis, axis);
        assert_eq!(app.model.layout.fan.is_some(), letter == "V");
        keys(&mut app, "v");
        assert_ne!(app.model.layout.axis, axis);
        // Where it is in sight, the keys stay where they are.
        let mut wide = opened(160, 50);
        let focus = wide.model.layout.focus;
        keys(&mut wide, letter);
        assert_eq!(wide.model.layout.focus, focus);
    }
}
