//! Object in a scene file: one shape, or a mesh.

use super::fields::{Fields, rows};
use super::mesh::mesh;
use crate::geometry::Shape;
use crate::math::Transform;
use crate::scene::Scene;

/// An object, or why it cannot be written.
pub fn object(scene: &Scene, number: u32) -> Result<String, String> {
    let object = &scene.objects[number as usize];
    let material = &scene.materials[object.material as usize];
    let fields = Fields::default()
        .text("name", &object.name)
        .text("material", &material.name);
    let written = match scene.shapes_of(number) {
        [shape] => solid(shape, fields.clone()).map(|(kind, fields)| fields.kind(kind)),
        _ => None,
    };
    written
        .or_else(|| mesh(object, scene.shapes_of(number), fields))
        .ok_or_else(|| {
            let name = &object.name;
            format!("object `{name}` is neither one shape nor triangles")
        })
}

/// The kind and the fields of a shape that is no triangle.
fn solid(shape: &Shape, fields: Fields) -> Option<(&'static str, Fields)> {
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
        Shape::Triangle(_) => return None,
    })
}

/// The steps of a transform: one, of any affine map.
fn matrix(transform: &Transform) -> String {
    let map = transform.to_world();
    let [x, y, z] = map.matrix3.transpose().to_cols_array_2d();
    let row = |r: [f64; 3], moved: f64| [r[0], r[1], r[2], moved];
    let moved = map.translation;
    let all = [row(x, moved.x), row(y, moved.y), row(z, moved.z)];
    format!("[{{\"matrix\": {}}}]", rows(&all))
}
