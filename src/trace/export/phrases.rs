//! Phrases that the text and the page share: hits, boundaries, what a ray went through, steps through the accelerator.

use crate::shading::Side;
use crate::trace::document::{
    HitPoint, MediumBoundary, PassedSurface, TestedPrimitive, TraversalStep, VisitedChildren,
};
use crate::trace::format::{num, triple};

/// Where a ray hit its object: the primitive, side, point, normals and material.
pub fn hit(hit: &HitPoint) -> String {
    let side = match hit.side {
        Side::Front => "outside",
        Side::Back => "inside",
    };
    let shape = (hit.geometric_normal != hit.normal)
        .then(|| format!(", N of the shape {}", triple(hit.geometric_normal)));
    let weights = hit.barycentric;
    let weights = weights.map(|weights| format!(", barycentric {}", triple(weights)));
    let part = hit.part.as_ref().map(|part| format!(", part {part},"));
    format!(
        "primitive {}{} from {side} at {}, N {}{}{}, material {}",
        hit.primitive,
        part.unwrap_or_default(),
        triple(hit.point),
        triple(hit.normal),
        shape.unwrap_or_default(),
        weights.unwrap_or_default(),
        hit.material
    )
}

/// A surface that a ray went straight through.
pub fn passed(passed: &PassedSurface) -> String {
    format!(
        "straight through the surface of {} at t = {}, inside {}",
        passed.object,
        num(passed.t),
        passed.medium
    )
}

/// A boundary of a medium.
pub fn boundary(boundary: &MediumBoundary) -> String {
    let text = format!(
        "n1 {}, n2 {}, reflectance {}",
        num(boundary.n1),
        num(boundary.n2),
        num(boundary.reflectance)
    );
    match boundary.touching.as_slice() {
        [] => text,
        touching => text + ", crossed as one with " + &touching.join(", "),
    }
}

/// A step through the acceleration structure: what was visited or tested, and why nothing more.
pub fn step(step: &TraversalStep) -> String {
    match step {
        TraversalStep::Visit {
            node,
            plane,
            t_split,
            interval,
            near,
            far,
            visit,
            reason,
        } => {
            let [from, to] = interval.map(|t| t.map_or("...".to_owned(), num));
            let split = plane.map_or(String::new(), |plane| match t_split {
                Some(t) => format!("split by {} at t = {}; ", plane_of(plane), num(*t)),
                None => format!("split by {}; ", plane_of(plane)),
            });
            let next = next(*visit, *near, *far);
            format!("node {node}, inside for t from {from} to {to}; {split}{reason}{next}")
        }
        TraversalStep::Test {
            test: TestedPrimitive { object, primitive },
            result,
            t,
            reason,
        } => {
            let at = t.map_or(String::new(), |t| format!(" at t = {}", num(t)));
            format!("test {object} {primitive}: {}{at}, {reason}", result.word())
        }
    }
}

/// Where the ray goes from a node.
fn next(visit: VisitedChildren, near: Option<u32>, far: Option<u32>) -> String {
    let child = |id: Option<u32>| id.map_or("an empty side".to_owned(), |id| format!("node {id}"));
    match visit {
        VisitedChildren::Near => format!("; on to {}", child(near)),
        VisitedChildren::Far => format!("; on to {}", child(far)),
        VisitedChildren::Both => format!("; on to {}, then {}", child(near), child(far)),
        VisitedChildren::Children | VisitedChildren::None => String::new(),
    }
}

/// A plane as an equation: `x = 2` across an axis, else with its normal.
fn plane_of([a, b, c, d]: [f64; 4]) -> String {
    let normal = [a, b, c];
    let axis = normal
        .iter()
        .zip(["x", "y", "z"])
        .find(|(n, _)| n.abs() == 1.0);
    match axis {
        // The normal may point to either side. (Adding 0 makes 0 of -0.)
        Some((n, name)) => format!("{name} = {}", num(d * n + 0.0)),
        None => format!("{} . p = {}", triple(normal), num(d)),
    }
}
