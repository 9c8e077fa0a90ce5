//! Bodies in a scene file: solids with parts.

use super::fields::Fields;
use crate::geometry::{Body, Quadric, QuadricKind, Sheets};

/// The kind and the fields of a body in its own space; `None` for a csg, whose parts have names: see `csg.rs`.
pub fn body(body: &Body, fields: Fields) -> Option<(&'static str, Fields)> {
    let kind = body.kind();
    Some(match body {
        Body::Quadric(quadric) => (kind, of_quadric(quadric, fields)),
        Body::BoxedQuadric(quadric) => {
            let bounds = quadric.closed_by();
            let fields = fields
                .row("coefficients", &quadric.form().0)
                .row("min", &bounds.min.to_array());
            (kind, fields.row("max", &bounds.max.to_array()))
        }
        Body::Torus(torus) => {
            let fields = fields.row("center", &[0.0; 3]).number("major", torus.major);
            (kind, fields.number("minor", torus.minor))
        }
        Body::Quartic(quartic) => {
            let fields = fields
                .row("coefficients", &quartic.coefficients)
                .row("min", &quartic.bounds.min.to_array());
            (kind, fields.row("max", &quartic.bounds.max.to_array()))
        }
        Body::Csg(_) => return None,
    })
}

fn of_quadric(quadric: &Quadric, fields: Fields) -> Fields {
    let h = quadric.half_height();
    let low = match quadric.given() {
        QuadricKind::Paraboloid { .. } => "vertex",
        _ => "base",
    };
    let fields = fields.row(low, &[0.0, -h, 0.0]).row("top", &[0.0, h, 0.0]);
    let fields = match quadric.given() {
        QuadricKind::Cylinder { radius } | QuadricKind::Paraboloid { radius } => {
            fields.number("radius", radius)
        }
        QuadricKind::Cone { radius, top_radius } => fields
            .number("radius", radius)
            .number("top_radius", top_radius),
        QuadricKind::Hyperboloid {
            waist,
            radius,
            sheets,
        } => fields
            .number("waist", waist)
            .number("radius", radius)
            .raw("sheets", if sheets == Sheets::One { "1" } else { "2" }),
    };
    if quadric.is_solid() {
        fields
    } else {
        fields.raw("open", "true")
    }
}
