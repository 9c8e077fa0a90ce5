//! Knot insertion: a B-spline cut into its Bezier pieces.
//!
//! Source: Boehm 1980, "Inserting new knots into B-spline curves"; Piegl and Tiller 1997, "The NURBS Book", 2nd edition,
//! sections 5.2 and 5.3.

use glam::DVec4;

use crate::math::DVec3;

/// A Bezier piece of a B-spline curve: its control points, and the knots at its ends.
pub struct Piece {
    /// The control points with weights.
    pub points: Vec<DVec4>,
    /// The knots at its ends.
    pub ends: [f64; 2],
}

/// The mix of two control points with weights, (1 - t) a + t b in (w x, w y, w z, w), seen as point and weight again. A
/// coordinate that they share stays what it is, to the bit; and `mix(a, b, 1/2)` is `mix(b, a, 1/2)`.
pub fn mix(a: DVec4, b: DVec4, t: f64) -> DVec4 {
    let (of_a, of_b) = (a.w * (1.0 - t), b.w * t);
    let w = of_a + of_b;
    let [p, q] = [a.truncate(), b.truncate()];
    let mixed = (p * of_a + q * of_b) / w;
    DVec3::select(p.cmpeq(q), p, mixed).extend(w)
}

/// The Bezier pieces of a B-spline curve. `knots` never fall, are `points.len() + degree + 1` in number, and none inside repeats
/// more than `degree` times.
pub fn pieces(degree: usize, knots: &[f64], points: &[DVec4]) -> Vec<Piece> {
    let (mut knots, mut points) = (knots.to_vec(), points.to_vec());
    // The curve lives between these two.
    let (first, last) = (knots[degree], knots[points.len()]);
    let mut inside: Vec<f64> = knots
        .iter()
        .copied()
        .filter(|k| (first..=last).contains(k))
        .collect();
    inside.dedup();
    for knot in inside {
        while knots.iter().filter(|k| **k == knot).count() < degree {
            insert(degree, &mut knots, &mut points, knot);
        }
    }
    // Each span between two different knots is now a Bezier curve, with the points that act there.
    (degree..points.len())
        .filter(|k| knots[*k] < knots[k + 1] && (first..last).contains(&knots[*k]))
        .map(|k| Piece {
            points: points[k - degree..=k].to_vec(),
            ends: [knots[k], knots[k + 1]],
        })
        .collect()
}

/// Repeats a knot once more: `degree` points are replaced by one more, each a mix of two neighbours. The curve stays.
fn insert(degree: usize, knots: &mut Vec<f64>, points: &mut Vec<DVec4>, knot: f64) {
    // The last knot that is not above: `knot` itself, since it is there already.
    let at = knots.partition_point(|k| *k <= knot) - 1;
    let repeated = knots.iter().filter(|k| **k == knot).count();
    let old = points.clone();
    points.insert(at - repeated, old[at - repeated]);
    for i in at + 1 - degree..=at - repeated {
        let t = (knot - knots[i]) / (knots[i + degree] - knots[i]);
        points[i] = mix(old[i - 1], old[i], t);
    }
    knots.insert(at + 1, knot);
}
