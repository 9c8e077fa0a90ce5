//! What the picture shows in the place of colours.

use super::support::{app, buffer, keys, settle, text};
use crate::lab::show::{ShowMode, ShownValue};

#[test]
fn each_mode_shows_its_numbers_and_colours_come_back() {
    let mut app = app(100, 30);
    let colours = buffer(&app);
    let mut seen = vec![colours.clone()];
    for (mode, unit) in [
        (ShowMode::Rays, "rays a pixel: "),
        (ShowMode::Nodes, "nodes a pixel: "),
        (ShowMode::Tests, "tests a pixel: "),
        (ShowMode::Depth, "depth: "),
        (ShowMode::T, "t, in metres: "),
        (ShowMode::Error, "standard error"),
        (ShowMode::Normal, "normal"),
        (ShowMode::Object, "object"),
        (ShowMode::Hit, "Kd"),
        (ShowMode::Direction, "direction"),
    ] {
        keys(&mut app, "s");
        settle(&mut app);
        assert_eq!(app.model.show, Some(mode));
        assert!(text(&app).contains(unit), "{unit}\n{}", text(&app));
        let shown = buffer(&app);
        assert!(!seen.contains(&shown), "{mode:?}");
        seen.push(shown);
        // A pixel shows what the mode says of it.
        let at = app.model.picture.cursor;
        let value = mode.of(&app.model.world, &app.model.settings, at);
        assert_eq!(app.model.picture.exact(at), Some(value), "{mode:?}");
    }
    keys(&mut app, "s");
    settle(&mut app);
    assert_eq!(buffer(&app), colours);
    keys(&mut app, "S");
    settle(&mut app);
    assert_eq!(app.model.show, Some(ShowMode::Direction));
}

#[test]
fn rays_of_a_pixel_are_those_of_its_tree() {
    let app = app(60, 20);
    for at in [(5, 5), (30, 20), (33, 22)] {
        let trace = crate::trace::trace_pixel(&app.model.world, &app.model.settings, at, false);
        let rays = ShowMode::Rays.of(&app.model.world, &app.model.settings, at);
        assert_eq!(
            rays,
            ShownValue::Number(trace.tree.nodes.len() as f64),
            "{at:?}"
        );
    }
}
