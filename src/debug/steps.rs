//! Steps of a ray through the acceleration structure, in words: nodes visited and skipped, shapes tested.

use super::session::Session;
use crate::probe::{Choice, Event, NONE, Verdict, Visit};
use crate::trace::format::num;

/// What a step came to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StepKind {
    /// A node was entered.
    Visited,
    /// A node was skipped.
    Skipped,
    /// A shape was hit.
    Hit,
    /// A shape was not hit within the interval.
    NoHit,
}

/// A traversal step in words.
#[derive(Clone, Debug, PartialEq)]
pub struct StepText {
    /// What it came to.
    pub kind: StepKind,
    /// The node or the shape.
    pub name: String,
    /// What was decided.
    pub result: String,
    /// Of a node: its split plane, and the part of the ray inside.
    pub interval: String,
}

impl StepText {
    /// An event of the log; `None` if it is no traversal step.
    pub fn new(session: &Session, event: usize) -> Option<Self> {
        match session.tree().events.get(event)? {
            Event::Visit(visit) => Some(visited(session, visit)),
            Event::Test {
                primitive,
                verdict,
                t,
            } => Some(tested(session, *primitive, *verdict, *t)),
            _ => None,
        }
    }
}

fn is_skipped(visit: &Visit) -> bool {
    matches!(
        visit.choice,
        Choice::SkippedCloserHit | Choice::SkippedOutside | Choice::SkippedMissed
    )
}

/// How many nodes the current ray visits, and how many shapes it is tested against.
pub fn visited_and_tested(session: &Session) -> (usize, usize) {
    let events = session
        .tree()
        .events
        .get(session.steps())
        .unwrap_or_default();
    let visits = events
        .iter()
        .filter(|e| matches!(e, Event::Visit(v) if !is_skipped(v)));
    let tests = events.iter().filter(|e| matches!(e, Event::Test { .. }));
    (visits.count(), tests.count())
}

/// A node: what is done and why not more, then where it is split and which part of the ray is inside.
fn visited(session: &Session, visit: &Visit) -> StepText {
    let [t0, t1] = visit.interval.map(short);
    let plane = session.world.accel.plane(visit.node);
    let plane = plane.map_or_else(String::new, |(n, d)| {
        let name = plane_name(n.to_array(), d);
        if visit.t_split.is_nan() {
            format!("{name}, ")
        } else {
            format!("{name} at t {}, ", short(visit.t_split))
        }
    });
    let skipped = is_skipped(visit);
    StepText {
        kind: if skipped {
            StepKind::Skipped
        } else {
            StepKind::Visited
        },
        name: format!("node {}", visit.node),
        result: choice(visit),
        interval: format!("  {plane}inside t {t0}..{t1}"),
    }
}

fn choice(visit: &Visit) -> String {
    let child = |id: u32| {
        if id == NONE {
            "empty".to_owned()
        } else {
            id.to_string()
        }
    };
    let (near, far) = (child(visit.near), child(visit.far));
    match visit.choice {
        Choice::Leaf => " leaf".to_owned(),
        Choice::Cell => " cell".to_owned(),
        Choice::Both => format!(" near {near}, far {far}"),
        Choice::BothInDoubt => format!(" near {near}, far {far} (in doubt)"),
        Choice::NearSplitBeyond => format!(" near {near}, not {far}: plane beyond"),
        Choice::NearRunsAway => format!(" near {near}, not {far}: runs away"),
        Choice::FarSplitBefore => format!(" far {far}, not {near}: plane before"),
        Choice::SkippedCloserHit => " skipped: a closer hit is known".to_owned(),
        Choice::SkippedOutside => " skipped: outside the box".to_owned(),
        Choice::Children => " the children it meets, nearest first".to_owned(),
        Choice::SkippedMissed => " skipped: misses its box".to_owned(),
    }
}

/// x = d across an axis, else the normal.
fn plane_name(n: [f64; 3], d: f64) -> String {
    let axis = (0..3).find(|i| n[*i].abs() == 1.0);
    if let Some(i) = axis {
        return format!("{} = {}", ["x", "y", "z"][i], short(d * n[i] + 0.0));
    }
    let [x, y, z] = n.map(short);
    format!("({x}, {y}, {z}).p = {}", short(d))
}

/// A shape: hit or not, and where.
fn tested(session: &Session, primitive: u32, verdict: Verdict, t: f64) -> StepText {
    let scene = &session.world.scene;
    let name = &scene.object_of(primitive).name;
    let number = scene.local_index(primitive);
    let t = short(t);
    let (kind, result) = match verdict {
        Verdict::Hit => (StepKind::Hit, format!("hit at t {t}")),
        Verdict::Miss => (StepKind::NoHit, "miss".to_owned()),
        Verdict::TooFar => (StepKind::NoHit, format!("too far, t {t}")),
        Verdict::Behind => (StepKind::NoHit, format!("behind, t {t}")),
    };
    StepText {
        kind,
        name: format!("  test {name} {number}: "),
        result,
        interval: String::new(),
    }
}

/// Three decimals without trailing zeros, or a power of ten.
fn short(x: f64) -> String {
    if x.is_infinite() {
        return "∞".to_owned();
    }
    if x == 0.0 || (1e-3..1e5).contains(&x.abs()) {
        let text = format!("{x:.3}");
        return text.trim_end_matches('0').trim_end_matches('.').to_owned();
    }
    num(x)
}
