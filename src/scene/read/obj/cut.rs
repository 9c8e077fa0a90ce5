//! Cutting polygons into triangles.

use earcut::Earcut;

use crate::math::{DVec2, DVec3, Frame};
use crate::scene::limits::MAX_CORNERS;

/// Triangles that cover a polygon in space, as triples of numbers of its corners, and what makes them a guess if they are
/// one. Convex polygons become a fan; of others the crate `earcut` cuts off ear by ear (Meisters 1975).
pub fn triangulate(corners: &[DVec3]) -> (Vec<[usize; 3]>, Option<&'static str>) {
    let flat = flatten(corners);
    let fan = || (2..corners.len()).map(|i| [0, i - 1, i]).collect();
    if is_convex(&flat) {
        return (fan(), None);
    }
    if corners.len() > MAX_CORNERS {
        return (fan(), Some("is not convex and has too many corners"));
    }
    let mut cut: Vec<usize> = Vec::new();
    Earcut::new().earcut(flat.iter().map(DVec2::to_array), &[], &mut cut);
    let turn = |[a, b, c]: [usize; 3]| (flat[b] - flat[a]).perp_dot(flat[c] - flat[a]);
    // They run as the polygon does.
    for t in cut.as_chunks_mut().0.iter_mut().filter(|t| turn(**t) < 0.0) {
        t.swap(1, 2);
    }
    let triangles = cut.as_chunks().0.to_vec();
    // What covers more or less than the polygon encloses is no polygon.
    let covered: f64 = triangles.iter().map(|t| turn(*t)).sum();
    let enclosed: f64 = (2..flat.len()).map(|i| turn([0, i - 1, i])).sum();
    let is_whole = (covered - enclosed).abs() <= 1e-6 * enclosed;
    let guess = (!is_whole).then_some("crosses itself");
    let is_empty = triangles.is_empty();
    (if is_empty { fan() } else { triangles }, guess)
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

/// True if the outline turns left at every corner, or goes straight on, and all of it lies to the left of the first: it goes
/// around once.
fn is_convex(flat: &[DVec2]) -> bool {
    let (n, turn) = (flat.len(), |a: DVec2, b: DVec2, c: DVec2| {
        (b - a).perp_dot(c - b) >= 0.0
    });
    (0..n).all(|i| {
        let [a, b, c] = [i, i + 1, i + 2].map(|i| flat[i % n]);
        turn(a, b, c) && turn(flat[0], b, c)
    })
}
