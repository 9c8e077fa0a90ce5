//! Cutting polygons into triangles.

use crate::math::{DVec2, DVec3, Frame};

/// Looks at all corners again where none seems to be an ear: few, so that the time grows with the square of the corners.
const LOOKS: usize = 8;

/// Triangles that cover a polygon in space, as triples of numbers of its corners. Convex polygons become a fan;
/// others are cut ear by ear (Meisters 1975): a corner whose triangle turns the right way and holds no other corner
/// can be cut off. What is left when no ear is found (the polygon crosses itself) becomes a fan.
pub fn triangulate(corners: &[DVec3]) -> Vec<[usize; 3]> {
    let mut left: Vec<usize> = (0..corners.len()).collect();
    let mut triangles = Vec::with_capacity(corners.len().saturating_sub(2));
    let flat = flatten(corners);
    let turn = |a: usize, b: usize, c: usize| (flat[b] - flat[a]).perp_dot(flat[c] - flat[a]);
    if !is_convex(&flat) {
        let is_ear = |left: &[usize], i: usize| {
            let n = left.len();
            let (a, b, c) = (left[(i + n - 1) % n], left[i], left[(i + 1) % n]);
            let covers =
                |p: usize| turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
            // A corner in the same place as one of the ear's own is in nobody's way.
            let other = |p: usize| [a, b, c].iter().all(|&q| flat[p] != flat[q]);
            turn(a, b, c) > 0.0 && !left.iter().any(|&p| other(p) && covers(p))
        };
        let look = |left: &[usize]| (0..left.len()).map(|i| is_ear(left, i)).collect();
        let mut ears: Vec<bool> = look(&left);
        let mut looks = LOOKS;
        while left.len() > 3 {
            let n = left.len();
            let Some(i) = ears.iter().position(|ear| *ear) else {
                if looks == 0 {
                    break;
                }
                looks -= 1;
                ears = look(&left);
                continue;
            };
            triangles.push([left[(i + n - 1) % n], left[i], left[(i + 1) % n]]);
            left.remove(i);
            ears.remove(i);
            // In a polygon that does not touch itself, a cut changes the corners beside it and no others.
            for beside in [(i + n - 2) % (n - 1), i % (n - 1)] {
                ears[beside] = is_ear(&left, beside);
            }
        }
    }
    triangles.extend((2..left.len()).map(|i| [left[0], left[i - 1], left[i]]));
    triangles
}

/// The corners in the polygon's own plane, seen so that they run counter-clockwise. Its normal is the sum of the
/// cross products of the edges (Newell's method: Sutherland, Sproull and Schumacker 1974).
fn flatten(corners: &[DVec3]) -> Vec<DVec2> {
    let Some(&first) = corners.first() else {
        return Vec::new();
    };
    let next = corners.iter().cycle().skip(1);
    let normal: DVec3 = corners
        .iter()
        .zip(next)
        .map(|(&p, &q)| (p - first).cross(q - first))
        .sum();
    let frame = Frame::around(normal.normalize_or(DVec3::Z));
    let flat = |p: &DVec3| DVec2::new((*p - first).dot(frame.u), (*p - first).dot(frame.v));
    corners.iter().map(flat).collect()
}

/// True if the outline turns left at every corner, or goes straight on.
fn is_convex(flat: &[DVec2]) -> bool {
    let n = flat.len();
    (0..n).all(|i| {
        let (a, b, c) = (flat[i], flat[(i + 1) % n], flat[(i + 2) % n]);
        (b - a).perp_dot(c - b) >= 0.0
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(corners: &[DVec3], triangles: &[[usize; 3]]) -> f64 {
        let double = |t: &[usize; 3]| {
            let [a, b, c] = t.map(|i| corners[i]);
            (b - a).cross(c - a).length()
        };
        triangles.iter().map(double).sum::<f64>() / 2.0
    }

    #[test]
    fn a_square_becomes_a_fan() {
        let square = [DVec3::ZERO, DVec3::X, DVec3::ONE, DVec3::Y + DVec3::Z];
        assert_eq!(triangulate(&square), [[0, 1, 2], [0, 2, 3]]);
    }

    #[test]
    fn a_concave_polygon_is_covered_once() {
        // An arrow head that points left, from each of its corners: a fan covers too much from some of them.
        let arrow =
            [[0.0, 0.0], [2.0, -1.0], [1.0, 0.0], [2.0, 1.0]].map(|[x, y]| DVec3::new(x, 5.0, -y));
        for turn in 0..4 {
            let mut corners = arrow;
            corners.rotate_left(turn);
            let triangles = triangulate(&corners);
            assert_eq!(triangles.len(), 2);
            assert!(
                (area(&corners, &triangles) - 1.0).abs() < 1e-12,
                "{turn}: {triangles:?}"
            );
        }
    }

    #[test]
    fn what_is_no_polygon_ends_all_the_same() {
        assert!(triangulate(&[]).is_empty());
        assert!(triangulate(&[DVec3::ZERO, DVec3::X]).is_empty());
        assert_eq!(triangulate(&[DVec3::ONE; 5]).len(), 3);
        let bow = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::X + DVec3::Y];
        assert_eq!(triangulate(&bow).len(), 2);
    }
}
