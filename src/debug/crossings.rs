//! All crossings of a ray's line with a shape, wherever they lie on it.

use crate::geometry::{Intersection, Shape, Shear};
use crate::math::{Interval, Ray};

/// The whole line of a ray.
const LINE: Interval = Interval {
    min: f64::NEG_INFINITY,
    max: f64::INFINITY,
};

/// The t of each crossing, in order: an even number of a solid, one of what is flat, none if the line misses the shape.
pub fn crossings(shape: &Shape, ray: &Ray) -> Vec<f64> {
    let shape = shape.plain();
    if let Some(spans) = shape.spans(ray) {
        return spans.cuts().map(|(cut, _)| cut.t).collect();
    }
    let shear = Shear::new(ray);
    if shape.mesh().is_some() {
        let mut all = Vec::new();
        let mut rest = LINE;
        while let Intersection::Hit { t, .. } = shape.intersect(ray, &shear, rest) {
            all.push(t);
            rest.min = t;
        }
        return all;
    }
    match shape.intersect(ray, &shear, LINE) {
        Intersection::Hit { t, .. } | Intersection::Behind(t) | Intersection::TooFar(t) => vec![t],
        Intersection::Miss => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Aabb, Cuboid, Sphere, Triangle};
    use crate::math::DVec3;

    #[test]
    fn a_solid_is_crossed_twice_and_a_triangle_once() {
        let ray = Ray::new(DVec3::new(0.0, 0.0, -3.0), DVec3::Z);
        let sphere = Shape::Sphere(Sphere {
            center: DVec3::ZERO,
            radius: 1.0,
        });
        assert_eq!(crossings(&sphere, &ray), [2.0, 4.0]);
        let bounds = Aabb {
            min: DVec3::splat(-0.5),
            max: DVec3::splat(0.5),
        };
        assert_eq!(
            crossings(&Shape::Cuboid(Cuboid { bounds }), &ray),
            [2.5, 3.5]
        );
        let triangle = |z: f64| {
            let corners = [[-1.0, -1.0, z], [1.0, -1.0, z], [0.0, 1.0, z]];
            Shape::Triangle(Triangle {
                corners: corners.map(DVec3::from),
            })
        };
        assert_eq!(crossings(&triangle(1.0), &ray), [4.0]);
        // Behind the origin as well.
        assert_eq!(crossings(&triangle(-5.0), &ray), [-2.0]);
        let beside = Ray::new(DVec3::new(0.0, 2.0, -3.0), DVec3::Z);
        assert!(crossings(&sphere, &beside).is_empty());
        assert!(crossings(&triangle(1.0), &beside).is_empty());
    }
}
