//! The arithmetic of a ray's test against a solid with parts: from the equation to the spans of the line inside.

use super::Explanation;
use crate::geometry::pieces::Pieces;
use crate::geometry::{
    Body, BoxedQuadric, Csg, Quadric, QuadricForm, QuadricSteps, Quartic, Spans, Torus, TorusMiss,
};
use crate::math::Ray;
use crate::scene::Leaf;
use crate::trace::format::{num, vec3};

/// Adds the arithmetic of a body in its own space. `parts` are those of a csg.
pub fn add(explanation: Explanation, (body, parts): (&Body, &[Leaf]), ray: &Ray) -> Explanation {
    let explanation = match body {
        Body::Quadric(own) => quadric(explanation, own, ray),
        Body::BoxedQuadric(own) => boxed(explanation, own, ray),
        Body::Torus(own) => torus(explanation, own, ray),
        Body::Quartic(own) => quartic(explanation, own, ray),
        Body::Csg(own) => return csg(explanation, own, parts, ray),
    };
    if body.is_solid() {
        inside(explanation, &body.spans(ray))
    } else {
        explanation
    }
}

fn quadric(explanation: Explanation, quadric: &Quadric, ray: &Ray) -> Explanation {
    of_second_degree(explanation, &quadric.arithmetic(ray), "between the ends")
}

fn boxed(explanation: Explanation, quadric: &BoxedQuadric, ray: &Ray) -> Explanation {
    of_second_degree(explanation, &quadric.arithmetic(ray), "in the box")
}

fn of_second_degree(explanation: Explanation, steps: &QuadricSteps, ends: &str) -> Explanation {
    let roots = match steps.discriminant {
        d if d > 0.0 => steps.roots.map(num).join(" and "),
        _ => "none: D is not above 0, the line misses the surface".to_owned(),
    };
    let clip = steps.clip.map_or_else(
        || "never".to_owned(),
        |clip| format!("for t from {} to {}", num(clip.min), num(clip.max)),
    );
    explanation
        .row("F(x, y, z)", equation(&steps.form))
        .row(
            "o moved",
            format!(
                "{}, where the ray is nearest to the middle, at t_c = {}",
                vec3(steps.origin),
                num(steps.t_c)
            ),
        )
        .row("A, B, C", [steps.a, steps.b, steps.c].map(num).join(", "))
        .row("", "F along the ray is A t^2 + 2 B t + C, t from t_c on")
        .row("D = B^2 - A C", num(steps.discriminant))
        .row("q = -(B + sign(B) root D)", num(steps.q))
        .row("t_c + C/q, t_c + q/A", roots)
        .row(ends, clip)
}

/// F as a student would write it.
fn equation(form: &QuadricForm) -> String {
    let names = ["x^2", "y^2", "z^2", "x y", "x z", "y z", "x", "y", "z", ""];
    let terms = form.0.into_iter().zip(names).filter(|(c, _)| *c != 0.0);
    let terms = terms.map(|(c, name)| match (c, name) {
        (1.0, name) if !name.is_empty() => name.to_owned(),
        (c, "") => num(c),
        (c, name) => format!("{} {name}", num(c)),
    });
    terms.collect::<Vec<_>>().join(" + ").replace("+ -", "- ")
}

fn torus(explanation: Explanation, torus: &Torus, ray: &Ray) -> Explanation {
    let steps = torus.arithmetic(ray);
    let explanation = explanation
        .row(
            "R, r",
            format!("{}, {}", num(torus.major), num(torus.minor)),
        )
        .row(
            "o moved",
            format!(
                "{}, where the ray is nearest to the middle, at t_c = {}",
                vec3(steps.origin),
                num(steps.closest)
            ),
        );
    if steps.quick_miss == Some(TorusMiss::Reach) {
        let why = "the line misses the ball of radius R + r, or the slab between y = -r and y = r";
        return explanation.row("far away", why);
    }
    let explanation = of_fourth_degree(
        explanation,
        &steps.coefficients,
        steps.reach,
        (steps.closest, &steps.pieces),
    );
    if steps.quick_miss == Some(TorusMiss::Bernstein) {
        let told = steps.bernstein.map(num).join(", ");
        return explanation.row("Bernstein", told).row(
            "",
            "F lies between these numbers there: all are above 0, so it has no root",
        );
    }
    explanation
}

fn quartic(explanation: Explanation, quartic: &Quartic, ray: &Ray) -> Explanation {
    let steps = quartic.arithmetic(ray);
    let explanation = explanation.row(
        "o moved",
        format!(
            "{}, half of its way through the box, at t_c = {}",
            vec3(steps.origin),
            num(steps.middle)
        ),
    );
    let Some([enter, leave]) = steps.faces else {
        return explanation.row("in the box", "never");
    };
    let reach = [enter.t - steps.middle, leave.t - steps.middle];
    of_fourth_degree(
        explanation,
        &steps.coefficients,
        reach,
        (steps.middle, &steps.pieces),
    )
}

/// The polynomial along a ray, lowest power first, and the pieces in which it only rises or only falls.
fn of_fourth_degree(
    explanation: Explanation,
    coefficients: &[f64; 5],
    [from, to]: [f64; 2],
    (closest, pieces): (f64, &Pieces),
) -> Explanation {
    let highest_first: Vec<String> = coefficients.iter().rev().map(|c| num(*c)).collect();
    let mut explanation = explanation
        .row("c4 to c0", highest_first.join(", "))
        .row(
            "",
            "F along the ray is c4 s^4 + c3 s^3 + c2 s^2 + c1 s + c0, s = t - t_c",
        )
        .row("searched", format!("s from {} to {}", num(from), num(to)));
    for piece in pieces {
        let side = |inside: bool| if inside { "inside" } else { "outside" };
        let [start, end] = piece.inside.map(side);
        let found = piece.crossing.map_or_else(
            || "no crossing".to_owned(),
            |crossing| {
                format!(
                    "t = t_c + {} = {}, in {} steps",
                    num(crossing.polished.root),
                    num(closest + crossing.polished.root),
                    crossing.plain.steps + crossing.polished.steps
                )
            },
        );
        explanation = explanation.row(
            format!("s {} to {}", num(piece.from), num(piece.to)),
            format!("{start} to {end}: {found}"),
        );
    }
    explanation
}

/// The spans, as a bar and as numbers.
fn inside(explanation: Explanation, spans: &Spans) -> Explanation {
    if spans.0.is_empty() {
        return explanation.row("inside", "nowhere: the line misses the solid");
    }
    let listed = spans.0.iter();
    let listed = listed.map(|span| format!("t {} to {}", num(span.enter.t), num(span.leave.t)));
    explanation
        .row("inside", listed.collect::<Vec<_>>().join(", "))
        .row("", bar(spans))
}

/// A line with the spans on it, such as `--[1====2]--[3==4]-->`: the numbers count the crossings.
fn bar(spans: &Spans) -> String {
    let parts = spans.0.iter().zip(0u32..);
    let parts = parts.map(|(_, i)| format!("[{}===={}]", 2 * i + 1, 2 * i + 2));
    format!("--{}-->", parts.collect::<Vec<_>>().join("--"))
}

/// Cut by cut: which leaf, in or out, and whether the whole changes there.
fn csg(explanation: Explanation, csg: &Csg, parts: &[Leaf], ray: &Ray) -> Explanation {
    let told = csg.cuts(ray);
    if told.cuts.is_empty() {
        return explanation.row("cuts", "none: the line misses all parts");
    }
    let mut explanation = explanation.row("parts", csg.leaves().count().to_string());
    let name = |leaf: u32| parts.get(leaf as usize).map_or("a part", |leaf| &leaf.name);
    let mut was_inside = csg.is_inside(told.before);
    let mut last = None;
    for cut in &told.cuts {
        let is_inside = csg.is_inside(cut.inside);
        let way = if cut.enters { "into" } else { "out of" };
        let effect = match (cut.counts, was_inside) {
            (true, false) => "the ray goes in here",
            (true, true) => "the ray comes out here",
            (false, _) if last == Some(cut.group) => "at the same place as the one before",
            (false, _) => "changes nothing",
        };
        if cut.counts {
            was_inside = !was_inside;
        } else if last != Some(cut.group) {
            was_inside = is_inside;
        }
        last = Some(cut.group);
        explanation = explanation.row(
            format!("t = {}", num(cut.t)),
            format!("{way} {}: {effect}", name(cut.leaf)),
        );
    }
    inside(explanation, &csg.spans(ray))
}
