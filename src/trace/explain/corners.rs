//! Terms that are blended between the corners of a triangle: each corner with its numbers, then their sum.

use super::Explanation;
use crate::math::Rgb;
use crate::probe::{Absence, Term, TermKind, highlight};
use crate::trace::View;
use crate::trace::corner_terms::CornerTerm;
use crate::trace::format::{degrees, num, rgb, vec3};

/// A term that is blended between corners, whose shares are these.
pub fn blended(
    view: View,
    node: u32,
    (kind, shares): (TermKind, [Rgb; 3]),
    light: (u32, u32),
) -> Explanation {
    let title = match kind {
        TermKind::Ambient => "ambient term, blended".to_owned(),
        kind => format!(
            "{} term of `{}`, blended",
            kind.name(),
            view.light_label(light)
        ),
    };
    let sentence = match kind {
        TermKind::Ambient => {
            "By Gouraud's model it is computed at the corners of the triangle and blended by their weights at the hit."
        }
        _ => {
            "By Gouraud's model it is computed at the corners of the triangle and blended by their weights at the hit; only whether the light is seen is asked at the hit."
        }
    };
    let mut explanation = Explanation::new(title, sentence);
    let corners = view.corner_terms(node, kind, light);
    for (i, name) in ["a", "b", "c"].into_iter().enumerate() {
        if let Some(corners) = &corners {
            explanation = at_corner(explanation, name, kind, &corners[i]);
        }
        explanation = explanation.color(format!("share of {name}"), shares[i]);
    }
    explanation.row("", "the sum of the shares")
}

/// Rows about one corner: N, L and V there, the product, and the weight.
fn at_corner(
    explanation: Explanation,
    name: &str,
    kind: TermKind,
    corner: &CornerTerm,
) -> Explanation {
    let mut explanation = explanation.row(
        format!("corner {name}"),
        format!("{}, weight {}", vec3(corner.at.point), num(corner.weight)),
    );
    if kind != TermKind::Ambient {
        explanation = explanation.row("N", vec3(corner.at.normal));
    }
    if let Some((l, cosine)) = corner.to_light.zip(corner.n_dot_l()) {
        explanation = explanation
            .row("L", vec3(l))
            .row("N.L", format!("{} ({})", num(cosine), degrees(cosine)));
    }
    let term = match corner.term {
        Ok(term) => term,
        Err(Absence::FacingAway { .. }) => return explanation.row("", "0: it faces away"),
        Err(Absence::OutsideCone { .. }) => return explanation.row("", "0: outside of the cone"),
        Err(_) => return explanation.row("", "0: no such term here"),
    };
    let value = term.value();
    match term {
        Term::Ambient { ka, ia } => product(explanation, "Ka Ia", &[ka, ia], "", value),
        Term::Diffuse {
            kd,
            intensity,
            n_dot_l,
        } => {
            let cosine = format!(" x {}", num(n_dot_l));
            product(explanation, "Kd I (N.L)", &[kd, intensity], &cosine, value)
        }
        Term::Projected { kd, light, .. } => {
            let factors = [kd, light.irradiance()];
            product(explanation, "Kd Le P / (pi samples)", &factors, "", value)
        }
        Term::Specular {
            ks,
            intensity,
            r_dot_v,
            shininess,
        } => {
            let explanation = explanation
                .row("V", vec3(corner.at.to_viewer))
                .row("R.V", format!("{} ({})", num(r_dot_v), degrees(r_dot_v)));
            let power = format!(" x {}", num(highlight(r_dot_v, shininess)));
            product(explanation, "Ks I (R.V)^n", &[ks, intensity], &power, value)
        }
        _ => explanation,
    }
}

/// A product of two colours, and of a number if there is one.
fn product(
    explanation: Explanation,
    name: &str,
    [a, b]: &[Rgb; 2],
    number: &str,
    value: Rgb,
) -> Explanation {
    explanation.row(
        name,
        format!("{} x {}{number} = {}", rgb(*a), rgb(*b), rgb(value)),
    )
}

#[cfg(test)]
mod tests {
    use crate::probe::{Event, Term, TermKind};
    use crate::scene::load;
    use crate::trace::explain::explain;
    use crate::trace::{View, trace_pixel};
    use crate::world::World;

    #[test]
    fn each_corner_is_told_with_its_share() {
        let scene = load("gouraud").expect("built in");
        let settings = scene.settings.with(|s| {
            (s.image.width, s.image.height) = (65, 65);
        });
        let world = World::new(scene, settings.accel);
        let trace = trace_pixel(&world, &settings, (32, 32), false);
        let is_it = |event: &Event| {
            let kind = TermKind::Specular;
            matches!(event, Event::Term { term: Term::Blended { kind: k, .. }, light: 0, .. } if *k == kind)
        };
        let at = trace.tree.events.iter().position(is_it);
        let view = View {
            world: &world,
            settings: &settings,
            trace: &trace,
        };
        let told = explain(view, at.expect("a highlight of the lamp"));
        assert_eq!(told.title, "specular term of `lamp`, blended");
        let rows = |name: &str| {
            let rows = told.rows.iter().filter(|row| row.name == name);
            rows.map(|row| row.text.as_str()).collect::<Vec<_>>()
        };
        // Eye and lamp 2 above the middle, the corners 1 from it.
        for cosine in rows("R.V") {
            assert!(cosine.starts_with("0.6"), "{cosine}");
        }
        assert_eq!((rows("R.V").len(), rows("N.L").len()), (3, 3));
        assert!(rows("corner a")[0].contains("weight 0.333"), "{told:?}");
        assert!(rows("Ks I (R.V)^n")[0].contains("8.08"), "{told:?}");
        for name in ["share of a", "share of b", "share of c"] {
            assert_eq!(rows(name).len(), 1, "{name}");
        }
    }
}
