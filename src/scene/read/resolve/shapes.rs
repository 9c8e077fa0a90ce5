//! Shapes in the world: those that keep their kind are carried there, the others are tested in their own space.

use crate::geometry::{Aabb, Cuboid, Disc, Plane, Shape, Sphere, Transformed};
use crate::math::{DVec3, Transform};

/// Shape in the world. `turn_shows` tells that its surface coordinates can be seen, so that a turn matters.
pub fn in_world(shape: Shape, map: Option<&Transform>) -> Shape {
    let Some(map) = map else { return shape };
    match shape {
        Shape::Sphere(s) => sphere(s, map),
        Shape::Disc(d) => disc(*d, map),
        Shape::Cuboid(c) => cuboid(c.bounds, map),
        Shape::Plane(p) => Shape::Plane(Box::new(Plane::new(
            map.point(p.origin()),
            map.normal(p.normal()),
        ))),
        Shape::Transformed(own) => together(*own, map),
        other => placed(other, map),
    }
}

/// Scaled evenly it stays a sphere; stretched or turned (u and v turn with it) it is tested in its own space.
fn sphere(sphere: Sphere, map: &Transform) -> Shape {
    match map.uniform_scale() {
        Some(scale) if !turns(map) => Shape::Sphere(Sphere {
            center: map.point(sphere.center),
            radius: sphere.radius * scale,
        }),
        _ => placed(Shape::Sphere(sphere), map),
    }
}

/// Scaled evenly it stays a disc; stretched or turned (u and v turn with it) it is tested in its own space.
fn disc(disc: Disc, map: &Transform) -> Shape {
    match map.uniform_scale() {
        Some(scale) if !turns(map) => Shape::Disc(Box::new(Disc::new(
            map.point(disc.center),
            map.normal(disc.frame.w),
            disc.radius * scale,
        ))),
        _ => placed(Shape::Disc(Box::new(disc)), map),
    }
}

/// If every axis goes to an axis it stays a box along the axes.
fn cuboid(bounds: Aabb, map: &Transform) -> Shape {
    let to_axis = |v: DVec3| v.to_array().iter().filter(|c| **c != 0.0).count() == 1;
    if DVec3::AXES.iter().all(|&axis| to_axis(map.vector(axis))) {
        let corners = [map.point(bounds.min), map.point(bounds.max)];
        let bounds = Aabb::around(corners);
        return Shape::Cuboid(Cuboid { bounds });
    }
    placed(Shape::Cuboid(Cuboid { bounds }), map)
}

/// A shape that is tested in a space of its own.
pub fn placed(shape: Shape, transform: &Transform) -> Shape {
    Shape::Transformed(Box::new(Transformed {
        shape,
        transform: *transform,
    }))
}

/// A shape that has a space of its own already.
fn together(own: Transformed, map: &Transform) -> Shape {
    match Transform::new(map.to_world() * own.transform.to_world()) {
        Some(whole) => in_world(own.shape, Some(&whole)),
        // Both can be undone, but together they are beyond what numbers hold: nothing of it is large enough to be hit.
        None => Shape::Transformed(Box::new(own)),
    }
}

/// True unless every axis keeps its direction.
fn turns(map: &Transform) -> bool {
    DVec3::AXES
        .iter()
        .any(|&axis| map.vector(axis) != axis * map.vector(axis).dot(axis).abs())
}

#[cfg(test)]
mod tests {
    use glam::DAffine3;

    use super::*;

    fn map(m: DAffine3) -> Transform {
        Transform::new(m).expect("can be undone")
    }

    #[test]
    fn spheres_and_boxes_are_carried_where_they_keep_their_kind() {
        let unit = Sphere {
            center: DVec3::X,
            radius: 1.0,
        };
        let grown = map(DAffine3::from_scale(DVec3::splat(2.0)));
        let Shape::Sphere(s) = sphere(unit, &grown) else {
            panic!("evenly scaled")
        };
        assert_eq!((s.center, s.radius), (DVec3::X * 2.0, 2.0));
        let stretched = map(DAffine3::from_scale(DVec3::new(1.0, 2.0, 1.0)));
        assert!(matches!(sphere(unit, &stretched), Shape::Transformed(_)));
        let turned = map(DAffine3::from_rotation_y(1.0));
        assert!(matches!(sphere(unit, &turned), Shape::Transformed(_)));

        let bounds = Aabb::around([DVec3::ZERO, DVec3::ONE]);
        assert!(matches!(cuboid(bounds, &turned), Shape::Transformed(_)));
        let flipped = map(DAffine3::from_scale(DVec3::new(-2.0, 1.0, 1.0)));
        let Shape::Cuboid(c) = cuboid(bounds, &flipped) else {
            panic!("along the axes")
        };
        assert_eq!(
            (c.bounds.min, c.bounds.max),
            (DVec3::new(-2.0, 0.0, 0.0), DVec3::new(0.0, 1.0, 1.0))
        );
    }
}
