//! The closest hit as a first ray tracer finds it: a loop over all shapes, formulas from the blackboard.

use glam::{DAffine3, DMat3, DVec3};
use raytree::scene::flat::{FlatCamera, FlatObject};

/// Origin and direction.
pub type Line = (DVec3, DVec3);

/// The ray through the middle of a pixel, as the format says.
pub fn eye_ray(camera: &FlatCamera, (x, y): (u32, u32), (width, height): (u32, u32)) -> Line {
    let (w, h) = (f64::from(width), f64::from(height));
    let right = (2.0 * (f64::from(x) + 0.5) / w - 1.0) * camera.half_height * (w / h);
    let up = (1.0 - 2.0 * (f64::from(y) + 0.5) / h) * camera.half_height;
    let [u, v, back] = [camera.u, camera.v, camera.w].map(DVec3::from);
    (camera.eye.into(), (right * u + up * v - back).normalize())
}

/// t and the shape.
pub fn closest(objects: &[FlatObject], ray: Line) -> Option<(f64, &FlatObject)> {
    let hits = objects.iter().filter_map(|o| Some((hit(o, ray)?, o)));
    hits.min_by(|a, b| a.0.total_cmp(&b.0))
}

/// The kind of a shape.
pub fn kind(object: &FlatObject) -> &'static str {
    match object {
        FlatObject::Triangle { .. } => "triangle",
        FlatObject::Sphere { .. } => "sphere",
        FlatObject::Plane { .. } => "plane",
        FlatObject::Box { .. } => "box",
        FlatObject::Disc { .. } => "disc",
    }
}

fn hit(object: &FlatObject, (o, d): Line) -> Option<f64> {
    let ahead = |t: f64| (t > 0.0 && t.is_finite()).then_some(t);
    match object {
        FlatObject::Plane { point, normal, .. } => {
            ahead(plane((o, d), (*point).into(), (*normal).into()))
        }
        FlatObject::Triangle { corners, .. } => {
            let [a, b, c] = corners.map(DVec3::from);
            let normal = (b - a).cross(c - a);
            let t = ahead(plane((o, d), a, normal))?;
            let p = o + t * d;
            let inside = |a: DVec3, b: DVec3| (b - a).cross(p - a).dot(normal) >= 0.0;
            (inside(a, b) && inside(b, c) && inside(c, a)).then_some(t)
        }
        FlatObject::Sphere {
            center,
            radius,
            to_world,
            ..
        } => {
            let (o, d) = to_own_space((o, d), to_world.as_ref());
            let f = o - DVec3::from(*center);
            let (a, b, c) = (d.dot(d), f.dot(d), f.dot(f) - radius * radius);
            let root = (b * b - a * c).sqrt();
            [(-b - root) / a, (-b + root) / a]
                .into_iter()
                .find_map(ahead)
        }
        FlatObject::Box {
            min, max, to_world, ..
        } => {
            let (o, d) = to_own_space((o, d), to_world.as_ref());
            let (t0, t1) = ((DVec3::from(*min) - o) / d, (DVec3::from(*max) - o) / d);
            let (enter, exit) = (t0.min(t1).max_element(), t0.max(t1).min_element());
            [enter, exit]
                .into_iter()
                .find_map(ahead)
                .filter(|_| enter <= exit)
        }
        FlatObject::Disc {
            center,
            normal,
            radius,
            to_world,
            ..
        } => {
            let (o, d) = to_own_space((o, d), to_world.as_ref());
            let center = DVec3::from(*center);
            let t = ahead(plane((o, d), center, (*normal).into()))?;
            ((o + t * d - center).length() <= *radius).then_some(t)
        }
    }
}

fn plane((o, d): Line, point: DVec3, normal: DVec3) -> f64 {
    (point - o).dot(normal) / d.dot(normal)
}

/// The ray in the space of a shape: t stays what it is.
fn to_own_space((o, d): Line, to_world: Option<&[f64; 12]>) -> Line {
    let Some(m) = to_world else { return (o, d) };
    let row = |i: usize| DVec3::new(m[4 * i], m[4 * i + 1], m[4 * i + 2]);
    let map = DAffine3 {
        matrix3: DMat3::from_cols(row(0), row(1), row(2)).transpose(),
        translation: DVec3::new(m[3], m[7], m[11]),
    };
    let back = map.inverse();
    (back.transform_point3(o), back.transform_vector3(d))
}
