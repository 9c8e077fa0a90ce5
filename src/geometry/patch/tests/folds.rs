//! Folds: sheets seen edge-on, cusps, and rays that touch.

use super::*;
use crate::geometry::test_rays::many;

fn rows(points: &[[[f64; 3]; 4]; 4]) -> Vec<Vec<DVec3>> {
    points
        .iter()
        .map(|row| row.iter().map(|p| DVec3::from(*p)).collect())
        .collect()
}

#[test]
fn a_fully_folded_net_gives_all_crossings() {
    let folded = leaf(
        &rows(&[
            [
                [0.0, 0.0, 0.0],
                [3.0, 0.0, 1.0],
                [-2.0, 0.0, 2.0],
                [1.0, 0.0, 3.0],
            ],
            [
                [0.0, 1.0, 0.0],
                [3.0, 1.0, 1.0],
                [-2.0, 1.0, 2.0],
                [1.0, 1.0, 3.0],
            ],
            [
                [0.0, 2.0, 0.0],
                [3.0, 2.0, 1.0],
                [-2.0, 2.0, 2.0],
                [1.0, 2.0, 3.0],
            ],
            [
                [0.0, 3.0, 0.0],
                [3.0, 3.0, 1.0],
                [-2.0, 3.0, 2.0],
                [1.0, 3.0, 3.0],
            ],
        ]),
        None,
    );
    // x(s) = 16 s^3 - 24 s^2 + 9 s is 1/2 at s = 1/2 and at 1/2 +- sqrt(3)/4; z = 3 s.
    let found = crossings(&folded, DVec3::new(0.5, 1.5, -2.0), DVec3::Z);
    let expected = [0.5 - 3f64.sqrt() / 4.0, 0.5, 0.5 + 3f64.sqrt() / 4.0];
    assert_eq!(found.len(), 3);
    for (c, s) in found.iter().zip(expected) {
        assert!((c.t - 2.0 - 3.0 * s).abs() < 1e-14 && (c.place[0] - s).abs() < 1e-14);
    }
    assert_eq!(
        found.iter().map(|c| c.enters).collect::<Vec<_>>(),
        [false, true, false]
    );
}

#[test]
fn a_sheet_seen_edge_on_is_crossed_as_often_as_its_rim_says() {
    // Along x at height z: odd if the heights at both ends lie on different sides of it.
    let mut random = PatchRays(12);
    for _ in 0..300 {
        let patch = sheet(&mut random, 0.3);
        let (y, z) = (random.signed(), 0.2 * random.signed());
        let height = |u: f64| patch.derivatives([u, 0.5 * (y + 1.0)])[0].z;
        let odd = (height(0.0) > z) != (height(1.0) > z);
        let found = crossings(&patch, DVec3::new(-5.0, y, z), DVec3::X);
        assert_eq!(found.len() % 2, usize::from(odd));
    }
    // A flat sheet in the ray's own plane, and one that is rolled around the ray's direction.
    let flat = lattice(|i, j| DVec3::new(i, j + 0.3 * i * i, 0.0));
    let rolled = lattice(|i, j| DVec3::new(i, 0.4 * (j - 1.0) * (j - 1.5), 0.3 * (j - 1.2)));
    for k in 0..50 {
        let (direction, aside) = (
            DVec3::new(1.0, 0.1 * f64::from(k), 0.0),
            DVec3::new(0.5, 1.0, 0.0),
        );
        assert_eq!(crossings(&flat, aside - direction, direction).len(), 0);
        let on = rolled.derivatives([0.0, f64::from(k) / 50.0])[0];
        assert_eq!(crossings(&rolled, on - DVec3::X, DVec3::X).len(), 0);
        assert!(parts(&rolled, on - DVec3::X, DVec3::X) < 400);
    }
}

#[test]
fn a_cusp_is_met_where_its_cubic_is_zero() {
    // A curve with crossed tangents, drawn straight along z. Its four points make a cusp at s = 1/2.
    let across = [[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0, 0.0]];
    let patch = lattice(|i, j| DVec3::new(across[i as usize][0], across[i as usize][1], j - 1.5));
    let mut random = PatchRays(21);
    let mut most = 0;
    for _ in 0..300 {
        let target = DVec3::new(0.5, 0.75, 0.0) + 0.3 * random.point();
        let direction = DVec3::new(random.signed(), random.signed(), 0.0).normalize()
            + DVec3::new(0.0, 0.0, 0.05);
        let origin = DVec3::new(target.x, target.y, 0.0) - 2.0 * direction;
        // n . (C(s) - o) changes its sign at each crossing.
        let n = DVec3::new(-direction.y, direction.x, 0.0);
        let value = |s: f64| n.dot(patch.derivatives([s, 0.5])[0] - origin);
        let samples: Vec<f64> = (0..=2000).map(|k| value(f64::from(k) / 2000.0)).collect();
        let changes = samples
            .windows(2)
            .filter(|w| (w[0] > 0.0) != (w[1] > 0.0))
            .count();
        let found = crossings(&patch, origin, direction);
        assert_eq!(found.len(), changes, "{origin} {direction}");
        most = most.max(found.len());
    }
    assert_eq!(most, 3);
    // Through the cusp itself: oddly if the line parts the curve's ends, which a slope above 3/2 does; the work is bounded.
    for k in 1..40 {
        let slope = 0.2 * f64::from(k - 20);
        let direction = DVec3::new(1.0, slope, 0.0);
        let origin = DVec3::new(0.5, 0.75, 0.1) - direction;
        assert_eq!(
            crossings(&patch, origin, direction).len() % 2,
            usize::from(slope.abs() > 1.5)
        );
        assert!(parts(&patch, origin, direction) < 600);
    }
}

/// Rays that pass over the top of z = -x^2 - y^2 at a height: how many parts are looked at in the mean, and how many rays met.
fn over_the_top(rays: i32, height: f64) -> (f64, i32) {
    // Bezier points of 1 - x^2 on [-1, 1], biquadratic in all: x in -1, 0, 1 and -x^2 in -1, 1, -1.
    let (x, square) = ([-1.0, 0.0, 1.0], [-1.0, 1.0, -1.0]);
    let row = |j: usize| {
        (0..3)
            .map(|i| DVec3::new(x[i], x[j], square[i] + square[j]))
            .collect()
    };
    let bowl = leaf(&(0..3).map(row).collect::<Vec<_>>(), None);
    let mut random = PatchRays(17);
    let (mut looked, mut met) = (0, 0);
    for _ in 0..rays {
        let (sin, cos) = libm::sincos(random.unit() * std::f64::consts::TAU);
        let direction = DVec3::new(cos, sin, 0.0);
        let origin = DVec3::new(0.0, 0.0, height) - 3.0 * direction;
        let found = crossings(&bowl, origin, direction);
        assert!(found.len() == 2 || found.is_empty());
        met += i32::from(!found.is_empty());
        looked += parts(&bowl, origin, direction);
        for c in &found {
            let surface = bowl.surface(c.place);
            let off = surface.point - (origin + c.t * direction);
            assert!(off.abs().cmple(surface.error).all(), "{off}");
        }
    }
    (looked as f64 / f64::from(rays), met)
}

#[test]
fn tangent_rays_take_bounded_work_and_meet_twice_or_never() {
    for exponent in (1..18).step_by(4) {
        let height = libm::pow(10.0, -f64::from(exponent));
        let (below, met) = over_the_top(20, -height);
        assert!(
            below < 300.0 && (met == 20 || exponent > 13),
            "{exponent}: {below} parts, {met} met"
        );
        let (above, met) = over_the_top(20, height);
        assert!(
            above < 300.0 && met == 0,
            "{exponent}: {above} parts, {met} met"
        );
    }
}

/// How often the ray crosses a net of `2 n^2` triangles between points of the patch, seen along the ray: by their signs alone.
fn by_triangles(patch: &SurfacePatch, ray: &Ray, n: usize) -> usize {
    let (x, y) = ray.direction.any_orthonormal_pair();
    let seen: Vec<DVec2> = (0..(n + 1) * (n + 1))
        .map(|k| {
            let place = [k % (n + 1), k / (n + 1)].map(|c| c as f64 / n as f64);
            let p = patch.derivatives(place)[0] - ray.origin;
            DVec2::new(p.dot(x), p.dot(y))
        })
        .collect();
    let inside = |a: DVec2, b: DVec2, c: DVec2| {
        let left = [(a, b), (b, c), (c, a)].map(|(p, q)| p.perp_dot(q) > 0.0);
        left == [true; 3] || left == [false; 3]
    };
    let squares = (0..n * n).map(|k| (k / n) * (n + 1) + k % n);
    squares
        .map(|k| {
            let [a, b, c, d] = [seen[k], seen[k + 1], seen[k + n + 2], seen[k + n + 1]];
            usize::from(inside(a, b, c)) + usize::from(inside(a, c, d))
        })
        .sum()
}

#[test]
fn all_crossings_of_wild_nets_are_found() {
    assert_eq!(wild(many(40), 1), 0);
}

/// The number of rays through nets of points at random for which a fine net of triangles has another count: a coarser one misses
/// two crossings near a fold.
fn wild(rays: usize, seed: u64) -> usize {
    let mut random = PatchRays(seed);
    let mut most = 0;
    let mut differ = 0;
    for _ in 0..rays {
        let row = |_| (0..4).map(|_| random.point()).collect();
        let patch = leaf(&(0..4).map(row).collect::<Vec<_>>(), None);
        let direction = random.direction();
        let ray = Ray::new(0.2 * random.point() - 3.0 * direction, direction);
        let found = crossings(&patch, ray.origin, direction);
        most = most.max(found.len());
        if found.len() != by_triangles(&patch, &ray, 60)
            && found.len() != by_triangles(&patch, &ray, 500)
        {
            differ += 1;
        }
    }
    assert!(most >= 3);
    differ
}
