//! The traversal of the acceleration structure: nodes visited and primitives tested.

use super::{Explanation, shapes};
use crate::geometry::{Arithmetic, Naive, Shape};
use crate::math::{DVec3, Ray};
use crate::probe::{NONE, Verdict, Visit};
use crate::trace::View;
use crate::trace::format::{num, vec3};

/// A node is visited or skipped.
pub fn visit(view: View, node: u32, visit: &Visit) -> Explanation {
    let sent = &view.trace.tree.node(node).ray;
    let [t0, t1] = visit.interval;
    let explanation = Explanation::new(
        format!("node {}", visit.node),
        sentence(visit.choice.reason()),
    )
    .row("interval", format!("{} < t < {}", num(t0), num(t1)));
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
        .row("near", child(visit.near))
        .row("far", child(visit.far))
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

fn child(node: u32) -> String {
    if node == NONE {
        "empty".to_owned()
    } else {
        format!("node {node}")
    }
}

/// A primitive is tested.
pub fn test(view: View, node: u32, primitive: u32, verdict: Verdict, t: f64) -> Explanation {
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
        sentence(verdict.reason()),
    );
    explanation = shapes::add(explanation, shape, &Ray::new(sent.origin, sent.direction));
    if let Shape::Naive(naive) = shape {
        explanation = explanation.row("arithmetic", tested_with(naive));
    }
    if t.is_finite() {
        explanation = explanation.row("t", num(t));
    }
    explanation
}

/// The algorithm and the precision of a test that is not raytree's own.
fn tested_with(naive: &Naive) -> String {
    let Arithmetic {
        triangle,
        quadratic,
        precision,
        ..
    } = naive.arithmetic;
    let algorithm = match naive.shape {
        Shape::Triangle(_) => format!("{}, ", triangle.name()),
        Shape::Sphere(_) => format!("quadratic {}, ", quadratic.name()),
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
