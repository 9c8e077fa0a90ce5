//! Search by a query, addresses that are typed, and the command that is copied.

use crossterm::event::KeyCode;

use super::support::{app, enter, keys, of_scene, opened, settle, text};
use crate::tui::terminal::program::Program;

fn glass() -> Program {
    let mut app = of_scene("glass-block", 120, 40, |_| ());
    settle(&mut app);
    app
}

#[test]
fn the_first_pixel_with_total_internal_reflection_and_its_absent_ray_take_six_keys() {
    let mut app = glass();
    enter(&mut app, "/tir");
    let found = text(&app);
    assert!(found.contains("`tir`: pixel 1 of "), "{found}");
    enter(&mut app, "");
    let tree = text(&app);
    assert!(tree.contains("no T: total internal reflection"), "{tree}");
    let session = app.model.session.as_ref().expect("a tree");
    let event = session.tree().events[session.cursor().position()];
    assert!(
        matches!(event, crate::probe::Event::Absent { reason, .. } if reason.name() == "total-internal-reflection"),
        "{event:?}"
    );
}

#[test]
fn found_pixels_are_walked_and_the_others_are_darker() {
    let mut app = glass();
    let before = super::support::buffer(&app);
    enter(&mut app, "/tir");
    let first = app.model.picture.cursor;
    assert_ne!(super::support::buffer(&app), before);
    keys(&mut app, "n");
    let second = app.model.picture.cursor;
    assert_ne!(first, second);
    assert!(text(&app).contains("pixel 2 of"), "{}", text(&app));
    keys(&mut app, "N");
    assert_eq!(app.model.picture.cursor, first);
    keys(&mut app, "N");
    let last = app.model.picture.cursor;
    keys(&mut app, "n");
    assert_eq!(
        app.model.picture.cursor, first,
        "after {last:?} comes the first"
    );
    // Escape ends the search, not the program.
    keys(&mut app, "q");
    assert!(app.model.search.is_none());
    assert!(!text(&app).contains("`tir`"));
}

#[test]
fn what_is_no_query_is_told_and_stays_to_be_mended() {
    let mut app = glass();
    enter(&mut app, "/glas");
    let told = text(&app);
    assert!(
        told.contains("find: glas") && told.contains("letter 1"),
        "{told}"
    );
    super::support::key(&mut app, KeyCode::Backspace);
    assert!(text(&app).contains("find: gla▏"), "{}", text(&app));
    super::support::key(&mut app, KeyCode::Esc);
    assert!(app.model.overlay.is_none() && app.model.search.is_none());
    // Some to begin with.
    keys(&mut app, "/");
    super::support::key(&mut app, KeyCode::Down);
    assert!(text(&app).contains("find: tir▏"), "{}", text(&app));
    super::support::key(&mut app, KeyCode::Up);
    assert!(text(&app).contains("find: miss▏"), "{}", text(&app));
    enter(&mut app, "");
    assert!(text(&app).contains("`miss`: pixel 1 of"), "{}", text(&app));
}

#[test]
fn rays_of_a_tree_are_found_both_ways() {
    let mut app = opened(120, 40);
    keys(&mut app, "g");
    enter(&mut app, "/R");
    let first = app.model.session.as_ref().expect("a tree").cursor();
    assert!(text(&app).contains("ray 1 of"), "{}", text(&app));
    keys(&mut app, "f");
    let second = app.model.session.as_ref().expect("a tree").cursor();
    assert!(second.position() > first.position());
    keys(&mut app, "F");
    assert_eq!(app.model.session.as_ref().expect("a tree").cursor(), first);
    // Around, as in the picture.
    keys(&mut app, "F");
    assert!(text(&app).contains("from the end again"), "{}", text(&app));
    assert!(
        app.model
            .session
            .as_ref()
            .expect("a tree")
            .cursor()
            .position()
            > second.position()
    );
    keys(&mut app, "f");
    assert!(
        text(&app).contains("from the start again"),
        "{}",
        text(&app)
    );
    assert_eq!(app.model.session.as_ref().expect("a tree").cursor(), first);
    keys(&mut app, "/hits:nothing");
    super::support::key(&mut app, KeyCode::Enter);
    assert!(text(&app).contains("nothing"), "{}", text(&app));
    keys(&mut app, "/depth >= 99");
    super::support::key(&mut app, KeyCode::Enter);
    assert!(
        text(&app).contains("no ray of this tree satisfies it"),
        "{}",
        text(&app)
    );
}

#[test]
fn addresses_are_typed_and_what_is_not_there_is_told() {
    let mut app = opened(120, 40);
    enter(&mut app, ":99999");
    assert!(
        text(&app).contains("there is no event 99999: the last one is"),
        "{}",
        text(&app)
    );
    super::support::key(&mut app, KeyCode::Esc);
    enter(&mut app, ":/R");
    assert!(
        text(&app).contains("R: the reflected ray"),
        "{}",
        text(&app)
    );
    enter(&mut app, ":#0");
    assert!(text(&app).contains("event 0 of"), "{}", text(&app));
    enter(&mut app, ":3,4");
    assert!(text(&app).contains("pixel 3,4"), "{}", text(&app));

    let mut app = super::support::app(120, 40);
    enter(&mut app, ":5,6");
    assert_eq!(app.model.picture.cursor, (5, 6));
    assert!(app.model.session.is_none());
    enter(&mut app, ":5000,6");
    assert!(
        text(&app).contains("pixel 5000,6 is outside"),
        "{}",
        text(&app)
    );
}

/// The line that is copied opens the same step elsewhere.
#[test]
fn the_copied_command_opens_the_same_step() {
    let mut there = opened(120, 40);
    keys(&mut there, "gnnr");
    keys(&mut there, "y");
    let command = there.model.clipboard.clone().expect("copied");
    assert!(text(&there).contains(&command[..40]), "{}", text(&there));
    let words: Vec<&str> = command.split(' ').collect();
    assert_eq!(
        words[..4],
        ["raytree", "view", "whitted", "--size"],
        "{command}"
    );
    let (width, height) = words[4].split_once('x').expect("a size");
    let size = (
        width.parse().expect("a number"),
        height.parse().expect("a number"),
    );
    let address = words[6].trim_matches('\'').parse().expect("an address");
    let mut here = super::support::app_with(90, 30, |options| {
        options.size = Some(size);
        options.at = Some(address);
    });
    settle(&mut here);
    let at = |app: &Program| {
        let session = app.model.session.as_ref().expect("a tree");
        (session.trace.x, session.trace.y, session.cursor())
    };
    assert_eq!(at(&here), at(&there), "{command}");
}

#[test]
fn letters_are_letters_where_a_text_is_typed() {
    let mut app = app(80, 24);
    keys(&mut app, "/q?mecw");
    assert!(text(&app).contains("find: q?mecw▏"), "{}", text(&app));
}

#[test]
fn steps_run_by_themselves_until_a_key_or_the_end() {
    use std::time::{Duration, Instant};

    use crate::tui::model::Message;

    let mut app = opened(120, 40);
    keys(&mut app, "g");
    keys(&mut app, ">");
    let tick = |app: &mut Program, seconds: f64| {
        app.send(Message::Tick(
            Instant::now() + Duration::from_secs_f64(seconds),
        ));
    };
    tick(&mut app, 0.1);
    assert_eq!(super::support::position(&app), 0, "not due yet");
    tick(&mut app, 0.6);
    assert_eq!(super::support::position(&app), 1);
    keys(&mut app, ">>");
    assert!(text(&app).contains("8 steps a second"), "{}", text(&app));
    keys(&mut app, "<");
    tick(&mut app, 1.0);
    assert_eq!(super::support::position(&app), 0);
    tick(&mut app, 2.0);
    assert!(app.model.play.is_none(), "it ends at the end");
    keys(&mut app, ">n");
    assert!(app.model.play.is_none());
    assert_eq!(
        super::support::position(&app),
        1,
        "the key does what it does"
    );
}
