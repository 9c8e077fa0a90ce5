//! Steps of a ray through the acceleration structure, in words: nodes visited and skipped, shapes tested.

use super::session::Session;
use crate::probe::{Choice, Event, NONE, RayKind, Verdict, Visit};
use crate::trace::explain::UNKNOWN;
use crate::trace::format::{counted, num};

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
    /// The lines of the tree that lead to it.
    pub guides: String,
    /// The node or the shape.
    pub name: String,
    /// What was decided.
    pub result: String,
    /// Of a node its split plane and the part of the ray inside; of a shape outside of the tree why it is there.
    pub interval: String,
}

impl StepText {
    /// An event of the log; `None` if it is no traversal step of the current ray.
    pub fn new(session: &Session, event: usize) -> Option<Self> {
        let step = session.step_number(event)?;
        let told = match session.tree().events.get(event)? {
            Event::Visit(visit) => visited(session, visit),
            Event::Test {
                primitive,
                verdict,
                t,
            } => tested(session, step, *primitive, (*verdict, *t)),
            _ => return None,
        };
        Some(Self {
            guides: session.step_tree.guides(step),
            ..told
        })
    }
}

/// Where the cursor is among the steps, and how much of the structure they visit and test, in at most so many letters.
pub fn totals(session: &Session, width: usize) -> String {
    let kind = session.settings.accel.name();
    let steps = session.steps();
    if steps.is_empty() {
        return kind.to_owned();
    }
    let (nodes, tree) = (session.nodes, &session.step_tree);
    let (visited, tested) = (tree.visited, tree.tested);
    let shapes = session.world.scene.shapes.len();
    let step = session.step_number(session.cursor().position());
    let of = if is_cut(session) {
        UNKNOWN.to_owned()
    } else {
        steps.len().to_string()
    };
    let at = |long: bool| match step {
        Some(step) if long => format!(" step {} of {of}", step + 1),
        Some(step) => format!(" {}/{of}", step + 1),
        None => String::new(),
    };
    // A list has no nodes.
    let work = |of_nodes: String, of_shapes: String| {
        let nodes = (nodes > 0).then(|| format!("{visited}{of_nodes} nodes, "));
        format!("{}{tested}{of_shapes} shapes", nodes.unwrap_or_default())
    };
    let of_all = |of: &str| work(format!("{of}{nodes}"), format!("{of}{shapes}"));
    let ways = [
        format!("{kind}{}: {}", at(true), of_all(" of ")),
        format!("{kind}{}: {}", at(false), of_all(" of ")),
        format!("{kind}{}: {}", at(false), of_all("/")),
        format!(
            "{kind}{}: {}",
            at(false),
            work(String::new(), String::new())
        ),
        format!("{kind}{}", at(false)),
    ];
    let fits = |way: &&String| way.chars().count() <= width;
    ways.iter().find(fits).unwrap_or(&ways[4]).clone()
}

/// True if a question stands before the end of the steps.
pub fn is_cut(session: &Session) -> bool {
    session.horizon() == Some(session.steps().end)
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
    StepText {
        kind: if visit.is_skipped() {
            StepKind::Skipped
        } else {
            StepKind::Visited
        },
        guides: String::new(),
        name: format!("node {}", visit.node),
        result: choice(session, visit),
        interval: if visit.is_missed() {
            String::new()
        } else {
            format!("  {plane}inside t {t0}..{t1}")
        },
    }
}

fn choice(session: &Session, visit: &Visit) -> String {
    let node = session.world.accel.node(visit.node);
    let shapes = || match node.map_or(0, |node| node.primitives.len()) {
        0 => "empty, nothing to test".to_owned(),
        count => counted(count as u64, "shape"),
    };
    let child = |id: u32| match session.world.accel.node(id) {
        None => "empty".to_owned(),
        Some(node) if node.children.is_none() && node.primitives.is_empty() => {
            format!("{id} (empty)")
        }
        Some(_) => id.to_string(),
    };
    let (near, far) = (child(visit.near), child(visit.far));
    match visit.choice {
        Choice::Leaf => format!(" leaf: {}", shapes()),
        Choice::Cell => format!(" cell: {}", shapes()),
        Choice::Both => format!(" near {near}, far {far}"),
        Choice::BothInDoubt => format!(" near {near}, far {far} (in doubt)"),
        Choice::NearSplitBeyond => format!(" near {near}, not {far}: plane beyond"),
        Choice::NearRunsAway => format!(" near {near}, not {far}: runs away"),
        Choice::FarSplitBefore => format!(" far {far}, not {near}: plane before"),
        Choice::SkippedCloserHit => " skipped: a closer hit is known".to_owned(),
        Choice::SkippedOutside => " skipped: outside the box".to_owned(),
        Choice::Children if visit.near == NONE => " misses all children".to_owned(),
        Choice::Children if visit.far == NONE => format!(" on to {near}"),
        Choice::Children => format!(" on to {near}, then {far}, nearest first"),
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

/// A shape: where it is kept, hit or not, and where.
fn tested(
    session: &Session,
    step: usize,
    primitive: u32,
    (verdict, t): (Verdict, f64),
) -> StepText {
    let scene = &session.world.scene;
    let name = &scene.object_of(primitive).name;
    let number = scene.local_index(primitive);
    let above = session.step_tree.parent(step);
    let above = above.and_then(|step| session.tree().events.get(session.steps().start + step));
    let is_bounded = session
        .world
        .accel
        .unbounded()
        .binary_search(&primitive)
        .is_err();
    let (place, why) = match above {
        Some(Event::Visit(visit)) if !visit.is_leaf() => ("on the plane: ", ""),
        None if !is_bounded => ("before the tree: ", "  it has no bounds"),
        None if session.nodes > 0 => ("without the tree: ", "  the ray starts too far away"),
        _ => ("", ""),
    };
    let at = short(t);
    let (kind, result) = match verdict {
        Verdict::Hit => {
            let beyond = beyond_leaf(session, above, t);
            (StepKind::Hit, format!("hit at t {at}{beyond}"))
        }
        Verdict::Miss => (StepKind::NoHit, "miss".to_owned()),
        Verdict::TooFar => (StepKind::NoHit, format!("too far, t {at}")),
        Verdict::Behind => (StepKind::NoHit, format!("behind, t {at}")),
    };
    StepText {
        kind,
        guides: String::new(),
        name: format!("{place}test {name} {number}: "),
        result,
        interval: why.to_owned(),
    }
}

/// What is said of a hit that lies behind its leaf: closer ones may lie in nodes that come before it.
fn beyond_leaf(session: &Session, above: Option<&Event>, t: f64) -> &'static str {
    let Some(Event::Visit(visit)) = above else {
        return "";
    };
    let kind = session.node().map(|id| session.tree().node(id).ray.kind);
    if !visit.is_leaf() || t <= visit.interval[1] || kind == Some(RayKind::Light) {
        return "";
    }
    ", beyond this leaf: kept in mind"
}

/// Three decimals without trailing zeros, or a power of ten.
pub fn short(x: f64) -> String {
    if x.is_infinite() {
        return if x < 0.0 { "-∞" } else { "∞" }.to_owned();
    }
    if x == 0.0 || (1e-3..1e5).contains(&x.abs()) {
        let text = format!("{x:.3}");
        return text.trim_end_matches('0').trim_end_matches('.').to_owned();
    }
    num(x)
}
