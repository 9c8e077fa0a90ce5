//! The convergence of a pixel.

use std::time::{Duration, Instant};

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use super::support::{self, keys, of_scene, settle, text};
use crate::debug::Convergence;
use crate::debug::convergence::{error_text, measure, with_samples};
use crate::probe::Silent;
use crate::scene::Settings;
use crate::tracer::pixel;
use crate::tui::model::{Action, Request};
use crate::tui::terminal::program::Program;

/// A pixel of the floor.
fn soft_shadow() -> Program {
    let mut app = of_scene("soft-shadow", 100, 40, |_| ());
    settle(&mut app);
    app.act(Action::Move(10, 18));
    app
}

fn convergence(app: &Program) -> &Convergence {
    app.model.convergence.as_ref().expect("it is shown")
}

#[test]
fn every_point_is_the_pixel_that_the_tracer_finds() {
    let mut app = soft_shadow();
    keys(&mut app, "c");
    let points = &convergence(&app).pixels;
    assert!(points.len() > 8, "{}", points.len());
    for (power, point) in points.iter().enumerate().take(8) {
        let settings = with_samples(&app.model.settings, 1 << power);
        let traced = pixel(
            &app.model.world,
            &settings,
            app.model.picture.cursor,
            &mut Silent,
        );
        assert_eq!(*point, traced);
    }
    // It nears: what is left of the error is a small part of the first that is known.
    let (first, last) = (points[1], points[points.len() - 1]);
    assert!(first.error > 0.0 && last.error < first.error / 20.0);
    let screen = text(&app);
    let luminance = last.color.luminance();
    let value = format!("luminance {luminance:.5} ± {}", error_text(&last));
    assert!(screen.contains(&value), "no {value} in\n{screen}");
    assert!(screen.contains("4096"), "{screen}");
    let dots = screen.chars().filter(|c| ('⠁'..='⣿').contains(c)).count();
    assert!(dots > 20, "{dots} cells of a chart in\n{screen}");
}

#[test]
fn it_follows_the_cursor_and_closes() {
    let mut app = soft_shadow();
    keys(&mut app, "c");
    let before = convergence(&app).pixels[0];
    keys(&mut app, "h");
    let (x, y) = app.model.picture.cursor;
    assert!(text(&app).contains(&format!("pixel ({x}, {y}), more samples")));
    assert_ne!(convergence(&app).pixels[0], before);
    // With one sample and one shadow ray to the middle nothing is left to chance.
    app.model.settings.pixel.samples = 1;
    keys(&mut app, "ej q");
    assert!(app.model.convergence.is_none());
    assert!(!app.is_busy());
    keys(&mut app, "ej qc");
    assert!(app.model.convergence.is_some());
    keys(&mut app, "q");
    assert!(app.model.convergence.is_none() && app.model.request == Request::Stay);
}

#[test]
fn without_chance_there_is_nothing_to_show() {
    let mut app = support::app(100, 40);
    keys(&mut app, "c");
    assert!(app.model.convergence.is_none());
    assert!(
        text(&app).contains("nothing is left to chance"),
        "{}",
        text(&app)
    );
    app.model.settings.pixel.samples = 4;
    keys(&mut app, "c");
    assert!(!convergence(&app).pixels.is_empty());
}

#[test]
fn keys_do_not_wait_and_old_work_is_given_up() {
    let mut app = soft_shadow();
    app.model.settings.light.samples = 1024;
    app.model.settings.recursion.max_rays = u64::MAX;
    let start = Instant::now();
    let mut longest = Duration::ZERO;
    app.press(KeyEvent::new(KeyCode::Char('c'), KeyModifiers::NONE));
    for _ in 0..20 {
        let before = Instant::now();
        app.press(KeyEvent::new(KeyCode::Left, KeyModifiers::NONE));
        app.receive();
        drop(support::buffer(&app));
        longest = longest.max(before.elapsed());
    }
    println!("{longest:?} a key, {:?} in all", start.elapsed());
    assert!(longest < Duration::from_millis(200), "{longest:?}");
    // Nothing that is left of the other pixels comes in.
    while convergence(&app).pixels.len() < 4 {
        app.receive();
        std::thread::sleep(Duration::from_millis(1));
    }
    for (power, point) in convergence(&app).pixels.iter().enumerate().take(4) {
        let settings = with_samples(&app.model.settings, 1 << power);
        let traced = pixel(
            &app.model.world,
            &settings,
            app.model.picture.cursor,
            &mut Silent,
        );
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
        measure(
            &app.model.world,
            settings,
            app.model.picture.cursor,
            stopped,
            &add,
        )
    };
    let many = app.model.settings.with(|s| {
        s.light.samples = 65_536;
        s.recursion.max_rays = u64::MAX;
    });
    assert_eq!(all(&many, &|| false), "more would take long");
    assert!(rays.get() < 1 << 21, "{}", rays.get());
    let few = app.model.settings.with(|s| {
        s.recursion.max_rays = u64::from(many.image.width) * u64::from(many.image.height) * 1000;
    });
    assert_eq!(
        all(&few, &|| false),
        "the pixel's share of --max-rays ends here"
    );
    assert!(rays.get() <= 2000);
    assert_eq!(all(&many, &|| true), "given up");
    assert_eq!(rays.get(), 0);
}
