//! Seams, corners and collapsed edges: closed bodies are crossed evenly, sheets once.

use super::*;
use crate::geometry::test_rays::many;

/// A closed body as lumpy as asked: patches around the y axis, closed at two poles, where an edge is a point each.
pub fn lump(
    random: &mut PatchRays,
    around: usize,
    up: usize,
    bumps: f64,
    rational: bool,
    degree: [usize; 2],
) -> Vec<SurfacePatch> {
    let [p, q] = degree;
    let (columns, rows) = (p * around, q * up + 1);
    let mut points = Vec::new();
    for j in 0..rows {
        let (sin, cos) = libm::sincos(std::f64::consts::PI * j as f64 / (rows - 1) as f64);
        let row: Vec<glam::DVec4> = (0..columns)
            .map(|i| {
                let (s, c) = libm::sincos(std::f64::consts::TAU * i as f64 / columns as f64);
                let radius = 1.0 + bumps * random.signed();
                let pole = j == 0 || j == rows - 1;
                let direction = if pole {
                    DVec3::new(0.0, -cos.signum(), 0.0)
                } else {
                    DVec3::new(sin * c, -cos, -sin * s)
                };
                let radius = if pole { 1.0 } else { radius };
                let weight = if rational {
                    4.0 * random.unit() + 0.25
                } else {
                    1.0
                };
                (direction * radius).extend(weight)
            })
            .collect();
        points.push(row);
    }
    patches_of(&points, degree, [around, up])
}

/// A closed body like a ring.
pub fn ring(random: &mut PatchRays, around: usize, tube: usize, bumps: f64) -> Vec<SurfacePatch> {
    let (columns, rows) = (3 * around, 3 * tube);
    let mut points: Vec<Vec<glam::DVec4>> = (0..rows)
        .map(|j| {
            let (y, x) = libm::sincos(std::f64::consts::TAU * j as f64 / rows as f64);
            (0..columns)
                .map(|i| {
                    let (s, c) = libm::sincos(std::f64::consts::TAU * i as f64 / columns as f64);
                    let radius = 1.0 + 0.4 * x;
                    (DVec3::new(c * radius, 0.4 * y, -s * radius) + bumps * random.point())
                        .extend(1.0)
                })
                .collect()
        })
        .collect();
    points.push(points[0].clone());
    patches_of(&points, [3, 3], [around, tube])
}

fn patches_of(
    points: &[Vec<glam::DVec4>],
    [p, q]: [usize; 2],
    [around, up]: [usize; 2],
) -> Vec<SurfacePatch> {
    let mut patches = Vec::new();
    for b in 0..up {
        for a in 0..around {
            let point =
                |k: usize| points[b * q + k / (p + 1)][(a * p + k % (p + 1)) % points[0].len()];
            let control = (0..(p + 1) * (q + 1)).map(point).collect();
            patches.push(SurfacePatch::new(
                [p + 1, q + 1],
                control,
                [[0.0; 2], [1.0; 2]],
            ));
        }
    }
    patches
}

/// The patches, each turned in (u, v) by a number of quarters at random: the same surface, with the same outside, but neighbours
/// run along their seams in any sense.
fn turned(random: &mut PatchRays, patches: Vec<SurfacePatch>) -> Vec<SurfacePatch> {
    let quarter = |patch: SurfacePatch| {
        let [m, n] = patch.size;
        // The new u runs along the old v, the new v against the old u.
        let control = (0..m * n).map(|k| patch.control[(k % n) * m + (m - 1 - k / n)]);
        SurfacePatch {
            size: [n, m],
            control: control.collect(),
            ..patch
        }
    };
    let quarters = |random: &mut PatchRays| (random.unit() * 4.0) as usize;
    let turn = |patch: SurfacePatch| (0..quarters(random)).fold(patch, |patch, _| quarter(patch));
    patches.into_iter().map(turn).collect()
}

/// All crossings of a body by one ray.
pub fn all(leaves: &[SurfacePatch], ray: &Ray) -> PatchCrossings {
    let shear = Shear::new(ray);
    let line = Interval::LINE;
    // Seen from far away, a patch is rounded as if it had been moved: boxes must be wider by that, as in `accel`.
    let near = leaves.iter().filter(|leaf| {
        let bounds = leaf.bounds();
        let reach =
            ray.origin.abs().max_element() + bounds.max.abs().max(bounds.min.abs()).max_element();
        bounds
            .padded(DVec3::splat(gamma(64) * reach))
            .clip(ray, line)
            .is_some()
    });
    near.flat_map(|leaf| leaf.crossings(&shear)).collect()
}

/// A ray to a point of a body that is hard on seams: at a corner, on an edge, or within some bits of them.
pub fn aimed(random: &mut PatchRays, leaves: &[SurfacePatch]) -> Ray {
    let leaf = &leaves[(random.unit() * leaves.len() as f64) as usize];
    let near = |random: &mut PatchRays| match (random.unit() * 6.0) as u32 {
        0 => 0.0,
        1 => 1.0,
        2 => random.unit() * 1e-15,
        3 => 1.0 - random.unit() * 1e-15,
        4 => 0.5,
        _ => random.unit(),
    };
    let place = [near(random), near(random)];
    let surface = leaf.surface(place);
    let direction = match (random.unit() * 4.0) as u32 {
        // Along an axis, at random, nearly and exactly tangent.
        0 => [DVec3::X, DVec3::NEG_Y, DVec3::Z][(random.unit() * 3.0) as usize],
        1 => {
            let tangent = random
                .direction()
                .cross(surface.normal)
                .normalize_or(DVec3::X);
            (tangent + random.signed().powi(15) * surface.normal).normalize()
        }
        _ => random.direction(),
    };
    let back = [0.0, 1.0, 1e3, 1e6][(random.unit() * 4.0) as usize];
    Ray::new(surface.point - back * direction, direction)
}

/// Asks a body with rays that are hard on seams; gives the number that are crossed.
pub fn evenly(leaves: &[SurfacePatch], rays: usize, seed: u64) -> usize {
    assert_eq!(open_edges(leaves), 0);
    let mut random = PatchRays(seed);
    let mut met = 0;
    for _ in 0..rays {
        let ray = aimed(&mut random, leaves);
        let found = all(leaves, &ray);
        let into = found.iter().filter(|c| c.enters).count();
        assert_eq!(2 * into, found.len(), "{ray:?}");
        met += usize::from(into > 0);
    }
    met
}

/// Closed bodies of all kinds.
fn bodies(random: &mut PatchRays) -> [Vec<SurfacePatch>; 6] {
    let whole = [
        lump(random, 4, 2, 0.2, false, [3, 3]),
        lump(random, 3, 2, 0.3, true, [3, 3]),
        lump(random, 3, 3, 0.5, true, [2, 4]),
        lump(random, 4, 3, 0.1, true, [1, 5]),
        ring(random, 3, 2, 0.1),
    ];
    let [a, b, c, d, e] = whole.map(|body| turned(random, body));
    // Also cut into leaves, which is done from both sides of a seam.
    let cut = leaves::cut(&b).expect("few");
    [a, b, c, d, e, cut]
}

#[test]
fn closed_bodies_are_entered_as_often_as_left() {
    let mut random = PatchRays(11);
    for k in 0..5 {
        for body in &bodies(&mut random) {
            let count = many(50);
            assert!(evenly(body, count, k) > count / 5);
        }
    }
}

/// Four sheets around a corner, from one lattice of heights: rays from above to their seams and the corner, each within some
/// bits. Gives the number of rays that are met.
fn exactly_one(rays: usize, seed: u64) -> usize {
    let mut random = PatchRays(seed);
    let heights: Vec<f64> = (0..49).map(|_| 0.5 * random.signed()).collect();
    let point = |i: usize, j: usize| {
        DVec3::new(
            i as f64 / 3.0 - 1.0,
            j as f64 / 3.0 - 1.0,
            heights[7 * j + i],
        )
    };
    let part = |a: usize, b: usize| {
        let row = |j: usize| (0..4).map(|i| point(3 * a + i, 3 * b + j)).collect();
        leaf(&(0..4).map(row).collect::<Vec<_>>(), None)
    };
    let sheets = [part(0, 0), part(1, 0), part(0, 1), part(1, 1)];
    let mut met = 0;
    for _ in 0..rays {
        let bits =
            |random: &mut PatchRays| random.signed() * libm::pow(10.0, -13.0 - 4.0 * random.unit());
        let (along, on_u) = (0.8 * random.signed(), random.unit() < 0.5);
        let corner = random.unit() < 0.4;
        let [x, y] = match (corner, on_u) {
            (true, _) => [bits(&mut random), bits(&mut random)],
            (_, true) => [along, 0.0],
            (_, false) => [bits(&mut random), along],
        };
        // The seam's own height there, so that it is met from any direction.
        let [a, b] = [x, y].map(|c| usize::from(c >= 0.0));
        let height = sheets[a + 2 * b]
            .surface([x + 1.0 - a as f64, y + 1.0 - b as f64])
            .point
            .z;
        let direction = DVec3::new(0.1 * random.signed(), 0.1 * random.signed(), -1.0);
        let back = [1.0, 1e3, 1e6][(random.unit() * 3.0) as usize];
        let ray = Ray::new(DVec3::new(x, y, height) - back * direction, direction);
        let shear = Shear::new(&ray);
        // A steep ray crosses the four together once, unless they rise more steeply than it falls.
        let found: Vec<PatchCrossing> = sheets.iter().flat_map(|s| s.crossings(&shear)).collect();
        let fronts = found.iter().filter(|c| c.enters).count();
        assert_eq!(2 * fronts, found.len() + 1, "{ray:?}");
        met += found.len();
    }
    met
}

#[test]
fn a_seam_and_a_corner_of_four_are_owned_once() {
    let met = exactly_one(many(2000), 1);
    assert!((many(2000)..many(2200)).contains(&met), "{met}");
}
