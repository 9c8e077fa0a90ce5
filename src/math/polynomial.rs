//! Real roots of polynomials of degree 2, 3 and 4 in an interval, by monotone pieces.
//!
//! A polynomial turns only where its derivative is zero. Between two turns it rises or falls all the way, so it crosses zero
//! there once if its signs at both ends differ, and never if they agree. So degree 4 stands on degree 3, that on degree 2, and
//! degree 2 on a formula. It finds all roots, cannot diverge, and needs no complex numbers.
//! Source: Yuksel 2022, "High-Performance Polynomial Root Finding for Graphics" (HPG).
//!
//! A polynomial is the array of its coefficients, lowest power first: `c[0] + c[1] x + c[2] x^2 + ...`
//! A root is a place where the sign changes between negative and not negative: a touch from above is none.

use smallvec::SmallVec;

use super::rounding::{UNIT_ROUNDOFF, gamma};

/// The real roots of a polynomial of degree 4 or less, in order. Never more than four, so never on the heap.
pub type Roots = SmallVec<[f64; 4]>;

/// A root, and what it took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RefinedRoot {
    /// The root.
    pub root: f64,
    /// How often the function was evaluated.
    pub steps: u32,
}

/// The value at `x`, by Horner's rule.
#[inline]
pub fn value<const N: usize>(c: &[f64; N], x: f64) -> f64 {
    c.iter().rev().fold(0.0, |sum, &k| sum * x + k)
}

/// A function at one place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evaluation {
    /// Its value.
    pub value: f64,
    /// Its slope.
    pub slope: f64,
    /// A bound for what the value was rounded by.
    pub rounding: f64,
}

/// A polynomial at `x`: Horner's rule for the value and the slope at once. It rounds twice a power, so the value is wrong by
/// gamma_2N of the sum of |c_k x^k| at most. Source: Higham, "Accuracy and Stability of Numerical Algorithms", section 5.1.
#[inline]
pub fn evaluate<const N: usize>(c: &[f64; N], x: f64) -> Evaluation {
    let (mut value, mut slope, mut size) = (0.0, 0.0, 0.0);
    for &k in c.iter().rev() {
        slope = slope * x + value;
        value = value * x + k;
        size = size * x.abs() + k.abs();
    }
    let rounding = gamma(2 * N as u32) * size;
    Evaluation {
        value,
        slope,
        rounding,
    }
}

/// The derivative, M = N - 1: `k c[k]` is its coefficient of x^(k - 1).
#[inline]
pub fn derivative<const N: usize, const M: usize>(c: &[f64; N]) -> [f64; M] {
    const { assert!(M + 1 == N) };
    std::array::from_fn(|k| (k + 1) as f64 * c[k + 1])
}

/// The Bernstein coefficients over an interval. The polynomial's values there lie between the smallest and the largest of them,
/// since they are weighted means of them: if all are above zero, there is no root.
/// Source: Farouki and Rajan 1987, "On the numerical condition of polynomials in Bernstein form".
pub fn bernstein(c: &[f64; 5], [from, to]: [f64; 2]) -> [f64; 5] {
    // The polynomial in s, where x = from + s: divided by (x - from) again and again, what is left over are its coefficients.
    let mut q = *c;
    for start in 0..4 {
        for k in (start..4).rev() {
            q[k] += from * q[k + 1];
        }
    }
    // In s / width, each divided by "4 over k"; then b_i = sum over k of ("i over k") q_k.
    let w = to - from;
    let q = [
        q[0],
        q[1] * w / 4.0,
        q[2] * w * w / 6.0,
        q[3] * w * w * w / 4.0,
        q[4] * (w * w) * (w * w),
    ];
    [
        q[0],
        q[0] + q[1],
        q[0] + 2.0 * q[1] + q[2],
        q[0] + 3.0 * (q[1] + q[2]) + q[3],
        q[0] + 4.0 * (q[1] + q[3]) + 6.0 * q[2] + q[4],
    ]
}

/// The two roots of `c[0] + c[1] x + c[2] x^2` inside an interval, without cancellation; none if they are equal.
///
/// With half of the middle coefficient, b, the roots are q / c2 and c0 / q, where q = -(b + sign(b) sqrt(b^2 - c0 c2)) adds
/// numbers of equal signs. Where c2 is 0, the first runs off to infinity and the second is the root of the line.
/// Source: Press, Teukolsky, Vetterling and Flannery 2007, "Numerical Recipes", section 5.6.
pub fn quadratic_roots(c: &[f64; 3], [from, to]: [f64; 2]) -> Roots {
    let half = 0.5 * c[1];
    let discriminant = half * half - c[0] * c[2];
    if discriminant <= 0.0 {
        return Roots::new();
    }
    let q = -(half + discriminant.sqrt().copysign(half));
    let (x, y) = (q / c[2], c[0] / q);
    let ordered = [x.min(y), x.max(y)];
    ordered
        .into_iter()
        .filter(|x| from < *x && *x < to)
        .collect()
}

/// The roots of a polynomial of degree 3 inside an interval.
pub fn cubic_roots(c: &[f64; 4], interval: [f64; 2]) -> Roots {
    let turns = quadratic_roots(&derivative(c), interval);
    roots_between(c, &turns, interval)
}

/// The roots of a polynomial of degree 4 inside an interval.
pub fn quartic_roots(c: &[f64; 5], interval: [f64; 2]) -> Roots {
    let turns = cubic_roots(&derivative(c), interval);
    roots_between(c, &turns, interval)
}

/// The roots of a polynomial that is monotone between two neighbouring `turns`.
#[inline]
fn roots_between<const N: usize>(c: &[f64; N], turns: &[f64], interval: [f64; 2]) -> Roots {
    let shortest = rounding_of(interval);
    let [start, end] = interval;
    let mut roots = Roots::new();
    let (mut from, mut negative) = (start, value(c, start) < 0.0);
    for &to in turns.iter().chain([&end]) {
        let negative_there = value(c, to) < 0.0;
        if negative != negative_there {
            let middle = 0.5 * (from + to);
            let function = |x| evaluate(c, x);
            let found = bracketed_newton(function, [from, to], negative, middle, shortest);
            roots.push(found.root);
        }
        (from, negative) = (to, negative_there);
    }
    roots
}

/// One rounding of the largest number of an interval: no root in it is told more exactly.
#[inline]
pub fn rounding_of([from, to]: [f64; 2]) -> f64 {
    UNIT_ROUNDOFF * from.abs().max(to.abs())
}

/// The place in a bracket where a function changes its sign, from `start` on by Newton's steps. `rising` says that it changes
/// from negative to positive.
///
/// Each value makes the bracket smaller. A step that would leave it, or that is not at most half as long as the one before, is
/// replaced by halving the bracket: so this ends for any function. It ends after Newton's step from a value that rounding could
/// have made, or after one that is no longer than `shortest`.
/// Source: Press, Teukolsky, Vetterling and Flannery 2007, "Numerical Recipes", section 9.4 (rtsafe).
#[inline]
pub fn bracketed_newton(
    function: impl Fn(f64) -> Evaluation,
    [mut from, mut to]: [f64; 2],
    rising: bool,
    start: f64,
    shortest: f64,
) -> RefinedRoot {
    // Two halvings a bit, and then some: only a NaN would need more.
    const MOST_STEPS: u32 = 128;
    let mut root = start;
    let mut last = to - from;
    for steps in 1..=MOST_STEPS {
        let Evaluation {
            value,
            slope,
            rounding,
        } = function(root);
        if (value < 0.0) == rising {
            from = root;
        } else {
            to = root;
        }
        let newton = root - value / slope;
        let is_inside = from <= newton && newton <= to;
        if is_inside && value.abs() <= rounding {
            let root = newton;
            return RefinedRoot { root, steps };
        }
        let is_good = is_inside && 2.0 * (newton - root).abs() <= last;
        let next = if is_good { newton } else { 0.5 * (from + to) };
        last = (next - root).abs();
        root = next;
        if last <= shortest {
            return RefinedRoot { root, steps };
        }
    }
    RefinedRoot {
        root,
        steps: MOST_STEPS,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WIDE: [f64; 2] = [-1e3, 1e3];

    /// The product of (x - root) over some roots.
    fn with_roots<const N: usize>(roots: &[f64]) -> [f64; N] {
        let mut c = [0.0; N];
        c[0] = 1.0;
        for root in roots {
            for k in (0..N).rev() {
                c[k] = if k > 0 { c[k - 1] } else { 0.0 } - root * c[k];
            }
        }
        c
    }

    #[test]
    fn whole_numbers_are_found_in_every_degree() {
        assert_eq!(
            quadratic_roots(&with_roots(&[-2.0, 5.0]), WIDE)[..],
            [-2.0, 5.0]
        );
        assert_eq!(
            cubic_roots(&with_roots(&[-2.0, 1.0, 5.0]), WIDE)[..],
            [-2.0, 1.0, 5.0]
        );
        let found = quartic_roots(&with_roots(&[-2.0, 1.0, 3.0, 5.0]), WIDE);
        for (found, root) in found.iter().zip([-2.0, 1.0, 3.0, 5.0]) {
            assert!((found - root).abs() < 1e-12, "{found}");
        }
        assert_eq!(found.len(), 4);
    }

    #[test]
    fn only_roots_inside_the_interval_are_found() {
        let c = with_roots(&[-2.0, 1.0, 3.0, 5.0]);
        assert_eq!(quartic_roots(&c, [0.0, 4.0]).len(), 2);
        assert_eq!(quartic_roots(&c, [1.5, 2.5]).len(), 0);
    }

    #[test]
    fn a_lower_degree_is_a_case_like_others() {
        let line = quartic_roots(&[-6.0, 2.0, 0.0, 0.0, 0.0], WIDE);
        assert_eq!(line[..], [3.0]);
        let parabola = quartic_roots(&[-4.0, 0.0, 1.0, 0.0, 0.0], WIDE);
        assert_eq!(parabola[..], [-2.0, 2.0]);
        assert!(quartic_roots(&[0.0; 5], WIDE).is_empty());
        assert!(quartic_roots(&[f64::NAN; 5], WIDE).len() <= 4);
    }

    #[test]
    fn a_touch_is_no_root_and_a_root_with_a_level_tangent_is_one() {
        // (x - 2)^2 (x + 1)^2 and (x - 2)^3 (x + 1).
        assert!(quartic_roots(&with_roots(&[2.0, 2.0, -1.0, -1.0]), WIDE).is_empty());
        let triple = quartic_roots(&with_roots(&[2.0, 2.0, 2.0, -1.0]), WIDE);
        assert_eq!(triple.len(), 2);
        assert!((triple[0] + 1.0).abs() < 1e-14 && (triple[1] - 2.0).abs() < 1e-4);
    }

    #[test]
    fn two_polynomials_that_other_solvers_got_wrong() {
        // In single precision a Sturm chain counts a root of the first; the second is from diagrams-solve, issue 7.
        let none = [9627.17676, -660.766_052, 0.003_295_898_44, 0.0, 1.0];
        assert!(quartic_roots(&none, WIDE).is_empty());
        let two = [26_471_900.25, -1_325_880.0, 25_449.0, -240.0, 1.0];
        let found = quartic_roots(&two, WIDE);
        let exact = [50.645_112_696_944_67, 69.354_887_303_055_34];
        assert_eq!(found.len(), 2);
        assert!(
            found
                .iter()
                .zip(exact)
                .all(|(x, root)| (x - root).abs() < 1e-12)
        );
    }

    #[test]
    fn bernstein_coefficients_hold_the_values() {
        let c = with_roots(&[-2.0, 1.0, 3.0, 5.0]);
        let b = bernstein(&c, [-1.0, 4.0]);
        assert_eq!((b[0], b[4]), (value(&c, -1.0), value(&c, 4.0)));
        let least = b.iter().copied().fold(f64::INFINITY, f64::min);
        let most = b.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        for i in 0..=100 {
            let at = value(&c, -1.0 + 0.05 * f64::from(i));
            assert!(least <= at && at <= most);
        }
    }

    #[test]
    fn newton_ends_where_it_would_diverge() {
        // Newton's steps on the cube root double the distance to zero each time.
        let cube_root = |x: f64| Evaluation {
            value: libm::cbrt(x),
            slope: 1.0 / (3.0 * libm::cbrt(x * x)),
            rounding: 0.0,
        };
        let found = bracketed_newton(cube_root, [-1.0, 3.0], true, 1.0, 1e-16);
        assert!(found.root.abs() < 1e-15 && found.steps < 128);
    }
}
