//! Bodies in the flat form: each in its own space, with the way from there to the world.

use super::FlatObject;
use crate::geometry::{Aabb, Body, Quadric};
use crate::math::{DVec3, Transform};

/// A body of one name and material; of a csg the box around it, since its parts have names of their own: see `of_scene/csg.rs`.
pub fn of_body(
    body: &Body,
    name: String,
    material: String,
    to_world: Option<&Transform>,
) -> FlatObject {
    let to_world = to_world.map(rows);
    let (form, bounds, open) = match body {
        Body::Torus(torus) => {
            return FlatObject::Torus {
                name,
                major: torus.major,
                minor: torus.minor,
                to_world,
                material,
            };
        }
        Body::Quartic(quartic) => {
            return FlatObject::Quartic {
                name,
                coefficients: quartic.coefficients.to_vec(),
                min: quartic.bounds.min.to_array(),
                max: quartic.bounds.max.to_array(),
                to_world,
                material,
            };
        }
        Body::Csg(csg) => {
            let Aabb { min, max } = csg.bounds();
            return FlatObject::Box {
                name,
                min: min.to_array(),
                max: max.to_array(),
                to_world,
                material,
            };
        }
        Body::Quadric(quadric) => (quadric.form(), around(quadric), !quadric.is_solid()),
        Body::BoxedQuadric(quadric) => (quadric.form(), quadric.closed_by(), false),
    };
    FlatObject::Quadric {
        name,
        coefficients: form.0,
        min: bounds.min.to_array(),
        max: bounds.max.to_array(),
        open,
        to_world,
        material,
    }
}

/// A box that closes a quadric at its ends and is around it everywhere else.
fn around(quadric: &Quadric) -> Aabb {
    let bounds = quadric.bounds();
    let (wide, h) = (2.0 * bounds.max.x, quadric.half_height());
    let max = DVec3::new(wide, h, wide);
    Aabb { min: -max, max }
}

/// The three rows of a transform: each coordinate in the world as factors of x, y and z, and a number that is added.
pub fn rows(transform: &Transform) -> [f64; 12] {
    let map = transform.to_world();
    let [x, y, z] = map.matrix3.transpose().to_cols_array_2d();
    let [a, b, c] = map.translation.to_array();
    [
        x[0], x[1], x[2], a, y[0], y[1], y[2], b, z[0], z[1], z[2], c,
    ]
}
