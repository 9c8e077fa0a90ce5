//! Parameters of arithmetic: what each robust choice costs, and what goes wrong without it.
//!
//! Whole pictures would not tell: raytree's own tests are made for eight triangles at once and for bundles of rays, the
//! others are not. So all steps of these test shape after shape, ours as well, and differ in the arithmetic alone.

use super::parameter::{Parameter, swept};
use crate::geometry::{Arithmetic, Body, Naive, PatchMethod, Shape};
use crate::scene::settings::knobs::knob;
use crate::scene::{Scene, Settings};

/// Shapes up to which there is room for a copy of the scene for every step.
const MANY_SHAPES: usize = 200_000;

/// Choices that shapes give rise to; `leaves` tells whether rays leave surfaces at all.
pub fn parameters(shapes: &[Shape], base: &Settings, leaves: bool) -> Vec<Parameter> {
    if shapes.is_empty() || shapes.len() > MANY_SHAPES {
        return Vec::new();
    }
    let any = |is: fn(&Shape) -> bool| shapes.iter().any(|shape| is(inner(shape)));
    let choices = [
        ("triangle", any(|shape| shape.triangle_count() > 0)),
        ("offset", leaves),
        ("quadratic", any(is_of_second_degree)),
        ("quartic", any(is_of_fourth_degree)),
        ("precision", true),
    ];
    let used = choices.into_iter().filter(|(_, used)| *used);
    let mut parameters: Vec<_> = used.map(|(flag, _)| parameter(flag, base)).collect();
    if any(|shape| matches!(shape, Shape::Patch(_))) {
        parameters.push(patches(base));
    }
    parameters
}

/// Patches as they are and as ever more triangles, which are tested as any others, many at a time.
fn patches(base: &Settings) -> Parameter {
    let mut parameter = swept("patch test", "patch-test", base);
    parameter.reference = Some(base.with(|s| s.arithmetic.patch = PatchMethod::Exact));
    parameter
}

fn is_of_second_degree(shape: &Shape) -> bool {
    match shape {
        Shape::Sphere(_) => true,
        Shape::Body(body) => matches!(**body, Body::Quadric(_) | Body::BoxedQuadric(_)),
        _ => false,
    }
}

fn is_of_fourth_degree(shape: &Shape) -> bool {
    matches!(shape, Shape::Body(body) if matches!(**body, Body::Torus(_) | Body::Quartic(_)))
}

/// A shape before it was turned or stretched.
fn inner(shape: &Shape) -> &Shape {
    match shape.plain() {
        Shape::Transformed(transformed) => &transformed.shape,
        plain => plain,
    }
}

/// A choice of arithmetic. The reference is the robust choice, with everything else as `base` asks.
fn parameter(flag: &'static str, base: &Settings) -> Parameter {
    let mut parameter = swept(flag, flag, base);
    for step in &mut parameter.steps {
        step.one_by_one = true;
    }
    parameter.reference = knob(flag).and_then(|knob| {
        let robust = (knob.field.get)(&Settings::default())?;
        Some(base.with(|s| (knob.field.set)(s, &robust)))
    });
    parameter
}

/// The scene with shapes that are all tested one by one with this arithmetic.
pub fn one_by_one(scene: &Scene, arithmetic: Arithmetic) -> Scene {
    let mut scene = scene.clone();
    for shape in &mut scene.shapes {
        let plain = shape.plain().clone();
        *shape = Shape::Naive(Box::new(Naive {
            shape: plain,
            arithmetic,
        }));
    }
    scene
}
