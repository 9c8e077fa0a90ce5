//! Runs stop where break points say.

use std::sync::Arc;
use std::time::Duration;

use super::*;
use crate::probe::RayKind;
use crate::scene::load;
use crate::world::World;

fn session(scene: &str, at: (u32, u32)) -> Session {
    let scene = load(scene).expect("built in");
    let settings = scene
        .settings
        .with(|s| (s.image.width, s.image.height) = (64, 48));
    Session::new(Arc::new(World::new(scene, settings.accel)), settings, at)
}

fn later() -> Instant {
    Instant::now() + Duration::from_secs(60)
}

/// Where all runs in a direction stop.
fn stops(session: &Session, points: &[BreakPoint], forward: bool) -> Vec<usize> {
    let last = session.tree().events.len() - 1;
    let mut at = if forward { 0 } else { last };
    let mut stops = Vec::new();
    while let Run::Stopped(event, _) = run(session, points, at, forward, later()) {
        stops.push(event);
        at = event;
    }
    stops
}

#[test]
fn what_is_ready_stops_where_it_says() {
    let session = session("nested-glass", (30, 24));
    let tree = session.tree();
    let mut many = 0;
    for text in READY {
        let point = BreakPoint::new(text).unwrap_or_else(|e| panic!("{text}: {e}"));
        let forward = stops(&session, std::slice::from_ref(&point), true);
        let mut back = stops(&session, std::slice::from_ref(&point), false);
        back.reverse();
        // The event at which a run begins does not stop it.
        back.retain(|at| *at != 0);
        let last = tree.events.len() - 1;
        let inner: Vec<_> = forward.iter().copied().filter(|at| *at != last).collect();
        assert_eq!(back, inner, "{text}");
        let first = usize::from(point.stops_at(&session, 0));
        let all = point.count(&session, last).expect("a small tree").1;
        assert_eq!(all, forward.len() + first, "{text}");
        for at in &forward {
            let event = &tree.events[*at];
            let fits = match text {
                "absent" => matches!(event, Event::Absent { .. }),
                "new object" => matches!(event, Event::Hit(_)),
                "test:*" => matches!(event, Event::Test { .. }),
                "node:0" => matches!(event, Event::Visit(v) if v.node == 0),
                _ => matches!(event, Event::Ray(_) | Event::Absent { .. }),
            };
            assert!(fits, "{text} at {at}: {event:?}");
        }
        many += usize::from(!forward.is_empty());
        assert!(text != "invalid" || forward.is_empty());
    }
    assert!(many >= 8, "{many} of them stop somewhere");
}

#[test]
fn the_deepest_and_the_largest_are_those() {
    let session = session("whitted", (32, 24));
    let tree = session.tree();
    let of = |text: &str| {
        let found = stops(&session, &[BreakPoint::new(text).expect(text)], true);
        found
            .into_iter()
            .map(|at| tree.node_of_event(at).expect("a ray"))
            .collect::<Vec<_>>()
    };
    let deepest = tree.nodes.iter().map(|n| n.ray.depth).max().expect("rays");
    let count = tree.nodes.iter().filter(|n| n.ray.depth == deepest).count();
    assert_eq!(of("deepest").len(), count);
    let largest = of("largest");
    assert_eq!(largest.len(), 1);
    let share = |n: u32| session.view().fraction(n);
    for (n, node) in (0..).zip(&tree.nodes) {
        let is_sent_on = matches!(node.ray.kind, RayKind::Reflected | RayKind::Transmitted);
        assert!(!is_sent_on || share(n) <= share(largest[0]), "ray {n}");
    }
}

#[test]
fn one_triangle_of_a_mesh_can_be_meant() {
    let session = session("teapot", (32, 26));
    let of = |text: &str| stops(&session, &[BreakPoint::new(text).expect(text)], true);
    let all = of("test:teapot");
    let scene = &session.world.scene;
    let number = |at: usize| match session.tree().events[at] {
        Event::Test { primitive, .. } => scene.local_index(primitive),
        ref event => panic!("{event:?}"),
    };
    let first = number(all[0]);
    let one = of(&format!("test:teapot#{first}"));
    assert!(!one.is_empty() && one.len() < all.len());
    assert!(one.iter().all(|at| number(*at) == first));
}

#[test]
fn numbers_that_are_none_stop_a_run() {
    let mut session = session("whitted", (32, 24));
    let last = session.tree().events.len() - 1;
    session.trace.tree.events[last] = Event::Return {
        radiance: crate::math::Rgb::WHITE * f64::NAN,
    };
    let point = [BreakPoint::new("invalid").expect("a word")];
    assert_eq!(
        run(&session, &point, 0, true, later()),
        Run::Stopped(last, 0)
    );
    if let Event::Ray(sent) = &mut session.trace.tree.events[1] {
        sent.direction *= 1.001;
    }
    assert_eq!(run(&session, &point, 0, true, later()), Run::Stopped(1, 0));
}

#[test]
fn a_run_that_takes_long_pauses_and_goes_on() {
    let session = session("nested-glass", (30, 24));
    let never = [BreakPoint::new("hits:nothing").expect("a query")];
    let (mut at, mut pauses) = (0, 0);
    while let Run::Paused(event) = run(&session, &never, at, true, Instant::now()) {
        assert!(event > at);
        (at, pauses) = (event, pauses + 1);
    }
    assert!(pauses > 1, "{pauses}");
}

#[test]
fn what_is_no_break_point_is_told() {
    for (text, told) in [
        ("node:x", "`x` is no number"),
        ("test:ball#x", "`x` is no number of a shape"),
        ("deepst", "did you mean `deepest`?"),
        ("nothing like it", "test:NAME"),
        ("", "letter 1"),
    ] {
        let error = BreakPoint::new(text).expect_err(text);
        assert!(error.contains(told), "{text}: {error}");
    }
}
