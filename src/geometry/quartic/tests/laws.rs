//! What must hold for any ray, and how long it takes.

use super::*;
use crate::geometry::test_rays::many;
use crate::math::rounding::offset_origin;

/// A ray that leaves the surface where another met it: the number of crossings ahead tells the side it starts on.
fn leave(quartic: &Quartic, random: &mut TestRays) {
    let mut arrival = random.ray(0.9 * quartic.bounds.max.x, 10.0);
    arrival.origin += quartic.bounds.center();
    for (cut, enters) in quartic.spans(&arrival).cuts() {
        let found = quartic.surface(&arrival, cut.t, cut.part);
        assert!((found.normal.length() - 1.0).abs() < 1e-14);
        if found.error.max_element() > 1e-10 {
            // Near a point without a normal.
            continue;
        }
        if found.normal.dot(arrival.direction).abs() > 1e-6 {
            assert_eq!(found.normal.dot(arrival.direction) < 0.0, enters);
        }
        let direction = random.direction();
        let origin = offset_origin(found.point, found.error, found.normal, direction);
        let next = quartic.spans(&Ray::new(origin, direction));
        let ahead = next.cuts().filter(|(cut, _)| cut.t > 0.0).count();
        let outwards = direction.dot(found.normal) >= 0.0;
        // At an edge of the box, the way along the wall's normal may end outside of the box.
        let Aabb { min, max } = quartic.bounds;
        let in_box = origin.cmpgt(min).all() && origin.cmplt(max).all();
        if in_box || cut.part > 0 {
            assert_eq!(
                ahead % 2 == 0,
                outwards,
                "{origin:?} {direction:?} part {}",
                cut.part
            );
        }
        assert!((origin - found.point).length() < 1e-9);
    }
}

#[test]
fn a_ray_that_leaves_does_not_find_its_own_surface() {
    let mut random = TestRays(5);
    for quartic in [ball(2.0), ball(0.75), ring(0.25), tangle(), plate()] {
        (0..many(300)).for_each(|_| leave(&quartic, &mut random));
    }
}
