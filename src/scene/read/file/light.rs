//! Lights in a scene file.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Triple;
use crate::math::Rgb;

/// A light.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum LightFile {
    /// Shines from one point in all directions.
    Point(PointFile),
    /// Shines along one direction everywhere, like the sun.
    Directional(DirectionalFile),
    /// Shines from one point into a cone.
    Spot(SpotFile),
    /// Shines from the whole surface of an object: its shadows are soft.
    Area(AreaFile),
}

impl LightFile {
    /// Its kind, as the file writes it, and its name.
    pub fn kind_and_name(&self) -> (&'static str, &str) {
        match self {
            Self::Point(light) => ("point", &light.name),
            Self::Directional(light) => ("directional", &light.name),
            Self::Spot(light) => ("spot", &light.name),
            Self::Area(light) => ("area", &light.name),
        }
    }
}

/// A point light.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointFile {
    /// Its name.
    pub name: String,
    /// What it is there for.
    pub note: Option<String>,
    /// Where it is.
    pub position: Triple,
    /// Its strength, linear.
    pub intensity: Rgb,
    /// a, b, c: at distance r it is weakened by 1 / (a + b r + c r^2).
    #[serde(default = "attenuation")]
    pub attenuation: [f64; 3],
}

/// A directional light.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DirectionalFile {
    /// Its name.
    pub name: String,
    /// What it is there for.
    pub note: Option<String>,
    /// Where the light goes; any length but 0.
    pub direction: Triple,
    /// Its strength, linear.
    pub intensity: Rgb,
}

/// A spot light.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SpotFile {
    /// Its name.
    pub name: String,
    /// What it is there for.
    pub note: Option<String>,
    /// Where it is.
    pub position: Triple,
    /// A point on the axis of the cone.
    pub look_at: Triple,
    /// Its strength on the axis, linear.
    pub intensity: Rgb,
    /// a, b, c: at distance r it is weakened by 1 / (a + b r + c r^2).
    #[serde(default = "attenuation")]
    pub attenuation: [f64; 3],
    /// The angle between the axis and the edge of the cone, in degrees.
    pub cone_angle: f64,
    /// The light falls off from the axis as the cosine to this power.
    #[serde(default = "exponent")]
    pub exponent: f64,
}

/// An area light. It sends out the `emission` of the object's material, from both sides.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AreaFile {
    /// Its name.
    pub name: String,
    /// What it is there for.
    pub note: Option<String>,
    /// The name of the object that shines: a sphere, a disc, a triangle, a quad, a box along the axes or a mesh.
    pub object: String,
}

fn attenuation() -> [f64; 3] {
    [1.0, 0.0, 0.0]
}

fn exponent() -> f64 {
    1.0
}
