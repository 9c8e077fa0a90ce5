//! Numbers of the scene that change while it is looked at.

use crossterm::event::KeyCode;
use ratatui::buffer::Buffer;

use super::support::{
    app, buffer, enter, is_as_set, key, keys, of_scene, of_source, opened, settle, text,
};
use crate::probe::Silent;
use crate::scene::effects::effects;
use crate::scene::{Edit, Effect, Patch, flags, source};
use crate::tracer::pixel;
use crate::tui::model::{Overlay, Prompt};
use crate::tui::terminal::program::Program;

#[test]
fn the_picture_follows_a_change_and_its_undoing_bit_by_bit() {
    let mut app = app(60, 20);
    let before = buffer(&app);
    let mut shown: Vec<Buffer> = Vec::new();
    for change in [
        "=material.glass.ior=1.1",
        "=samples=4",
        "=light.sun.intensity*=0.5",
        "=camera.eye[0]+=1",
        "=depth=1",
        "=object.mirror sphere.radius=0.5",
    ] {
        app.model.message = None;
        shown.push(buffer(&app));
        enter(&mut app, change);
        is_as_set(&app);
        assert_ne!(Some(&buffer(&app)), shown.last(), "{change}");
    }
    assert_eq!(app.model.world.scene.changes.len(), 4);
    assert!(text(&app).contains("4 changes: press C"), "{}", text(&app));
    // All of it is taken back in one order.
    while let Some(then) = shown.pop() {
        keys(&mut app, "U");
        settle(&mut app);
        app.model.message = None;
        assert_eq!(buffer(&app), then);
    }
    assert_eq!(buffer(&app), before);
    assert_eq!(app.model.patch, Patch::default());
}

#[test]
fn an_open_tree_is_traced_again_at_the_same_ray() {
    let mut app = opened(120, 40);
    keys(&mut app, "t");
    let path = app.model.address().path;
    assert_eq!(path.steps.len(), 1, "{path}");
    let trace = |app: &Program| app.model.session.as_ref().map(|s| s.trace.pixel.color);
    let before = trace(&app);
    enter(&mut app, "=material.glass.ior=1.6");
    assert_eq!(app.model.address().path, path);
    assert_ne!(trace(&app), before);
    assert!(text(&app).contains("1 change: press C"), "{}", text(&app));
    // Where the ray is gone, it is what led to it.
    enter(&mut app, "=material.glass.transmission=[0,0,0]");
    assert_eq!(app.model.address().path.steps.len(), 0);
    assert!(text(&app).contains("any more"), "{}", text(&app));
    keys(&mut app, "UU");
    settle(&mut app);
    assert_eq!(trace(&app), before);
}

#[test]
fn effects_outlines_and_warnings_follow() {
    let mut app = of_scene("shadows", 80, 24, |_| ());
    settle(&mut app);
    app.model.settings.effects = effects(&app.model.world.scene);
    assert!(!app.model.settings.effects.has(Effect::Reflection));
    let before = app.model.settings;
    let material = app.model.world.scene.materials[0].name.clone();
    let outlines = format!("{:?}", app.model.outlines);
    enter(
        &mut app,
        &format!("=material.{material}.mirror=[0.1,0.1,0.1]"),
    );
    assert!(app.model.settings.effects.has(Effect::Reflection));
    let finding = |app: &Program| {
        app.model
            .findings
            .iter()
            .any(|f| f.on && f.effect == Effect::Reflection)
    };
    assert!(finding(&app));
    is_as_set(&app);
    assert!(app.model.world.scene.warnings.is_empty());
    enter(&mut app, &format!("=material.{material}.diffuse=[200,0,0]"));
    assert!(
        text(&app).contains(" 1 warning: press w "),
        "{}",
        text(&app)
    );
    // What was left out stays out.
    let reflection = app
        .model
        .findings
        .iter()
        .position(|f| f.effect == Effect::Reflection)
        .expect("one");
    app.model.overlay = Some(Overlay::Effects(reflection));
    keys(&mut app, " ");
    keys(&mut app, "q");
    let object = app.model.world.scene.objects[0].name.clone();
    enter(
        &mut app,
        &format!("=object.{object}.transform=[{{\"translate\":[0,0.5,0]}}]"),
    );
    assert_eq!(app.model.message, None, "{:?}", app.model.message);
    assert!(!app.model.settings.effects.has(Effect::Reflection));
    assert_ne!(format!("{:?}", app.model.outlines), outlines);
    is_as_set(&app);
    // Back at the scene as it was, its effects are those of then, whatever was left out since.
    app.model.overlay = Some(Overlay::Effects(0));
    keys(&mut app, " q");
    assert!(
        app.model.findings[0].on && !app.model.settings.effects.has(app.model.findings[0].effect)
    );
    // Leaving an effect out is a change like any other.
    keys(&mut app, "UUUUU");
    settle(&mut app);
    assert_eq!(app.model.settings, before);
    assert!(!finding(&app) && app.model.undone.is_empty());
    is_as_set(&app);
}

#[test]
fn what_is_wrong_is_told_and_the_text_stays() {
    let mut app = app(80, 24);
    let before = buffer(&app);
    for (typed, told) in [
        ("material.glas.ior=1.3", "did you mean `glass`?"),
        ("material.glass.iro=1.3", "did you mean `ior`?"),
        ("material.glass.ior=1000", "a number from 0.01 to 100"),
        (
            "lamp.sun.intensity=1",
            "what can be changed is camera, background",
        ),
        ("background=1", "write"),
    ] {
        enter(&mut app, &format!("={typed}"));
        let stays = Overlay::Prompt(Prompt::Set, typed.to_owned());
        assert_eq!(app.model.overlay, Some(stays));
        let shown = text(&app);
        // Words may stand on two lines.
        let words: Vec<&str> = shown.split_whitespace().collect();
        assert!(words.join(" ").contains(told), "{told}: {shown}");
        assert!(shown.contains(typed), "{shown}");
        key(&mut app, KeyCode::Esc);
    }
    app.model.message = None;
    assert_eq!(buffer(&app), before);
    assert!(app.model.undone.is_empty());
    // What is so already is no change.
    enter(&mut app, "=material.glass.ior=1.5");
    assert!(text(&app).contains("it is so already"), "{}", text(&app));
    assert!(app.model.undone.is_empty());
}

#[test]
fn the_numbers_of_the_scene_are_among_the_examples() {
    let mut app = app(80, 24);
    keys(&mut app, "=");
    let mut seen = Vec::new();
    for _ in 0..40 {
        key(&mut app, KeyCode::Down);
        let Some(Overlay::Prompt(_, typed)) = &app.model.overlay else {
            panic!("a prompt")
        };
        seen.push(typed.clone());
    }
    for wanted in [
        "light.sun.intensity=[0.95,0.92,0.85]",
        "light.sun.position=[-4,9,5]",
        "material.glass.ior=1.5",
        "material.mirror.mirror=[0.82,0.84,0.86]",
        "camera.eye=[0,1.5,6.5]",
        "samples=16",
    ] {
        assert!(seen.iter().any(|text| text == wanted), "{wanted}: {seen:?}");
    }
    // Each of the scene's own is what the scene has.
    for text in seen
        .iter()
        .filter(|text| text.contains('.') || text.contains("background"))
    {
        let edits = [Edit::Typed(text.clone())];
        let (_, patch) = source("whitted")
            .expect("a source")
            .changed(&edits)
            .expect("a change");
        assert!(patch.is_empty(), "{text}");
    }
}

#[test]
fn changes_are_shown_and_written_and_read() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("patch.json");
    let path = path.to_str().expect("UTF-8");
    let mut app = app(100, 40);
    keys(&mut app, "C");
    assert!(text(&app).contains("nothing is changed"), "{}", text(&app));
    keys(&mut app, "q");
    enter(&mut app, "P/nowhere/a.json");
    assert!(
        text(&app).contains("nothing of the scene is changed"),
        "{}",
        text(&app)
    );
    key(&mut app, KeyCode::Esc);
    enter(&mut app, "=material.glass.ior=1.3");
    enter(&mut app, "=light.sun.intensity=[1,0.5,0]");
    enter(&mut app, "=samples=4");
    keys(&mut app, "C");
    let shown = text(&app);
    for part in [
        "light.sun.intensity=[1,0.5,0]",
        "material.glass.ior=1.3",
        "\"ior\": 1.3",
        "--samples 4",
        "--change material.glass.ior=1.3",
    ] {
        assert!(shown.contains(part), "{part}: {shown}");
    }
    keys(&mut app, "q");
    for told in ["written: raytree view whitted --patch", "cannot be written"] {
        enter(&mut app, &format!("P{path}"));
        assert!(text(&app).contains(told), "{}", text(&app));
        key(&mut app, KeyCode::Esc);
        app.model.request = crate::tui::model::Request::Stay;
    }
    let (patch, _) = Patch::read(path.as_ref()).expect("a patch");
    assert_eq!(
        patch,
        Patch::from_json(&app.model.patch.to_json()).expect("a patch")
    );
    let (scene, _) = source("whitted")
        .expect("a source")
        .changed(&[Edit::Patch(patch)])
        .expect("changed");
    assert_eq!(scene.hash, app.model.world.scene.hash);
}

#[test]
fn the_copied_command_opens_what_is_shown() {
    let mut app = opened(100, 36);
    enter(&mut app, "=material.glass.ior=1.3");
    enter(&mut app, "=light.sun.intensity=[1,0.5,0]");
    enter(&mut app, "=object.glass sphere.center[1]+=0.1");
    enter(&mut app, "=depth=3");
    let command = app.model.open_command();
    assert!(
        command.contains("--change 'object.glass sphere.center=[-0.5,1.1800000000000002,1.4]'"),
        "{command}"
    );
    let scene = &app.model.world.scene;
    for change in &scene.changes {
        let word = crate::scene::printable::shell_word(change);
        assert!(command.contains(&format!(" --change {word}")), "{command}");
    }
    // As the program opens it: the changes one by one, and the settings.
    let edits: Vec<Edit> = scene.changes.iter().cloned().map(Edit::Typed).collect();
    let (there, patch) = source("whitted")
        .expect("a source")
        .changed(&edits)
        .expect("changed");
    assert_eq!((&there.hash, &patch), (&scene.hash, &app.model.patch));
    assert_eq!(
        flags(&app.model.settings, &there),
        flags(&app.model.settings, scene)
    );
    let session = app.model.session.as_ref().expect("a tree");
    let at = (session.trace.x, session.trace.y);
    let world = crate::world::World::new(there, app.model.settings.accel);
    let traced = pixel(&world, &app.model.settings, at, &mut Silent);
    assert_eq!(traced.color, session.trace.pixel.color);
    assert_eq!(app.model.picture.color(at), Some(traced.color));
}

#[test]
fn a_change_that_takes_long_is_given_up_by_escape() {
    let mut app = of_scene("bunny", 60, 20, |_| ());
    settle(&mut app);
    let hash = app.model.world.scene.hash.clone();
    for letter in "=camera.eye[0]+=1".chars() {
        app.press(KeyCode::Char(letter).into());
    }
    app.press(KeyCode::Enter.into());
    assert!(app.model.changing.is_some(), "it takes longer than a frame");
    // Meanwhile nothing else is changed.
    app.press(KeyCode::Char('}').into());
    assert!(text(&app).contains("Esc gives that up"), "{}", text(&app));
    assert!(app.model.undone.is_empty());
    app.press(KeyCode::Esc.into());
    settle(&mut app);
    assert_eq!(
        (app.model.patch.is_empty(), &app.model.world.scene.hash),
        (true, &hash)
    );
    // Another one is made as if nothing had been.
    enter(&mut app, "=camera.eye[0]+=2");
    assert_eq!(app.model.world.scene.changes.len(), 1);
    assert_ne!(app.model.world.scene.hash, hash);
    is_as_set(&app);
}

#[test]
fn a_scene_that_was_opened_with_changes_goes_on_from_them() {
    let source = source("whitted").expect("a source");
    let edits = [Edit::Typed("material.glass.ior=1.3".to_owned())];
    let (_, patch) = source.changed(&edits).expect("changed");
    let mut app = of_source("whitted", source, (80, 24), |options| {
        options.patch = patch.clone();
    });
    settle(&mut app);
    enter(&mut app, "=material.glass.ior+=0.5");
    assert_eq!(app.model.world.scene.changes, ["material.glass.ior=1.8"]);
    keys(&mut app, "U");
    settle(&mut app);
    assert_eq!((&app.model.patch, app.model.undone.len()), (&patch, 0));
}
