//! A scene for programs of others, format `raytree-flat/1`: no groups, transforms, quads and model files, everything in world
//! space, every default written out.
//!
//! The types are the format: they are written and read by serde, and the JSON Schema is generated from them. What a scene is
//! made of is in `of_scene.rs`, how it is written in `write.rs` (JSON, one object a line) and `text.rs` (lines of words).

mod body;
mod light;
mod object;
mod of_scene;
mod text;
mod write;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::math::Rgb;
use crate::scene::file::Triple;
use crate::shading::Fresnel;

pub use light::FlatLight;
pub use object::FlatObject;
pub use of_scene::{head, objects, shining};
pub use text::{check_text, write_text};
pub use write::{line, write_json};

/// The version of the format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum FlatFormat {
    /// Where no field is renamed and none loses its meaning; fields may be added.
    #[serde(rename = "raytree-flat/1")]
    V1,
}

/// A scene in world space: lengths in metres, colours linear.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(title = "raytree-flat/1")]
pub struct FlatScene {
    /// Always `raytree-flat/1`.
    pub format: FlatFormat,
    /// The name of the scene.
    pub name: String,
    /// What recursion and colours depend on beside the scene.
    pub settings: FlatSettings,
    /// Radiance of a ray that hits nothing.
    pub background: Rgb,
    /// Ia: light that reaches every surface from everywhere.
    pub ambient: Rgb,
    /// The eye.
    pub camera: FlatCamera,
    /// Materials.
    pub materials: Vec<FlatMaterial>,
    /// Lights, in the order in which a hit asks them.
    pub lights: Vec<FlatLight>,
    /// What there is to see.
    pub objects: Vec<FlatObject>,
}

/// The settings that the scene asks for.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FlatSettings {
    /// How many times a ray may bounce: 0 stops at what the eye sees directly.
    pub depth: u32,
    /// R and T rays that could add less than this to the pixel (the largest channel of the product of the weights from the eye)
    /// are not sent.
    pub min_weight: f64,
    /// The model of reflectance.
    pub fresnel: Fresnel,
    /// Factor on the picture before it is clamped.
    pub exposure: f64,
}

/// A pinhole camera. The eye ray through the middle of pixel (x, y) of a picture of W x H pixels, (0, 0) at the top left, starts
/// at `eye` and goes along
///
/// d = unit((2 (x + 0.5) / W - 1) half_height (W / H) u + (1 - 2 (y + 0.5) / H) half_height v - w)
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FlatCamera {
    /// Where all eye rays start.
    pub eye: Triple,
    /// To the right of the picture (unit).
    pub u: Triple,
    /// Upwards in the picture (unit).
    pub v: Triple,
    /// From the scene to the eye (unit): the view direction is -w.
    pub w: Triple,
    /// tan(vertical_fov / 2): half the height of the film at distance 1.
    pub half_height: f64,
    /// The angle between the lower and the upper edge of the picture, in degrees.
    pub vertical_fov: f64,
}

/// A material, with the names of scene files.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FlatMaterial {
    /// Its name.
    pub name: String,
    /// Ka: the share of the ambient light that comes back.
    pub ambient: Rgb,
    /// Kd: Lambert's share of a light.
    pub diffuse: Rgb,
    /// Ks: the strength of highlights.
    pub specular: Rgb,
    /// The exponent of highlights.
    pub shininess: f64,
    /// Kr: the factor of the reflected ray.
    pub mirror: Rgb,
    /// Kt: the factor of the transmitted ray.
    pub transmission: Rgb,
    /// The index of refraction of what is inside.
    pub ior: f64,
    /// Where transparent objects overlap, the inside is that of the highest priority.
    pub priority: i32,
    /// Le: radiance that the surface sends out by itself.
    pub emission: Rgb,
    /// Other colours in the squares of a chessboard, if there is one: where floor(u / size) + floor(v / size) is odd.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub checker: Option<FlatChecker>,
}

/// A chessboard over the surface coordinates u and v.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FlatChecker {
    /// Kd of the other squares.
    pub diffuse: Rgb,
    /// Ka of the other squares.
    pub ambient: Rgb,
    /// The edge of a square in units of u and v.
    pub size: f64,
}

/// The JSON Schema of the format, as it is written.
pub fn schema() -> serde_json::Value {
    schemars::generate::SchemaSettings::default()
        .for_serialize()
        .into_generator()
        .into_root_schema_for::<FlatScene>()
        .to_value()
}
