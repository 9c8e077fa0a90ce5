//! Transparent bodies that are inside out, of mixed winding, or open: what is inside of them cannot be told.

use super::Checked;
use crate::geometry::Shape;
use crate::math::{DVec3, Interval, Ray};
use crate::scene::AIR_IOR;
use crate::scene::warning::{WarningCode, Warnings};
use crate::world::closed::{Closing, closing};
use crate::world::shells::shells;

/// Warns about transparent bodies that refract and have no inside. Without refraction (`ior` 1) that changes nothing.
pub fn check(checked: &Checked, warnings: &mut Warnings) {
    let scene = &checked.world.scene;
    for (index, object) in (0u32..).zip(&scene.objects) {
        let material = &scene.materials[object.material as usize];
        if material.is_transmissive() && material.ior != AIR_IOR {
            let about = |what: &str| {
                format!(
                    "object `{}` is transparent (index {}) {what}",
                    object.name, material.ior
                )
            };
            let found = body(checked, index);
            if let Some((code, what, cure)) = found {
                warnings.add(code, checked.path.error(about(&what), cure));
            }
        }
    }
}

/// What is wrong with the body of an object: the kind, how it is told, and the cure.
fn body(checked: &Checked, object: u32) -> Option<(WarningCode, String, &'static str)> {
    let shapes = checked.world.scene.shapes_of(object);
    match closing(shapes) {
        Closing::Closed => match inside_out(checked, object) {
            (0, _) => None,
            (turned, all) => Some((
                WarningCode::InsideOut,
                format!(
                    "and inside out: {turned} of its {all} closed parts has a negative volume, so that all around counts as inside"
                ),
                "turn its faces: corners run counter-clockwise, seen from outside (in most programs: \"flip normals\")",
            )),
        },
        Closing::Mixed(edges) => Some((
            WarningCode::MixedWinding,
            format!(
                "and its faces run both ways: at {edges} edges front and back meet, so light that goes in may never come out"
            ),
            "turn all faces alike: corners run counter-clockwise, seen from outside (\"recalculate normals\")",
        )),
        Closing::Open(_) if is_flat(shapes) => ends_nowhere(checked, shapes).then(|| {
            (
                WarningCode::OpenBody,
                "and flat: what is behind it counts as its inside, and has no end".to_owned(),
                "use a box for a pane; a sheet that does not refract has \"ior\": 1",
            )
        }),
        Closing::Open(edges) => Some((
            WarningCode::OpenBody,
            format!(
                "and open: {edges} edges have a face on one side only, so light that goes in may never come out"
            ),
            "close it; a sheet that does not refract has \"ior\": 1",
        )),
    }
}

/// Of a closed object's parts that hang together by their corners: how many are wound inwards without being a hole in
/// another one, and how many there are.
fn inside_out(checked: &Checked, object: u32) -> (usize, usize) {
    let world = checked.world;
    let shells = shells(world.scene.shapes_of(object));
    let turned = shells.iter().filter(|shell| {
        // Too flat to have a volume that rounding leaves a sign.
        let least = 1e-12 * shell.bounds.size().length().powi(3);
        if shell.volume >= -least {
            return false;
        }
        // From its foremost corner on there is nothing of it. A hole is inside of what it is a hole in.
        let away = 1e-6 * shell.bounds.size().length() + 1e-12 * shell.foremost.length();
        let ray = Ray::new(shell.foremost + away * DVec3::X, DVec3::X);
        let crossings = world.crossings(&ray, Interval::FORWARD);
        let own = crossings.iter().filter(|c| c.object == object);
        let depth: i32 = own
            .map(|c| match c.enters {
                Some(true) => -1,
                Some(false) => 1,
                None => 0,
            })
            .sum();
        depth <= 0
    });
    (turned.count(), shells.len())
}

/// True if all shapes lie in one plane.
fn is_flat(shapes: &[Shape]) -> bool {
    let plane = |shape: &Shape| match shape.plain() {
        Shape::Triangle(triangle) => Some((triangle.corners[0], triangle.normal()?)),
        Shape::Plane(plane) => Some((plane.origin(), plane.normal())),
        Shape::Disc(disc) => Some((disc.center, disc.frame.w)),
        Shape::Polygon(polygon) => Some((polygon.center(), polygon.normal())),
        _ => None,
    };
    let Some((origin, normal)) = shapes.first().and_then(plane) else {
        return false;
    };
    shapes.iter().all(|shape| {
        plane(shape).is_some_and(|(point, n)| {
            let (way, size) = (point - origin, (point - origin).length());
            n.dot(normal) > 1.0 - 1e-9 && way.dot(normal).abs() <= 1e-6 * size
        })
    })
}

/// True if a straight line through a flat surface to its back meets nothing opaque: a pool has a floor, a lone pane has
/// none.
fn ends_nowhere(checked: &Checked, shapes: &[Shape]) -> bool {
    let world = checked.world;
    let through = shapes.first().and_then(|shape| match shape.plain() {
        Shape::Triangle(t) => Some((t.corners.iter().sum::<DVec3>() / 3.0, t.normal()?)),
        Shape::Plane(plane) => Some((plane.origin(), plane.normal())),
        Shape::Disc(disc) => Some((disc.center, disc.frame.w)),
        Shape::Polygon(polygon) => Some((polygon.center(), polygon.normal())),
        _ => None,
    });
    through.is_some_and(|(point, normal)| {
        let crossings = world.crossings(&Ray::new(point, -normal), Interval::FORWARD);
        let opaque = |object: u32| {
            let object = &world.scene.objects[object as usize];
            !world.scene.materials[object.material as usize].is_transmissive()
        };
        !crossings.iter().any(|crossing| opaque(crossing.object))
    })
}
