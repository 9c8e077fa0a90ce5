//! The steps of a ray beside those that it takes through another structure, or in another order.

#[cfg(test)]
mod tests;

use super::session::Session;
use super::steps::StepText;
use crate::accel::AccelKind;
use crate::math::{Interval, Ray};
use crate::probe::{Event, Probe as _, RayKind};
use crate::trace::address::{node_at, path_of};
use crate::trace::format::counted;
use crate::trace::{Outcome, PixelTrace, RayTree, Recorder};
use crate::tracer::Pixel;
use crate::world::World;

/// Steps of a ray at most that are aligned with others; of more each stands beside the one of its number.
const ALIGNED: usize = 2000;

/// Shapes of a scene at most for which another structure is built while the user waits.
const BUILT: usize = 20_000;

/// One ray in two ways.
pub struct StepsBeside {
    /// What both cost and find, in words.
    pub told: String,
    /// The steps, each in its own order.
    pub pairs: Vec<StepPair>,
    /// The session of the other way, with its cursor in that ray.
    pub other: Session,
}

/// A step of the one way, of the other one, or the same of both, as indices of events.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StepPair {
    /// In this session.
    pub a: Option<usize>,
    /// In the other one.
    pub b: Option<usize>,
    /// True if both do the same: test the same shape, or visit the same node of the same tree.
    pub is_same: bool,
}

/// The current ray's steps, beside those through a structure of another kind.
pub fn through(session: &Session, kind: AccelKind) -> Result<StepsBeside, String> {
    let scene = &session.world.scene;
    if scene.shapes.len() > BUILT {
        return Err(format!(
            "the scene has more than {BUILT} shapes; raytree cost --knob accelerator compares structures"
        ));
    }
    let node = ray(session)?;
    let settings = session.settings.with(|s| s.accel = kind);
    let world = World::new(scene.clone(), kind);
    let mut other = Session::new(world.into(), settings, (session.trace.x, session.trace.y));
    let path = path_of(session.view(), node);
    let there = node_at(other.view(), &path)?;
    other.go_to_event(other.tree().node(there).first_event as usize);
    let names = [session.settings.accel.name(), kind.name()];
    Ok(beside(
        session,
        other,
        names,
        session.settings.accel == kind,
    ))
}

/// The current ray's steps, beside those that it takes if the far child of each node comes first.
pub fn far_first(session: &Session) -> Result<StepsBeside, String> {
    let node = ray(session)?;
    let sent = session.tree().node(node).ray;
    let is_shadow = sent.kind == RayKind::Light;
    let interval = Interval::before(sent.t_max);
    let line = Ray::new(sent.origin, sent.direction);
    let (accel, shapes) = (&session.world.accel, &session.world.scene.shapes);
    let mut recorder = Recorder::<true>::default();
    recorder.event(Event::Ray(sent));
    let hit = accel.hit_far_first(shapes, (&line, interval), is_shadow, &mut recorder);
    let Some(hit) = hit else {
        return Err(
            "only a bsp tree has a near and a far child here: = accel=bsp first".to_owned(),
        );
    };
    recorder.event(match (hit, is_shadow) {
        (Some(hit), false) => Event::Hit(hit),
        (None, false) => Event::Miss,
        (Some(hit), true) => Event::Blocked(hit),
        (None, true) => Event::Lit,
    });
    let trace = PixelTrace {
        x: session.trace.x,
        y: session.trace.y,
        pixel: Pixel::default(),
        tree: RayTree::new(recorder),
    };
    let other = Session::of(session.world.clone(), session.settings, trace);
    Ok(beside(session, other, ["near first", "far first"], true))
}

/// The ray under the cursor: it must have been searched for something.
fn ray(session: &Session) -> Result<u32, String> {
    let node = session.node().filter(|_| !session.steps().is_empty());
    node.ok_or_else(|| "go to a ray first that is searched for a hit".to_owned())
}

fn beside(session: &Session, other: Session, names: [&str; 2], is_same_tree: bool) -> StepsBeside {
    let pairs = pairs(session, &other, is_same_tree);
    let cost = |session: &Session, name: &str| {
        let tree = &session.step_tree;
        let nodes = match session.nodes {
            0 => String::new(),
            _ => format!("{}, ", counted(tree.visited as u64, "node")),
        };
        format!("{name}: {nodes}{}", counted(tree.tested as u64, "test"))
    };
    let ends = [session, &other].map(|session| {
        let node = session.node()?;
        found(session, session.tree().node(node).outcome)
    });
    let agree = if ends[0] == ends[1] {
        let what = ends[0].as_deref().unwrap_or("nothing");
        format!("Both find {what}.")
    } else if session
        .node()
        .is_some_and(|n| session.tree().node(n).ray.kind == RayKind::Light)
    {
        "Both find that something is in the way: which, depends on the order.".to_owned()
    } else {
        "They do not find the same: this is a bug.".to_owned()
    };
    let told = format!(
        "{}. {}. {agree}",
        cost(session, names[0]),
        cost(&other, names[1])
    );
    StepsBeside { told, pairs, other }
}

/// What a ray meets, in words; none of a ray that is not done.
fn found(session: &Session, outcome: Option<Outcome>) -> Option<String> {
    let scene = &session.world.scene;
    Some(match outcome? {
        Outcome::Hit(hit) | Outcome::Blocked(hit) => {
            let name = &scene.object_of(hit.primitive).name;
            format!("`{name}` {} at t {}", scene.face_of(&hit), hit.t)
        }
        Outcome::Miss => "no hit".to_owned(),
        Outcome::Lit => "nothing in the way".to_owned(),
    })
}

/// What a step does, as far as it can be found again in the other way.
#[derive(Clone, Copy, PartialEq, Eq)]
enum StepKey {
    Test(u32),
    Node(u32),
}

fn keys(session: &Session, with_nodes: bool) -> Vec<Option<StepKey>> {
    let steps = session.tree().events.get(session.steps());
    let key = |event: &Event| match event {
        Event::Test { primitive, .. } => Some(StepKey::Test(*primitive)),
        Event::Visit(visit) if with_nodes => Some(StepKey::Node(visit.node)),
        _ => None,
    };
    steps.unwrap_or_default().iter().map(key).collect()
}

/// Both ways beside each other: as many steps as possible in one row with the same of the other.
fn pairs(a: &Session, b: &Session, with_nodes: bool) -> Vec<StepPair> {
    let (first_a, first_b) = (a.steps().start, b.steps().start);
    let (a, b) = (keys(a, with_nodes), keys(b, with_nodes));
    let common = if a.len() <= ALIGNED && b.len() <= ALIGNED {
        common(&a, &b)
    } else {
        Vec::new()
    };
    let mut pairs = Vec::new();
    let (mut i, mut j) = (0, 0);
    // What is only in one stands before the next step that is in both, row by row.
    for (to_i, to_j, is_end) in
        common
            .iter()
            .map(|&(i, j)| (i, j, false))
            .chain([(a.len(), b.len(), true)])
    {
        for row in 0..(to_i - i).max(to_j - j) {
            pairs.push(StepPair {
                a: (i + row < to_i).then_some(first_a + i + row),
                b: (j + row < to_j).then_some(first_b + j + row),
                is_same: false,
            });
        }
        if !is_end {
            pairs.push(StepPair {
                a: Some(first_a + to_i),
                b: Some(first_b + to_j),
                is_same: true,
            });
        }
        (i, j) = (to_i + 1, to_j + 1);
    }
    pairs
}

/// The longest common part of both, in order: pairs of indices.
fn common(a: &[Option<StepKey>], b: &[Option<StepKey>]) -> Vec<(usize, usize)> {
    let same = |i: usize, j: usize| a[i].is_some() && a[i] == b[j];
    let width = b.len() + 1;
    // How much is common behind the first i and j.
    let mut left = vec![0_u16; (a.len() + 1) * width];
    for i in (0..a.len()).rev() {
        for j in (0..b.len()).rev() {
            left[i * width + j] = if same(i, j) {
                left[(i + 1) * width + j + 1] + 1
            } else {
                left[(i + 1) * width + j].max(left[i * width + j + 1])
            };
        }
    }
    let (mut i, mut j, mut pairs) = (0, 0, Vec::new());
    while i < a.len() && j < b.len() {
        if same(i, j) {
            pairs.push((i, j));
            (i, j) = (i + 1, j + 1);
        } else if left[(i + 1) * width + j] >= left[i * width + j + 1] {
            i += 1;
        } else {
            j += 1;
        }
    }
    pairs
}

/// A step in a line: the lines of its tree, what it is and what it came to.
pub fn line(session: &Session, event: usize) -> String {
    StepText::new(session, event).map_or(String::new(), |step| {
        format!("{}{}{}", step.guides, step.name, step.result)
    })
}
