//! Break points: where a run through the log stops.

use std::time::Instant;

use super::session::Session;
use crate::math::DVec3;
use crate::probe::Event;
use crate::trace::TreeQuery;
use crate::trace::query::Pattern;

/// Break points to begin with.
pub const READY: [&str; 11] = [
    "tir",
    "absent",
    "deepest",
    "largest",
    "new object",
    "invalid",
    "miss",
    "blocked:*",
    "test:*",
    "node:0",
    "depth >= 3",
];

/// What may be typed beside a query.
const WORDS: &str = "or type absent, deepest, largest, new object, invalid, test:NAME, node:NUMBER";

/// Events between two looks at the clock.
const BETWEEN: usize = 256;

/// Events of a tree at most of which all that stop a run are counted.
const COUNTED: usize = 50_000;

/// How far a direction's length may be from 1: some rounding errors.
const UNIT: f64 = 1e-12;

/// A break point.
#[derive(Clone, Debug, PartialEq)]
pub struct BreakPoint {
    /// As it was typed.
    pub text: String,
    kind: BreakKind,
}

#[derive(Clone, Debug, PartialEq)]
enum BreakKind {
    /// A ray that satisfies a query.
    Rays(TreeQuery),
    /// A ray that is not sent.
    Absent,
    /// A ray as deep as any in the tree.
    Deepest,
    /// The R or T ray that brings the pixel most of its light.
    Largest,
    /// The first hit on an object.
    NewObject,
    /// A number that is none or infinite, or a direction that is not of length 1.
    Invalid,
    /// A test of a shape of such an object.
    Test(Pattern),
    /// A visit to a node of the acceleration structure.
    Node(u32),
}

impl BreakPoint {
    /// A break point from its text. An error says what could be typed.
    pub fn new(text: &str) -> Result<Self, String> {
        let text = text.trim();
        let kind = match text {
            "absent" => BreakKind::Absent,
            "deepest" => BreakKind::Deepest,
            "largest" => BreakKind::Largest,
            "new object" => BreakKind::NewObject,
            "invalid" => BreakKind::Invalid,
            _ => match text.split_once(':') {
                Some(("test", name)) => BreakKind::Test(Pattern(name.to_owned())),
                Some(("node", number)) => BreakKind::Node(
                    number
                        .parse()
                        .map_err(|_| format!("`{number}` is no number of a node"))?,
                ),
                _ => {
                    let query: TreeQuery =
                        text.parse().map_err(|error| format!("{error}; {WORDS}"))?;
                    BreakKind::Rays(query.of_each_ray().clone())
                }
            },
        };
        Ok(Self {
            text: text.to_owned(),
            kind,
        })
    }

    /// True if a run stops at an event.
    pub fn stops_at(&self, session: &Session, event: usize) -> bool {
        let (view, tree) = (session.view(), session.tree());
        let Some(what) = tree.events.get(event) else {
            return false;
        };
        // The ray that begins here.
        let begins = || tree.node_of_event(event);
        match (&self.kind, what) {
            (BreakKind::Rays(query), Event::Ray(_) | Event::Absent { .. }) => {
                begins().is_some_and(|node| query.event(view, node) == Some(event))
            }
            (BreakKind::Absent, Event::Absent { .. }) => true,
            (BreakKind::Deepest, Event::Ray(sent)) => sent.depth == session.landmarks().deepest,
            (BreakKind::Largest, Event::Ray(_)) => session
                .landmarks()
                .largest
                .is_some_and(|node| begins() == Some(node)),
            (BreakKind::NewObject, Event::Hit(_)) => {
                let places = &session.landmarks().new_objects;
                places.binary_search(&(event as u32)).is_ok()
            }
            (BreakKind::Invalid, what) => is_invalid(what),
            (BreakKind::Test(name), Event::Test { primitive, .. }) => {
                name.matches(&view.world.scene.object_of(*primitive).name)
            }
            (BreakKind::Node(node), Event::Visit(visit)) => visit.node == *node,
            _ => false,
        }
    }

    /// Which of all its stops an event is, and how many there are; none in a tree of too many events.
    pub fn count(&self, session: &Session, event: usize) -> Option<(usize, usize)> {
        let events = session.tree().events.len();
        if events > COUNTED {
            return None;
        }
        let stops = (0..events).filter(|at| self.stops_at(session, *at));
        let (before, behind): (Vec<_>, Vec<_>) = stops.partition(|at| *at <= event);
        Some((before.len(), before.len() + behind.len()))
    }
}

/// True if a number of an event is none or infinite where it may not be, or a direction is not of length 1.
fn is_invalid(event: &Event) -> bool {
    let no_unit = |v: DVec3| {
        let off = (v.length_squared() - 1.0).abs();
        off.is_nan() || off > UNIT
    };
    match event {
        Event::Ray(sent) => {
            no_unit(sent.direction) || !sent.origin.is_finite() || !sent.weight.is_finite()
        }
        Event::Hit(hit) | Event::Blocked(hit) | Event::Passed { hit, .. } => !hit.t.is_finite(),
        Event::Term { term, .. } => !term.value().is_finite(),
        Event::Boundary {
            n1,
            n2,
            reflectance,
        } => ![n1, n2, reflectance].iter().all(|x| x.is_finite()),
        Event::Return { radiance } => !radiance.is_finite(),
        _ => false,
    }
}

/// What a run came to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Run {
    /// It stops at this event, because of the break point with this number.
    Stopped(usize, usize),
    /// It came to the end of the log.
    Ended,
    /// It came to this event when the time was over.
    Paused(usize),
}

/// Runs through the log from an event on, itself not included, until a break point stops it or the time is over.
pub fn run(
    session: &Session,
    points: &[BreakPoint],
    from: usize,
    forward: bool,
    until: Instant,
) -> Run {
    let last = session.tree().events.len();
    let mut at = from;
    for step in 1.. {
        let next = if forward {
            Some(at + 1).filter(|next| *next < last)
        } else {
            at.checked_sub(1)
        };
        let Some(next) = next else {
            return Run::Ended;
        };
        at = next;
        if let Some(by) = points.iter().position(|p| p.stops_at(session, at)) {
            return Run::Stopped(at, by);
        }
        if step % BETWEEN == 0 && Instant::now() >= until {
            return Run::Paused(at);
        }
    }
    Run::Ended
}

/// All break points: how often each stops a run through this tree, and where it does first.
pub fn list(session: &Session, points: &[BreakPoint]) -> Vec<(String, Option<usize>)> {
    let here = session.cursor().position();
    let events = session.tree().events.len().min(COUNTED);
    let line = |point: &BreakPoint| {
        let told = match point.count(session, here) {
            Some((before, all)) => {
                format!(
                    "{}: {all} in this tree, {before} of them up to here",
                    point.text
                )
            }
            None => format!("{}: not counted, the tree is large", point.text),
        };
        (told, (0..events).find(|at| point.stops_at(session, *at)))
    };
    points.iter().map(line).collect()
}

#[cfg(test)]
mod tests {
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
            ("deepst", "deepest"),
            ("", "letter 1"),
        ] {
            let error = BreakPoint::new(text).expect_err(text);
            assert!(error.contains(told), "{text}: {error}");
        }
    }
}
