//! The end of a ray: what it found, and what it brings back.

use super::screen::to_screen;
use super::term::weighted;
use super::{Explanation, UNKNOWN};
use crate::math::Rgb;
use crate::probe::RayKind;
use crate::trace::View;
use crate::trace::format::{counted, num, rgb, vec3};
use crate::trace::ledger::{self, Summand};

/// A ray leaves the scene.
pub fn miss(view: View) -> Explanation {
    Explanation::new(
        "miss",
        "The ray hits nothing: what comes back is the background.",
    )
    .color("background", view.world.scene.background)
}

/// A shadow ray arrives.
pub fn lit(view: View, node: u32) -> Explanation {
    let sent = &view.trace.tree.node(node).ray;
    Explanation::new(
        "lit",
        format!(
            "Nothing stands before `{}`: its diffuse and specular terms count.",
            view.light_name(sent.light)
        ),
    )
    .row("distance", num(sent.t_max))
}

/// A shadow ray is stopped.
pub fn blocked(view: View, node: u32) -> Explanation {
    let sent = &view.trace.tree.node(node).ray;
    let light = view.light_name(sent.light);
    let Some(surface) = view.surface_hit(node) else {
        return Explanation::new("blocked", format!("Something stands before `{light}`."));
    };
    let note = if surface.material.is_transmissive() {
        " (it is transparent, but shadow rays are straight and do not refract, so it blocks as well)"
    } else {
        ""
    };
    let explanation = Explanation::new(
        format!("blocked by `{}`", surface.object.name),
        format!(
            "`{}` stands before `{light}`{note}: the point is in its shadow and the light adds nothing.",
            surface.object.name
        ),
    )
    .row("t", format!("{} < {}, the distance to the light", num(surface.hit.t), num(sent.t_max)))
    .row("point", vec3(surface.at.point));
    self_hit(view, node, explanation)
}

/// Adds that a ray hit the surface that it had just left, if it did.
pub fn self_hit(view: View, node: u32, explanation: Explanation) -> Explanation {
    if !view.is_self_hit(node) {
        return explanation;
    }
    explanation.row(
        "self-hit",
        format!(
            "this is the surface that the ray has just left: rounding put its origin on the wrong side (offset {})",
            view.settings.arithmetic.offset
        ),
    )
}

/// A ray is done: the ledger of its radiance.
pub fn returned(view: View, node: u32, radiance: Rgb) -> Explanation {
    let tree = &view.trace.tree;
    let this = tree.node(node);
    if this.ray.kind == RayKind::Light {
        return Explanation::new(
            "the shadow ray is done",
            "Its answer is lit or blocked; the light's terms are added where it was sent.",
        );
    }
    let mut explanation = Explanation::new(
        format!("{} brings back its sum", this.ray.kind.letter()),
        "The terms and the weighted rays, added in this order, are the radiance to the last bit.",
    );
    for estimate in view.light_estimates(node) {
        let light = view.light_name(estimate.light);
        let name = format!("+ {light}, {}", counted(estimate.lit.into(), "sample"));
        explanation = explanation.color(name, estimate.mean);
    }
    for summand in ledger::summands(tree, node) {
        explanation = match summand {
            Summand::Term { light, .. } if view.is_area(light) => explanation,
            Summand::Term { term, light } => {
                let light = view.light_name(light);
                let space = if light.is_empty() { "" } else { " " };
                explanation.color(format!("+ {}{space}{light}", term.name()), term.value())
            }
            Summand::Child {
                kind,
                weight,
                radiance,
                ..
            } => explanation.color(format!("+ weight x {}", kind.letter()), weight * radiance),
        };
    }
    let weight = view.sample_weight(node);
    let is_whole = view.trace.is_whole();
    let share = if is_whole {
        format!("{:.1}", view.fraction(node) * 100.0)
    } else {
        UNKNOWN.to_owned()
    };
    let explanation = explanation.color("radiance", radiance).row(
        "in the pixel",
        format!(
            "{}{} x {} = {} ({share} % of its brightness)",
            weighted(weight),
            rgb(this.throughput),
            rgb(radiance),
            rgb(this.total() * weight),
        ),
    );
    if this.parent.is_none() && is_whole {
        return to_screen(view, node, radiance, explanation);
    }
    explanation
}
