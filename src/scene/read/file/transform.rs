//! Transforms in a scene file: lists of steps, applied in the order in which they stand.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Triple;

/// One step of a transform.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum TransformStep {
    /// Move by a vector.
    Translate(Triple),
    /// Turn around an axis through the origin.
    Rotate(RotateFile),
    /// Stretch from the origin.
    Scale(ScaleFile),
    /// Any affine map: three rows of four numbers, of which the last are a translation.
    Matrix([[f64; 4]; 3]),
}

/// A rotation, counter-clockwise when the axis points to the viewer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RotateFile {
    /// What it is there for.
    pub note: Option<String>,
    /// The axis; any length but 0.
    pub axis: Triple,
    /// The angle.
    pub degrees: f64,
}

/// A stretch: by one factor, or by one for each axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(
    untagged,
    expecting = "a scale is one number or a list of three numbers"
)]
pub enum ScaleFile {
    /// In all directions alike.
    Even(f64),
    /// Along x, y and z.
    Axes(Triple),
}
