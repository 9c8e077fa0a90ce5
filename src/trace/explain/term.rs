//! Terms of the shading equation.

use super::Explanation;
use crate::probe::{Term, highlight};
use crate::trace::View;
use crate::trace::format::{degrees, num, rgb, vec3};

/// A term of the shading equation.
pub fn term(view: View, node: u32, term: &Term, light: (u32, u32)) -> Explanation {
    let throughput = view.trace.tree.node(node).throughput;
    let value = term.value();
    let weight = view.sample_weight(node);
    base_term(view, node, term, light)
        .color(term.name(), value)
        .row(
            "in the pixel",
            format!(
                "{}{} x {} = {}",
                weighted(weight),
                rgb(throughput),
                rgb(value),
                rgb(throughput * value * weight)
            ),
        )
}

/// The weight of a sample as a factor; nothing where it is 1.
pub fn weighted(weight: f64) -> String {
    if weight == 1.0 {
        return String::new();
    }
    format!("{} x ", num(weight))
}

fn base_term(view: View, node: u32, term: &Term, light: (u32, u32)) -> Explanation {
    let mut name = view.light_name(light.0).to_owned();
    if view.is_area(light.0) {
        name = format!("{name}, sample {}", light.1);
    }
    match *term {
        Term::Ambient { ka, ia } => Explanation::new(
            "ambient term",
            "Light that comes from everywhere is guessed by a constant, once a hit.",
        )
        .color("Ka", ka)
        .color("Ia", ia)
        .row("", "Ka Ia"),
        Term::Projected { kd, light, .. } => Explanation::new(
            format!("diffuse term of `{name}`"),
            "The place on the light was chosen in proportion to what it brings, so every sample brings the same: the whole light's share.",
        )
        .color("Kd", kd)
        .row("P", format!("{}, the light's projected solid angle", num(light.solid_angle)))
        .color("Le P / (pi samples)", light.irradiance())
        .row("", "Kd Le P / (pi samples)"),
        Term::Diffuse { kd, intensity, n_dot_l } => {
            let explanation = Explanation::new(
                format!("diffuse term of `{name}`"),
                "A matt surface is the brighter the straighter the light falls on it, seen from everywhere alike.",
            )
            .color("Kd", kd)
            .color("I", intensity);
            directions(view, node, light, explanation)
                .row("N.L", format!("{} ({})", num(n_dot_l), degrees(n_dot_l)))
                .row("", "Kd I (N.L)")
        }
        Term::Specular { ks, intensity, r_dot_v, shininess } => Explanation::new(
            format!("specular term of `{name}`"),
            "The highlight: how near the mirrored light comes to the viewer, sharpened by the exponent.",
        )
        .color("Ks", ks)
        .color("I", intensity)
        .row("R.V", format!("{} ({})", num(r_dot_v), degrees(r_dot_v)))
        .row("n", num(shininess))
        .row("(R.V)^n", num(highlight(r_dot_v, shininess)))
        .row("", "Ks I (R.V)^n"),
        Term::Emission(_) => Explanation::new("emission", "The surface shines by itself."),
        Term::Background(_) => Explanation::new("background", "Behind everything stands this colour."),
    }
}

/// N at the hit of a node, and L to a sample of a light.
fn directions(view: View, node: u32, light: (u32, u32), explanation: Explanation) -> Explanation {
    let Some((hit, seen)) = view.surface_hit(node).zip(view.light_sample(node, light)) else {
        return explanation;
    };
    explanation
        .row("N", vec3(hit.at.normal))
        .row("L", vec3(seen.direction))
}
