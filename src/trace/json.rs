//! The ray tree as JSON, format `raytree/1`: what graders read.
//!
//! The types below are the format; the JSON Schema is generated from them. A tree is written node by node while it is
//! visited, so a tree of a million rays needs no second copy in memory.

mod knobs;
mod node;

use schemars::JsonSchema;
use serde::ser::SerializeSeq;
use serde::{Serialize, Serializer};

use self::knobs::{Knobs, knobs};
use self::node::node;
use super::View;
use crate::math::Rgb;

/// The value of `format`.
pub const FORMAT: &str = "raytree/1";

type Vector = [f64; 3];

/// A traced pixel with its ray trees.
#[derive(Serialize, JsonSchema)]
#[schemars(title = "raytree/1", rename = "Document")]
pub struct Document<C> {
    /// Always `raytree/1`.
    format: &'static str,
    scene: SceneId,
    image: Size,
    pixel: At,
    settings: Knobs,
    /// What `render` puts into this pixel, bit for bit.
    color: Color,
    /// Of the pixel's luminance, estimated from the spread of its samples; absent if nothing is known of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    standard_error: Option<f64>,
    /// Samples whose radiance is no finite number; they count as black.
    #[serde(skip_serializing_if = "is_zero")]
    spoiled: u32,
    /// Events that did not fit into the log; absent if the tree is whole.
    #[serde(skip_serializing_if = "Option::is_none")]
    truncated: Option<u64>,
    samples: Vec<SampleNode<C>>,
}

#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Scene")]
struct SceneId {
    name: String,
    /// Of the files that the scene was read from.
    hash: String,
}

#[derive(Serialize, JsonSchema)]
struct Size {
    width: u32,
    height: u32,
}

/// (0, 0) is the top left corner.
#[derive(Serialize, JsonSchema)]
struct At {
    x: u32,
    y: u32,
}

#[derive(Serialize, JsonSchema)]
struct Color {
    /// Linear radiance, before exposure.
    linear: Rgb,
    /// After exposure, clamp and the sRGB curve.
    srgb8: [u8; 3],
}

#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Sample")]
struct SampleNode<C> {
    index: u32,
    /// Place on the film, in pixels from the top left corner.
    film: [f64; 2],
    /// Factor in the pixel's sum: the samples' radiances times their weights, added in this order, are the pixel.
    weight: f64,
    /// Absent if the log was cut before it.
    #[serde(skip_serializing_if = "Option::is_none")]
    root: Option<Node<C>>,
}

/// A ray and what became of it. The fields of a ray's sum (weight to contribution) are absent for L rays, whose light
/// is in the terms of the node that sent them.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Node")]
struct Node<C> {
    id: u32,
    kind: &'static str,
    depth: u32,
    origin: Vector,
    /// Unit length.
    direction: Vector,
    t_min: f64,
    /// For L the distance to the light; null for an open end.
    t_max: Option<f64>,
    /// Factor in the parent's sum.
    #[serde(skip_serializing_if = "Option::is_none")]
    weight: Option<Rgb>,
    /// Product of the weights from the root.
    #[serde(skip_serializing_if = "Option::is_none")]
    throughput: Option<Rgb>,
    /// The material that the ray travels in, or "air".
    medium: String,
    /// Its index of refraction.
    ior: f64,
    /// "hit", "miss", "light", "lit" or "blocked"; null if the log was cut before the ray ended.
    outcome: Option<&'static str>,
    /// Surfaces on the way that changed nothing: the medium behind them was that before them.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    passed: Vec<PassedNode>,
    /// For blocked L rays the blocker.
    #[serde(skip_serializing_if = "Option::is_none")]
    hit: Option<HitNode>,
    /// Of L rays.
    #[serde(skip_serializing_if = "Option::is_none")]
    light: Option<String>,
    /// Of L rays to an area light, which of its samples this is.
    #[serde(skip_serializing_if = "Option::is_none")]
    sample: Option<u32>,
    /// Of hits that send rays to area lights.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    bundles: Vec<BundleNode>,
    /// Of hits on transparent surfaces.
    #[serde(skip_serializing_if = "Option::is_none")]
    boundary: Option<Boundary>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    terms: Vec<TermNode>,
    /// Sum of the terms, then of weight x radiance of the R and T children, in this order.
    #[serde(skip_serializing_if = "Option::is_none")]
    radiance: Option<Rgb>,
    /// throughput x sum of own terms; over the tree they add up to the root's radiance.
    #[serde(skip_serializing_if = "Option::is_none")]
    contribution: Option<Rgb>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    absent: Vec<AbsentNode>,
    children: C,
    /// With `--traversal`: every step through the acceleration structure.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    traversal: Vec<Step>,
}

#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Hit")]
struct HitNode {
    t: f64,
    point: Vector,
    object: String,
    /// Counted within the object, from 0.
    primitive: u32,
    /// Weights of a triangle's corners.
    #[serde(skip_serializing_if = "Option::is_none")]
    barycentric: Option<[f64; 3]>,
    uv: [f64; 2],
    /// Unit, facing the ray, like `normal`.
    geometric_normal: Vector,
    /// The normal that shading used.
    normal: Vector,
    side: &'static str,
    material: String,
}

/// A surface that a ray went straight through.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Passed")]
struct PassedNode {
    t: f64,
    object: String,
    /// Counted within the object, from 0.
    primitive: u32,
    /// The medium on both sides.
    medium: String,
}

/// The shadow rays to one area light, taken together.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Bundle")]
struct BundleNode {
    light: String,
    /// How many places on the light were chosen; for those that are neither lit nor blocked no ray was sent.
    samples: u32,
    lit: u32,
    blocked: u32,
    /// What the light adds: the sum of its samples' terms, each of which is its share of the mean.
    mean: Rgb,
    /// Of the mean, in luminance, estimated as if the samples were independent; absent for one sample.
    #[serde(skip_serializing_if = "Option::is_none")]
    standard_error: Option<f64>,
}

/// How a transparent surface shares light between R and T.
#[derive(Serialize, JsonSchema)]
struct Boundary {
    /// Index of refraction on the side of the ray.
    n1: f64,
    /// Index of refraction on the other side.
    n2: f64,
    /// The share that is reflected.
    reflectance: f64,
    /// Other objects whose surfaces touch this one: they are crossed as one.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    touching: Vec<String>,
}

/// A term of the shading equation with its factors: value = product of the factors that its kind names.
#[derive(Default, Serialize, JsonSchema)]
#[schemars(rename = "Term")]
struct TermNode {
    /// "ambient", "emission", "background", "diffuse" or "specular".
    term: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    light: Option<String>,
    /// Of an area light, the sample that it comes from.
    #[serde(skip_serializing_if = "Option::is_none")]
    sample: Option<u32>,
    value: Rgb,
    /// Ambient: value = ka x ambient_light.
    #[serde(skip_serializing_if = "Option::is_none")]
    ka: Option<Rgb>,
    #[serde(skip_serializing_if = "Option::is_none")]
    ambient_light: Option<Rgb>,
    /// Diffuse: value = kd x intensity x n_dot_l.
    #[serde(skip_serializing_if = "Option::is_none")]
    kd: Option<Rgb>,
    /// Specular: value = ks x intensity x r_dot_v ^ shininess.
    #[serde(skip_serializing_if = "Option::is_none")]
    ks: Option<Rgb>,
    /// What arrives from the light, attenuated.
    #[serde(skip_serializing_if = "Option::is_none")]
    intensity: Option<Rgb>,
    #[serde(skip_serializing_if = "Option::is_none")]
    n_dot_l: Option<f64>,
    /// P of an area light whose samples all bring the same: intensity x n_dot_l = radiance x P / (pi x samples).
    #[serde(skip_serializing_if = "Option::is_none")]
    projected_solid_angle: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    r_dot_v: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    shininess: Option<f64>,
}

/// A ray that was not sent.
#[derive(Default, Serialize, JsonSchema)]
#[schemars(rename = "Absent")]
struct AbsentNode {
    kind: &'static str,
    reason: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    light: Option<String>,
    /// Of total-internal-reflection: the negative number under the root of the refracted direction.
    #[serde(skip_serializing_if = "Option::is_none")]
    k: Option<f64>,
    /// Of facing-away.
    #[serde(skip_serializing_if = "Option::is_none")]
    n_dot_l: Option<f64>,
    /// Of below-surface.
    #[serde(skip_serializing_if = "Option::is_none")]
    n_dot_r: Option<f64>,
    /// Of outside-cone.
    #[serde(skip_serializing_if = "Option::is_none")]
    cos_angle: Option<f64>,
    /// Of min-weight: the largest channel of the throughput that the ray would have had.
    #[serde(skip_serializing_if = "Option::is_none")]
    weight: Option<f64>,
}

/// A step through the acceleration structure.
#[derive(Serialize, JsonSchema)]
#[serde(untagged)]
enum Step {
    /// A node was visited or skipped.
    Visit {
        node: u32,
        /// a, b, c, d of the plane a x + b y + c z = d; null for leaves.
        plane: Option<[f64; 4]>,
        t_split: Option<f64>,
        /// The part of the ray inside the node; null for an open end.
        interval: [Option<f64>; 2],
        near: Option<u32>,
        far: Option<u32>,
        /// "near", "far", "both", "children" or "none".
        visit: &'static str,
        reason: &'static str,
    },
    /// A primitive was tested.
    Test {
        test: Tested,
        /// "hit", "miss", "too-far" or "behind".
        result: &'static str,
        t: Option<f64>,
        reason: &'static str,
    },
}

#[derive(Serialize, JsonSchema)]
struct Tested {
    object: String,
    primitive: u32,
}

/// A node's children, written while they are visited.
#[derive(Clone, Copy)]
struct Lazy<'a> {
    view: View<'a>,
    node: u32,
}

impl Serialize for Lazy<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut list = serializer.serialize_seq(None)?;
        for child in self.view.trace.tree.children(self.node) {
            list.serialize_element(&node(self.view, child))?;
        }
        list.end()
    }
}

/// The children of a node as the schema knows them: a list of nodes.
struct Children;

impl JsonSchema for Children {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Children".into()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let node = generator.subschema_for::<Node<Self>>();
        schemars::json_schema!({ "type": "array", "items": node })
    }
}

/// The JSON Schema of the format.
pub fn schema() -> serde_json::Value {
    schemars::generate::SchemaSettings::default()
        .for_serialize()
        .into_generator()
        .into_root_schema_for::<Document<Children>>()
        .to_value()
}

/// The document of a recorded pixel, ready to be written.
pub fn document(view: View) -> impl Serialize {
    let View {
        world,
        settings,
        trace,
    } = view;
    Document {
        format: FORMAT,
        scene: SceneId {
            name: world.scene.name.clone(),
            hash: world.scene.hash.clone(),
        },
        image: Size {
            width: settings.image.width,
            height: settings.image.height,
        },
        pixel: At {
            x: trace.x,
            y: trace.y,
        },
        settings: knobs(settings, &world.scene),
        color: Color {
            linear: trace.pixel.color,
            srgb8: (trace.pixel.color * settings.image.exposure).to_srgb8(),
        },
        standard_error: Some(trace.pixel.error).filter(|error| error.is_finite()),
        spoiled: trace.pixel.spoiled,
        truncated: (trace.tree.dropped > 0).then_some(trace.tree.dropped),
        samples: trace
            .tree
            .samples
            .iter()
            .map(|s| SampleNode {
                index: s.index,
                film: s.film,
                weight: s.weight,
                root: s.root.map(|root| node(view, root)),
            })
            .collect(),
    }
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde gives a reference")]
fn is_zero(count: &u32) -> bool {
    *count == 0
}
