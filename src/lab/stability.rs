//! Hard cases, measured: what common arithmetic makes of them, and what ours does.
//!
//! Each case is data and a function that counts how often an arithmetic is wrong. What is right is known on paper, from `expansion`,
//! which is exact, or from the tracer's own ray; nothing is quoted. The cases are the same in every run. A picture of a case is
//! traced with the same functions.

mod coplanar;
mod expansion;
mod meshes;
mod optics;
mod patches;
mod perspective;
mod picture;
mod pinhole;
mod polygons;
mod solids;
mod spheres;
mod surfaces;
pub mod table;

pub use picture::{Panel, Picture};

use std::fmt;

use crate::geometry::{Arithmetic, Naive, Shape};
use crate::math::DVec3;
use crate::sampling::stream::{splitmix64, to_unit_f64};

/// A hard case.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// The name that users write.
    pub name: &'static str,
    /// What is hard about it, in a line.
    pub hard: &'static str,
    /// Where it is known from.
    pub source: &'static str,
    /// Measures it.
    pub measure: fn() -> Vec<Outcome>,
    /// What it looks like.
    pub picture: Picture,
}

/// How one arithmetic did on a case.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// The arithmetic, as its flags say it.
    pub arithmetic: String,
    /// True for that of raytree.
    pub ours: bool,
    /// What was counted or measured.
    pub found: f64,
    /// What `found` may be at most.
    pub allowed: f64,
    /// In what it is measured: `% of rays that slip through`.
    pub unit: &'static str,
}

impl Outcome {
    /// True if it is as it should be.
    pub fn is_right(&self) -> bool {
        self.found <= self.allowed
    }
}

/// All cases.
pub const CASES: [Case; 13] = [
    surfaces::SELF_HITS,
    surfaces::PLATE_GAP,
    meshes::SHARED_EDGES,
    meshes::SHARED_CORNERS,
    polygons::T_JUNCTIONS,
    coplanar::COPLANAR_TWINS,
    spheres::FAR_SPHERE,
    spheres::NEAR_SPHERE,
    solids::FAR_CYLINDER,
    solids::FAR_TORUS,
    patches::PATCH_OUTLINE,
    perspective::ROW_WEIGHTS,
    optics::CRITICAL_ANGLE,
];

/// Numbers in [0, 1), the same in every run.
struct Chance(u64);

impl Chance {
    fn next(&mut self) -> f64 {
        self.0 = splitmix64(self.0);
        to_unit_f64(self.0)
    }

    /// A point of the cube [-1, 1]^3.
    fn point(&mut self) -> DVec3 {
        let mut next = || 2.0 * self.next() - 1.0;
        DVec3::new(next(), next(), next())
    }
}

/// A shape as an arithmetic tests it.
fn under(arithmetic: Arithmetic, shape: Shape) -> Shape {
    if arithmetic == Arithmetic::default() {
        return shape;
    }
    Shape::Naive(Box::new(Naive { shape, arithmetic }))
}

/// The name of an arithmetic: `ours`, or the flag that asks for it.
fn told(ours: bool, flag: &str, value: impl fmt::Display) -> String {
    if ours {
        "ours".to_owned()
    } else {
        format!("--{flag} {value}")
    }
}

/// So many of so many, in per cent.
fn percent(wrong: usize, all: usize) -> f64 {
    100.0 * wrong as f64 / all.max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ours_is_right_and_something_common_is_wrong_in_every_case() {
        for case in CASES {
            let outcomes = (case.measure)();
            let (ours, others): (Vec<_>, Vec<_>) = outcomes.iter().partition(|o| o.ours);
            assert!(!ours.is_empty(), "{}", case.name);
            assert!(ours.iter().all(|o| o.is_right()), "{}: {ours:?}", case.name);
            assert!(
                others.iter().any(|o| !o.is_right()),
                "{}: {others:?}",
                case.name
            );
        }
    }
}
