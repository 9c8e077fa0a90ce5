//! Hit points, normals and origins gone wrong.

use glam::Vec2Swizzles;

use crate::geometry::{Hit, Shape};
use crate::math::{DVec3, Ray};
use crate::scene::{Bend, Scene};
use crate::shading::{Interaction, Side};

/// The offset of [`Bend::OffsetInwards`], in metres.
const OFFSET: f64 = 1e-4;

/// Hit point with its normals.
pub fn interaction(bend: Bend, scene: &Scene, ray: &Ray, hit: &Hit) -> Interaction {
    let at = scene.interaction(ray, hit);
    let with = |normal: DVec3| Interaction { normal, ..at };
    let with_both = |normal: DVec3, geometric_normal: DVec3| Interaction {
        geometric_normal,
        normal,
        ..at
    };
    let shape = &scene.shapes[hit.primitive as usize];
    match bend {
        Bend::NormalNotTurned if at.side == Side::Back => {
            with_both(-at.normal, -at.geometric_normal)
        }
        Bend::NormalInward if !matches!(shape, Shape::Plane(_)) => {
            with_both(-at.normal, -at.geometric_normal)
        }
        Bend::NormalByMatrix => match shape {
            Shape::Transformed(moved) => {
                let local = moved.shape.surface(
                    &moved.transform.ray_to_object(ray),
                    hit.t,
                    hit.place,
                    hit.part,
                );
                let normal = moved.transform.vector(local.normal).normalize_or(at.normal);
                let turned = normal * facing(normal, ray.direction);
                with_both(turned, turned)
            }
            _ => at,
        },
        Bend::NormalNotUnit => match (shape, blended(scene, hit, hit.place)) {
            (_, Some(blended)) => with(blended * facing(blended, ray.direction)),
            (Shape::Sphere(sphere), None) => with(at.normal * sphere.radius),
            _ => at,
        },
        Bend::BarycentricRotated => {
            let [u, v, w] = hit.place;
            match blended(scene, hit, [w, u, v]).and_then(DVec3::try_normalize) {
                Some(normal) => with(normal * facing(normal, ray.direction)),
                None => at,
            }
        }
        // Flat parts have no gradient, and no other normal.
        Bend::NormalRadial => match radial(shape, at.point) {
            Some(normal) if shape.gradient(at.point, hit.part).is_some() => {
                let turned = normal * facing(normal, ray.direction);
                with_both(turned, turned)
            }
            _ => at,
        },
        Bend::UvSwapped => Interaction {
            uv: at.uv.yx(),
            ..at
        },
        Bend::Flat => with(at.geometric_normal),
        _ => at,
    }
}

/// The direction from the middle of a solid with curved walls, as if it were a sphere.
fn radial(shape: &Shape, point: DVec3) -> Option<DVec3> {
    match shape {
        Shape::Body(body) => (point - body.bounds().center()).try_normalize(),
        Shape::Transformed(moved) => match &moved.shape {
            Shape::Body(body) => {
                let middle = moved.transform.point(body.bounds().center());
                (point - middle).try_normalize()
            }
            _ => None,
        },
        _ => None,
    }
}

/// 1 or -1, so that a normal times it faces the ray.
fn facing(normal: DVec3, direction: DVec3) -> f64 {
    if normal.dot(direction) > 0.0 {
        -1.0
    } else {
        1.0
    }
}

/// The corner normals of a smooth mesh, weighed and added.
fn blended(scene: &Scene, hit: &Hit, weights: [f64; 3]) -> Option<DVec3> {
    scene.blended_normal(hit, weights)
}

/// Origin of a ray that leaves a hit point.
pub fn origin(bend: Option<Bend>, at: &Interaction, direction: DVec3) -> DVec3 {
    match bend {
        Some(Bend::NoOffset) => at.point,
        Some(Bend::OffsetInwards) => at.point - OFFSET * at.geometric_normal,
        _ => at.origin_towards(direction),
    }
}
