//! Break points: where a run through the log stops.

use super::session::Session;
use super::watch::Watch;
use crate::math::DVec3;
use crate::probe::Event;
use crate::scene::read::did_you_mean::did_you_mean;
use crate::trace::TreeQuery;
use crate::trace::query::{Pattern, QueryError};

/// Break points to begin with.
pub const READY: [&str; 13] = [
    "tir",
    "absent",
    "deepest",
    "largest",
    "new object",
    "invalid",
    "miss",
    "blocked:*",
    "L blocked every 3rd",
    "changes:throughput",
    "test:*",
    "node:0",
    "depth >= 3",
];

/// Break points of one word or two.
const SINGLE: [&str; 7] = [
    "absent",
    "deepest",
    "largest",
    "new object",
    "invalid",
    "L blocked",
    "L lit",
];

/// What may be typed beside a query.
const WORDS: &str = "or type absent, deepest, largest, new object, invalid, L blocked, L lit, test:NAME, test:NAME#NUMBER, \
                     node:NUMBER, changes:NUMBER; `every 3rd` behind any of them stops at each third";

/// Events of a tree at most of which all that fit a break point are counted.
const COUNTED: usize = 50_000;

/// How far a direction's length may be from 1: some rounding errors.
const UNIT: f64 = 1e-12;

/// A break point.
#[derive(Clone, Debug, PartialEq)]
pub struct BreakPoint {
    /// As it was typed.
    pub text: String,
    kind: BreakKind,
    /// Of the events that fit, counted from the first one of the log, it stops at each so many-th.
    every: usize,
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
    /// An L ray that is stopped on its way, or that reaches its light.
    Shadow(bool),
    /// Another value of a watched number.
    Changes(Watch),
}

impl BreakPoint {
    /// A break point from its text; the session tells which numbers there are. An error says what could be typed.
    pub fn new(text: &str, session: Option<&Session>) -> Result<Self, String> {
        let text = text.trim();
        let (what, every) = counted_by(text);
        let kind = match what {
            "L blocked" => BreakKind::Shadow(false),
            "L lit" => BreakKind::Shadow(true),
            "absent" => BreakKind::Absent,
            "deepest" => BreakKind::Deepest,
            "largest" => BreakKind::Largest,
            "new object" => BreakKind::NewObject,
            "invalid" => BreakKind::Invalid,
            _ => match what.split_once(':') {
                Some(("changes", number)) => {
                    let session = session.ok_or("open the ray tree of a pixel first")?;
                    BreakKind::Changes(Watch::new(number, session)?)
                }
                Some(("test", name)) => tests_of(name)?,
                Some(("node", number)) => BreakKind::Node(
                    number
                        .parse()
                        .map_err(|_| format!("`{number}` is no number of a node"))?,
                ),
                _ => {
                    let query: TreeQuery = what.parse().map_err(|error| no_break(what, &error))?;
                    BreakKind::Rays(query.of_each_ray().clone())
                }
            },
        };
        Ok(Self {
            text: text.to_owned(),
            kind,
            every,
        })
    }

    /// The break point at each change of a watched number.
    pub fn at_changes(watch: &Watch) -> Self {
        Self {
            text: format!("changes:{}", watch.text),
            kind: BreakKind::Changes(watch.clone()),
            every: 1,
        }
    }

    /// True if it stops at changes of a watched number.
    pub fn is_change(&self) -> bool {
        matches!(self.kind, BreakKind::Changes(_))
    }

    /// True if it stops at each event that fits.
    pub fn is_single(&self) -> bool {
        self.every == 1
    }

    /// True if it stops at the event that is the n-th to fit.
    pub fn stops_at_nth(&self, n: usize) -> bool {
        n.is_multiple_of(self.every)
    }

    /// True if an event is one that it is for.
    pub fn fits(&self, session: &Session, event: usize) -> bool {
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
            (BreakKind::Shadow(lit), Event::Lit) => *lit,
            (BreakKind::Shadow(lit), Event::Blocked(_)) => !*lit,
            (BreakKind::Changes(watch), _) => watch.changes_at(session, event),
            _ => false,
        }
    }

    /// The events that fit, in order; none in a tree of too many events, and of what takes long at each.
    pub fn all(&self, session: &Session) -> Option<Vec<usize>> {
        let events = session.tree().events.len();
        if events > COUNTED || self.is_change() {
            return None;
        }
        Some((0..events).filter(|at| self.fits(session, *at)).collect())
    }

    /// How often it stops a run, and how many of the events that fit are there up to one: in words.
    pub fn counted(&self, session: &Session, all: &[usize], event: usize) -> String {
        let place = place(session);
        let before = all.partition_point(|at| *at <= event);
        if self.is_single() {
            return format!("{} {place}, {before} of them up to here", all.len());
        }
        format!(
            "{} {place}, {before} of them up to here; stops at {} of them, {} up to here",
            all.len(),
            all.len() / self.every,
            before / self.every
        )
    }

    /// The first event at which a run from the start of the log stops.
    pub fn first_stop(&self, all: &[usize]) -> Option<usize> {
        all.get(self.every - 1).copied()
    }
}

/// Where stops are counted, in words.
pub fn place(session: &Session) -> &'static str {
    session
        .horizon()
        .map_or("in this tree", |_| "before the question")
}

/// A text without `every 3rd` at its end, and that number; 1 if there is none.
fn counted_by(text: &str) -> (&str, usize) {
    let number = |end: &str| {
        let digits = end.trim_end_matches(|c: char| c.is_ascii_lowercase());
        let is_ordinal = ["", "st", "nd", "rd", "th"].contains(&&end[digits.len()..]);
        let number = digits.parse().ok().filter(|number| *number > 0);
        number.filter(|_| is_ordinal)
    };
    let split = text.rsplit_once(" every ");
    split
        .and_then(|(what, end)| Some((what.trim(), number(end.trim())?)))
        .unwrap_or((text, 1))
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
