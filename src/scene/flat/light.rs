//! Lights of a flat scene.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::math::Rgb;
use crate::scene::file::Triple;

/// A light.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum FlatLight {
    /// Shines from one point in all directions.
    Point {
        /// Its name.
        name: String,
        /// Where it is.
        position: Triple,
        /// Its strength.
        intensity: Rgb,
        /// a, b, c: at distance r it is weakened by 1 / (a + b r + c r^2).
        attenuation: [f64; 3],
    },
    /// Shines along one direction everywhere.
    Directional {
        /// Its name.
        name: String,
        /// Where the light goes (unit): L is the opposite.
        direction: Triple,
        /// Its strength.
        intensity: Rgb,
    },
    /// Shines from one point into a cone.
    Spot {
        /// Its name.
        name: String,
        /// Where it is.
        position: Triple,
        /// The axis of the cone (unit).
        direction: Triple,
        /// Its strength on the axis.
        intensity: Rgb,
        /// a, b, c: at distance r it is weakened by 1 / (a + b r + c r^2).
        attenuation: [f64; 3],
        /// The cosine of the angle between the axis and the edge of the cone.
        cos_cutoff: f64,
        /// The light falls off from the axis as the cosine to this power.
        exponent: f64,
    },
    /// Shines from the whole surface of an object, with the `emission` of its material.
    Area {
        /// Its name.
        name: String,
        /// The object that shines.
        object: String,
    },
}
