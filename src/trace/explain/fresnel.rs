//! The reflected share of a transparent surface: the formula with its numbers.

use super::Explanation;
use crate::shading::Fresnel;
use crate::trace::format::num;

/// Adds how F comes from the cosine of the angle of incidence and the indices of both sides.
pub fn formula(
    model: Fresnel,
    ci: f64,
    (n1, n2): (f64, f64),
    explanation: Explanation,
) -> Explanation {
    let eta = n1 / n2;
    let k = 1.0 - eta * eta * (1.0 - ci * ci);
    let explanation = explanation
        .row("ci", format!("cos of the angle = {}", num(ci)))
        .row("k", format!("1 - (n1 / n2)^2 (1 - ci^2) = {}", num(k)));
    if k <= 0.0 {
        return explanation.row("F", "1: k is not positive, total internal reflection");
    }
    let ct = k.sqrt();
    let explanation = explanation.row(
        "ct",
        format!("cos of the refracted angle = sqrt(k) = {}", num(ct)),
    );
    let quotient = |a: [f64; 2], b: [f64; 2]| {
        let root = (a[0] * a[1] - b[0] * b[1]) / (a[0] * a[1] + b[0] * b[1]);
        root * root
    };
    let numbers = |a: [f64; 2], b: [f64; 2]| {
        let [a0, a1, b0, b1] = [a[0], a[1], b[0], b[1]].map(num);
        format!("(({a0} {a1} - {b0} {b1}) / ({a0} {a1} + {b0} {b1}))^2")
    };
    match model {
        Fresnel::None => explanation.row("F", "0: `--fresnel none` leaves Fresnel's equations out"),
        Fresnel::Exact => {
            let (s, p) = (([n1, ci], [n2, ct]), ([n1, ct], [n2, ci]));
            let (rs, rp) = (quotient(s.0, s.1), quotient(p.0, p.1));
            explanation
                .row(
                    "Rs",
                    format!(
                        "((n1 ci - n2 ct) / (n1 ci + n2 ct))^2 = {} = {}",
                        numbers(s.0, s.1),
                        num(rs)
                    ),
                )
                .row(
                    "Rp",
                    format!(
                        "((n1 ct - n2 ci) / (n1 ct + n2 ci))^2 = {} = {}",
                        numbers(p.0, p.1),
                        num(rp)
                    ),
                )
                .row(
                    "F",
                    format!(
                        "(Rs + Rp) / 2 = {}, after Fresnel",
                        num(f64::midpoint(rs, rp))
                    ),
                )
        }
        Fresnel::Schlick => {
            let r0 = quotient([n1, 1.0], [n2, 1.0]);
            let (name, c) = if n1 > n2 { ("ct", ct) } else { ("ci", ci) };
            let share = r0 + (1.0 - r0) * libm::pow(1.0 - c, 5.0);
            explanation
                .row("R0", format!("((n1 - n2) / (n1 + n2))^2 = {}", num(r0)))
                .row(
                    "F",
                    format!("R0 + (1 - R0) (1 - {name})^5 = {}, after Schlick; {name} is the cosine in the thinner medium", num(share)),
                )
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::format::num;

    /// The number at the end is that of the tracer, for every model and angle.
    #[test]
    fn the_formula_gives_what_the_tracer_gives() {
        for model in [Fresnel::None, Fresnel::Exact, Fresnel::Schlick] {
            for (n1, n2) in [(1.0, 1.5), (1.5, 1.0), (1.33, 1.5)] {
                for degrees in [0.0f64, 20.0, 41.0, 60.0, 85.0] {
                    let ci = libm::cos(degrees.to_radians());
                    let eta: f64 = n1 / n2;
                    let k = 1.0 - eta * eta * (1.0 - ci * ci);
                    let share = if k > 0.0 {
                        model.reflectance(ci, k.sqrt(), n1, n2)
                    } else {
                        1.0
                    };
                    let told = formula(model, ci, (n1, n2), Explanation::default());
                    let last = told.rows.last().expect("F");
                    assert_eq!(last.name, "F");
                    assert!(last.text.contains(&num(share)), "{}: {share}", last.text);
                }
            }
        }
    }
}
