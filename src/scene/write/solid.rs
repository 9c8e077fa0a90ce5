//! A single shape in a scene file.

use super::body::body;
use super::fields::{Fields, rows};
use crate::geometry::Shape;
use crate::math::{DVec3, Transform};

/// The kind and the fields of a shape that is no triangle.
pub fn solid(shape: &Shape, fields: Fields) -> Option<(&'static str, Fields)> {
    Some(match shape {
        Shape::Sphere(sphere) => {
            let fields = fields.row("center", &sphere.center.to_array());
            ("sphere", fields.number("radius", sphere.radius))
        }
        Shape::Plane(plane) => {
            let fields = fields.row("point", &plane.origin().to_array());
            ("plane", fields.row("normal", &plane.normal().to_array()))
        }
        Shape::Cuboid(cuboid) => {
            let fields = fields.row("min", &cuboid.bounds.min.to_array());
            ("box", fields.row("max", &cuboid.bounds.max.to_array()))
        }
        Shape::Disc(disc) => {
            let fields = fields
                .row("center", &disc.center.to_array())
                .row("normal", &disc.frame.w.to_array());
            ("disc", fields.number("radius", disc.radius))
        }
        Shape::Transformed(moved) => {
            let (kind, fields) = solid(&moved.shape, fields)?;
            (kind, fields.raw("transform", &matrix(&moved.transform)))
        }
        Shape::Naive(naive) => return solid(&naive.shape, fields),
        Shape::Polygon(polygon) => {
            let loops: Vec<Vec<[f64; 3]>> = polygon
                .loops()
                .map(|corners| corners.iter().map(DVec3::to_array).collect())
                .collect();
            let holes: Vec<String> = loops[1..].iter().map(|hole| rows(hole)).collect();
            let fields = fields.rows("points", &loops[0]);
            let holes = (!holes.is_empty()).then(|| format!("[{}]", holes.join(", ")));
            let fields = match holes {
                Some(holes) => fields.raw("holes", &holes),
                None => fields,
            };
            ("polygon", fields)
        }
        Shape::Body(own) => return body(own, fields),
        Shape::Triangle(_) | Shape::Patch(_) | Shape::Mesh(_) => return None,
    })
}

/// The steps of a transform: one, of any affine map.
pub fn matrix(transform: &Transform) -> String {
    let map = transform.to_world();
    let [x, y, z] = map.matrix3.transpose().to_cols_array_2d();
    let row = |r: [f64; 3], moved: f64| [r[0], r[1], r[2], moved];
    let moved = map.translation;
    let all = [row(x, moved.x), row(y, moved.y), row(z, moved.z)];
    format!("[{{\"matrix\": {}}}]", rows(&all))
}
