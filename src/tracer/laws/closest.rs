//! Closest hits gone wrong: a loop over all shapes with an altered test. No accelerator is touched.

use super::solids;
use crate::geometry::{Hit, Intersection, Plane, Shape, Shear, Triangle};
use crate::math::{DVec3, Interval, Ray};
use crate::scene::Bend;
use crate::world::World;

/// What is taken for the closest hit of a ray.
pub fn closest(bend: Bend, world: &World, ray: &Ray) -> Option<Hit> {
    let crossings = || world.crossings(ray, Interval::FORWARD).into_iter();
    match bend {
        Bend::FarthestHit => crossings().last().map(|crossing| crossing.hit),
        // Of a solid the first of its two crossings, which stand by t.
        Bend::FirstInList => crossings().map(|c| c.hit).min_by_key(|hit| hit.primitive),
        _ => first(bend, world, ray, f64::INFINITY),
    }
}

/// What is taken for something in the way of a shadow ray.
pub fn occluder(bend: Bend, world: &World, ray: &Ray, distance: f64) -> Option<Hit> {
    match bend {
        Bend::FarthestHit | Bend::FirstInList => {
            let crossings = world.crossings(ray, Interval::before(distance));
            crossings.first().map(|crossing| crossing.hit)
        }
        _ => first(bend, world, ray, distance),
    }
}

/// The first hit before `end` by the altered test.
fn first(bend: Bend, world: &World, ray: &Ray, end: f64) -> Option<Hit> {
    let shear = Shear::new(ray);
    let start = match bend {
        Bend::BehindAccepted => f64::NEG_INFINITY,
        _ => 0.0,
    };
    let interval = Interval::new(start, end);
    let shapes = (0..).zip(&world.scene.shapes);
    let hits = shapes.filter_map(|(primitive, shape)| {
        let (t, place, part) = test(bend, shape, ray, &shear, interval)?;
        Some(Hit {
            t,
            primitive,
            part,
            place,
        })
    });
    hits.min_by(|a, b| a.t.total_cmp(&b.t))
}

/// t, and the place and part of the shape there.
type Met = (f64, [f64; 3], u32);

/// The altered test of one shape; of a moved one in its own space.
fn test(bend: Bend, shape: &Shape, ray: &Ray, shear: &Shear, interval: Interval) -> Option<Met> {
    let at = |t: f64| interval.contains(t).then_some((t, [0.0; 3], 0));
    match (bend, shape) {
        (Bend::FarRoot, Shape::Sphere(sphere)) => at(sphere.span(ray)?[1]),
        (Bend::PlaneDSign, Shape::Plane(plane)) => at(with_wrong_sign(plane, ray)),
        (Bend::EdgePlaneSlide, Shape::Triangle(triangle)) => {
            let (t, place) = by_slide(triangle, ray)?;
            interval.contains(t).then_some((t, place, 0))
        }
        (Bend::EdgePlaneSlide, Shape::Mesh(mesh)) => {
            let all = mesh.triangles().iter().zip(0..);
            let met = all.filter_map(|(triangle, part)| {
                let (t, place) = by_slide(triangle, ray)?;
                interval.contains(t).then_some((t, place, part))
            });
            met.min_by(|a, b| a.0.total_cmp(&b.0))
        }
        (_, Shape::Body(body)) if solids::exchanges(bend, body) => {
            let cut = solids::first_crossing(bend, body, ray, interval)?;
            Some((cut.t, [0.0; 3], cut.part))
        }
        (_, Shape::Transformed(moved)) => {
            let own = moved.transform.ray_to_object(ray);
            test(bend, &moved.shape, &own, &Shear::new(&own), interval)
        }
        _ => right(shape, ray, shear, interval),
    }
}

fn right(shape: &Shape, ray: &Ray, shear: &Shear, interval: Interval) -> Option<Met> {
    match shape.intersect(ray, shear, interval) {
        Intersection::Hit { t, place, part } => Some((t, place, part)),
        _ => None,
    }
}

/// t = -(n.o - D) / (n.d) with D = -n.p, where D must be added.
fn with_wrong_sign(plane: &Plane, ray: &Ray) -> f64 {
    let n = plane.normal();
    -(n.dot(ray.origin) + n.dot(plane.origin())) / n.dot(ray.direction)
}

/// The inside test with edge planes through the wrong points: E_i.P - V_i.n >= 0 for E_i.(P - V_i) >= 0, where E_i = n x
/// (V_i+1 - V_i) points inwards.
fn by_slide(triangle: &Triangle, ray: &Ray) -> Option<(f64, [f64; 3])> {
    let [a, b, c] = triangle.corners;
    let n = (b - a).cross(c - a).try_normalize()?;
    let t = n.dot(a - ray.origin) / n.dot(ray.direction);
    let p = ray.at(t);
    let inside = [(a, b), (b, c), (c, a)]
        .into_iter()
        .all(|(v, next)| n.cross(next - v).dot(p) - v.dot(n) >= 0.0);
    let twice_area = |x: DVec3, y: DVec3, z: DVec3| (y - x).cross(z - x).dot(n);
    let whole = twice_area(a, b, c);
    let weights = [
        twice_area(p, b, c),
        twice_area(p, c, a),
        twice_area(p, a, b),
    ];
    (inside && t.is_finite()).then_some((t, weights.map(|w| w / whole)))
}
