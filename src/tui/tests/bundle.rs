//! The rays to an area light in the debugger.

use ratatui::layout::Position;

use super::{Mouse, keys, of_scene, settle, text};
use crate::tui::App;

#[test]
fn the_rays_to_an_area_light_are_one_row_that_opens() {
    let mut app = of_scene("soft-shadow", 120, 36, |_| ());
    settle(&mut app);
    app.point(Mouse::Press, Position::new(60, 24));
    app.point(Mouse::Press, Position::new(60, 24));
    settle(&mut app);
    keys(&mut app, "gn");
    let rows = |app: &App| app.session.as_ref().map_or(0, |s| s.rows.len());
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
