//! Walking through a ray tree.

use crossterm::event::KeyCode;

use super::support::{app, key, keys, opened, position, text};
use crate::tui::model::Request;
use crate::tui::terminal::program::Program;

#[test]
fn a_pixel_is_picked_and_its_tree_walked() {
    let mut app = app(120, 36);
    let before = text(&app);
    assert!(before.contains("--size 120x66 --pixel 60,33"), "{before}");
    keys(&mut app, "lljH");
    assert!(text(&app).contains("--pixel 54,34"), "{}", text(&app));
    key(&mut app, KeyCode::Enter);
    let start = text(&app);
    for part in [
        "ray tree:",
        "picture, pixel 54,34",
        "event 0 of",
        "sample 1 of 1",
        "scene from",
    ] {
        assert!(start.contains(part), "no {part} in\n{start}");
    }
    keys(&mut app, "n");
    assert!(
        text(&app).contains("I: a ray from the eye"),
        "{}",
        text(&app)
    );
    // Over the eye ray: its return, just before the end.
    keys(&mut app, "o");
    let returned = text(&app);
    assert!(returned.contains("I brings back its sum"), "{returned}");
    keys(&mut app, "G");
    assert_eq!(
        text(&app),
        returned,
        "the return of the eye ray is the last event"
    );
    keys(&mut app, "gnr");
    assert!(
        text(&app).contains("R: the reflected ray"),
        "{}",
        text(&app)
    );
    keys(&mut app, "u");
    assert!(
        text(&app).contains("R brings back its sum"),
        "{}",
        text(&app)
    );
    keys(&mut app, "T");
    assert!(
        text(&app).contains("no T ray comes before this"),
        "{}",
        text(&app)
    );
    key(&mut app, KeyCode::Esc);
    assert!(app.model.session.is_none() && app.model.request == Request::Stay);
    key(&mut app, KeyCode::Esc);
    assert_eq!(app.model.request, Request::Quit);
}

#[test]
fn back_undoes_step_on_the_screen() {
    let mut app = opened(80, 24);
    let count = app
        .model
        .session
        .as_ref()
        .map_or(0, |s| s.tree().events.len());
    assert!(count > 50);
    let mut screens = vec![text(&app)];
    for _ in 1..count {
        keys(&mut app, "n");
        screens.push(text(&app));
    }
    for i in (0..count - 1).rev() {
        keys(&mut app, "p");
        assert!(text(&app) == screens[i], "event {i}");
    }
}

#[test]
fn a_number_goes_to_an_event() {
    let mut app = opened(80, 24);
    keys(&mut app, ":17");
    assert!(text(&app).contains("event (0 to"), "{}", text(&app));
    key(&mut app, KeyCode::Enter);
    assert_eq!(position(&app), 17);
    // Beyond the last one it stays, and says so.
    keys(&mut app, ":999999999");
    key(&mut app, KeyCode::Enter);
    assert_eq!(position(&app), 17);
    assert!(
        text(&app).contains("there is no event 999999999"),
        "{}",
        text(&app)
    );
}

#[test]
fn closed_rays_hide_theirs_and_stepping_opens_them() {
    let mut app = opened(120, 36);
    keys(&mut app, "gn");
    let rows = |app: &Program| app.model.session.as_ref().map_or(0, |s| s.rows.len());
    let all = rows(&app);
    keys(&mut app, " ");
    assert_eq!(rows(&app), 1);
    assert!(text(&app).contains("▸I"), "{}", text(&app));
    keys(&mut app, "r");
    assert_eq!(rows(&app), all);
}
