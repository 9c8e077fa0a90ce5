//! The ray tree of a pixel as owned data, format `raytree/1`: what graders read, and what every export is made of.
//!
//! The types are the format: they are written and read by serde, and the JSON Schema is generated from them. Ids of the
//! scene are resolved to names, so a document needs neither the scene nor the log that it was made from.

mod make;
mod node;
mod path;
mod settings;
mod step;
mod stream;
mod term;
mod warning;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use make::of;
pub use node::{
    AbsentRay, GroupFrame, HitPoint, LightSummary, MediumBoundary, PassedSurface, PointOfLight,
    RayNode, RayOutcome,
};
pub use path::RayInTree;
pub use settings::{AdaptiveSettings, ArithmeticSettings, DocumentSettings};
pub use step::{TestedPrimitive, TraversalStep, VisitedChildren};
pub use stream::{Foreseen, SampleStream, foresee, stream};
pub use term::{CornerValue, TermFactors, TermValue};
pub use warning::{DocumentWarning, list};

use crate::math::Rgb;

/// The version of the format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum FormatVersion {
    /// Where no field is renamed and none loses its meaning; fields may be added.
    #[serde(rename = "raytree/1")]
    Raytree1,
}

/// A traced pixel with its ray trees.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(title = "raytree/1")]
pub struct Document<S = Vec<SampleTree>> {
    /// Always `raytree/1`.
    pub format: FormatVersion,
    /// The scene.
    pub scene: SceneId,
    /// The picture that the pixel belongs to.
    pub image: ImageSize,
    /// The pixel.
    pub pixel: PixelIndex,
    /// What of the scene is strange; absent if nothing is.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub warnings: Vec<DocumentWarning>,
    /// Every setting that changes the picture.
    pub settings: DocumentSettings,
    /// What `render` puts into this pixel, bit for bit.
    pub color: PixelColor,
    /// Rays that the pixel cost, surfaces that a ray went straight through included.
    pub rays: u64,
    /// Rays that `depth` and `min_weight` left out; absent if there are none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cut: Option<DocumentCuts>,
    /// Of the pixel's luminance, estimated from the spread of its samples; absent if nothing is known of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub standard_error: Option<f64>,
    /// Samples whose radiance is NaN or infinite; they count as black.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub spoiled: u32,
    /// Events that did not fit into the log; absent if the tree is whole.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub truncated: Option<u64>,
    /// The samples of the pixel, in order.
    pub samples: S,
}

/// Rays that the limits of recursion left out.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct DocumentCuts {
    /// Beyond the depth.
    pub depth: u64,
    /// Of too little weight.
    pub weight: u64,
    /// The sum of the luminances of their throughputs, over the number of samples: the share of the pixel's light that is
    /// missing if they would have met what is as bright as the rest.
    pub share: f64,
}

/// A scene by name, with a hash of its files.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SceneId {
    /// Its name.
    pub name: String,
    /// Of the files that the scene was read from.
    pub hash: String,
    /// Its lights by name, in the order in which a hit asks them.
    pub lights: Vec<String>,
}

/// The size of a picture in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct ImageSize {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

/// A pixel of a picture; (0, 0) is the top left corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct PixelIndex {
    /// Its column.
    pub x: u32,
    /// Its row.
    pub y: u32,
}

/// A pixel's colour.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PixelColor {
    /// Linear radiance, before exposure.
    pub linear: Rgb,
    /// After exposure, clamp and the sRGB curve.
    pub srgb8: [u8; 3],
}

/// A sample of the pixel, with the tree of its eye ray.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SampleTree {
    /// Its number, from 0.
    pub index: u32,
    /// Position on the film, in pixels from the top left corner.
    pub film: [f64; 2],
    /// Factor in the pixel's sum: the samples' radiances times their weights, added in this order, are the pixel.
    pub weight: f64,
    /// Absent if the log was cut before it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub root: Option<RayNode>,
}

/// The JSON Schema of the format, as it is written.
pub fn schema() -> serde_json::Value {
    schemars::generate::SchemaSettings::default()
        .for_serialize()
        .into_generator()
        .into_root_schema_for::<Document>()
        .to_value()
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde gives a reference")]
fn is_zero(count: &u32) -> bool {
    *count == 0
}
