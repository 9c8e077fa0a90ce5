//! The line and the panel of warnings.

use crossterm::event::KeyCode;

use super::support::{key, keys, of_scene, of_source, settle, text};
use crate::scene::source_in_memory;
use crate::tui::terminal::program::Program;

/// A scene of these objects, in glass or in red from 0 to 255, at 80x24.
fn with(objects: &str) -> Program {
    let file = format!(
        r#"{{"format": "raytree-scene/1", "camera": {{"eye": [0.3, 0.2, 5], "look_at": [0, 0, 0], "vertical_fov": 20}},
"background": [0.2, 0.4, 0.6], "ambient": [1, 1, 1],
"materials": {{"red": {{"diffuse": [204, 26, 26]}}, "glass": {{"transmission": [1, 1, 1], "ior": 1.5}}}},
"objects": [{objects}]}}"#
    );
    let files = [("odd.json".to_owned(), file.into_bytes())];
    let source = source_in_memory("odd.json", files.into()).expect("a scene");
    let mut app = of_source("odd.json", source, (80, 24), |_| ());
    settle(&mut app);
    app
}

/// A pane of glass at this distance.
fn pane(z: i32) -> String {
    format!(
        r#"{{"box": {{"name": "pane {z}", "material": "glass", "min": [-5, -5, -{z}.1], "max": [5, 5, -{z}.05]}}}}"#
    )
}

const BALL: &str =
    r#"{"sphere": {"name": "ball", "material": "red", "center": [0, 0, 0], "radius": 1}}"#;

#[test]
fn a_line_says_how_many_and_a_key_shows_all() {
    let mut app = with(BALL);
    let before = text(&app);
    assert!(before.contains(" 1 warning: press w "), "{before}");
    keys(&mut app, "w");
    let panel = text(&app);
    for words in [
        " warnings (↓ ↑ scroll, q closes) ",
        "odd.json: materials.red.diffuse: material `red` sends back 204 times",
        "[share-above-one]",
        "  if it is a colour from 0 to 255, divide by 255: [0.8, 0.102, 0.102]",
    ] {
        assert!(panel.contains(words), "{words} is not in\n{panel}");
    }
    for close in ["w", "q", "c"] {
        keys(&mut app, close);
        assert_eq!(text(&app), before, "{close}");
        keys(&mut app, "w");
    }
}

#[test]
fn a_picture_that_lost_light_says_so_when_it_is_whole() {
    let panes: Vec<String> = (1..6).map(pane).collect();
    let mut app = with(&[panes, vec![BALL.to_owned()]].concat().join(", "));
    assert!(
        text(&app).contains(" 2 warnings: press w "),
        "{}",
        text(&app)
    );
    keys(&mut app, "w");
    let panel = text(&app);
    assert!(panel.contains("odd.json: limits left out"), "{panel}");
    assert!(panel.contains("raise --depth (5 now)"), "{panel}");
    // The tree of a pixel beside the ball tells its own.
    keys(&mut app, "qHHHH");
    key(&mut app, KeyCode::Enter);
    let title = text(&app).lines().next().expect("a title").to_owned();
    assert!(title.contains(")  10 rays cut (88.9 %)  "), "{title}");
}

#[test]
fn what_a_pixel_lost_stands_in_the_title_whatever_else_does() {
    let panes: Vec<String> = (1..6).map(pane).collect();
    let mut app = with(&panes.join(", "));
    let long = "a name that is longer than all of the line, which is eighty columns wide on many terminals";
    for name in ["short", long] {
        std::sync::Arc::get_mut(&mut app.model.world)
            .expect("nobody else holds it")
            .scene
            .name = name.to_owned();
        key(&mut app, KeyCode::Enter);
        let title = text(&app).lines().next().expect("a title").to_owned();
        assert!(title.contains(" cut (88.9 %)  "), "{title}");
        assert!(title.contains(" rays"), "{title}");
        keys(&mut app, "q");
    }
}

#[test]
fn a_scene_without_warnings_has_no_line_and_an_empty_panel() {
    let mut app = of_scene("triangle", 80, 24, |_| ());
    settle(&mut app);
    assert!(!text(&app).contains("warning"), "{}", text(&app));
    keys(&mut app, "w");
    assert!(text(&app).contains("nothing is strange about this scene"));
}

#[test]
fn many_warnings_are_scrolled() {
    let many: Vec<String> = (0..15)
        .map(|i| {
            format!(
                r#"{{"triangle": {{"name": "t{i}", "material": "glass", "corners": [[0, 0, {i}], [1, 0, {i}], [0, 1, {i}]],
"normals": [[0, 0, -1], [0, 0, -1], [0, 0, -1]]}}}}"#
            )
        })
        .collect();
    let mut app = with(&many.join(", "));
    keys(&mut app, "w");
    let top = text(&app);
    assert!(!top.contains("`t14`"), "{top}");
    for _ in 0..100 {
        key(&mut app, KeyCode::Down);
    }
    let bottom = text(&app);
    assert!(bottom.contains("`t14`"), "{bottom}");
    for _ in 0..100 {
        key(&mut app, KeyCode::Up);
    }
    assert_eq!(text(&app), top);
}
