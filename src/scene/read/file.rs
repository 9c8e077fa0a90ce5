//! Scene file format `raytree-scene/1`: what stands in the JSON, before names are looked up and shapes transformed.
//!
//! Kinds are told by a key, as in `{"sphere": {"name": ...}}`: then an error inside has an exact path, such as
//! `objects[3].sphere.radius`. Every object may carry a `note`, which says what it is there for and changes nothing.

mod common;
mod expected;
mod light;
mod material;
mod object;
mod other_format;
mod parse;
mod settings;
mod shape;
mod solid;
mod syntax;
mod transform;

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use common::Common;
pub use light::{AreaFile, DirectionalFile, LightFile, PointFile, SpotFile};
pub use material::{CheckerFile, MaterialFile};
pub use object::{
    BezierFile, DiscFile, GroupFile, MeshFile, NurbsFile, ObjFile, ObjectFile, PolygonFile,
    QuadFile, TriangleFile, UseFile,
};
pub use parse::parse;
pub use settings::SettingsFile;
pub use solid::{
    BoxFile, ConeFile, ConvexFile, CsgFile, CsgOpFile, CsgPartFile, CylinderFile, EllipsoidFile,
    HyperboloidFile, ParaboloidFile, PlaneFile, QuadricFile, QuarticFile, SphereFile, TorusFile,
};
pub use transform::{RotateFile, ScaleFile, TransformStep};

use crate::math::Rgb;

/// Three numbers: a point or a vector `[x, y, z]`.
pub type Triple = [f64; 3];

/// A scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SceneFile {
    /// Which format this is: always `raytree-scene/1`.
    pub format: SceneFormat,
    /// The name of the scene; without one it is the name of the file.
    pub name: Option<String>,
    /// What the scene shows.
    pub note: Option<String>,
    /// The eye.
    pub camera: CameraFile,
    /// What a ray brings back that hits nothing, linear.
    #[serde(default)]
    pub background: Rgb,
    /// Light that reaches every surface from everywhere, linear.
    #[serde(default)]
    pub ambient: Rgb,
    /// Materials by name.
    #[serde(default, deserialize_with = "parse::map_without_duplicates")]
    pub materials: BTreeMap<String, Box<MaterialFile>>,
    /// Objects by the name of the part that they are: a part is seen where an object `use`s it, any number of times.
    #[serde(default, deserialize_with = "parse::map_without_duplicates")]
    pub parts: BTreeMap<String, Vec<ObjectFile>>,
    /// Lights.
    #[serde(default)]
    pub lights: Vec<LightFile>,
    /// What there is to see.
    #[serde(default)]
    pub objects: Vec<ObjectFile>,
    /// How it is rendered if the user asks for nothing else.
    #[serde(default)]
    pub settings: SettingsFile,
}

/// The versions of the format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[schemars(rename = "Format")]
pub enum SceneFormat {
    /// The first version.
    #[serde(rename = "raytree-scene/1")]
    V1,
}

/// A pinhole camera.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CameraFile {
    /// What it is there for.
    pub note: Option<String>,
    /// Where the eye is.
    pub eye: Triple,
    /// The point in the middle of the picture.
    pub look_at: Triple,
    /// The direction that is up in the picture.
    #[serde(default = "CameraFile::up")]
    pub up: Triple,
    /// The angle between the lower and the upper edge of the picture, in degrees.
    #[serde(default = "CameraFile::vertical_fov")]
    pub vertical_fov: f64,
    /// tan(vertical_fov / 2), half the height of the film at distance 1: if it is given, it counts in the place of the angle.
    pub half_height: Option<f64>,
}

impl CameraFile {
    fn up() -> Triple {
        [0.0, 1.0, 0.0]
    }

    fn vertical_fov() -> f64 {
        45.0
    }

    /// A camera with the defaults.
    pub fn new(eye: Triple, look_at: Triple) -> Self {
        Self {
            note: None,
            eye,
            look_at,
            up: Self::up(),
            vertical_fov: Self::vertical_fov(),
            half_height: None,
        }
    }
}

/// JSON Schema of scene files, made from the types in this module.
pub fn schema() -> serde_json::Value {
    expected::SCHEMA.clone()
}
