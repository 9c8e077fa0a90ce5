//! A ray of the document, and what became of it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{TermValue, TraversalStep};
use crate::math::Rgb;
use crate::probe::{AbsenceReason, RayKind};
use crate::shading::{ShadingModel, Side};

type Vector = [f64; 3];

/// A ray with the rays that its hit sent. The fields of a ray's sum (weight, throughput, radiance, contribution) are
/// absent for L rays, whose light is in the terms of the node that sent them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RayNode {
    /// Its number, in the order in which the pixel's rays were sent.
    pub id: u32,
    /// I, L, R or T.
    pub kind: RayKind,
    /// Bounces since the eye.
    pub depth: u32,
    /// In world space, in metres.
    pub origin: Vector,
    /// Unit length.
    pub direction: Vector,
    /// Where the ray begins.
    pub t_min: f64,
    /// For L the distance to the light; null for an open end.
    pub t_max: Option<f64>,
    /// Factor in the parent's sum.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub weight: Option<Rgb>,
    /// Product of the weights from the root.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub throughput: Option<Rgb>,
    /// The material that the ray travels in, or "air".
    pub medium: String,
    /// Its index of refraction.
    pub ior: f64,
    /// Null if the log was cut before the ray ended.
    pub outcome: Option<RayOutcome>,
    /// Surfaces on the way that changed nothing: the medium behind them was that before them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub passed: Vec<PassedSurface>,
    /// For blocked L rays the blocker.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hit: Option<Box<HitPoint>>,
    /// Of L rays.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub light: Option<String>,
    /// Of L rays to an area light, which of its samples this is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sample: Option<u32>,
    /// Of L rays to an area light whose points are chosen by its area.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub light_point: Option<Box<PointOfLight>>,
    /// Of hits that send rays to area lights.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub bundles: Vec<LightSummary>,
    /// Of hits on transparent surfaces.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub boundary: Option<Box<MediumBoundary>>,
    /// The terms of the shading equation, in the order in which they were added.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub terms: Vec<TermValue>,
    /// Sum of the terms, then of weight x radiance of the R and T children, in this order.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radiance: Option<Rgb>,
    /// weight of the sample x throughput x sum of own terms; over all samples they add up to the pixel.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contribution: Option<Rgb>,
    /// Rays that were not sent from here, and why.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub absent: Vec<AbsentRay>,
    /// The rays that were, in order.
    pub children: Vec<RayNode>,
    /// With `--traversal`: every step through the acceleration structure.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub traversal: Vec<TraversalStep>,
}

/// The point on an area light that an L ray goes to. What arrives is radiance x area x cosine / (pi x distance^2 x samples).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PointOfLight {
    /// In world space.
    pub point: Vector,
    /// Le, the radiance of the light.
    pub radiance: Rgb,
    /// The area among whose points it was chosen, in square metres.
    pub area: f64,
    /// Between the light's normal and the way to the surface.
    pub cosine: f64,
    /// From the hit point, in metres.
    pub distance: f64,
    /// How many points are chosen.
    pub samples: u32,
}

/// How a ray ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RayOutcome {
    /// On a surface.
    Hit,
    /// Nowhere.
    Miss,
    /// An I, R or T ray on a light.
    Light,
    /// An L ray at its light.
    Lit,
    /// An L ray at something before its light.
    Blocked,
}

/// The surface that a ray ended on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct HitPoint {
    /// Distance from the ray's origin, in metres.
    pub t: f64,
    /// In world space.
    pub point: Vector,
    /// The object's name.
    pub object: String,
    /// Counted within the object, from 0.
    pub primitive: u32,
    /// The part of the shape: the wall or a face of a cylinder, the part of a csg by its name.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub part: Option<String>,
    /// Weights of a triangle's corners.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub barycentric: Option<[f64; 3]>,
    /// Texture coordinates.
    pub uv: [f64; 2],
    /// The gradient of the equation of a curved surface (quadrics, torus, quartics), outwards; its direction is that of the normal.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gradient: Option<Vector>,
    /// Unit, facing the ray, like `normal`.
    pub geometric_normal: Vector,
    /// The normal that shading used.
    pub normal: Vector,
    /// The side of the surface that the ray came from.
    pub side: Side,
    /// The material's name.
    pub material: String,
    /// The model by which it is shaded, if its object or the settings name one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shading: Option<ShadingModel>,
    /// The groups that the object stands in, from the innermost outwards.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub frames: Vec<GroupFrame>,
}

/// The frame of a group, or of a part where it is used.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct GroupFrame {
    /// The group's name, with those that it stands in.
    pub group: String,
    /// From its coordinates to the world's: three rows of four numbers, of which the last are a translation.
    pub to_world: [[f64; 4]; 3],
}

/// A surface that a ray went straight through.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PassedSurface {
    /// Distance from the ray's origin, in metres.
    pub t: f64,
    /// The object's name.
    pub object: String,
    /// Counted within the object, from 0.
    pub primitive: u32,
    /// The medium on both sides.
    pub medium: String,
}

/// The shadow rays to one area light, taken together.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LightSummary {
    /// The light's name.
    pub light: String,
    /// How many points on the light were chosen; for those that are neither lit nor blocked no ray was sent.
    pub samples: u32,
    /// Rays that reached the light.
    pub lit: u32,
    /// Rays that something stopped.
    pub blocked: u32,
    /// What the light adds: the sum of its samples' terms, each of which is its share of the mean.
    pub mean: Rgb,
    /// Of the mean, in luminance, estimated as if the samples were independent; absent for one sample.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub standard_error: Option<f64>,
}

/// How a transparent surface shares light between R and T.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MediumBoundary {
    /// Index of refraction on the side of the ray.
    pub n1: f64,
    /// Index of refraction on the other side.
    pub n2: f64,
    /// The share that is reflected.
    pub reflectance: f64,
    /// Other objects whose surfaces touch this one: they are crossed as one.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub touching: Vec<String>,
}

/// A ray that was not sent.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct AbsentRay {
    /// L, R or T.
    pub kind: RayKind,
    /// Why it was not sent.
    pub reason: AbsenceReason,
    /// Of L rays.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub light: Option<String>,
    /// Of total-internal-reflection: the number under the root of the refracted direction, not positive.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub k: Option<f64>,
    /// Of facing-away.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub n_dot_l: Option<f64>,
    /// Of below-surface.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub n_dot_r: Option<f64>,
    /// Of outside-cone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cos_angle: Option<f64>,
    /// Of min-weight: the largest channel of the throughput that the ray would have had.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub weight: Option<f64>,
}
