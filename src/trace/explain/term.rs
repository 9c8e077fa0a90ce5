//! The terms of the shading equation.

use super::Explanation;
use crate::math::Rgb;
use crate::probe::Term;
use crate::trace::format::{degrees, num, rgb, vec3};
use crate::trace::{Lighting, View};

/// A term of the shading equation.
pub fn term(view: View, node: u32, term: Term, light: (u32, u32), value: Rgb) -> Explanation {
    let explanation = base_term(view, node, term, light);
    let throughput = view.trace.tree.node(node).throughput;
    explanation.color(term.name(), value).row(
        "in the pixel",
        format!(
            "{} x {} = {}",
            rgb(throughput),
            rgb(value),
            rgb(throughput * value)
        ),
    )
}

fn base_term(view: View, node: u32, term: Term, light: (u32, u32)) -> Explanation {
    let mut name = view.light_name(light.0).to_owned();
    if view.is_area(light.0) {
        name = format!("{name}, sample {}", light.1);
    }
    let surface = view.surface_hit(node);
    let lighting = surface.and_then(|hit| view.lighting(node, &hit, light));
    match (term, surface, lighting) {
        (Term::Ambient, Some(surface), _) => Explanation::new(
            "ambient term",
            "Light that comes from everywhere is guessed by a constant, once a hit.",
        )
        .color("Ka", surface.material.ambient_at(surface.at.uv))
        .color("Ia", view.world.scene.ambient)
        .row("", "Ka Ia"),
        (Term::Diffuse, Some(_), Some(Lighting { light: seen, projected: Some(area), kd, .. })) => Explanation::new(
            format!("diffuse term of `{name}`"),
            "The place on the light was chosen in proportion to what it brings, so every sample brings the same: the whole light's share.",
        )
        .color("Kd", kd)
        .row("P", format!("{}, the light's projected solid angle", num(area)))
        .color("Le P / (pi samples)", seen.irradiance.unwrap_or(Rgb::BLACK))
        .row("", "Kd Le P / (pi samples)"),
        (Term::Diffuse, Some(surface), Some(l)) => Explanation::new(
            format!("diffuse term of `{name}`"),
            "A matt surface is the brighter the straighter the light falls on it, seen from everywhere alike.",
        )
        .color("Kd", l.kd)
        .color("I", l.light.intensity)
        .row("N", vec3(surface.at.normal))
        .row("L", vec3(l.light.direction))
        .row("N.L", format!("{} ({})", num(l.n_dot_l), degrees(l.n_dot_l)))
        .row("", "Kd I (N.L)"),
        (Term::Specular, Some(surface), Some(l)) => Explanation::new(
            format!("specular term of `{name}`"),
            "The highlight: how near the mirrored light comes to the viewer, sharpened by the exponent.",
        )
        .color("Ks", surface.material.specular)
        .color("I", l.light.intensity)
        .row("R.V", format!("{} ({})", num(l.r_dot_v), degrees(l.r_dot_v)))
        .row("n", num(surface.material.shininess))
        .row(
            "(R.V)^n",
            num(libm::pow(l.r_dot_v.max(0.0), surface.material.shininess)),
        )
        .row("", "Ks I (R.V)^n"),
        (Term::Emission, ..) => {
            Explanation::new("emission", "The surface shines by itself.")
        }
        (Term::Background, ..) => {
            Explanation::new("background", "Behind everything stands this colour.")
        }
        _ => Explanation::new(format!("{} term", term.name()), "A term of the shading equation."),
    }
}
