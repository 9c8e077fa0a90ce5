//! Cutting polygons into triangles.

use earcut::Earcut;

use crate::math::{DVec2, DVec3, Frame};
use crate::scene::limits::MAX_CORNERS;

/// Corners that are further from their plane than this part of the polygon's size do not lie in it: what files round to is less.
const FLAT: f64 = 1e-5;

/// Triangles that cover a polygon in space, as triples of numbers of its corners, and what makes them a guess if they are
/// one. Convex polygons become a fan; of others the crate `earcut` cuts off ear by ear (Meisters 1975). It sees them from
/// above: if it cannot cover what it sees, a polygon that is not flat becomes a fan, too.
pub fn triangulate(corners: &[DVec3]) -> (Vec<[usize; 3]>, Option<&'static str>) {
    let (flat, is_flat) = flatten(corners);
    if is_convex(&flat) {
        return (fan(corners.len(), 0), None);
    }
    if corners.len() > MAX_CORNERS {
        let guess = "is not convex and has too many corners";
        return (fan(corners.len(), 0), Some(guess));
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
    // A corner without an ear is in line with its neighbours as seen from above, but in space only if all is flat.
    let next = corners.iter().cycle().skip(1);
    let distinct = corners.iter().zip(next).filter(|(p, q)| p != q).count();
    match (is_whole, is_flat) {
        (true, true) => (triangles, None),
        (true, false) if triangles.len() + 2 >= distinct => (triangles, None),
        (_, false) => (smoother_fan(corners), Some("is twisted")),
        (false, true) if triangles.is_empty() => (fan(corners.len(), 0), Some("crosses itself")),
        (false, true) => (triangles, Some("crosses itself")),
    }
}

/// All triangles of a polygon of `n` corners that have the corner `first`.
fn fan(n: usize, first: usize) -> Vec<[usize; 3]> {
    let corner = |i: usize| (first + i) % n;
    (2..n).map(|i| [first, corner(i - 1), corner(i)]).collect()
}

/// The fan from the first corner or from the second, whichever bends less where two of its triangles meet. A polygon of four
/// corners has no others.
fn smoother_fan(corners: &[DVec3]) -> Vec<[usize; 3]> {
    let bend = |triangles: &[[usize; 3]]| {
        let normal = |t: &[usize; 3]| {
            let [a, b, c] = t.map(|i| corners[i]);
            (b - a).cross(c - a).normalize_or_zero()
        };
        let edges = triangles.iter().zip(&triangles[1..]);
        let cosines = edges.map(|(s, t)| normal(s).dot(normal(t)));
        cosines.fold(1.0, f64::min)
    };
    let [a, b] = [0, 1].map(|first| fan(corners.len(), first));
    if bend(&b) > bend(&a) { b } else { a }
}

/// The corners in the polygon's own plane, seen so that they run counter-clockwise. Its normal is the sum of the
/// cross products of the edges (Newell's method: Sutherland, Sproull and Schumacker 1974). Also, if all lie in it.
fn flatten(corners: &[DVec3]) -> (Vec<DVec2>, bool) {
    let Some(&first) = corners.first() else {
        return (Vec::new(), true);
    };
    let next = corners.iter().cycle().skip(1);
    let normal: DVec3 = corners
        .iter()
        .zip(next)
        .map(|(&p, &q)| (p - first).cross(q - first))
        .sum();
    let frame = Frame::around(normal.normalize_or(DVec3::Z));
    let local = |p: &DVec3| [frame.u, frame.v, frame.w].map(|axis| (*p - first).dot(axis));
    let size = |i: usize| {
        corners
            .iter()
            .map(|p| local(p)[i].abs())
            .fold(0.0, f64::max)
    };
    let is_flat = size(2) <= FLAT * size(0).max(size(1));
    let flat = corners.iter().map(local).map(|[x, y, _]| DVec2::new(x, y));
    (flat.collect(), is_flat)
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
