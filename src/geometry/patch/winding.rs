//! Whose is a ray at a seam? The winding number of a patch's boundary around the ray, decided by its four curves alone.
//!
//! Seen along the ray, a patch is a map of the square (u, v) to the plane, and the ray is the plane's origin. However the map
//! folds, its signed number of crossings (fronts minus backs) is the number of times that the image of the square's *boundary*
//! runs around the origin. So the four boundary curves decide how often a patch is crossed, as the three edges decide for a
//! triangle, and neighbours that share a curve decide from the same bits: one counts it forwards, the other backwards. Over
//! a closed surface all counts cancel exactly. That holds at seams and corners, at folds and collapsed edges, without any
//! tolerance. Source of the law: the degree of a map, Brouwer 1911; of its use for edges: Woop, Benthin and Wald 2013.
//!
//! The winding number is counted as in the crossing test for polygons: each curve counts where it crosses the half-line
//! y = 0, x > 0, upwards +1, downwards -1.

use super::grid::{ControlGrid, Row};
use super::outline::{extent, length};
use crate::math::DVec2;
use crate::math::rounding::gamma;

/// How often a curve is halved at most: then it is as short as the last bit of what it was.
pub const MAX_HALVINGS: u32 = 54;

/// How often the boundary of a part runs around the origin, counter-clockwise. `halvings` says how often the patch was halved
/// along u and along v to get the part: its curves stop where those of the whole patch do.
pub fn winding(grid: &ControlGrid<DVec2>, halvings: [u32; 2]) -> i32 {
    let curves = grid.boundary().into_iter().zip([0, 1, 0, 1]);
    curves
        .map(|((curve, backwards), axis)| {
            let count = crossings(curve, MAX_HALVINGS - halvings[axis].min(MAX_HALVINGS));
            if backwards { -count } else { count }
        })
        .sum()
}

/// How often the curve crosses the half-line y = 0, x > 0: upwards less downwards.
///
/// If the curve cannot run around the origin, its chord crosses as often as it does. Else both halves are asked, as often as
/// `left` says. So the answer of the whole is always the sum of the halves' answers, and a search that halves a patch sees the
/// same crossings at every stage. The reversed curve gives the negative, exactly.
fn crossings(curve: Row<DVec2>, left: u32) -> i32 {
    let points = curve.points();
    let above = points.iter().filter(|p| p.y > 0.0).count();
    // Halving keeps signs exactly, so these need no margin.
    if above == 0 || above == points.len() || points.iter().all(|p| p.x <= 0.0) {
        return 0;
    }
    let (first, last) = (points[0], points[points.len() - 1]);
    if left == 0 || points.iter().all(|p| p.x > 0.0) || passes_on_one_side(points, last - first) {
        return chord(first, last);
    }
    let [low, high] = curve.halves();
    crossings(low, left - 1) + crossings(high, left - 1)
}

/// True if the curve's points, and whatever halving makes of them, lie on one side of the line through the origin along its
/// chord. A coordinate gains at most u times the largest one in each of 5 steps of at most 54 halvings, 270 u in all, and
/// the cross product 4 u more.
fn passes_on_one_side(points: &[DVec2], chord: DVec2) -> bool {
    let [low, high] = extent(points, |p| chord.perp_dot(p));
    let size = points
        .iter()
        .fold(0.0, |size, p| f64::max(size, length(*p)));
    let margin = gamma(300) * size * length(chord);
    low > margin || high < -margin
}

/// How often the straight line p -> q crosses the half-line. A point on the axis counts as below it, and a line through the origin
/// as left of it: as if the ray had been moved by an endlessly small step.
///
/// The side is rounded only where the line is as short as a last bit, and the reversed line rounds alike: both neighbours still
/// get the same answer.
fn chord(p: DVec2, q: DVec2) -> i32 {
    match (p.y > 0.0, q.y > 0.0) {
        (false, true) if p.perp_dot(q) > 0.0 => 1,
        (true, false) if q.perp_dot(p) > 0.0 => -1,
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::super::grid::value_and_slope;
    use super::*;

    fn square(at: DVec2) -> ControlGrid<DVec2> {
        let points = (0..16).map(|k| DVec2::new((k % 4) as f64, (k / 4) as f64) / 3.0 - at);
        ControlGrid::of([4, 4], points)
    }

    #[test]
    fn a_square_is_run_around_once_from_inside_and_never_from_outside() {
        for (x, y, expected) in [(0.5, 0.5, 1), (0.1, 0.9, 1), (1.5, 0.5, 0), (-0.1, 0.5, 0)] {
            assert_eq!(winding(&square(DVec2::new(x, y)), [0; 2]), expected);
        }
        let turned = square(DVec2::splat(0.5)).map(|p| DVec2::new(p.y, p.x));
        assert_eq!(winding(&turned, [0; 2]), -1);
    }

    #[test]
    fn squares_that_share_edges_and_a_corner_own_every_point_once() {
        // 3 x 3 squares, asked at the corners, the middles of the edges and of the squares of the middle one.
        for k in 0..25 {
            let at = DVec2::new((k % 5) as f64, (k / 5) as f64) / 4.0;
            let tiles = (0..9).map(|t| DVec2::new((t % 3) as f64, (t / 3) as f64) - 1.0);
            let owners = tiles.filter(|tile| winding(&square(at - *tile), [0; 2]) == 1);
            assert_eq!(owners.count(), 1, "{at}");
        }
    }

    #[test]
    fn a_curve_is_as_often_crossed_as_its_halves_and_its_reverse() {
        let mut random = crate::geometry::patch::tests::PatchRays(7);
        for _ in 0..20_000 {
            let shift = DVec2::new(random.signed(), random.signed());
            let points: [DVec2; 4] =
                std::array::from_fn(|_| DVec2::new(random.signed(), random.signed()) - shift);
            let curve = Row::new(4, |i| points[i]);
            // The origin is put on the curve, to the last bit.
            let [on, _] = value_and_slope(curve.points(), random.unit());
            let curve = Row::new(4, |i| points[i] - on);
            let back = Row::new(4, |i| points[3 - i] - on);
            let count = crossings(curve, MAX_HALVINGS);
            assert_eq!(count, -crossings(back, MAX_HALVINGS));
            let halves = curve.halves().map(|half| crossings(half, MAX_HALVINGS - 1));
            assert_eq!(count, halves[0] + halves[1]);
        }
    }
}
