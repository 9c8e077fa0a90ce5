//! Transforms in a scene file: lists of steps, applied in the order in which they stand.

use std::fmt;

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

impl fmt::Display for TransformStep {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        // Debug writes large numbers with exponents.
        let vector = |[x, y, z]: Triple| {
            format!("({x:?}, {y:?}, {z:?})")
                .replace(".0,", ",")
                .replace(".0)", ")")
        };
        match self {
            Self::Translate(by) => write!(f, "moved by {}", vector(*by)),
            Self::Rotate(by) => {
                let angle = format!("{:?}", by.degrees);
                let angle = angle.strip_suffix(".0").unwrap_or(&angle);
                write!(f, "turned by {angle} degrees around {}", vector(by.axis))
            }
            Self::Scale(ScaleFile::Even(by)) => write!(f, "stretched by {by:?}"),
            Self::Scale(ScaleFile::Axes(by)) => write!(f, "stretched by {}", vector(*by)),
            Self::Matrix(_) => write!(f, "mapped by a matrix"),
        }
    }
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
