//! Rays that graze a curved patch, tested as it is and as triangles.

use std::f64::consts::FRAC_1_SQRT_2;

use super::picture::{Panel, Picture, Seen, panel};
use super::polygons::t;
use super::{Case, Chance, Outcome, percent, told};
use crate::geometry::{BezierSurface, PatchMethod, Shape};
use crate::math::{DVec3, Ray};
use crate::scene::triangles_of;

pub const PATCH_OUTLINE: Case = Case {
    name: "patch-outline",
    hard: "rays that graze an arch of radius 1, 1e-9 to 1e-3 m inside its outline",
    source: "Kajiya 1982, Ray tracing parametric patches",
    measure: patch_outline,
    picture: Picture {
        shows: "the outline of an arch laid out flat, 3 mm of it",
        wrong: "hit or missed wrongly",
        draw: outline,
    },
};

/// From a point above the arch to where its ray grazes it.
const REACH: f64 = 2.0;
/// Angles from the top of the arch at which rays graze it, at most. The arch ends at 45 degrees.
const WIDEST: f64 = 0.5;

fn methods() -> [(String, bool, PatchMethod); 3] {
    let all = [
        PatchMethod::Triangles(4),
        PatchMethod::Triangles(16),
        PatchMethod::Exact,
    ];
    all.map(|method| {
        let ours = method == PatchMethod::Exact;
        (told(ours, "patch-test", method), ours, method)
    })
}

/// A quarter of the cylinder x^2 + y^2 = 1 with its top at x = 0, 2 m long along z: an arc of a circle is a rational curve of degree 2.
fn arch(method: PatchMethod) -> Vec<Shape> {
    let side = FRAC_1_SQRT_2;
    let row = |z: f64| {
        let arc = [(side, side), (0.0, 2.0 * side), (-side, side)];
        arc.map(|(x, y)| DVec3::new(x, y, z)).to_vec()
    };
    let surface = BezierSurface {
        degree: [2, 1],
        patches: vec![vec![row(-1.0), row(1.0)]],
        weights: Some(vec![vec![vec![1.0, side, 1.0]; 2]]),
        ranges: None,
    };
    let leaves = surface.leaves().unwrap_or_default();
    match method {
        PatchMethod::Exact => {
            let shapes = leaves.into_iter();
            shapes.map(|leaf| Shape::Patch(Box::new(leaf))).collect()
        }
        PatchMethod::Triangles(squares) => triangles_of(&leaves, squares),
    }
}

/// The ray across the arch that passes its axis at distance `height`, at an angle from the top.
fn grazing(angle: f64, height: f64, z: f64) -> Ray {
    let (sin, cos) = libm::sincos(angle);
    let (up, along) = (DVec3::new(sin, cos, 0.0), DVec3::new(cos, -sin, 0.0));
    Ray::new(height * up - REACH * along + z * DVec3::Z, along)
}

fn closest(shapes: &[Shape], ray: &Ray) -> Option<f64> {
    let hits = shapes.iter().filter_map(|shape| t(shape, ray));
    hits.min_by(f64::total_cmp)
}

/// What is right follows from the circle: half of the chord at depth d is sqrt(2 d - d^2).
fn patch_outline() -> Vec<Outcome> {
    const RAYS: usize = 2000;
    let outcome = |(arithmetic, ours, method): (String, bool, PatchMethod)| {
        let shapes = arch(method);
        let mut chance = Chance(41);
        let wrong = (0..RAYS).filter(|_| {
            let depth = libm::exp10(-3.0 - 6.0 * chance.next());
            let angle = WIDEST * (2.0 * chance.next() - 1.0);
            let ray = grazing(angle, 1.0 - depth, 1.6 * chance.next() - 0.8);
            let right = REACH - (2.0 * depth - depth * depth).sqrt();
            closest(&shapes, &ray).is_none_or(|t| (t - right).abs() > 1e-6)
        });
        Outcome {
            arithmetic,
            ours,
            found: percent(wrong.count(), RAYS),
            allowed: 0.0,
            unit: "% of rays miss or are 1e-6 m off",
        }
    };
    methods().map(outcome).to_vec()
}

/// To the right along the outline, upwards away from the arch: from 2 mm inside of the outline to 1 mm outside.
fn outline(size: (u32, u32)) -> Vec<Panel> {
    let of = |(name, ours, method): (String, bool, PatchMethod)| {
        let shapes = arch(method);
        panel((&name, ours), size, |place| {
            let above = 1.5e-3 * place.y - 0.5e-3;
            let ray = grazing(WIDEST * place.x, 1.0 + above, 0.1);
            let hit = closest(&shapes, &ray).is_some();
            Seen {
                brightness: if hit { 0.8 } else { 0.02 },
                wrong: hit != (above < 0.0),
            }
        })
    };
    methods().map(of).to_vec()
}
