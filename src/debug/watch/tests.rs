//! Watched numbers are what the log tells, and change where it tells another value.

use std::sync::Arc;

use super::*;
use crate::debug::running::running_sum;
use crate::probe::Event;
use crate::scene::load;
use crate::trace::format::rgb;
use crate::world::World;

fn session(scene: &str, at: (u32, u32)) -> Session {
    let scene = load(scene).expect("built in");
    let settings = scene.settings.with(|s| {
        (s.image.width, s.image.height) = (64, 48);
        s.light.samples = 4;
    });
    Session::new(Arc::new(World::new(scene, settings.accel)), settings, at)
}

fn sessions() -> [Session; 3] {
    [
        session("whitted", (32, 24)),
        session("nested-glass", (30, 24)),
        session("soft-shadow", (24, 36)),
    ]
}

fn watch(text: &str, session: &Session) -> Watch {
    Watch::new(text, session).unwrap_or_else(|e| panic!("{text}: {e}"))
}

/// Changes and values of a watch, beside those of a walk through the whole log by `told`, which knows nothing of watches.
fn check(session: &Session, text: &str, told: impl Fn(usize) -> Option<String>) -> usize {
    let watch = watch(text, session);
    let mut known: Option<String> = None;
    let mut changes = 0;
    for event in 0..session.tree().events.len() {
        let now = told(event);
        let changed = now.is_some() && now != known;
        assert_eq!(
            watch.changes_at(session, event),
            changed,
            "{text} at {event}"
        );
        let before = known.clone();
        known = now.or(known);
        changes += usize::from(changed);
        let state = watch.state(session, event);
        assert_eq!(state.changes, changed);
        assert_eq!(state.now.map(|now| now.text), known, "{text} at {event}");
        if changed {
            assert_eq!(state.before.map(|b| b.text), before, "{text} at {event}");
        }
    }
    changes
}

#[test]
fn what_is_watched_is_what_the_tree_tells() {
    for mut session in sessions() {
        let tree = session.tree().clone();
        let node = |event: usize| tree.node_of_event(event).map(|id| tree.node(id));
        let throughput = |event| node(event).map(|node| rgb(node.throughput));
        let depth = |event| node(event).map(|node| node.ray.depth.to_string());
        let radiance = |event: usize| match tree.events[event] {
            Event::Return { radiance } => Some(rgb(radiance)),
            _ => None,
        };
        assert!(check(&session, "throughput", throughput) > 0);
        assert!(check(&session, "depth", depth) > 1);
        assert!(check(&session, "radiance", radiance) > 1);
        let sums: Vec<_> = (0..tree.events.len())
            .map(|event| {
                session.go_to_event(event);
                running_sum(&session).map(|running| rgb(running.sum))
            })
            .collect();
        assert!(check(&session, "running sum", |event| sums[event].clone()) > 2);
    }
}

/// Numbers of the details, as they stand there.
#[test]
fn any_number_of_the_details_can_be_watched() {
    let session = session("whitted", (32, 24));
    for name in ["t", "n1", "Kd"] {
        let told = |event| {
            let rows = explain(session.view(), event).rows;
            rows.into_iter()
                .find(|row| row.name == name)
                .map(|row| row.text)
        };
        let watch = watch(name, &session);
        let mut known: Option<String> = None;
        let mut changes = 0;
        for event in 0..session.tree().events.len() {
            let (now, state) = (told(event), watch.state(&session, event));
            changes += usize::from(state.changes);
            assert!(
                !state.changes || now.is_some() && now != known,
                "{name} at {event}"
            );
            known = now.or(known);
            // What was told too long ago is not found.
            if let Some(shown) = state.now {
                assert_eq!(Some(shown.text), known, "{name} at {event}");
            }
        }
        assert!(changes > 0, "{name}");
    }
}

/// Of one ray: only its own steps tell it, and between them stands what it was.
#[test]
fn a_number_of_one_ray_stays_while_others_are_followed() {
    let session = session("whitted", (32, 24));
    let watch = watch("running sum of ray 0", &session);
    let root = *session.tree().node(0);
    let mut changes = Vec::new();
    for event in 0..session.tree().events.len() {
        let state = watch.state(&session, event);
        if event < root.first_event as usize {
            assert!(state.now.is_none());
            continue;
        }
        let told = state.now.expect("known").event;
        let tree = session.tree();
        assert_eq!(tree.node_of_event(told), Some(0), "{event}");
        if state.changes {
            changes.push(event);
        }
    }
    let last = watch.state(&session, usize::MAX >> 1).now.expect("known");
    assert_eq!(last.color, Some(root.radiance));
    assert!(changes.len() > 2, "{changes:?}");
}

#[test]
fn what_cannot_be_watched_is_told() {
    let session = session("whitted", (32, 24));
    for (text, told) in [
        ("thruput", "radiance, throughput, running sum, depth"),
        ("radianc", "did you mean `radiance`?"),
        ("depth of ray 99999", "there is no ray 99999"),
        ("depth of ray x", "there is no ray x"),
        ("", "no step near here tells ``"),
    ] {
        let error = Watch::new(text, &session).expect_err(text);
        assert!(error.contains(told), "{text}: {error}");
    }
    let names = names(&session);
    assert!(names.len() > FIELDS.len());
    for name in names {
        watch(&name, &session);
    }
}
