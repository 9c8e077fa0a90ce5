//! The picture, and the command line of its pixels.

use std::time::Duration;

use ratatui::layout::Rect;
use ratatui::style::Color;

use super::support::{app, app_with, buffer, settle, text};
use crate::math::Rgb;
use crate::probe::Silent;
use crate::tracer::pixel;
use crate::tui::model::Action;
use crate::tui::panes::bars;
use crate::tui::terminal::program::Program;

#[test]
fn the_picture_is_that_of_the_tracer() {
    let mut app = app_with(60, 20, |_| ());
    let check = |app: &Program| {
        let (width, height) = app.model.picture.size;
        for at in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
            if let Some(shown) = app.model.picture.color(at) {
                let traced = pixel(&app.model.world, &app.model.settings, at, &mut Silent).color;
                assert_eq!(shown, traced, "{at:?}");
            }
        }
    };
    // Windows change while it renders: the picture stays, another part of it is seen.
    for (width, height) in [(50, 20), (44, 15)] {
        std::thread::sleep(Duration::from_millis(100));
        app.resize(Rect::new(0, 0, width, height));
        app.receive();
        check(&app);
    }
    settle(&mut app);
    assert_eq!(app.model.picture.size, (60, 34));
    assert_eq!(app.model.picture.progress(), 1.0);
    check(&app);
    let mut app = app_with(44, 15, |_| ());
    settle(&mut app);
    assert_eq!(app.model.picture.size, (44, 24));
    check(&app);
    // Each half cell is one pixel.
    let drawn = buffer(&app);
    let color = |c: Rgb| {
        let [r, g, b] = (c * app.model.settings.image.exposure).to_srgb8();
        Color::Rgb(r, g, b)
    };
    let cell = &drawn[(3, 5)];
    assert_eq!(cell.symbol(), "▀");
    assert_eq!(Some(cell.fg), app.model.picture.color((3, 10)).map(color));
    assert_eq!(Some(cell.bg), app.model.picture.color((3, 11)).map(color));
}

#[test]
fn an_image_larger_than_the_screen_is_seen_through_a_window() {
    let mut app = app_with(60, 20, |o| o.size = Some((300, 200)));
    settle(&mut app);
    assert!(
        text(&app).contains("--size 300x200 --pixel 150,100"),
        "{}",
        text(&app)
    );
    app.act(Action::Move(-1000, 0));
    settle(&mut app);
    let at = app.model.picture.cursor;
    assert_eq!(at, (0, 100));
    let traced = pixel(&app.model.world, &app.model.settings, at, &mut Silent).color;
    assert_eq!(app.model.picture.color(at), Some(traced));
}

#[test]
fn the_line_that_reruns_a_pixel_has_what_the_scene_does_not() {
    let mut app = app(120, 36);
    app.model.settings.recursion.depth = 9;
    app.model.settings.fresnel = crate::shading::Fresnel::None;
    let line = bars::rerun(&app.model);
    let end = "whitted --size 120x66 --pixel 60,33 --depth 9 --fresnel none";
    assert_eq!(line, format!("raytree trace {end}"));
}
