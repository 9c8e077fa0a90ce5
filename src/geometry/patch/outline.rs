//! What a grid of control points says about its patch at a glance: where the ray is beside it, where it is thin, and where it
//! maps one to one.
//!
//! All of it holds since a patch lies in the convex hull of its control points, and its derivatives in that of their steps.

use super::grid::ControlGrid;
use crate::math::DVec2;
use crate::math::rounding::gamma;

/// The smallest and the largest value of some points.
#[inline]
pub fn extent(points: &[DVec2], value: impl Fn(DVec2) -> f64) -> [f64; 2] {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for p in points {
        let x = value(*p);
        // (In one instruction each; `f64::min` would look after NaN, which cannot come here.)
        low = if x < low { x } else { low };
        high = if x > high { x } else { high };
    }
    [low, high]
}

/// The length |x| + |y|, which is cheap and bounds the others.
#[inline]
pub fn length(v: DVec2) -> f64 {
    v.x.abs() + v.y.abs()
}

/// The strip along a direction in which all control points lie, as seen from the ray.
///
/// The two axes are asked, and then the grid's own mean directions along u and along v, which tell a sheet that is seen nearly
/// edge-on from the ray beside it.
#[derive(Clone, Copy, Debug)]
pub struct Strip {
    /// How far to the left of the line through the ray the points lie, at least and at most, times `length`.
    extent: [f64; 2],
    /// The length of the direction; 0 if there is none.
    length: f64,
    /// The largest coordinate.
    size: f64,
}

impl Strip {
    /// The strip along `direction`; `size` is the grid's largest coordinate.
    #[inline]
    pub fn of(grid: &ControlGrid<DVec2>, direction: DVec2, size: f64) -> Self {
        Self {
            extent: extent(grid.points(), |p| direction.perp_dot(p)),
            length: length(direction),
            size,
        }
    }

    /// True if the line through the ray has all points on one side, so that it misses.
    ///
    /// It must then not be crossed by any later part: their points are rounded by 5 u of the largest coordinate in each of at
    /// most 2 * 50 halvings.
    pub fn is_beside(&self) -> bool {
        let margin = gamma(600) * self.size * self.length;
        self.extent[0] > margin || self.extent[1] < -margin
    }

    /// True if the points lie as near to one line as they are known.
    pub fn is_thin(&self, error: f64) -> bool {
        self.length > 0.0 && self.extent[1] - self.extent[0] <= 4.0 * error * self.length
    }
}

/// The largest coordinate.
pub fn size(grid: &ControlGrid<DVec2>) -> f64 {
    let [[_, x], [_, y]] = [
        extent(grid.points(), |p| p.x.abs()),
        extent(grid.points(), |p| p.y.abs()),
    ];
    x.max(y)
}

/// The sum of the steps along an axis over all rows.
pub fn mean_step(grid: &ControlGrid<DVec2>, axis: usize) -> DVec2 {
    let [m, n] = grid.size;
    match axis {
        0 => (0..n)
            .map(|j| grid.point(m - 1, j) - grid.point(0, j))
            .sum(),
        _ => (0..m)
            .map(|i| grid.point(i, n - 1) - grid.point(i, 0))
            .sum(),
    }
}

/// Calls `f` for the steps between neighbouring control points along an axis.
#[inline]
pub fn for_each_step(grid: &ControlGrid<DVec2>, axis: usize, mut f: impl FnMut(DVec2)) {
    let points = grid.points();
    let [m, n] = grid.size;
    if axis == 0 {
        for row in points.chunks_exact(m) {
            for pair in row.windows(2) {
                f(pair[1] - pair[0]);
            }
        }
    } else {
        for (low, high) in points.iter().zip(&points[m..n * m]) {
            f(*high - *low);
        }
    }
}

/// True if no two places of the part have the same image: every step along u crosses every step along v in the same sense.
///
/// Proof: the way from the image of a to that of b is x U + y V, where x and y are b - a, and U and V are means, with positive
/// weights, of the control points' steps along u and along v. Their cross product is a mean of those of the steps, so it is not
/// 0, and x U + y V = 0 only for x = y = 0. Steps of no length, at a collapsed edge, add nothing.
pub fn maps_one_to_one(grid: &ControlGrid<DVec2>) -> bool {
    let (Some(u), Some(v)) = (cone(grid, 0), cone(grid, 1)) else {
        return false;
    };
    // The outermost steps of each side stand for all of them: the others are positive sums of them.
    let products = [
        u[0].perp_dot(v[0]),
        u[0].perp_dot(v[1]),
        u[1].perp_dot(v[0]),
        u[1].perp_dot(v[1]),
    ];
    products.iter().all(|p| *p > 0.0) || products.iter().all(|p| *p < 0.0)
}

/// The directions of the outermost two steps along an axis, clockwise first; `None` unless all are within a right angle of
/// their mean. (By their slopes against the mean, since these can be computed side by side.)
fn cone(grid: &ControlGrid<DVec2>, axis: usize) -> Option<[DVec2; 2]> {
    let mean = mean_step(grid, axis);
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    let mut narrow = true;
    for_each_step(grid, axis, |step| {
        let along = step.dot(mean);
        let slope = mean.perp_dot(step) / along;
        narrow &= along > 0.0 || step == DVec2::ZERO;
        // A step of no length has no slope, and changes nothing.
        low = if slope < low { slope } else { low };
        high = if slope > high { slope } else { high };
    });
    (narrow && low <= high).then(|| [low, high].map(|slope| mean + slope * mean.perp()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn net(at: impl Fn(f64, f64) -> DVec2) -> ControlGrid<DVec2> {
        ControlGrid::of(
            [4, 4],
            (0..16).map(|k| at(f64::from(k % 4), f64::from(k / 4))),
        )
    }

    #[test]
    fn folds_are_told_from_what_maps_one_to_one() {
        assert!(maps_one_to_one(&net(|i, j| DVec2::new(i + 0.3 * j * j, j))));
        // Collapsed to a point at j = 0, and turned around.
        assert!(maps_one_to_one(&net(|i, j| DVec2::new(j, i * j))));
        assert!(!maps_one_to_one(&net(|i, j| DVec2::new(i * (2.5 - i), j))));
        assert!(!maps_one_to_one(&net(|i, j| DVec2::new(i + j, i + j))));
        assert!(!maps_one_to_one(&net(|_, _| DVec2::ONE)));
    }

    #[test]
    fn a_sheet_seen_nearly_edge_on_is_parted_from_the_ray_along_its_own_direction() {
        let sheet = net(|i, j| DVec2::new(i - 1.5, i - 1.5 + 1e-9 * (1.0 + j)));
        let strip = |direction| Strip::of(&sheet, direction, size(&sheet));
        assert!(!strip(DVec2::X).is_beside() && !strip(DVec2::Y).is_beside());
        let along = strip(mean_step(&sheet, 0));
        assert!(along.is_beside() && !along.is_thin(1e-16) && along.is_thin(1e-9));
    }
}
