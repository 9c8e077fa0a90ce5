//! TreeRow of the ray tree in words: guide lines, name, distance, share of the pixel, colour.

use super::rows::{RowKind, TreeRow, TreeRows};
use super::session::Session;
use crate::math::Rgb;
use crate::probe::{Event, RayKind};
use crate::trace::explain::UNKNOWN;
use crate::trace::format::num;
use crate::trace::{Node, Outcome, RayTree};

/// A row in words.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RowText {
    /// Guide lines from the root to the row.
    pub guides: String,
    /// ▸ closed, ▾ open, a blank if nothing hangs on it.
    pub fold: &'static str,
    /// The kind of the ray; `None` for a ray that was not spawned.
    pub kind: Option<RayKind>,
    /// What the ray met, or why there is none.
    pub name: String,
    /// Distance and share of the pixel, in columns.
    pub columns: String,
    /// The radiance that it brings back, as exposed; `None` for a ray that was not spawned, and where it is not known yet.
    pub color: Option<Rgb>,
}

impl RowText {
    /// A row without the guides of the first `shift` levels.
    pub fn new(session: &Session, row: TreeRow, shift: usize) -> Self {
        let mut text = match row.kind {
            RowKind::Absent => Self {
                name: absence(session, row),
                ..Self::default()
            },
            RowKind::LightSamples => light_samples(session, row),
            RowKind::Ray => ray(session, row.node),
        };
        text.guides = guides(session, row, shift);
        text.fold = match session.rows.has_children(row) {
            true if session.rows.is_closed(row) => "▸",
            true => "▾",
            false => " ",
        };
        text
    }
}

/// A ray: what it met, t, share of the pixel, colour.
fn ray(session: &Session, id: u32) -> RowText {
    let node = session.tree().node(id);
    let t = match node.outcome {
        Some(Outcome::Hit(hit) | Outcome::Blocked(hit)) => distance(hit.t),
        Some(Outcome::Lit) => distance(node.ray.t_max),
        None if !session.trace.is_whole() => UNKNOWN.to_owned(),
        _ => "∞".to_owned(),
    };
    let share = share(session, session.view().fraction(id));
    let color = if node.ray.kind == RayKind::Light {
        session.tree().lit_by(id)
    } else {
        node.radiance
    };
    let is_known = session.trace.is_whole() || is_known(session.tree(), id);
    RowText {
        kind: Some(node.ray.kind),
        name: format!(" {}", met(session, node)),
        columns: format!(" t {t:>8} {share:>6} % "),
        color: is_known.then_some(color * session.settings.image.exposure),
        ..RowText::default()
    }
}

/// A share of the pixel in percent; before its colour is known, nothing is.
fn share(session: &Session, share: f64) -> String {
    if session.trace.is_whole() {
        format!("{:.1}", share * 100.0)
    } else {
        UNKNOWN.to_owned()
    }
}

/// True if the log knows all that a ray brings: of an L ray the terms behind it as well.
fn is_known(tree: &RayTree, id: u32) -> bool {
    let node = tree.node(id);
    let behind = tree.events.get(node.last_event as usize + 1..);
    let is_own = |event: &&Event| {
        let ray = (node.ray.light, node.ray.sample);
        matches!(event, Event::Term { light, sample, .. } if (*light, *sample) == ray)
    };
    let is_followed = || behind.unwrap_or_default().iter().any(|e| !is_own(&e));
    let is_lit = node.outcome == Some(Outcome::Lit);
    tree.is_done(id) && (!is_lit || is_followed())
}

/// What a ray met.
fn met(session: &Session, node: &Node) -> String {
    let scene = &session.world.scene;
    let object = |primitive| &scene.object_of(primitive).name;
    let to = if node.ray.kind == RayKind::Light {
        format!("to {}: ", session.view().light_name(node.ray.light))
    } else {
        String::new()
    };
    match node.outcome {
        Some(Outcome::Hit(hit)) => format!("{to}{}", object(hit.primitive)),
        Some(Outcome::Blocked(hit)) => format!("{to}blocked by {}", object(hit.primitive)),
        Some(Outcome::Lit) => format!("{to}lit"),
        Some(Outcome::Miss) => format!("{to}background"),
        None if !session.trace.is_whole() => format!("{to}{UNKNOWN}"),
        None => format!("{to}not finished"),
    }
}

/// The samples of an area light together: how many are lit, share of the pixel, mean.
fn light_samples(session: &Session, row: TreeRow) -> RowText {
    let (view, tree) = (session.view(), session.tree());
    let Some(Event::LightSamples { light, samples }) = tree.events.get(row.event as usize) else {
        return RowText::default();
    };
    let bundle = view.light_estimate(row.node, *light);
    let name = view.light_name(*light);
    if !view.trace.is_whole() && !tree.is_done(row.node) {
        return RowText {
            kind: Some(RayKind::Light),
            name: format!(" {samples} to {name}: {UNKNOWN}"),
            columns: format!(" {UNKNOWN:>6} % "),
            ..RowText::default()
        };
    }
    let pixel = view.trace.pixel.color.luminance();
    let weight = tree.sample_of_node(row.node).map_or(1.0, |s| s.weight);
    let brought = tree.node(row.node).throughput * bundle.mean * weight;
    let share = share(
        session,
        if pixel > 0.0 {
            brought.luminance() / pixel
        } else {
            0.0
        },
    );
    RowText {
        kind: Some(RayKind::Light),
        name: format!(
            " {samples} to {name}: {} lit, {} blocked",
            bundle.lit, bundle.blocked
        ),
        columns: format!(" {share:>6} % "),
        color: Some(bundle.mean * session.settings.image.exposure),
        ..RowText::default()
    }
}

/// Which ray was not spawned, and why.
fn absence(session: &Session, row: TreeRow) -> String {
    match session.tree().events.get(row.event as usize) {
        Some(Event::Absent {
            kind,
            light,
            reason,
        }) => {
            let name = session.view().light_name(*light);
            let to = if name.is_empty() {
                String::new()
            } else {
                format!(" to {name}")
            };
            format!(" no {}{to}: {}", kind.letter(), reason.words())
        }
        _ => String::new(),
    }
}

/// The guide lines before a row: for each ray around it whether more follows below that.
fn guides(session: &Session, row: TreeRow, shift: usize) -> String {
    let tree = session.tree();
    let mut parts: Vec<&str> = Vec::new();
    let (mut at, mut own) = (row, true);
    let depth = TreeRows::depth(tree, row) as usize;
    // From the row to the root, but no further left than the pane reaches.
    for _ in shift..depth {
        parts.push(match (session.rows.is_last(tree, at), own) {
            (true, true) => "└─",
            (false, true) => "├─",
            (true, false) => "  ",
            (false, false) => "│ ",
        });
        own = false;
        let Some(above) = session.rows.above(tree, at) else {
            break;
        };
        at = above;
    }
    if shift > 0 {
        parts.push("…");
    }
    parts.reverse();
    parts.concat()
}

fn distance(x: f64) -> String {
    if x.is_infinite() {
        "∞".to_owned()
    } else if (1e-3..1e5).contains(&x) {
        format!("{x:.3}")
    } else {
        num(x)
    }
}
