//! The chart of a pixel that nears its value.

use std::time::{Duration, Instant};

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use super::{Action, keys, of_scene, settle, text};
use crate::probe::Silent;
use crate::scene::Settings;
use crate::tracer::pixel;
use crate::tui::App;
use crate::tui::input::press;
use crate::tui::nearing::{Nearing, error, run, sampled};

/// A pixel of the floor.
fn soft_shadow() -> App {
    let mut app = of_scene("soft-shadow", 100, 40, |_| ());
    settle(&mut app);
    app.handle(Action::Move(10, 18));
    app
}

fn nearing(app: &App) -> &Nearing {
    app.nearing.as_ref().expect("it is shown")
}

#[test]
fn every_point_is_the_pixel_that_the_tracer_finds() {
    let mut app = soft_shadow();
    keys(&mut app, "c");
    let points = &nearing(&app).points;
    assert!(points.len() > 8, "{}", points.len());
    for (power, point) in points.iter().enumerate().take(8) {
        let settings = sampled(&app.settings, 1 << power);
        let traced = pixel(&app.world, &settings, app.picture.cursor, &mut Silent);
        assert_eq!(*point, traced);
    }
    // It nears: what is left of the error is a small part of the first that is known.
    let (first, last) = (points[1], points[points.len() - 1]);
    assert!(first.error > 0.0 && last.error < first.error / 20.0);
    let screen = text(&app);
    let luminance = last.color.luminance();
    let value = format!("luminance {luminance:.5} ± {}", error(&last));
    assert!(screen.contains(&value), "no {value} in\n{screen}");
    assert!(screen.contains("4096"), "{screen}");
    let dots = screen.chars().filter(|c| ('⠁'..='⣿').contains(c)).count();
    assert!(dots > 20, "{dots} cells of a chart in\n{screen}");
}

#[test]
fn it_follows_the_cursor_and_closes() {
    let mut app = soft_shadow();
    keys(&mut app, "c");
    let before = nearing(&app).points[0];
    keys(&mut app, "h");
    let (x, y) = app.picture.cursor;
    assert!(text(&app).contains(&format!("pixel ({x}, {y}), more samples")));
    assert_ne!(nearing(&app).points[0], before);
    // With one sample and one shadow ray to the middle nothing is left to chance.
    app.settings.pixel.samples = 1;
    keys(&mut app, "ej q");
    assert!(app.nearing.is_none());
    assert!(!app.is_busy());
    keys(&mut app, "ej qc");
    assert!(app.nearing.is_some());
    keys(&mut app, "q");
    assert!(app.nearing.is_none() && app.wish == super::Wish::Stay);
}

#[test]
fn without_chance_there_is_nothing_to_show() {
    let mut app = super::app(100, 40);
    keys(&mut app, "c");
    assert!(app.nearing.is_none());
    assert!(
        text(&app).contains("nothing is left to chance"),
        "{}",
        text(&app)
    );
    app.settings.pixel.samples = 4;
    keys(&mut app, "c");
    assert!(!nearing(&app).points.is_empty());
}

#[test]
fn keys_do_not_wait_and_old_work_is_given_up() {
    let mut app = soft_shadow();
    app.settings.light.samples = 1024;
    app.settings.recursion.max_rays = u64::MAX;
    let start = Instant::now();
    let mut longest = Duration::ZERO;
    press(
        &mut app,
        KeyEvent::new(KeyCode::Char('c'), KeyModifiers::NONE),
    );
    for _ in 0..20 {
        let before = Instant::now();
        press(&mut app, KeyEvent::new(KeyCode::Left, KeyModifiers::NONE));
        app.receive();
        drop(super::buffer(&app));
        longest = longest.max(before.elapsed());
    }
    println!("{longest:?} a key, {:?} in all", start.elapsed());
    assert!(longest < Duration::from_millis(200), "{longest:?}");
    // Nothing that is left of the other pixels comes in.
    while nearing(&app).points.len() < 4 {
        app.receive();
        std::thread::sleep(Duration::from_millis(1));
    }
    for (power, point) in nearing(&app).points.iter().enumerate().take(4) {
        let settings = sampled(&app.settings, 1 << power);
        let traced = pixel(&app.world, &settings, app.picture.cursor, &mut Silent);
        assert_eq!(*point, traced);
    }
}

#[test]
fn the_work_is_bounded() {
    let app = soft_shadow();
    let rays = std::cell::Cell::new(0);
    let all = |settings: &Settings, stopped: &dyn Fn() -> bool| {
        rays.set(0);
        let add = |pixel: crate::tracer::Pixel| rays.set(rays.get() + pixel.rays);
        run(&app.world, settings, app.picture.cursor, stopped, &add)
    };
    let many = app.settings.with(|s| {
        s.light.samples = 65_536;
        s.recursion.max_rays = u64::MAX;
    });
    assert_eq!(all(&many, &|| false), "more would take long");
    assert!(rays.get() < 1 << 21, "{}", rays.get());
    let few = app.settings.with(|s| {
        s.recursion.max_rays = u64::from(many.image.width) * u64::from(many.image.height) * 1000
    });
    assert_eq!(
        all(&few, &|| false),
        "the pixel's share of --max-rays ends here"
    );
    assert!(rays.get() <= 2000);
    assert_eq!(all(&many, &|| true), "given up");
    assert_eq!(rays.get(), 0);
}
