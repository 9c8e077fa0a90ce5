//! Rays that leave a patch: they never find their own surface again, and lose nothing behind it.

use super::seams::{all, lump};
use super::*;
use crate::geometry::test_rays::many;
use crate::math::rounding::offset_origin;

/// Sends rays from places of leaves of a convex body, outwards and inwards.
fn leave(leaves: &[SurfacePatch], rays: usize, seed: u64) {
    let mut random = PatchRays(seed);
    for _ in 0..rays {
        let leaf = &leaves[(random.unit() * leaves.len() as f64) as usize];
        let end = |random: &mut PatchRays| match (random.unit() * 4.0) as u32 {
            0 => 0.0,
            1 => 1.0,
            _ => random.unit(),
        };
        let surface = leaf.surface([end(&mut random), end(&mut random)]);
        // From straight off to within 1e-9 of grazing.
        let aside = random
            .direction()
            .cross(surface.normal)
            .normalize_or(DVec3::X);
        let rise = libm::pow(10.0, -9.0 * random.unit());
        let out = (aside + rise * surface.normal).normalize();
        let away = Ray::new(
            offset_origin(surface.point, surface.error, surface.normal, out),
            out,
        );
        let front =
            |found: PatchCrossings| found.into_iter().filter(|c| c.t > 0.0).collect::<Vec<_>>();
        assert!(front(all(leaves, &away)).is_empty(), "{away:?}");
        let into = (aside - rise * surface.normal).normalize();
        let inside = Ray::new(
            offset_origin(surface.point, surface.error, surface.normal, into),
            into,
        );
        let found = front(all(leaves, &inside));
        assert_eq!(
            found.iter().filter(|c| !c.enters).count(),
            1 + found.iter().filter(|c| c.enters).count()
        );
        // From 1e-9 above, straight down: found, there.
        let above = Ray::new(surface.point + 1e-9 * surface.normal, -surface.normal);
        let near = front(all(leaves, &above))
            .into_iter()
            .find(|c| (c.t - 1e-9).abs() < 4.0 * surface.error.x);
        assert!(near.is_some_and(|c| c.enters), "{above:?}");
    }
}

/// A convex body: a sphere by NURBS, moved.
fn ball(center: DVec3, radius: f64) -> Vec<SurfacePatch> {
    let mut surface = super::nurbs::sphere();
    for p in surface.points.iter_mut().flatten() {
        *p = center + radius * *p;
    }
    surface.leaves().expect("a good surface")
}

#[test]
fn a_ray_that_leaves_a_convex_body_is_gone() {
    leave(&ball(DVec3::ZERO, 1.0), many(300), 1);
    leave(&ball(DVec3::new(300.0, -20.0, 7.0), 0.5), many(300), 2);
    leave(&ball(DVec3::new(10.0, -10.0, 3.0), 1e2), many(300), 3);
    leave(&ball(DVec3::new(0.1, -0.1, 0.03), 1e-2), many(300), 4);
}

#[test]
fn what_leaves_a_lump_starts_on_the_side_it_went_to() {
    // A lump is not convex: the ray may meet it again, but then as often as it takes to be outside, or inside.
    let mut random = PatchRays(31);
    for _ in 0..4 {
        let body = lump(&mut random, 4, 2, 0.1, false, [3, 3]);
        for leaf in &body {
            for _ in 0..10 {
                let surface = leaf.surface([random.unit(), random.unit()]);
                let direction = random.direction();
                let origin = offset_origin(surface.point, surface.error, surface.normal, direction);
                let found = all(&body, &Ray::new(origin, direction));
                let ahead = found.iter().filter(|c| c.t > 0.0).count();
                assert_eq!(ahead % 2, usize::from(surface.normal.dot(direction) < 0.0));
            }
        }
    }
}
