//! Watched numbers and counted break points on the screen, and the same ray in two ways.

use crossterm::event::KeyCode;

use super::support::{app_with, enter, key, keys, of_scene, opened, position, settle, text};
use crate::probe::Event;
use crate::trace::format::rgb;
use crate::tui::model::{Overlay, Pane};
use crate::tui::terminal::program::Program;

fn event(app: &Program) -> Event {
    let session = app.model.session.as_ref().expect("a tree");
    session.tree().events[session.cursor().position()]
}

/// The first line of the details.
fn watched(app: &Program) -> String {
    let shown = text(app);
    let line = shown.lines().find(|line| line.contains("running sum ("));
    let line = line.or(shown.lines().find(|line| line.contains("running sum")));
    line.unwrap_or_default().to_owned()
}

#[test]
fn a_watched_number_is_shown_and_run_to() {
    for size in [(160, 50), (80, 24)] {
        let mut app = opened(size.0, size.1);
        keys(&mut app, ")");
        assert!(
            text(&app).contains("no number is watched"),
            "{}",
            text(&app)
        );
        enter(&mut app, "*running sum");
        assert!(
            text(&app).contains("running sum is watched"),
            "{}",
            text(&app)
        );
        keys(&mut app, "g");
        assert!(watched(&app).contains("not told yet"), "{}", text(&app));
        let mut stops = Vec::new();
        loop {
            let before = position(&app);
            keys(&mut app, ")");
            if position(&app) == before {
                break;
            }
            stops.push(position(&app));
            let sum =
                crate::debug::running::running_sum(app.model.session.as_ref().expect("a tree"));
            let told = rgb(sum.expect("a ray").sum);
            let line = watched(&app);
            assert!(line.contains("≠ running sum"), "{line}");
            let digits = told.replace(' ', "");
            let digits = &digits[..digits.len().min(9)];
            assert!(line.replace(' ', "").contains(digits), "{told}: {line}");
        }
        assert!(text(&app).contains("no watched number changes on the way to the end"));
        assert!(stops.len() > 3, "{stops:?}");
        // Between two of them nothing changes, and what was before is told.
        keys(&mut app, "g");
        enter(&mut app, &format!(":{}", stops[1] + 1));
        if !stops.contains(&(stops[1] + 1)) {
            assert!(!watched(&app).contains('≠'), "{}", watched(&app));
        }
        assert!(watched(&app).contains(", bef"), "{}", watched(&app));
        // Back over the same steps.
        keys(&mut app, "G");
        let mut back = Vec::new();
        if stops.last() == Some(&position(&app)) {
            back.push(position(&app));
        }
        loop {
            let before = position(&app);
            keys(&mut app, "(");
            if position(&app) == before {
                break;
            }
            back.push(position(&app));
        }
        back.reverse();
        assert_eq!(back, stops);
        // The list leads to where it was told; the same text takes it away.
        keys(&mut app, "G#");
        assert!(text(&app).contains("watched numbers"), "{}", text(&app));
        assert!(text(&app).contains("running sum: ("), "{}", text(&app));
        key(&mut app, KeyCode::Enter);
        assert!(app.model.overlay.is_none());
        enter(&mut app, "*running sum");
        assert!(app.model.watches.is_empty());
        assert!(!watched(&app).contains("before"), "{}", text(&app));
    }
}

/// The numbers of the details are offered by their names, in their order.
#[test]
fn any_number_of_the_step_can_be_chosen() {
    let mut app = opened(160, 50);
    keys(&mut app, "gn*");
    let session = app.model.session.as_ref().expect("a tree");
    let names = crate::debug::watch::names(session);
    for name in &names {
        key(&mut app, KeyCode::Down);
        assert!(matches!(&app.model.overlay, Some(Overlay::Prompt(_, text)) if text == name));
    }
    key(&mut app, KeyCode::Home);
    assert_eq!(names.last().map(String::as_str), Some("depth"));
    key(&mut app, KeyCode::Enter);
    assert_eq!(app.model.watches.len(), 1);
    // What is none is told, and the prompt stays.
    enter(&mut app, "*thruput");
    assert!(
        text(&app).contains("radiance, throughput"),
        "{}",
        text(&app)
    );
    key(&mut app, KeyCode::Esc);
    for name in names.iter().take(5) {
        enter(&mut app, &format!("*{name}"));
    }
    enter(&mut app, "*radiance");
    assert!(app.model.watches.len() <= 6);
}

#[test]
fn every_third_event_stops_a_run() {
    let mut app = of_scene("soft-shadow", 120, 36, |options| {
        options.size = Some((64, 48));
    });
    settle(&mut app);
    enter(&mut app, ":24,36");
    key(&mut app, KeyCode::Enter);
    enter(&mut app, "bL blocked every 3rd");
    assert!(
        text(&app).contains("break at L blocked every 3rd: of "),
        "{}",
        text(&app)
    );
    keys(&mut app, "gx");
    let first = position(&app);
    assert!(matches!(event(&app), Event::Blocked(_)));
    assert!(
        text(&app).contains("L blocked every 3rd: 3 of "),
        "{}",
        text(&app)
    );
    keys(&mut app, "x");
    assert!(
        text(&app).contains("L blocked every 3rd: 6 of "),
        "{}",
        text(&app)
    );
    keys(&mut app, "X");
    assert_eq!(position(&app), first);
    keys(&mut app, "B");
    let told = text(&app);
    assert!(told.contains("3 of them up to here; stops at "), "{told}");
    // The list leads to the first stop.
    key(&mut app, KeyCode::Enter);
    assert_eq!(position(&app), first);
}

#[test]
fn the_steps_of_a_ray_stand_beside_those_of_another_structure() {
    let mut app = of_scene("teapot", 120, 40, |_| ());
    settle(&mut app);
    enter(&mut app, "=accel=bsp");
    key(&mut app, KeyCode::Enter);
    enter(&mut app, "daccel=kd");
    assert!(text(&app).contains("go to a ray first"), "{}", text(&app));
    key(&mut app, KeyCode::Esc);
    keys(&mut app, "n");
    for (typed, parts) in [
        (
            "daccel=kd",
            [
                "steps of this ray | accel=kd",
                "bsp: ",
                ". kd: ",
                "Both find `teapot`",
            ],
        ),
        (
            "daccel=list",
            [
                "accel=list",
                "list: 994 tests",
                "| test teapot 0: miss",
                "Both find `teapot`",
            ],
        ),
        (
            "dorder=far-first",
            [
                "near first: ",
                "far first: ",
                "= node 0",
                "Both find `teapot`",
            ],
        ),
    ] {
        enter(&mut app, typed);
        let told = text(&app);
        for part in parts {
            assert!(told.contains(part), "{typed}, {part}: {told}");
        }
        key(&mut app, KeyCode::Esc);
    }
    // A row leads to its step.
    enter(&mut app, "dorder=far-first");
    keys(&mut app, "jjj");
    key(&mut app, KeyCode::Enter);
    assert!(matches!(event(&app), Event::Visit(_) | Event::Test { .. }));
    enter(&mut app, "dorder=both");
    assert!(text(&app).contains("it can be far-first"), "{}", text(&app));
    key(&mut app, KeyCode::Esc);
    enter(&mut app, "daccel=tree");
    assert!(
        text(&app).contains("it is one of list, bsp"),
        "{}",
        text(&app)
    );
}

#[test]
fn the_same_pixel_of_another_scene_stands_beside() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = crate::scene::builtin::scene("whitted").expect("built in");
    let changed = scene.replace("\"name\": \"whitted\"", "\"name\": \"other\"");
    std::fs::write(folder.path().join("same.json"), &changed).expect("written");
    std::fs::write(
        folder.path().join("broken.json"),
        "{\"format\": \"raytree-scene/1\"}",
    )
    .expect("written");
    let mut app = app_with(120, 36, |options| options.folder = folder.path().to_owned());
    settle(&mut app);
    key(&mut app, KeyCode::Enter);
    enter(&mut app, "dsame.json");
    assert!(text(&app).contains("rays agree"), "{}", text(&app));
    key(&mut app, KeyCode::Esc);
    enter(&mut app, "droom");
    let told = text(&app);
    assert!(
        told.contains("beside the same pixel of scene room") && told.contains('≠'),
        "{told}"
    );
    key(&mut app, KeyCode::Esc);
    enter(&mut app, "dbroken.json");
    assert!(text(&app).contains("camera"), "{}", text(&app));
    key(&mut app, KeyCode::Esc);
    enter(&mut app, "dnothing.json");
    assert!(text(&app).contains("nothing.json"), "{}", text(&app));
}

#[test]
fn the_first_tree_is_compared_as_the_command_line_says() {
    let mut app = app_with(120, 40, |options| {
        options.compare = Some("bend=eta-inverted".to_owned());
    });
    settle(&mut app);
    assert!(app.model.overlay.is_none());
    key(&mut app, KeyCode::Enter);
    assert!(
        text(&app).contains("as if     eta-inverted"),
        "{}",
        text(&app)
    );
    keys(&mut app, "q");
    enter(&mut app, ":3,4");
    assert!(app.model.overlay.is_none(), "only the first");
}

/// Watched numbers leave the details their room, and scrolling reaches their end.
#[test]
fn the_details_scroll_below_watched_numbers() {
    let mut app = opened(80, 24);
    for name in ["throughput", "radiance", "depth"] {
        enter(&mut app, &format!("*{name}"));
    }
    keys(&mut app, "G");
    key(&mut app, KeyCode::Tab);
    assert_eq!(app.model.layout.focus, Pane::Details);
    for _ in 0..60 {
        key(&mut app, KeyCode::Down);
    }
    let shown = text(&app);
    assert!(
        shown.contains("code: ") && shown.contains("throughput"),
        "{shown}"
    );
}
