//! Places that are jumped to: break points, where numbers come from, the pixel beside, back and forward.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use super::support::{app, enter, key, keys, opened, position, settle, text};
use crate::probe::Event;
use crate::tui::model::{Message, Overlay};
use crate::tui::terminal::program::Program;

fn event(app: &Program) -> Event {
    let session = app.model.session.as_ref().expect("a tree");
    session.tree().events[session.cursor().position()]
}

#[test]
fn a_run_stops_at_break_points_forwards_and_back() {
    let mut app = opened(120, 36);
    keys(&mut app, "x");
    assert!(
        text(&app).contains("there are no break points"),
        "{}",
        text(&app)
    );
    enter(&mut app, "babsent");
    assert!(text(&app).contains("break at absent: "), "{}", text(&app));
    keys(&mut app, "gx");
    let first = position(&app);
    assert!(matches!(event(&app), Event::Absent { .. }));
    assert!(text(&app).contains("absent: 1 of "), "{}", text(&app));
    keys(&mut app, "x");
    assert!(matches!(event(&app), Event::Absent { .. }) && position(&app) > first);
    keys(&mut app, "X");
    assert_eq!(position(&app), first);
    keys(&mut app, "X");
    assert!(
        text(&app).contains("no break point on the way to the start"),
        "{}",
        text(&app)
    );
    assert_eq!(position(&app), first);
    enter(&mut app, "bdeepest");
    keys(&mut app, "B");
    let told = text(&app);
    assert!(
        told.contains("absent: ") && told.contains("deepest: "),
        "{told}"
    );
    // The list leads to the first event of a break point.
    keys(&mut app, "j");
    key(&mut app, KeyCode::Enter);
    let session = app.model.session.as_ref().expect("a tree");
    let node = session.node().expect("a ray");
    let deepest = session.tree().nodes.iter().map(|n| n.ray.depth).max();
    assert_eq!(Some(session.tree().node(node).ray.depth), deepest);
    // The same text again takes it away; what is none is told, and the prompt stays.
    enter(&mut app, "babsent");
    enter(&mut app, "bdeepest");
    assert!(app.model.breaks.is_empty());
    enter(&mut app, "bdeepst");
    assert!(
        text(&app).contains("did you mean `deepest`?"),
        "{}",
        text(&app)
    );
    assert!(matches!(app.model.overlay, Some(Overlay::Prompt(..))));
}

#[test]
fn numbers_are_followed_to_their_origin_and_back() {
    let mut app = opened(120, 36);
    keys(&mut app, "G");
    let end = app.model.address();
    keys(&mut app, "w");
    assert!(
        text(&app).contains("where the numbers come from"),
        "{}",
        text(&app)
    );
    key(&mut app, KeyCode::Enter);
    let there = app.model.address();
    assert!(position(&app) < 1000 && there != end);
    // Where they go leads to the end again.
    keys(&mut app, "W");
    let told = text(&app);
    assert!(told.contains("where the numbers go"), "{told}");
    key(&mut app, KeyCode::Esc);
    keys(&mut app, ",");
    assert_eq!(app.model.address(), end);
    keys(&mut app, ".");
    assert_eq!(app.model.address(), there);
    keys(&mut app, ".");
    assert!(
        text(&app).contains("no place comes after this"),
        "{}",
        text(&app)
    );
    // The first event comes from the scene and the settings.
    keys(&mut app, "gwj");
    key(&mut app, KeyCode::Enter);
    assert!(text(&app).contains("scene: camera"), "{}", text(&app));
}

#[test]
fn the_pixel_beside_opens_at_the_same_ray() {
    let mut app = opened(120, 36);
    enter(&mut app, ":/T");
    let before = app.model.address();
    app.press(KeyEvent::new(KeyCode::Right, KeyModifiers::SHIFT));
    settle(&mut app);
    let after = app.model.address();
    assert_eq!(after.pixel, (before.pixel.0 + 1, before.pixel.1));
    assert_eq!(after.path, before.path);
    enter(&mut app, ":0,0");
    app.press(KeyEvent::new(KeyCode::Up, KeyModifiers::SHIFT));
    assert!(
        text(&app).contains("the edge of the picture"),
        "{}",
        text(&app)
    );
}

#[test]
fn jumps_are_undone_from_any_place() {
    let mut app = opened(120, 36);
    let mut places = vec![app.model.address()];
    for jump in [":/T", ":45", ":/R", ":3,4"] {
        enter(&mut app, jump);
        if places.last() != Some(&app.model.address()) {
            places.push(app.model.address());
        }
    }
    assert!(places.len() >= 4, "{places:?}");
    let forward = places.clone();
    while let Some(place) = places.pop() {
        assert_eq!(app.model.address(), place);
        keys(&mut app, ",");
    }
    // The first jump led out of the picture.
    assert!(app.model.session.is_none());
    for place in &forward {
        keys(&mut app, ".");
        assert_eq!(app.model.address(), *place);
    }
}

#[test]
fn trees_stand_side_by_side() {
    let mut app = opened(120, 40);
    enter(&mut app, "dbend=eta-inverted");
    let told = text(&app);
    for part in [
        "this tree | bend=eta-inverted",
        "as if     eta-inverted",
        "< first cause",
        "≠",
    ] {
        assert!(told.contains(part), "{part}: {told}");
    }
    // Enter opens the ray where it begins.
    key(&mut app, KeyCode::Enter);
    assert!(app.model.overlay.is_none());
    let (x, y) = app.model.picture.cursor;
    enter(&mut app, &format!("d{x},{y}"));
    assert!(text(&app).contains("rays agree"), "{}", text(&app));
    keys(&mut app, "q");
    enter(&mut app, "d3,4");
    assert!(text(&app).contains("beside pixel 3,4"), "{}", text(&app));
}

#[test]
fn what_does_not_fit_is_wrapped_or_ends_in_a_sign() {
    let mut app = app(80, 24);
    // A long message stands above the line of keys.
    keys(&mut app, "y");
    let told: String = text(&app).split_whitespace().collect();
    let command = app.model.message.clone().expect("the command");
    let command: String = command.split_whitespace().collect();
    assert!(told.contains(&command), "{told}");
    // Of a long text in a prompt the end is shown, and its hints are those of a prompt.
    keys(&mut app, "/");
    app.send(Message::Paste(format!(
        "{}the end\n",
        "hits:a or ".repeat(12)
    )));
    let told = text(&app);
    assert!(told.contains("the end▏") && told.contains('…'), "{told}");
    let last = told.lines().last().expect("a line");
    assert!(!last.contains("effects"), "{last}");
    key(&mut app, KeyCode::Esc);
    app.send(Message::Paste("tir".to_owned()));
    assert!(
        text(&app).contains("pasted text goes into prompts"),
        "{}",
        text(&app)
    );
}

#[test]
fn pixels_are_walked_in_the_order_of_what_they_show() {
    let mut app = app(60, 20);
    keys(&mut app, "s");
    settle(&mut app);
    let value = |app: &Program| {
        let shown = app.model.picture.exact(app.model.picture.cursor);
        crate::debug::ranking::number(shown.expect("known")).expect("a number")
    };
    keys(&mut app, "o");
    assert!(text(&app).contains("rays a pixel"), "{}", text(&app));
    key(&mut app, KeyCode::Enter);
    let mut before = value(&app);
    for _ in 0..20 {
        keys(&mut app, "x");
        assert!(value(&app) <= before);
        before = value(&app);
    }
    assert!(
        text(&app).contains("from the largest down"),
        "{}",
        text(&app)
    );
    keys(&mut app, "X");
    assert!(value(&app) >= before);
}

#[test]
fn a_standard_error_of_one_sample_is_told_not_to_be_one() {
    let mut app = app(80, 24);
    keys(&mut app, "ssssss");
    assert!(
        text(&app).contains("one sample tells no standard error"),
        "{}",
        text(&app)
    );
}

#[test]
fn an_event_shows_its_function() {
    let mut app = opened(120, 40);
    keys(&mut app, "ns");
    let told = text(&app);
    assert!(
        told.contains("src/scene/camera.rs") && told.contains("pub fn ray("),
        "{told}"
    );
}
