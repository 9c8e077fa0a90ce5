//! Terms of the shading equation.

use super::Explanation;
use super::corners::blended;
use crate::math::Rgb;
use crate::probe::{Term, highlight};
use crate::shading::{LightKind, LightSample};
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
    let name = view.light_label(light);
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
            arriving(view, node, light, directions(view, node, light, explanation))
                .row("N.L", format!("{} ({})", num(n_dot_l), degrees(n_dot_l)))
                .row("", "Kd I (N.L)")
        }
        Term::Specular { ks, intensity, r_dot_v, shininess } => mirrored(view, node, light, Explanation::new(
            format!("specular term of `{name}`"),
            "The highlight: how near the mirrored light comes to the viewer, sharpened by the exponent.",
        )
        .color("Ks", ks)
        .color("I", intensity))
        .row("R.V", format!("{} ({})", num(r_dot_v), degrees(r_dot_v)))
        .row("n", num(shininess))
        .row("(R.V)^n", num(highlight(r_dot_v, shininess)))
        .row("", "Ks I (R.V)^n"),
        Term::Blended { kind, corners } => blended(view, node, (kind, corners), light),
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

/// R, the direction to the light mirrored at N, and V, that to the viewer.
fn mirrored(view: View, node: u32, light: (u32, u32), explanation: Explanation) -> Explanation {
    let Some((hit, seen)) = view.surface_hit(node).zip(view.light_sample(node, light)) else {
        return explanation;
    };
    let (n, l) = (hit.at.normal, seen.direction);
    let r = 2.0 * n.dot(l) * n - l;
    explanation
        .row("L", vec3(l))
        .row("N", vec3(n))
        .row("R", format!("2 (N.L) N - L = {}", vec3(r)))
        .row("V", vec3(hit.at.to_viewer))
}

/// How I, what arrives from a sample of a light, was computed.
fn arriving(view: View, node: u32, light: (u32, u32), explanation: Explanation) -> Explanation {
    if let Some(asked) = view.asked_point(node, light) {
        return explanation
            .row("point on the light", vec3(asked.point))
            .color("Le", asked.radiance)
            .row("A", format!("{} square metres", num(asked.area)))
            .row(
                "cos'",
                format!(
                    "{} at the light ({})",
                    num(asked.cosine),
                    degrees(asked.cosine)
                ),
            )
            .row(
                "r",
                format!(
                    "{}, r^2 = {}",
                    num(asked.distance),
                    num(asked.distance * asked.distance)
                ),
            )
            .row("samples", asked.samples.to_string())
            .row("I", "Le A cos' / (pi r^2 samples)");
    }
    let lights = &view.world.scene.lights;
    let Some((kind, seen)) = lights
        .get(light.0 as usize)
        .map(|l| &l.kind)
        .zip(view.light_sample(node, light))
    else {
        return explanation;
    };
    match kind {
        LightKind::Point {
            intensity,
            attenuation,
            ..
        } => attenuated(explanation, (*attenuation, *intensity), &seen),
        LightKind::Spot {
            intensity,
            attenuation,
            exponent,
            ..
        } => attenuated(explanation, (*attenuation, *intensity), &seen).row(
            "fall-off",
            format!(
                "cos^e = {}^{}, cos between the spot's axis and -L",
                num(seen.cos_angle),
                num(*exponent)
            ),
        ),
        LightKind::Directional { .. } | LightKind::Area(_) => explanation,
    }
}

/// How the intensity of a light falls with the distance.
fn attenuated(
    explanation: Explanation,
    ([a, b, c], intensity): ([f64; 3], Rgb),
    seen: &LightSample,
) -> Explanation {
    let r = seen.distance;
    let numbers = [a, b, r, c, r * r, seen.attenuation].map(num);
    let [a, b, r, c, squared, factor] = numbers;
    explanation
        .color("I of the light", intensity)
        .row("r", r.as_str())
        .row(
            "attenuation",
            format!("1 / (a + b r + c r^2) = 1 / ({a} + {b} {r} + {c} {squared}) = {factor}"),
        )
}
