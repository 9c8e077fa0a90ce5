//! Quadrics that were turned, stretched and moved, by the same steps as `Transformed` takes.

use glam::{DAffine3, DQuat};

use super::{QuadricRays, scaled};
use crate::geometry::{Intersection, SurfacePoint};
use crate::math::rounding::offset_origin;
use crate::math::{DVec3, Interval, Ray, Transform};

fn any(random: &mut QuadricRays) -> Transform {
    let size = DVec3::from_array([0, 1, 2].map(|_| random.power(-1.0, 1.0)));
    let axis = random.vector().normalize();
    let turn = DQuat::from_axis_angle(axis, random.within(0.0, 6.0));
    let to = random.power(-1.0, 4.0) * random.vector();
    let map = DAffine3::from_scale_rotation_translation(size, turn, to);
    Transform::new(map).expect("can be undone")
}

/// What `Transformed::surface` makes of a point.
fn in_world(local: &SurfacePoint, transform: &Transform) -> SurfacePoint {
    let error = transform.point_error(local.point, local.error);
    let there_and_back = 1.0 + 2.0 * transform.condition();
    SurfacePoint {
        point: transform.point(local.point),
        error: DVec3::splat(there_and_back * error.max_element()),
        normal: transform.normal(local.normal),
        uv: local.uv,
    }
}

#[test]
fn no_ray_finds_a_placed_quadric_again_that_it_leaves() {
    let mut random = QuadricRays(23);
    let mut left = 0;
    for _ in 0..3000 {
        // The convex ones.
        for quadric in &scaled(1.0)[..5] {
            let transform = any(&mut random);
            let target = transform.point(0.8 * random.vector());
            let origin = target + random.power(0.5, 4.0) * random.vector();
            let ray = Ray::new(origin, (target - origin).normalize());
            let local = transform.ray_to_object(&ray);
            let Some((cut, _)) = quadric.spans(&local).cuts().next() else {
                continue;
            };
            let surface = in_world(&quadric.surface(&local, cut.t, cut.part), &transform);
            let n = surface.normal;
            let along = n.cross(random.vector()).normalize();
            let d = (along + random.power(-6.0, 1.0) * n).normalize();
            let next = Ray::new(offset_origin(surface.point, surface.error, n, d), d);
            let next = transform.ray_to_object(&next);
            let found = quadric.intersect(&next, Interval::FORWARD);
            assert!(
                !matches!(found, Intersection::Hit { .. }),
                "{quadric:?} {cut:?} {found:?}"
            );
            left += 1;
        }
    }
    assert!(left > 5000);
}
