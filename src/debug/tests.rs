//! The debugger without a screen, on recorded pixels.

mod accelerators;
mod horizon;

use std::sync::{Arc, Mutex};

use super::progressive::DrawnPixel;
use super::{
    PartialPicture, RowKind, RowText, Session, StepCommand, TreeRows, effects, pick, progressive,
};
use crate::lab::show::ShownValue;
use crate::probe::{Event, RayKind, Silent};
use crate::scene::effects::findings;
use crate::scene::{self, Bend, Effect, Settings};
use crate::trace::Outcome;
use crate::tracer::pixel;
use crate::world::World;

fn world(name: &str) -> (Arc<World>, Settings) {
    let scene = scene::load(name).expect("a built-in scene");
    let settings = scene
        .settings
        .with(|s| (s.image.width, s.image.height) = (64, 48));
    (Arc::new(World::new(scene, settings.accel)), settings)
}

fn session(name: &str, at: (u32, u32)) -> Session {
    let (world, settings) = world(name);
    Session::new(world, settings, at)
}

/// All that a step changes.
fn state(session: &Session) -> (usize, Option<u32>, usize, std::ops::Range<usize>) {
    let position = session.cursor().position();
    (position, session.node(), session.row(), session.steps())
}

#[test]
fn back_undoes_forward() {
    let mut session = session("whitted", (32, 24));
    let count = session.tree().events.len();
    assert!(count > 50, "{count}");
    let mut states = vec![state(&session)];
    for _ in 1..count {
        assert_eq!(session.step(StepCommand::Forward), Ok(()));
        states.push(state(&session));
    }
    for expected in states.iter().rev().skip(1) {
        assert_eq!(session.step(StepCommand::Back), Ok(()));
        assert_eq!(state(&session), *expected);
    }
}

#[test]
fn a_command_without_a_ray_says_so_and_stays() {
    let mut session = session("whitted", (32, 24));
    let none = |s: &mut Session| s.step(StepCommand::PreviousRay(RayKind::Transmitted));
    assert_eq!(
        none(&mut session),
        Err("no T ray comes before this".to_owned())
    );
    assert_eq!(session.cursor().position(), 0);
    assert_eq!(
        session.step(StepCommand::NextRay(RayKind::Transmitted)),
        Ok(())
    );
    let node = session.node().expect("a ray");
    assert_eq!(session.tree().node(node).ray.kind, RayKind::Transmitted);
}

#[test]
fn rows_match_the_tree() {
    for (name, at) in [("whitted", (32, 24)), ("soft-shadow", (32, 36))] {
        let mut session = session(name, at);
        // Stepping through all events opens all rows.
        while session.cursor().position() + 1 < session.tree().events.len() {
            assert_eq!(session.step(StepCommand::Forward), Ok(()));
        }
        let tree = session.tree();
        let stands = |e: &&Event| {
            matches!(
                e,
                Event::Ray(_) | Event::Absent { .. } | Event::LightSamples { .. }
            )
        };
        assert_eq!(
            session.rows.len(),
            tree.events.iter().filter(stands).count()
        );
        let rows: Vec<_> = (0..).map_while(|i| session.rows.get(i)).collect();
        let rays: Vec<u32> = rows
            .iter()
            .filter(|row| row.kind == RowKind::Ray)
            .map(|row| row.node)
            .collect();
        assert_eq!(rays, (0..tree.nodes.len() as u32).collect::<Vec<_>>());
        for (i, row) in rows.iter().enumerate() {
            assert_eq!(session.rows.of_event(tree, row.event as usize), i);
            let text = RowText::new(&session, *row, 0);
            let depth = TreeRows::depth(tree, *row) as usize;
            assert_eq!(text.guides.chars().count(), 2 * depth);
            assert_eq!(text.kind.is_none(), row.kind == RowKind::Absent);
        }
        let roots = rows
            .iter()
            .filter(|row| TreeRows::parent(tree, **row).is_none());
        assert_eq!(roots.count(), tree.samples.len());
        // A single camera ray brings all that the pixel has.
        let first = RowText::new(&session, rows[0], 0);
        let whole = first.columns.ends_with(" 100.0 % ");
        assert_eq!(whole, tree.samples.len() == 1, "{}", first.columns);
    }
}

#[test]
fn folding_hides_a_subtree_and_steps_open_it() {
    let mut session = session("whitted", (32, 24));
    session.go_to_row(0);
    let all = session.rows.len();
    session.toggle();
    assert_eq!(session.rows.len(), 1);
    session.fold(false);
    assert_eq!(session.rows.len(), all);
    session.fold(true);
    assert_eq!(
        session.step(StepCommand::NextRay(RayKind::Reflected)),
        Ok(())
    );
    assert_eq!(session.rows.len(), all);
    // A ray that hides nothing leads to its parent.
    session.go_to_row(all - 1);
    session.fold(true);
    assert_ne!(session.row(), all - 1);
}

#[test]
fn steps_stay_within_those_of_the_ray() {
    let mut session = session("whitted", (32, 24));
    session.go_to_event(1);
    let steps = session.steps();
    assert!(!steps.is_empty());
    // From outside, to the nearest; then by so many, as far as there are some.
    session.go_by_steps(1000);
    assert_eq!(session.cursor().position(), steps.start);
    session.go_by_steps(1000);
    assert_eq!(session.cursor().position(), steps.end - 1);
    session.go_by_steps(-1000);
    assert_eq!(session.cursor().position(), steps.start);
}

#[test]
fn picking_finds_what_the_camera_ray_hits() {
    let (world, settings) = world("whitted");
    let mut found = 0;
    for at in (0..48).step_by(5).map(|y| (y + 8, y)) {
        let session = Session::new(Arc::clone(&world), settings, at);
        let hit = match session.tree().node(0).outcome {
            Some(Outcome::Hit(hit)) => Some(hit),
            _ => None,
        };
        let picked = pick(&world, &settings, at);
        assert_eq!(picked.map(|p| p.t), hit.map(|hit| hit.t));
        if let (Some(picked), Some(hit)) = (picked, hit) {
            assert_eq!(picked.object, world.scene.object_of(hit.primitive).name);
            let text = super::pick::description(&world, &settings, at);
            assert_eq!(text, picked.to_string());
            found += 1;
        }
    }
    assert!(found > 3, "{found}");
    let sky = super::pick::description(&world, &settings, (0, 0));
    assert_eq!(sky, "nothing: the background");
}

#[test]
fn an_effect_is_switched_there_and_back() {
    let (world, mut settings) = world("soft-shadow");
    for finding in findings(&world.scene) {
        let switched = effects::switched(settings.effects, &finding);
        if !finding.on {
            assert!(switched.is_err_and(|e| e.contains("would change nothing")));
            continue;
        }
        let without = switched.expect("it is called for");
        assert!(!without.has(finding.effect));
        assert_eq!(effects::switched(without, &finding), Ok(settings.effects));
    }
    assert_eq!(
        effects::deviations(&settings, &findings(&world.scene)),
        None
    );
    settings.effects = settings.effects.without(Effect::Shadows);
    let told = |settings: &Settings| effects::deviations(settings, &findings(&world.scene));
    assert_eq!(told(&settings).as_deref(), Some("without shadows"));
    let bent = settings.with(|s| s.bends = Bend::FarRoot.into());
    assert_eq!(
        told(&bent).as_deref(),
        Some("bend far-root, without shadows")
    );
    let command = crate::scene::trace_command("soft-shadow", &world.scene, &settings, (3, 4));
    let end = "--size 64x48 --pixel 3,4 --without shadows";
    assert_eq!(command, format!("raytree trace soft-shadow {end}"));
}

#[test]
fn progressive_pixels_are_those_of_the_tracer() {
    let (world, settings) = world("triangle");
    let mut picture = PartialPicture::new((64, 48), (20, 10), (32, 24));
    let rendered = Mutex::new(Vec::new());
    let tell = |pixels| rendered.lock().expect("no panic").extend(pixels);
    let missing = picture.missing();
    let render = |threads, stopped: bool| {
        let stopped = move || stopped;
        progressive::render(
            (&world, &settings),
            None,
            &missing,
            threads,
            &stopped,
            &tell,
        )
    };
    assert!(!render(1, true));
    assert!(rendered.lock().expect("no panic").is_empty());
    assert!(render(2, false));
    let rendered = rendered.into_inner().expect("no panic");
    assert_eq!(rendered.len(), picture.window.area());
    for (at, drawn) in rendered {
        let DrawnPixel::Pixel(drawn) = drawn else {
            panic!("colours are drawn");
        };
        assert_eq!(drawn, pixel(&world, &settings, at, &mut Silent));
        picture.set(at, ShownValue::Color(drawn.color));
    }
    assert_eq!(picture.progress(), 1.0);
    // Another size keeps the cursor at the corresponding pixel; the same size changes nothing.
    assert!(picture.resized((64, 48), (20, 10)).is_none());
    let larger = picture.resized((128, 96), (20, 10)).expect("another size");
    assert_eq!(larger.cursor, (65, 49));
    assert_eq!(larger.progress(), 0.0);
}
