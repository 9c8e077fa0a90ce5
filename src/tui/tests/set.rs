//! Settings that change while the debugger runs, and trees that are compared.

use crossterm::event::KeyCode;

use super::support::{app, buffer, enter, key, keys, of_scene, opened, settle, text};
use crate::tui::terminal::program::Program;

#[test]
fn the_noise_of_a_penumbra_takes_three_keys_and_less_of_it_two_more() {
    let mut app = of_scene("soft-shadow", 80, 40, |_| ());
    settle(&mut app);
    let before = app.model.settings;
    keys(&mut app, "[[[[");
    settle(&mut app);
    assert_eq!(app.model.settings.light.samples, 1);
    assert!(text(&app).contains("samples a light: 1"), "{}", text(&app));
    let noisy = buffer(&app);
    keys(&mut app, "+");
    settle(&mut app);
    assert_ne!(buffer(&app), noisy, "another seed, another noise");
    keys(&mut app, "]]");
    settle(&mut app);
    assert_eq!(app.model.settings.light.samples, 4);
    // Everything is taken back.
    keys(&mut app, "UUUUUUU");
    settle(&mut app);
    assert_eq!(app.model.settings, before);
    keys(&mut app, "U");
    assert!(text(&app).contains("nothing was changed"), "{}", text(&app));
}

#[test]
fn a_setting_that_is_typed_changes_the_picture_and_the_open_tree() {
    let mut app = opened(120, 40);
    let rays = |app: &Program| app.model.session.as_ref().map_or(0, |s| s.trace.pixel.rays);
    let before = rays(&app);
    enter(&mut app, "=depth=1");
    assert!(rays(&app) < before, "{before}");
    enter(&mut app, "=accel=kd");
    assert_eq!(app.model.settings.accel, crate::accel::AccelKind::Kd);
    keys(&mut app, "UU");
    settle(&mut app);
    assert_eq!(rays(&app), before);
    enter(&mut app, "=dept=1");
    assert!(
        text(&app).contains("`dept` is no setting"),
        "{}",
        text(&app)
    );
    key(&mut app, KeyCode::Esc);
    enter(&mut app, "=size=10x10");
    assert!(
        text(&app).contains("start again with --size"),
        "{}",
        text(&app)
    );
}

#[test]
fn a_bend_is_told_by_the_difference_of_the_trees() {
    let mut app = opened(120, 40);
    keys(&mut app, "d");
    key(&mut app, KeyCode::Down);
    enter(&mut app, "");
    let told = text(&app);
    assert!(
        told.contains("this tree | bend=eta-inverted") && told.contains("as if     eta-inverted"),
        "{told}"
    );
    keys(&mut app, "q");
    // With itself it agrees.
    let (x, y) = app.model.picture.cursor;
    enter(&mut app, &format!("d{x},{y}"));
    assert!(text(&app).contains("rays agree"), "{}", text(&app));
    keys(&mut app, "q");
    enter(&mut app, "d3,3");
    assert!(text(&app).contains("beside pixel 3,3"), "{}", text(&app));
    keys(&mut app, "q");
    enter(&mut app, "dno-such-file.json");
    assert!(text(&app).contains("no-such-file.json: "), "{}", text(&app));
}

#[test]
fn in_the_picture_there_is_no_tree_to_compare() {
    let mut app = app(80, 24);
    keys(&mut app, "d");
    assert!(app.model.overlay.is_none());
    assert!(
        text(&app).contains("there is no other picture"),
        "{}",
        text(&app)
    );
}

#[test]
fn the_samples_of_a_pixel_are_a_table_and_each_opens() {
    let mut app = opened(120, 40);
    enter(&mut app, "=samples=4");
    keys(&mut app, "h");
    let told = text(&app);
    for part in [
        "samples of the pixel",
        "4 samples",
        ":3  at (",
        "weight 0.25 x radiance",
        "Their sum is the pixel",
    ] {
        assert!(told.contains(part), "{part}: {told}");
    }
    keys(&mut app, "q");
    enter(&mut app, "::2");
    let told = text(&app);
    assert!(told.contains("I: a ray from the eye"), "{told}");
    let session = app.model.session.as_ref().expect("a tree");
    let node = session.node().expect("a ray");
    assert_eq!(
        session.tree().sample_of_node(node).map(|s| s.index),
        Some(2)
    );
}

#[test]
fn marks_are_walked_and_written_and_opened_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("question.json");
    let path = path.to_str().expect("UTF-8");
    let mut app = opened(120, 40);
    keys(&mut app, "'");
    assert!(text(&app).contains("nothing is marked"), "{}", text(&app));
    keys(&mut app, "gnr");
    enter(&mut app, "Mwhy R?");
    assert!(text(&app).contains("mark 1 of 1: why R?"), "{}", text(&app));
    let marked = app.model.address();
    enter(&mut app, ":3,4");
    enter(&mut app, "M");
    keys(&mut app, "'");
    settle(&mut app);
    assert_eq!(app.model.address(), marked);
    assert!(text(&app).contains("mark 1 of 2"), "{}", text(&app));
    enter(&mut app, &format!("\"{path}"));
    assert!(text(&app).contains("2 marks are in"), "{}", text(&app));
    // No file is replaced.
    enter(&mut app, &format!("\"{path}"));
    assert!(text(&app).contains("cannot be written"), "{}", text(&app));

    let written = std::fs::read_to_string(path).expect("written");
    let marks = crate::debug::marks::Marks::from_json(&written).expect("marks");
    let size = (marks.size[0], marks.size[1]);
    let mut there = super::support::app_with(90, 30, |options| {
        options.size = Some(size);
        options.marks = Some(marks);
    });
    settle(&mut there);
    assert!(text(&there).contains("2 marks"), "{}", text(&there));
    keys(&mut there, "'");
    settle(&mut there);
    assert_eq!(there.model.address(), marked);
}

#[test]
fn two_settings_are_seen_in_turn_and_their_difference() {
    let mut app = app(60, 20);
    key(&mut app, KeyCode::Tab);
    assert!(
        text(&app).contains("there is no other picture"),
        "{}",
        text(&app)
    );
    // What stands above the line of keys is the same with each.
    let picture = |app: &Program| {
        let drawn = buffer(app);
        let cells = app.model.panes().picture;
        let rows = cells.y..cells.bottom();
        rows.flat_map(|y| (cells.x..cells.right()).map(move |x| (x, y)))
            .map(|at| drawn[at].clone())
            .collect::<Vec<_>>()
    };
    keys(&mut app, "j");
    keys(&mut app, "k");
    let exact = picture(&app);
    enter(&mut app, "=fresnel=none");
    keys(&mut app, "j");
    keys(&mut app, "k");
    let none = picture(&app);
    assert_ne!(exact, none);
    for expected in [&exact, &none, &exact] {
        key(&mut app, KeyCode::Tab);
        keys(&mut app, "jk");
        assert!(picture(&app) == *expected);
    }
    // The pictures are apart where there is glass, and nowhere else.
    keys(&mut app, "d");
    assert!(text(&app).contains("difference: "), "{}", text(&app));
    let apart = app.model.shown();
    let (mut same, mut other) = (0, 0);
    let (width, height) = app.model.picture.size;
    for at in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
        match apart.exact(at) {
            Some(crate::lab::show::ShownValue::Number(0.0)) => same += 1,
            Some(crate::lab::show::ShownValue::Number(_)) => other += 1,
            shown => panic!("{at:?}: {shown:?}"),
        }
    }
    assert!(same > other && other > 20, "{same}, {other}");
}
