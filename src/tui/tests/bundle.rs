//! The rays to an area light in the debugger.

use std::time::{Duration, Instant};

use ratatui::layout::Position;

use super::support::{buffer, keys, of_scene, settle, text};
use crate::math::Rgb;
use crate::probe::{Event, RayKind};
use crate::tui::model::Mouse;
use crate::tui::panes::tree;
use crate::tui::terminal::program::Program;

#[test]
fn the_rays_to_an_area_light_are_one_row_that_opens() {
    let mut app = of_scene("soft-shadow", 120, 36, |_| ());
    settle(&mut app);
    app.mouse(Mouse::Press, Position::new(60, 24));
    app.mouse(Mouse::Press, Position::new(60, 24));
    settle(&mut app);
    keys(&mut app, "gn");
    let rows = |app: &Program| app.model.session.as_ref().map_or(0, |s| s.rows.len());
    let closed = rows(&app);
    keys(&mut app, "j");
    assert!(text(&app).contains("▸L 16 to lamp: "), "{}", text(&app));
    assert!(text(&app).contains("16 rays to `lamp`"), "{}", text(&app));
    keys(&mut app, " ");
    assert_eq!(rows(&app), closed + 16);
    keys(&mut app, "jjk ");
    assert_eq!(
        rows(&app),
        closed + 16,
        "a ray in the bundle has nothing to hide"
    );
    keys(&mut app, "k ");
    assert_eq!(rows(&app), closed);
    // Stepping into the bundle opens it.
    keys(&mut app, "n");
    assert_eq!(rows(&app), closed + 16);
}

#[test]
fn a_thousand_rays_to_a_light_are_as_quick_as_sixteen() {
    let mut app = of_scene("soft-shadow", 120, 36, |_| ());
    app.model.settings.light.samples = 1024;
    app.mouse(Mouse::Press, Position::new(60, 24));
    app.mouse(Mouse::Press, Position::new(60, 24));
    settle(&mut app);
    // Into each of the four bundles, which opens it.
    keys(&mut app, "gnllll");
    let rows = app.model.session.as_ref().map_or(0, |s| s.rows.len());
    assert!(rows > 1024, "{rows}");
    // What a frame makes is what the screen shows.
    let height = app.model.panes().tree.height;
    let session = app.model.session.as_ref().expect("a tree");
    assert_eq!(tree::shown(session, height).count(), usize::from(height));
    // What a ray brings is found beside it, not among all others; it is the same.
    let tree = session.tree();
    let mut lit = 0;
    for (id, node) in (0..).zip(&tree.nodes) {
        let (RayKind::Light, Some(parent)) = (node.ray.kind, node.parent) else {
            continue;
        };
        let ours = (node.ray.light, node.ray.sample);
        let terms = tree
            .own_events(parent)
            .filter_map(|(_, event)| match *event {
                Event::Term {
                    light,
                    sample,
                    term,
                } if (light, sample) == ours => Some(term.value()),
                _ => None,
            });
        if id % 64 == 2 {
            assert_eq!(
                tree.lit_by(id),
                terms.fold(Rgb::BLACK, |sum, value| sum + value)
            );
            lit += u32::from(!tree.lit_by(id).is_black());
        }
    }
    assert!(lit > 20, "{lit}");
    let start = Instant::now();
    for _ in 0..10 {
        keys(&mut app, "njj");
        drop(buffer(&app));
    }
    let each = start.elapsed() / 10;
    println!("{each:?} a frame");
    assert!(each < Duration::from_millis(50), "{each:?} a frame");
}
