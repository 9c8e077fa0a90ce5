//! Runs stop where break points say.

use std::sync::Arc;
use std::time::Duration;

use super::*;
use crate::debug::breaks::READY;
use crate::probe::{Event, RayKind};
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

fn point(text: &str, session: &Session) -> BreakPoint {
    BreakPoint::new(text, Some(session)).unwrap_or_else(|e| panic!("{text}: {e}"))
}

/// Where a run from an event on stops.
fn run(session: &Session, points: &[BreakPoint], from: usize, forward: bool) -> Run {
    LogRun::new(points, from, forward).go_on(session, points, later())
}

/// Where all runs in a direction stop.
fn stops(session: &Session, points: &[BreakPoint], forward: bool) -> Vec<usize> {
    let last = session.tree().events.len() - 1;
    let mut at = if forward { 0 } else { last };
    let mut stops = Vec::new();
    while let Run::Stopped(event, _) = run(session, points, at, forward) {
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
        let point = point(text, &session);
        let forward = stops(&session, std::slice::from_ref(&point), true);
        let mut back = stops(&session, std::slice::from_ref(&point), false);
        back.reverse();
        // The event at which a run begins does not stop it.
        back.retain(|at| *at != 0);
        let last = tree.events.len() - 1;
        let inner: Vec<_> = forward.iter().copied().filter(|at| *at != last).collect();
        assert_eq!(back, inner, "{text}");
        let first = usize::from(point.is_single() && point.fits(&session, 0));
        if let Some(all) = point.all(&session) {
            let every = if point.is_single() { 1 } else { 3 };
            assert_eq!(all.len() / every, forward.len() + first, "{text}");
        }
        for at in &forward {
            let event = &tree.events[*at];
            let fits = match text {
                "absent" => matches!(event, Event::Absent { .. }),
                "new object" => matches!(event, Event::Hit(_)),
                "test:*" => matches!(event, Event::Test { .. }),
                "L blocked every 3rd" => matches!(event, Event::Blocked(_)),
                "changes:throughput" => {
                    matches!(event, Event::Ray(_))
                        || *at > 0 && matches!(tree.events[at - 1], Event::Return { .. })
                }
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
        let found = stops(&session, &[point(text, &session)], true);
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
    let of = |text: &str| stops(&session, &[point(text, &session)], true);
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
    let point = [point("invalid", &session)];
    assert_eq!(run(&session, &point, 0, true), Run::Stopped(last, 0));
    if let Event::Ray(sent) = &mut session.trace.tree.events[1] {
        sent.direction *= 1.001;
    }
    assert_eq!(run(&session, &point, 0, true), Run::Stopped(1, 0));
}

#[test]
fn a_run_that_takes_long_pauses_and_goes_on() {
    let session = session("nested-glass", (30, 24));
    let never = [point("hits:nothing", &session)];
    let mut run = LogRun::new(&never, 0, true);
    let (mut at, mut pauses) = (0, 0);
    while run.go_on(&session, &never, Instant::now()) == Run::Paused {
        assert!(run.at > at);
        (at, pauses) = (run.at, pauses + 1);
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
        ("absent every 0th", "every 3rd"),
        ("absent every third", "every 3rd"),
        ("absent every 3rd and tir", "every 3rd"),
        ("changes:throughput", "open the ray tree of a pixel first"),
    ] {
        let error = BreakPoint::new(text, None).expect_err(text);
        assert!(error.contains(told), "{text}: {error}");
    }
}

/// Whatever is counted: a break point at every n-th event stops at those, forwards and backwards, wherever a run begins and however
/// often it pauses.
#[test]
fn every_third_is_the_same_event_from_either_side() {
    let session = session("soft-shadow", (24, 36));
    let last = session.tree().events.len() - 1;
    for (what, every, ending) in [
        ("L blocked", 3, "3rd"),
        ("L lit", 2, "2"),
        ("test:*", 7, "7th"),
        ("depth >= 0", 1, "1st"),
    ] {
        let all = point(what, &session).all(&session).expect("a small tree");
        assert!(all.len() > 2 * every, "{what}: {}", all.len());
        let text = format!("{what} every {ending}");
        let points = [point("hits:nothing", &session), point(&text, &session)];
        let mut expected: Vec<usize> = all.chunks_exact(every).map(|c| c[every - 1]).collect();
        expected.retain(|at| *at != 0 && *at != last);
        assert_eq!(stops(&session, &points, true), expected, "{text}");
        let mut back = stops(&session, &points, false);
        back.reverse();
        assert_eq!(back, expected, "{text}, backwards");
        // From anywhere, with a pause at each look at the clock.
        for from in [1, all[1], all[every], last / 2, last / 3] {
            for forward in [true, false] {
                let mut run = LogRun::new(&points, from, forward);
                let mut stopped = run.go_on(&session, &points, Instant::now());
                while stopped == Run::Paused {
                    stopped = run.go_on(&session, &points, Instant::now());
                }
                let next = expected.iter().find(|at| **at > from);
                let before = expected.iter().rev().find(|at| **at < from);
                let wanted = if forward { next } else { before };
                let wanted = wanted.map_or(Run::Ended, |at| Run::Stopped(*at, 1));
                assert_eq!(stopped, wanted, "{text} from {from}, {forward}");
            }
        }
        assert_eq!(points[1].first_stop(&all), Some(all[every - 1]));
    }
}

#[test]
fn the_list_tells_the_counts() {
    let mut session = session("soft-shadow", (24, 36));
    let points = ["L blocked", "L blocked every 3rd"].map(|text| point(text, &session));
    let all = points[0].all(&session).expect("a small tree");
    session.go_to_event(all[3]);
    let told = list(&session, &points);
    let count = all.len();
    assert_eq!(
        told[0].0,
        format!("L blocked: {count} in this tree, 4 of them up to here")
    );
    assert_eq!(
        told[1].0,
        format!(
            "L blocked every 3rd: {count} in this tree, 4 of them up to here; stops at {} of them, 1 up to here",
            count / 3
        )
    );
    assert_eq!((told[0].1, told[1].1), (Some(all[0]), Some(all[2])));
}
