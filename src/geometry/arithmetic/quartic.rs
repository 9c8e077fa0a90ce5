//! Other ways to the crossings of a torus or quartic: a closed formula, and our roots without the last steps.

use crate::geometry::{Cut, Quartic, Span, Spans, Torus};
use crate::math::Ray;
use crate::math::polynomial::Roots;

/// How the crossings of a torus or quartic are computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
pub enum QuarticMethod {
    /// Ferrari's formula, from the ray's own origin.
    Plain,
    /// The roots of the polynomial from the moved origin, as they are.
    Moved,
    /// These, polished on the surface itself.
    #[default]
    Polished,
}

impl QuarticMethod {
    /// Every choice.
    pub const ALL: [Self; 3] = [Self::Plain, Self::Moved, Self::Polished];

    /// Its name on the command line and in JSON.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

/// The spans of a torus by a chosen method.
pub fn torus(torus: &Torus, ray: &Ray, method: QuarticMethod) -> Spans {
    match method {
        QuarticMethod::Plain => {
            let mut roots = ferrari(&torus.coefficients(ray));
            // In a spindle some roots lie on the lemon, which is no surface.
            let (big, small) = (torus.major, torus.minor);
            let is_surface =
                |t: f64| ray.at(t).length_squared() + (big - small) * (big + small) >= 0.0;
            roots.retain(|t| is_surface(*t));
            in_pairs(&roots)
        }
        QuarticMethod::Moved => torus.arithmetic_unpolished(ray).spans(),
        QuarticMethod::Polished => torus.spans(ray),
    }
}

/// The spans of a quartic by a chosen method. Ferrari's formula needs degree 4: of a surface of a lower one it sees nothing.
pub fn quartic(quartic: &Quartic, ray: &Ray, method: QuarticMethod) -> Spans {
    match method {
        QuarticMethod::Plain => {
            let box_span = quartic.arithmetic(ray).faces;
            let Some([enter, leave]) = box_span else {
                return Spans::none();
            };
            let wall = |t| Cut { t, part: 0 };
            let roots = ferrari(&quartic.coefficients_along(ray));
            let mut cuts: Vec<Cut> = roots
                .iter()
                .copied()
                .filter(|t| enter.t < *t && *t < leave.t)
                .map(wall)
                .collect();
            if quartic.value(ray.at(enter.t)) < 0.0 {
                cuts.insert(0, enter);
            }
            if cuts.len() % 2 == 1 {
                cuts.push(leave);
            }
            let spans = cuts.chunks_exact(2).map(|pair| Span {
                enter: pair[0],
                leave: pair[1],
            });
            Spans(spans.collect())
        }
        QuarticMethod::Moved => quartic.arithmetic_unpolished(ray).spans(),
        QuarticMethod::Polished => quartic.spans(ray),
    }
}

/// The spans between roots of a closed surface; one that is left over is lost.
fn in_pairs(roots: &[f64]) -> Spans {
    let pairs = roots.chunks_exact(2);
    Spans(pairs.map(|pair| Span::between(pair[0], pair[1])).collect())
}

/// The real roots of `c[0] + c[1] t + ... + c[4] t^4` by Ferrari's formula, in order.
///
/// With t = y - a/4 the cubic term is gone: y^4 + p y^2 + q y + r. For a root m of 8 m^3 + 8 p m^2 + (2 p^2 - 8 r) m - q^2 it
/// falls into two quadratics, y^2 -+ s y + p/2 + m +- q/(2 s), s = sqrt(2 m). It is exact on paper. In floating point, nearly all
/// of its sums cancel when the roots lie near to each other and far from zero, as those of a distant torus do.
/// Source: Ferrari, in Cardano 1545, "Ars Magna", chapter 39.
pub fn ferrari(c: &[f64; 5]) -> Roots {
    let [e, d, cc, b] = [c[0], c[1], c[2], c[3]].map(|k| k / c[4]);
    let p = cc - 3.0 * b * b / 8.0;
    let q = d - b * cc / 2.0 + b * b * b / 8.0;
    let r = e - b * d / 4.0 + b * b * cc / 16.0 - 3.0 * b * b * b * b / 256.0;
    let m = largest_root_of_cubic([p, p * p / 4.0 - r, -q * q / 8.0]);
    let mut roots = Roots::new();
    let mut add = |half: f64, constant: f64| {
        let discriminant = half * half - constant;
        if discriminant > 0.0 {
            let root = discriminant.sqrt();
            roots.extend([-half - root - b / 4.0, -half + root - b / 4.0]);
        }
    };
    if m > 0.0 {
        let s = (2.0 * m).sqrt();
        add(-s / 2.0, p / 2.0 + m + q / (2.0 * s));
        add(s / 2.0, p / 2.0 + m - q / (2.0 * s));
    } else {
        // q is 0: a quadratic in y^2.
        let discriminant = p * p / 4.0 - r;
        for square in [
            -p / 2.0 - discriminant.sqrt(),
            -p / 2.0 + discriminant.sqrt(),
        ] {
            add(0.0, -square);
        }
    }
    roots.sort_by(f64::total_cmp);
    roots
}

/// The largest real root of m^3 + a m^2 + b m + c, by Cardano's formula, or by the cosine of a third of an angle where that
/// would need complex numbers (Viete 1615).
fn largest_root_of_cubic([a, b, c]: [f64; 3]) -> f64 {
    let p = (a * a - 3.0 * b) / 9.0;
    let q = (2.0 * a * a * a - 9.0 * a * b + 27.0 * c) / 54.0;
    let y = if q * q < p * p * p {
        let angle = libm::acos(-q / (p * p * p).sqrt()) / 3.0;
        2.0 * p.sqrt() * libm::cos(angle)
    } else {
        let u = -libm::cbrt(q.abs() + (q * q - p * p * p).sqrt()).copysign(q);
        if u == 0.0 { 0.0 } else { u + p / u }
    };
    y - a / 3.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::DVec3;

    #[test]
    fn the_formula_is_right_where_it_keeps_its_digits() {
        // (t^2 - 1)(t^2 - 4), and (t - 1)(t - 2)(t - 3)(t - 5).
        for (c, roots) in [
            ([4.0, 0.0, -5.0, 0.0, 1.0], [-2.0, -1.0, 1.0, 2.0]),
            ([30.0, -61.0, 41.0, -11.0, 1.0], [1.0, 2.0, 3.0, 5.0]),
        ] {
            let found = ferrari(&c);
            assert_eq!(found.len(), 4);
            assert!(
                found
                    .iter()
                    .zip(roots)
                    .all(|(x, root)| (x - root).abs() < 1e-12)
            );
        }
        assert!(ferrari(&[1.0, 0.0, 0.0, 0.0, 1.0]).is_empty());
    }

    #[test]
    fn near_by_all_methods_agree_and_from_afar_the_formula_fails() {
        let ring = Torus {
            major: 1.0,
            minor: 0.25,
        };
        let ray = |distance: f64| Ray::new(DVec3::new(0.125, 0.0625, distance), DVec3::NEG_Z);
        for method in QuarticMethod::ALL {
            let spans = torus(&ring, &ray(4.0), method);
            assert_eq!(spans.0.len(), 2, "{method:?}");
            assert!(
                (spans.length() - torus(&ring, &ray(4.0), QuarticMethod::Polished).length()).abs()
                    < 1e-9
            );
        }
        let far = |method| torus(&ring, &ray(1e6), method).length();
        let true_length = ring.spans(&ray(0.0)).length();
        assert!((far(QuarticMethod::Polished) - true_length).abs() < 1e-9);
        assert!((far(QuarticMethod::Plain) - true_length).abs() > 1e-3);
    }
}
