//! Break points: where a run through the log stops.

#[cfg(test)]
mod tests;

use std::time::Instant;

use super::session::Session;
use crate::math::DVec3;
use crate::probe::Event;
use crate::scene::read::did_you_mean::did_you_mean;
use crate::trace::TreeQuery;
use crate::trace::query::{Pattern, QueryError};

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

/// Break points of one word or two.
const SINGLE: [&str; 5] = ["absent", "deepest", "largest", "new object", "invalid"];

/// What may be typed beside a query.
const WORDS: &str = "or type absent, deepest, largest, new object, invalid, test:NAME, test:NAME#NUMBER, node:NUMBER";

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
    /// A test of a shape of such an object, of one of its shapes if that is named.
    Test(Pattern, Option<u32>),
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
                Some(("test", name)) => tests_of(name)?,
                Some(("node", number)) => BreakKind::Node(
                    number
                        .parse()
                        .map_err(|_| format!("`{number}` is no number of a node"))?,
                ),
                _ => {
                    let query: TreeQuery = text.parse().map_err(|error| no_break(text, &error))?;
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
            (BreakKind::Test(name, shape), Event::Test { primitive, .. }) => {
                let scene = &view.world.scene;
                name.matches(&scene.object_of(*primitive).name)
                    && shape.is_none_or(|shape| shape == scene.local_index(*primitive))
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

/// What a text may have meant that is no break point.
fn no_break(text: &str, error: &QueryError) -> String {
    let near = did_you_mean(text, SINGLE);
    near.map_or_else(
        || format!("{error}; {WORDS}"),
        |near| format!("did you mean `{near}`?"),
    )
}

/// Tests of `NAME`, or of one shape of it: `NAME#NUMBER`.
fn tests_of(text: &str) -> Result<BreakKind, String> {
    let Some((name, number)) = text.rsplit_once('#') else {
        return Ok(BreakKind::Test(Pattern(text.to_owned()), None));
    };
    match number.parse() {
        Ok(shape) => Ok(BreakKind::Test(Pattern(name.to_owned()), Some(shape))),
        Err(_) => Err(format!("`{number}` is no number of a shape")),
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
