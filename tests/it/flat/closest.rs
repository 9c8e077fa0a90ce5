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
        FlatObject::Polygon { .. } => "polygon",
        FlatObject::Quadric { .. } => "quadric",
        FlatObject::Torus { .. } => "torus",
        FlatObject::Quartic { .. } => "quartic",
        FlatObject::Bezier { .. } => "bezier",
        FlatObject::Polyhedron { .. } => "polyhedron",
        FlatObject::Csg { .. } => "csg",
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
        FlatObject::Polygon { loops, .. } => {
            let corners: Vec<Vec<DVec3>> = loops
                .iter()
                .map(|l| l.iter().copied().map(DVec3::from).collect())
                .collect();
            let rim = &corners[0];
            let normal: DVec3 = (1..rim.len() - 1)
                .map(|i| (rim[i] - rim[0]).cross(rim[i + 1] - rim[0]))
                .sum();
            let t = ahead(plane((o, d), rim[0], normal))?;
            let p = o + t * d;
            let drop = (0..3).max_by(|i, j| normal[*i].abs().total_cmp(&normal[*j].abs()));
            let axes = [0, 1, 2].map(|i| (drop.unwrap_or(0) + i) % 3);
            let flat = |p: DVec3| (p[axes[1]], p[axes[2]]);
            let (x, y) = flat(p);
            let crossed = corners.iter().flat_map(|l| {
                let next = l.iter().cycle().skip(1);
                l.iter().zip(next).filter(|(a, b)| {
                    let ((ax, ay), (bx, by)) = (flat(**a), flat(**b));
                    (ay > y) != (by > y) && x < ax + (y - ay) / (by - ay) * (bx - ax)
                })
            });
            (crossed.count() % 2 == 1).then_some(t)
        }
        FlatObject::Bezier { points, .. } => on_patch(points, (o, d)).and_then(ahead),
        solid => crossings(solid, (o, d)).into_iter().find_map(ahead),
    }
}

/// Where a line crosses the surface of a solid, by what a point is inside of: sought by small steps, and then by halving.
fn crossings(object: &FlatObject, (o, d): Line) -> Vec<f64> {
    const STEP: f64 = 1e-3;
    let inside = |t: f64| is_inside(object, o + t * d);
    let cut = |mut before: f64, mut after: f64| {
        let start = inside(before);
        for _ in 0..60 {
            let middle = f64::midpoint(before, after);
            if inside(middle) == start {
                before = middle;
            } else {
                after = middle;
            }
        }
        after
    };
    let mut cuts = Vec::new();
    for i in 2_000..12_000 {
        let (from, to) = (f64::from(i) * STEP, f64::from(i + 1) * STEP);
        if inside(from) != inside(to) {
            cuts.push(cut(from, to));
        }
    }
    if let FlatObject::Quadric {
        open: true,
        min,
        max,
        to_world,
        ..
    } = object
    {
        // What lies on a face of the box is not there.
        cuts.retain(|t| {
            let p = to_own_space((o + *t * d, DVec3::ZERO), to_world.as_ref()).0;
            let gap = (p - DVec3::from(*min)).min(DVec3::from(*max) - p);
            gap.min_element() > 1e-9
        });
    }
    cuts
}

/// Where a line meets a patch, by Newton's method from nine places; the nearest.
fn on_patch(points: &[Vec<[f64; 3]>], (o, d): Line) -> Option<f64> {
    let (x, y) = d.normalize().any_orthonormal_pair();
    let seen = |p: &[f64; 3]| {
        let from = DVec3::from(*p) - o;
        [from.dot(x), from.dot(y)]
    };
    // All on one side: missed.
    for axis in [0, 1] {
        let all = || points.iter().flatten().map(|p| seen(p)[axis]);
        if all().all(|c| c > 0.0) || all().all(|c| c < 0.0) {
            return None;
        }
    }
    let at = |u: f64, v: f64| {
        curve(
            &points
                .iter()
                .map(|row| casteljau(row, u))
                .collect::<Vec<_>>(),
            v,
        )
    };
    let solved = |start: [f64; 2]| {
        let [mut u, mut v] = start;
        for _ in 0..30 {
            let h = 1e-6;
            let place = |u: f64, v: f64| {
                let from = at(u, v) - o;
                [from.dot(x), from.dot(y)]
            };
            let (f, fu, fv) = (place(u, v), place(u + h, v), place(u, v + h));
            let [a, b, c, e] =
                [fu[0] - f[0], fv[0] - f[0], fu[1] - f[1], fv[1] - f[1]].map(|x| x / h);
            let det = a * e - b * c;
            u -= (f[0] * e - f[1] * b) / det;
            v -= (f[1] * a - f[0] * c) / det;
        }
        let inside = |x: f64| (-1e-12..1.0 + 1e-12).contains(&x);
        let from = at(u, v) - o;
        let is_met = from.dot(x).hypot(from.dot(y)) < 1e-12;
        (is_met && inside(u) && inside(v)).then(|| from.dot(d) / d.dot(d))
    };
    let starts = [0.2, 0.5, 0.8].map(|u| [0.2, 0.5, 0.8].map(|v| [u, v]));
    let found = starts.into_iter().flatten().filter_map(solved);
    found.min_by(f64::total_cmp)
}

fn casteljau(row: &[[f64; 3]], x: f64) -> DVec3 {
    curve(&row.iter().copied().map(DVec3::from).collect::<Vec<_>>(), x)
}

fn curve(points: &[DVec3], x: f64) -> DVec3 {
    let mut points = points.to_vec();
    while points.len() > 1 {
        points = points
            .windows(2)
            .map(|pair| pair[0].lerp(pair[1], x))
            .collect();
    }
    points[0]
}

fn is_inside(object: &FlatObject, p: DVec3) -> bool {
    let own = |to_world: &Option<[f64; 12]>| to_own_space((p, DVec3::ZERO), to_world.as_ref()).0;
    let in_box = |p: DVec3, min: [f64; 3], max: [f64; 3]| {
        p.cmpgt(min.into()).all() && p.cmplt(max.into()).all()
    };
    match object {
        FlatObject::Sphere {
            center,
            radius,
            to_world,
            ..
        } => (own(to_world) - DVec3::from(*center)).length() < *radius,
        FlatObject::Box {
            min, max, to_world, ..
        } => in_box(own(to_world), *min, *max),
        FlatObject::Plane { point, normal, .. } => {
            (p - DVec3::from(*point)).dot((*normal).into()) < 0.0
        }
        FlatObject::Quadric {
            coefficients,
            min,
            max,
            to_world,
            ..
        } => {
            let p = own(to_world);
            let [x, y, z] = p.to_array();
            let terms = [x * x, y * y, z * z, x * y, x * z, y * z, x, y, z, 1.0];
            let value: f64 = terms.iter().zip(coefficients).map(|(t, c)| t * c).sum();
            value < 0.0 && in_box(p, *min, *max)
        }
        FlatObject::Torus {
            major,
            minor,
            to_world,
            ..
        } => {
            let p = own(to_world);
            let from_ring = p.x.hypot(p.z) - major;
            from_ring.hypot(p.y) < *minor
        }
        FlatObject::Csg { op, parts, .. } => {
            let mut inside = parts.iter().map(|part| is_inside(part, p));
            match op.as_str() {
                "union" => inside.any(|i| i),
                "intersection" => inside.all(|i| i),
                _ => inside.next() == Some(true) && !inside.any(|i| i),
            }
        }
        other => panic!("{} is not asked for", kind(other)),
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
