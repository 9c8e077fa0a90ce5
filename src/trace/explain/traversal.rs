//! The traversal of the acceleration structure: nodes visited and primitives tested.

use super::{Explanation, shapes};
use crate::geometry::{Arithmetic, Body, Naive, Shape};
use crate::math::{DVec3, Ray};
use crate::probe::{Event, RayKind, RayRecord, Verdict, Visit};
use crate::trace::View;
use crate::trace::format::{counted, num, vec3};

/// Tests that are looked through for the leaf that they belong to.
const MAX_LEAF: usize = 10_000;

/// A node is visited or skipped.
pub fn visit(view: View, node: u32, visit: &Visit) -> Explanation {
    let sent = &view.trace.tree.node(node).ray;
    let [t0, t1] = visit.interval;
    let held = view.world.accel.node(visit.node);
    let held = held.map_or(0, |node| node.primitives.len());
    let reason = if visit.is_leaf() && held == 0 {
        "empty: there is nothing to test"
    } else {
        visit.choice.reason()
    };
    let mut explanation = Explanation::new(format!("node {}", visit.node), sentence(reason));
    if !visit.is_missed() {
        explanation = explanation.row("interval", format!("{} < t < {}", num(t0), num(t1)));
    }
    if visit.is_leaf() {
        explanation = explanation.row("holds", counted(held as u64, "shape"));
    }
    let Some((n, d)) = view.world.accel.plane(visit.node) else {
        return explanation;
    };
    let (n_o, n_d) = (n.dot(sent.origin), n.dot(sent.direction));
    explanation
        .row("plane", plane(n, d))
        .row(
            "t of the plane",
            format!(
                "(d - n.o) / (n.direction) = ({} - {}) / {} = {}",
                num(d),
                num(n_o),
                num(n_d),
                num((d - n_o) / n_d)
            ),
        )
        .row("near", child(view, visit.near))
        .row("far", child(view, visit.far))
}

/// A plane as an equation: `x = 2` along an axis, else with its normal.
fn plane(n: DVec3, d: f64) -> String {
    for (axis, name) in [(DVec3::X, "x"), (DVec3::Y, "y"), (DVec3::Z, "z")] {
        if n == axis {
            return format!("{name} = {}", num(d));
        }
    }
    format!("{} . p = {}", vec3(n), num(d))
}

fn child(view: View, id: u32) -> String {
    match view.world.accel.node(id) {
        None => "empty".to_owned(),
        Some(node) if node.children.is_none() && node.primitives.is_empty() => {
            format!("node {id}, an empty leaf")
        }
        Some(_) => format!("node {id}"),
    }
}

/// A primitive is tested, by a ray in a leaf of the accelerator, or outside of it.
pub fn test(
    view: View,
    (node, leaf): (u32, Option<&Visit>),
    (primitive, verdict, t): (u32, Verdict, f64),
) -> Explanation {
    let scene = &view.world.scene;
    let shape = &scene.shapes[primitive as usize];
    let sent = &view.trace.tree.node(node).ray;
    let mut explanation = Explanation::new(
        format!(
            "test {} {}: {}",
            scene.object_of(primitive).name,
            scene.local_index(primitive),
            verdict.name()
        ),
        sentence(verdict.reason()) + beyond(sent, leaf, verdict, t),
    );
    let ray = Ray::new(sent.origin, sent.direction);
    let parts = &scene.object_of(primitive).leaves;
    explanation = shapes::add(explanation, (shape, parts), &ray);
    if let Shape::Naive(naive) = shape {
        explanation = explanation.row("arithmetic", tested_with(naive));
    }
    if t.is_finite() {
        explanation = explanation.row("t", num(t));
    }
    explanation
}

/// What a hit behind its leaf is worth.
fn beyond(sent: &RayRecord, leaf: Option<&Visit>, verdict: Verdict, t: f64) -> &'static str {
    if verdict != Verdict::Hit || leaf.is_none_or(|leaf| t <= leaf.interval[1]) {
        ""
    } else if sent.kind == RayKind::Light {
        " It lies beyond this leaf, but any hit before the light ends the search of a shadow ray."
    } else {
        " It lies beyond this leaf: it is kept in mind, and the search goes on, since a shape in a node before it may be closer."
    }
}

/// The leaf whose primitives are tested at an event; `None` outside of leaves, and for shapes on the plane of a node.
pub fn leaf_at(view: View<'_>, event: usize) -> Option<&Visit> {
    let before = view.trace.tree.events.get(..event)?;
    let mut tested = 0;
    for event in before.iter().rev().take(MAX_LEAF) {
        match event {
            Event::Test { .. } => tested += 1,
            Event::Visit(visit) => {
                let node = view.world.accel.node(visit.node)?;
                return (visit.is_leaf() && tested < node.primitives.len()).then_some(visit);
            }
            _ => return None,
        }
    }
    None
}

/// The algorithm and the precision of a test that is not raytree's own.
fn tested_with(naive: &Naive) -> String {
    let Arithmetic {
        triangle,
        quadratic,
        quartic,
        precision,
        ..
    } = naive.arithmetic;
    let algorithm = match naive.shape {
        Shape::Triangle(_) => format!("{}, ", triangle.name()),
        ref shape if shape.mesh().is_some() => format!("{}, ", triangle.name()),
        Shape::Sphere(_) => format!("quadratic {}, ", quadratic.name()),
        Shape::Body(ref body) => match **body {
            Body::Quadric(_) | Body::BoxedQuadric(_) => format!("quadratic {}, ", quadratic.name()),
            Body::Torus(_) | Body::Quartic(_) => format!("quartic {}, ", quartic.name()),
            Body::Csg(_) => String::new(),
        },
        _ => String::new(),
    };
    format!("{algorithm}{} precision", precision.name())
}

fn sentence(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().map_or(String::new(), |first| {
        format!("{}{}.", first.to_uppercase(), letters.as_str())
    })
}
