//! The debugger without a terminal: actions in, screens out.

mod bundle;
mod effects;
mod huge;
mod mouse;
mod nearing;

use std::time::{Duration, Instant};

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use ratatui::Terminal;
use ratatui::backend::TestBackend;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Color;

use super::Options;
use super::actions::{ACTIONS, Action, Context};
use super::app::{App, Wish};
use super::input::press;
use super::layout::Pane;
use super::mouse::Mouse;
use crate::math::Rgb;
use crate::probe::Silent;
use crate::tracer::picture::ColorLevel;
use crate::tracer::pixel;
use crate::world::World;

fn app_with(width: u16, height: u16, change: impl FnOnce(&mut Options)) -> App {
    of_scene("whitted", width, height, change)
}

fn of_scene(scene: &str, width: u16, height: u16, change: impl FnOnce(&mut Options)) -> App {
    let name = scene.to_owned();
    let scene = crate::scene::load(scene).expect("a built-in scene");
    let settings = scene.settings;
    let world = World::new(scene, settings.accel);
    let mut options = Options {
        scene: name,
        color: ColorLevel::True,
        mouse: true,
        threads: 2,
        size: None,
    };
    change(&mut options);
    App::new(world, settings, options, Rect::new(0, 0, width, height))
}

fn app(width: u16, height: u16) -> App {
    let mut app = app_with(width, height, |_| ());
    settle(&mut app);
    app
}

/// Waits until the background has done all its work.
fn settle(app: &mut App) {
    let start = Instant::now();
    while app.is_busy() {
        app.receive();
        assert!(
            start.elapsed() < Duration::from_secs(60),
            "the background never ends"
        );
        std::thread::sleep(Duration::from_millis(1));
    }
    app.receive();
}

fn buffer(app: &App) -> Buffer {
    let mut terminal =
        Terminal::new(TestBackend::new(app.screen.width, app.screen.height)).expect("in memory");
    terminal
        .draw(|frame| frame.render_widget(app, frame.area()))
        .expect("in memory");
    terminal.backend().buffer().clone()
}

fn text(app: &App) -> String {
    let buffer = buffer(app);
    let width = usize::from(buffer.area.width).max(1);
    let line = |cells: &[ratatui::buffer::Cell]| {
        cells
            .iter()
            .map(ratatui::buffer::Cell::symbol)
            .collect::<String>()
    };
    buffer
        .content
        .chunks(width)
        .map(|cells| line(cells) + "\n")
        .collect()
}

fn key(app: &mut App, code: KeyCode) {
    press(app, KeyEvent::new(code, KeyModifiers::NONE));
    settle(app);
}

fn keys(app: &mut App, letters: &str) {
    for letter in letters.chars() {
        key(app, KeyCode::Char(letter));
    }
}

/// The tree of the pixel in the middle: a glass sphere.
fn opened(width: u16, height: u16) -> App {
    let mut app = app(width, height);
    key(&mut app, KeyCode::Enter);
    assert!(app.session.is_some());
    app
}

fn position(app: &App) -> usize {
    app.session.as_ref().map_or(0, |s| s.cursor().position())
}

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
    assert!(app.session.is_none() && app.wish == Wish::Stay);
    key(&mut app, KeyCode::Esc);
    assert_eq!(app.wish, Wish::Quit);
}

#[test]
fn back_undoes_step_on_the_screen() {
    let mut app = opened(80, 24);
    let count = app.session.as_ref().map_or(0, |s| s.tree().events.len());
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
fn every_key_does_something_and_is_in_the_help() {
    let help: String = super::help::lines(82)
        .iter()
        .map(|line| line.to_string() + "\n")
        .collect();
    for binding in ACTIONS {
        for (key, action) in binding.keys {
            let label = key.label();
            assert!(
                help.split_whitespace().any(|word| word == label),
                "{label} is not in\n{help}"
            );
            // In at least one of these situations the key must change what is seen, or end the program.
            let did = situations(binding.context).into_iter().any(|mut app| {
                let before = buffer(&app);
                assert!(press(&mut app, key.event()), "{label} is not known");
                settle(&mut app);
                app.wish != Wish::Stay || buffer(&app) != before
            });
            assert!(did, "{label} ({action:?}) does nothing");
        }
    }
}

fn situations(context: Context) -> Vec<App> {
    let at = |letters: &str| {
        let mut app = opened(120, 36);
        keys(&mut app, letters);
        app
    };
    match context {
        Context::Picture | Context::Always => vec![app(80, 24)],
        Context::Tree => vec![at("gnt"), at("gn ")],
        Context::Prompt => vec![at(":7")],
        Context::Effects => vec![at("e"), at("ej")],
    }
}

#[test]
fn a_number_goes_to_an_event() {
    let mut app = opened(80, 24);
    keys(&mut app, ":1x7");
    assert!(text(&app).contains("event (0 to"), "{}", text(&app));
    key(&mut app, KeyCode::Enter);
    assert_eq!(position(&app), 17);
    keys(&mut app, ":999999999");
    key(&mut app, KeyCode::Enter);
    let last = app
        .session
        .as_ref()
        .map_or(0, |s| s.tree().events.len() - 1);
    assert_eq!(position(&app), last);
}

#[test]
fn help_opens_scrolls_and_closes() {
    let mut app = opened(80, 24);
    let before = text(&app);
    keys(&mut app, "?");
    let top = text(&app);
    assert!(top.contains("Choosing a pixel"), "{top}");
    for _ in 0..100 {
        key(&mut app, KeyCode::Down);
    }
    let bottom = text(&app);
    assert!(bottom.contains("Ctrl-C"), "{bottom}");
    for _ in 0..100 {
        key(&mut app, KeyCode::Up);
    }
    assert_eq!(text(&app), top);
    keys(&mut app, "n");
    assert_eq!(
        text(&app),
        before,
        "another key closes the help and does no more"
    );
}

#[test]
fn the_line_that_reruns_a_pixel_has_what_the_scene_does_not() {
    let mut app = app(120, 36);
    app.settings.recursion.depth = 9;
    app.settings.fresnel = crate::shading::Fresnel::None;
    let line = super::bars::rerun(&app);
    let end = "whitted --size 120x66 --pixel 60,33 --depth 9 --fresnel none";
    assert_eq!(line, format!("raytree trace {end}"));
}

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
    // The cursor went through an image of one pixel, so its place is lost; all else is as before.
    app.handle(Action::Move(-200, -200));
    app.handle(Action::Move(60, 33));
    assert_eq!(text(&app), before);
}

#[test]
fn the_picture_is_that_of_the_tracer() {
    let mut app = app_with(60, 20, |_| ());
    let check = |app: &App| {
        let (width, height) = app.picture.size;
        for at in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
            if let Some(shown) = app.picture.exact(at) {
                let traced = pixel(&app.world, &app.settings, at, &mut Silent).color;
                assert_eq!(shown, traced, "{at:?}");
            }
        }
    };
    // Sizes change while it renders: what was rendered of an older image must not be taken for this one.
    for (width, height) in [(50, 20), (44, 15)] {
        std::thread::sleep(Duration::from_millis(100));
        app.resize(Rect::new(0, 0, width, height));
        app.receive();
        check(&app);
    }
    settle(&mut app);
    assert_eq!(app.picture.size, (44, 24));
    assert_eq!(app.picture.progress(), 1.0);
    check(&app);
    // Each half cell is one pixel.
    let drawn = buffer(&app);
    let color = |c: Rgb| {
        let [r, g, b] = (c * app.settings.image.exposure).to_srgb8();
        Color::Rgb(r, g, b)
    };
    let cell = &drawn[(3, 5)];
    assert_eq!(cell.symbol(), "▀");
    assert_eq!(Some(cell.fg), app.picture.exact((3, 10)).map(color));
    assert_eq!(Some(cell.bg), app.picture.exact((3, 11)).map(color));
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
    app.handle(Action::Move(-1000, 0));
    settle(&mut app);
    let at = app.picture.cursor;
    assert_eq!(at, (0, 100));
    let traced = pixel(&app.world, &app.settings, at, &mut Silent).color;
    assert_eq!(app.picture.exact(at), Some(traced));
}

#[test]
fn without_colour_there_is_none_and_the_current_row_is_marked() {
    let mut app = app_with(120, 36, |o| o.color = ColorLevel::Never);
    settle(&mut app);
    let plain = |app: &App| {
        buffer(app)
            .content
            .iter()
            .all(|c| c.fg == Color::Reset && c.bg == Color::Reset)
    };
    assert!(plain(&app));
    key(&mut app, KeyCode::Enter);
    keys(&mut app, "nr");
    assert!(plain(&app));
    assert!(text(&app).contains("▶├─"), "{}", text(&app));
}

#[test]
fn few_colours_are_those_of_the_palette() {
    let mut app = app_with(80, 24, |o| o.color = ColorLevel::Palette);
    settle(&mut app);
    let rgb = |c: Color| matches!(c, Color::Rgb(..));
    assert!(
        buffer(&app)
            .content
            .iter()
            .all(|c| !rgb(c.fg) && !rgb(c.bg))
    );
}

#[test]
fn closed_rays_hide_theirs_and_stepping_opens_them() {
    let mut app = opened(120, 36);
    keys(&mut app, "gn");
    let rows = |app: &App| app.session.as_ref().map_or(0, |s| s.rows.len());
    let all = rows(&app);
    keys(&mut app, " ");
    assert_eq!(rows(&app), 1);
    assert!(text(&app).contains("▸I"), "{}", text(&app));
    keys(&mut app, "r");
    assert_eq!(rows(&app), all);
}
