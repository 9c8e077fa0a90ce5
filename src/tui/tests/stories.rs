//! The stories that the debugger is for, each in as few keys as it is promised.

use crossterm::event::KeyCode;

use super::support::{buffer, key, keys, of_scene, position, settle, text};
use crate::probe::{Absence, Event};
use crate::tui::terminal::program::Program;

fn event(app: &Program) -> Event {
    let session = app.model.session.as_ref().expect("a tree");
    session.tree().events[position(app)]
}

fn started(scene: &str) -> Program {
    let mut app = of_scene(scene, 160, 50, |_| ());
    settle(&mut app);
    app
}

/// The glass pixel of `whitted`: the sum down to 8 bits, Fresnel's formula, the test of a sphere; three keys at most.
#[test]
fn a_glass_pixel_is_explained_in_three_keys() {
    let mut app = started("whitted");
    key(&mut app, KeyCode::Enter);
    keys(&mut app, "G");
    let [r, g, b] = {
        let session = app.model.session.as_ref().expect("a tree");
        (session.trace.pixel.color * app.model.settings.image.exposure).to_srgb8()
    };
    let told = text(&app);
    assert!(told.contains("8 bits") || told.contains("x 255"), "{told}");
    for part in [r, g, b] {
        assert!(told.contains(&part.to_string()), "{part}: {told}");
    }

    let mut app = started("whitted");
    key(&mut app, KeyCode::Enter);
    keys(&mut app, "rp");
    assert!(
        matches!(event(&app), Event::Boundary { .. }),
        "{:?}",
        event(&app)
    );
    assert!(
        text(&app).contains("n1") && text(&app).contains("n2"),
        "{}",
        text(&app)
    );

    let mut app = started("whitted");
    key(&mut app, KeyCode::Enter);
    keys(&mut app, "nn");
    let mut more = 0;
    while !text(&app).contains("b^2 - a c") && more < 9 {
        keys(&mut app, "n");
        more += 1;
    }
    assert!(more <= 1, "{more} keys more: {}", text(&app));
}

/// The order in which a ray of the teapot visits the BSP tree: two keys.
#[test]
fn the_order_of_the_bsp_tree_is_seen_at_once() {
    let mut app = of_scene("teapot", 160, 50, |_| ());
    settle(&mut app);
    key(&mut app, KeyCode::Enter);
    keys(&mut app, "n");
    let session = app.model.session.as_ref().expect("a tree");
    let first = session.tree().events[session.steps()].first().copied();
    assert!(
        matches!(first, Some(Event::Visit(_) | Event::Test { .. })),
        "{first:?}"
    );
    let told = text(&app);
    assert!(told.contains("nodes") && told.contains("shapes"), "{told}");
}

/// The first pixel with total internal reflection, and the ray that is not sent there: six keys.
#[test]
fn the_first_total_reflection_takes_six_keys() {
    let mut app = started("nested-glass");
    keys(&mut app, "/tir");
    key(&mut app, KeyCode::Enter);
    settle(&mut app);
    key(&mut app, KeyCode::Enter);
    let Event::Absent { reason, .. } = event(&app) else {
        panic!("{:?}: {}", event(&app), text(&app));
    };
    assert!(
        matches!(reason, Absence::TotalInternalReflection { .. }),
        "{reason:?}"
    );
    let session = app.model.session.as_ref().expect("a tree");
    let found = app.model.search.as_ref().expect("a search");
    assert_eq!(
        found.pixel((0, 0), true),
        Some((session.trace.x, session.trace.y))
    );
}

/// The noise of a penumbra: four keys to see it, three more to halve it twice and more.
#[test]
fn the_noise_of_a_penumbra_is_seen_and_halved() {
    let mut app = started("soft-shadow");
    let smooth = buffer(&app);
    keys(&mut app, "[[[[");
    settle(&mut app);
    assert_ne!(buffer(&app), smooth);
    let noisy = app.model.settings.light.samples;
    keys(&mut app, "]]]");
    settle(&mut app);
    assert!(app.model.settings.light.samples >= 4 * noisy);
}
