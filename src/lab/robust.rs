//! The knobs of arithmetic: what each robust choice costs, and what goes wrong without it.
//!
//! Whole pictures would not tell: raytree's own tests are made for eight triangles at once and for bundles of rays, the
//! others are not. So all positions of these knobs test shape after shape, ours as well, and differ in the arithmetic alone.

use super::knobs::{Knob, Step, plain};
use crate::geometry::{Arithmetic, Naive, Offset, Precision, Quadratic, Shape, TriangleTest};
use crate::scene::{Scene, Settings};

/// Shapes up to which there is room for a copy of the scene for every position.
const MANY_SHAPES: usize = 200_000;

/// Offsets that are tried, in metres.
const FIXED: [f64; 3] = [1e-9, 1e-4, 1e-2];

/// The choices that shapes give rise to; `leaves` tells whether rays leave surfaces at all. The reference is the robust
/// choice, with everything else as `base` asks.
pub fn knobs(shapes: &[Shape], base: &Settings, leaves: bool) -> Vec<Knob> {
    if shapes.is_empty() || shapes.len() > MANY_SHAPES {
        return Vec::new();
    }
    let any = |is: fn(&Shape) -> bool| shapes.iter().any(|shape| is(inner(shape)));
    let ours = Arithmetic::default();
    let mut knobs = Vec::new();
    if any(|shape| matches!(shape, Shape::Triangle(_))) {
        let with = |arithmetic: &mut Arithmetic, test| arithmetic.triangle = test;
        let name = |test: &TriangleTest| test.name().to_owned();
        knobs.push(knob(
            "triangle",
            TriangleTest::ALL,
            ours.triangle,
            name,
            with,
            base,
        ));
    }
    if leaves {
        let with = |arithmetic: &mut Arithmetic, offset| arithmetic.offset = offset;
        let fixed = FIXED.map(Offset::Fixed).into_iter();
        let all = std::iter::once(Offset::None)
            .chain(fixed)
            .chain([ours.offset]);
        knobs.push(knob(
            "offset",
            all,
            ours.offset,
            Offset::to_string,
            with,
            base,
        ));
    }
    if any(|shape| matches!(shape, Shape::Sphere(_))) {
        let with = |arithmetic: &mut Arithmetic, formula| arithmetic.quadratic = formula;
        let name = |formula: &Quadratic| formula.name().to_owned();
        knobs.push(knob(
            "quadratic",
            Quadratic::ALL,
            ours.quadratic,
            name,
            with,
            base,
        ));
    }
    let with = |arithmetic: &mut Arithmetic, bits| arithmetic.precision = bits;
    let name = |bits: &Precision| bits.name().to_owned();
    knobs.push(knob(
        "precision",
        Precision::ALL,
        ours.precision,
        name,
        with,
        base,
    ));
    knobs
}

/// A shape before it was turned or stretched.
fn inner(shape: &Shape) -> &Shape {
    match shape.plain() {
        Shape::Placed(placed) => &placed.shape,
        plain => plain,
    }
}

/// A choice of arithmetic, the robust one last.
fn knob<T>(
    group: &'static str,
    choices: impl IntoIterator<Item = T>,
    robust: T,
    name: impl Fn(&T) -> String,
    choose: impl Fn(&mut Arithmetic, T),
    base: &Settings,
) -> Knob {
    let with = |choice| {
        let mut settings = *base;
        choose(&mut settings.arithmetic, choice);
        settings
    };
    let knob = plain(group, choices, name, with);
    let one_by_one = |step| Step {
        one_by_one: true,
        ..step
    };
    Knob {
        steps: knob.steps.into_iter().map(one_by_one).collect(),
        reference: Some(with(robust)),
        ..knob
    }
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
