//! Materials in a scene file.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::math::Rgb;

/// How a surface answers light: coefficients per channel, usually 0 to 1.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MaterialFile {
    /// What it is there for.
    pub note: Option<String>,
    /// The share of the ambient light that comes back; without it the same as `diffuse`.
    pub ambient: Option<Rgb>,
    /// Lambert's share of a light.
    #[serde(default)]
    pub diffuse: Rgb,
    /// The strength of highlights.
    #[serde(default)]
    pub specular: Rgb,
    /// The exponent of highlights: the larger, the smaller and sharper they are; with 0 they have no edge but that between the
    /// side that the mirrored light reaches and the other.
    #[serde(default = "MaterialFile::shininess")]
    pub shininess: f64,
    /// The factor of the reflected ray, at most 1.
    #[serde(default)]
    pub mirror: Rgb,
    /// The factor of the transmitted ray, at most 1.
    #[serde(default)]
    pub transmission: Rgb,
    /// The index of refraction of what is inside: water 1.33, glass 1.5.
    #[serde(default = "MaterialFile::ior")]
    pub ior: f64,
    /// Where transparent objects overlap, as water does with the glass that holds it, the inside is that of the highest
    /// priority; of equal ones, that of the smaller object, else of the later in the file.
    #[serde(default)]
    pub priority: i32,
    /// Radiance that the surface sends out by itself.
    #[serde(default)]
    pub emission: Rgb,
    /// Other colours in the squares of a chessboard.
    pub checker: Option<CheckerFile>,
}

/// A chessboard over the surface coordinates u and v.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CheckerFile {
    /// What it is there for.
    pub note: Option<String>,
    /// The diffuse colour of the other squares.
    pub diffuse: Rgb,
    /// The ambient colour of the other squares; without it the same as `diffuse`.
    pub ambient: Option<Rgb>,
    /// The edge of a square in units of u and v: metres on a plane.
    pub size: f64,
}

impl MaterialFile {
    fn shininess() -> f64 {
        32.0
    }

    fn ior() -> f64 {
        1.0
    }
}

impl Default for MaterialFile {
    fn default() -> Self {
        Self {
            note: None,
            ambient: None,
            diffuse: Rgb::BLACK,
            specular: Rgb::BLACK,
            shininess: Self::shininess(),
            mirror: Rgb::BLACK,
            transmission: Rgb::BLACK,
            ior: Self::ior(),
            priority: 0,
            emission: Rgb::BLACK,
            checker: None,
        }
    }
}
