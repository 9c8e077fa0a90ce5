//! Hard cases of patches, and what the tests share.

mod folds;
mod geomdl;
mod leaving;
mod nurbs;
mod refusals;
mod seams;
mod shapes;
mod teapot;

use super::*;
use crate::math::Ray;

/// A small generator (Knuth's MMIX constants), enough for tests.
pub struct PatchRays(pub u64);

impl PatchRays {
    /// A number from 0 up to 1.
    pub fn unit(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A number from -1 up to 1.
    pub fn signed(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// A point of the cube from -1 to 1.
    pub fn point(&mut self) -> DVec3 {
        DVec3::new(self.signed(), self.signed(), self.signed())
    }

    /// A direction.
    pub fn direction(&mut self) -> DVec3 {
        self.point().normalize_or(DVec3::Z)
    }
}

/// A leaf of its own from rows of points.
pub fn leaf(rows: &[Vec<DVec3>], weights: Option<&[Vec<f64>]>) -> SurfacePatch {
    let weight = |j: usize, i: usize| weights.map_or(1.0, |w| w[j][i]);
    let rows_of = rows.iter().enumerate();
    let control = rows_of.flat_map(|(j, row)| {
        row.iter()
            .enumerate()
            .map(move |(i, p)| p.extend(weight(j, i)))
    });
    let size = [rows[0].len(), rows.len()];
    SurfacePatch::new(size, control.collect(), [[0.0; 2], [1.0; 2]])
}

/// A bicubic sheet over the square from -1 to 1 with heights at random.
pub fn sheet(random: &mut PatchRays, height: f64) -> SurfacePatch {
    let mut row = |j: usize| {
        let place = |i: usize| i as f64 / 1.5 - 1.0;
        (0..4)
            .map(|i| DVec3::new(place(i), place(j), height * random.signed()))
            .collect()
    };
    leaf(&(0..4).map(&mut row).collect::<Vec<_>>(), None)
}

pub fn crossings(patch: &SurfacePatch, origin: DVec3, direction: DVec3) -> PatchCrossings {
    patch.crossings(&Shear::new(&Ray::new(origin, direction)))
}

/// How many parts the search looked at.
pub fn parts(patch: &SurfacePatch, origin: DVec3, direction: DVec3) -> usize {
    let done = patch.arithmetic(&Shear::new(&Ray::new(origin, direction)));
    done.steps
        .iter()
        .filter(|s| matches!(s, SearchStep::Part(..)))
        .count()
}

/// A bicubic leaf over a lattice of points: `place(i, j)` with i along u.
pub fn lattice(place: impl Fn(f64, f64) -> DVec3) -> SurfacePatch {
    let row = |j: u32| (0..4).map(|i| place(f64::from(i), f64::from(j))).collect();
    leaf(&(0..4).map(row).collect::<Vec<_>>(), None)
}

/// Rays at corners, which lie on the ball or close to it, and across the patch, from near and from far.
#[test]
fn the_ball_turns_no_ray_away_that_meets_the_patch() {
    let mut random = PatchRays(77);
    let (mut met, mut turned_away) = (0, 0);
    for _ in 0..crate::geometry::test_rays::many(20_000u32) {
        let patch = sheet(&mut random, 0.5);
        let corner = [0, 3, 12, 15][(4.0 * random.unit()) as usize];
        let inwards = 1.0 - libm::exp10(-16.0 * random.unit());
        let target = patch.control[corner].truncate() * inwards;
        let distance = libm::exp10(8.0 * random.unit());
        let direction = random.direction();
        let ray = Ray::new(target - distance * direction, direction);
        let shear = Shear::new(&ray);
        let found = patch.intersect(&shear, Interval::LINE);
        let first = patch.crossings(&shear).first().map(|crossing| crossing.t);
        let t = match found {
            Intersection::Hit { t, .. } => Some(t),
            _ => None,
        };
        assert_eq!(t, first, "{ray:?}");
        met += u32::from(t.is_some());
        let beside = Ray::new(
            ray.origin + 3.0 * direction.any_orthonormal_vector(),
            direction,
        );
        turned_away += u32::from(patch.ball.is_passed_by_far(&Shear::new(&beside)));
    }
    assert!(met > 5000 && turned_away > 5000, "{met} {turned_away}");
}
