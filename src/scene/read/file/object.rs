//! Objects in a scene file.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{TransformStep, Vector};

/// Something to see, or a group of such.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ObjectFile {
    /// A sphere.
    Sphere(SphereFile),
    /// An endless plane.
    Plane(PlaneFile),
    /// A disc.
    Disc(DiscFile),
    /// A triangle.
    Triangle(TriangleFile),
    /// A parallelogram: two triangles.
    Quad(QuadFile),
    /// A box with faces along the axes.
    Box(BoxFile),
    /// A triangle mesh.
    Mesh(MeshFile),
    /// A triangle mesh from an OBJ file.
    Obj(ObjFile),
    /// Objects that are placed together.
    Group(GroupFile),
}

/// A sphere. u runs once around the y axis, v from the lowest point (0) to the highest (1).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SphereFile {
    /// Its name.
    pub name: String,
    /// What it is there for.
    pub note: Option<String>,
    /// The name of its material.
    pub material: String,
    /// How it is placed.
    #[serde(default)]
    pub transform: Vec<TransformStep>,
    /// The centre.
    pub center: Vector,
    /// The radius, above 0.
    pub radius: f64,
}

/// An endless plane. u and v are metres from `point`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlaneFile {
    /// Its name.
    pub name: String,
    /// What it is there for.
    pub note: Option<String>,
    /// The name of its material.
    pub material: String,
    /// How it is placed.
    #[serde(default)]
    pub transform: Vec<TransformStep>,
    /// A point of it.
    pub point: Vector,
    /// The direction at right angles to it; any length but 0.
    pub normal: Vector,
}

/// A disc. u runs once around it, v from the centre (0) to the rim (1).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DiscFile {
    /// Its name.
    pub name: String,
    /// What it is there for.
    pub note: Option<String>,
    /// The name of its material.
    pub material: String,
    /// How it is placed.
    #[serde(default)]
    pub transform: Vec<TransformStep>,
    /// The centre.
    pub center: Vector,
    /// The direction at right angles to it, on its front; any length but 0.
    pub normal: Vector,
    /// The radius, above 0.
    pub radius: f64,
}

/// A triangle. Its front is the side from which the corners run counter-clockwise.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TriangleFile {
    /// Its name.
    pub name: String,
    /// What it is there for.
    pub note: Option<String>,
    /// The name of its material.
    pub material: String,
    /// How it is placed.
    #[serde(default)]
    pub transform: Vec<TransformStep>,
    /// The corners.
    pub corners: [Vector; 3],
    /// Normals at the corners, for a look as if it were curved; any length but 0.
    pub normals: Option<[Vector; 3]>,
}

/// The parallelogram between `corner`, `corner` + u, `corner` + u + v and `corner` + v, whose front shows along u x v.
/// u and v run from 0 to 1.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct QuadFile {
    /// Its name.
    pub name: String,
    /// What it is there for.
    pub note: Option<String>,
    /// The name of its material.
    pub material: String,
    /// How it is placed.
    #[serde(default)]
    pub transform: Vec<TransformStep>,
    /// One corner.
    pub corner: Vector,
    /// The edge to the next corner.
    pub u: Vector,
    /// The other edge from the same corner.
    pub v: Vector,
}

/// A solid box with faces along the axes. u and v run from 0 to 1 over each face.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BoxFile {
    /// Its name.
    pub name: String,
    /// What it is there for.
    pub note: Option<String>,
    /// The name of its material.
    pub material: String,
    /// How it is placed.
    #[serde(default)]
    pub transform: Vec<TransformStep>,
    /// The corner with the smallest coordinates.
    pub min: Vector,
    /// The corner with the largest.
    pub max: Vector,
}

/// A triangle mesh.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeshFile {
    /// Its name.
    pub name: String,
    /// What it is there for.
    pub note: Option<String>,
    /// The name of its material.
    pub material: String,
    /// How it is placed.
    #[serde(default)]
    pub transform: Vec<TransformStep>,
    /// Points.
    pub vertices: Vec<Vector>,
    /// Triples of numbers of vertices, counted from 0.
    pub triangles: Vec<[u32; 3]>,
    /// A normal for each vertex, for a look as if it were curved; any length but 0.
    pub normals: Option<Vec<Vector>>,
    /// Surface coordinates for each vertex.
    pub uvs: Option<Vec<[f64; 2]>>,
}

/// A mesh from an OBJ file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ObjFile {
    /// Its name.
    pub name: String,
    /// What it is there for.
    pub note: Option<String>,
    /// The name of its material; without it those of the OBJ file's own MTL file.
    pub material: Option<String>,
    /// How it is placed.
    #[serde(default)]
    pub transform: Vec<TransformStep>,
    /// The path of the file, from the folder of the scene file.
    pub file: String,
}

/// Objects that are placed together. Their names begin with the group's: `group/part`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GroupFile {
    /// Its name.
    pub name: String,
    /// What it is there for.
    pub note: Option<String>,
    /// How they are placed, after their own transforms.
    #[serde(default)]
    pub transform: Vec<TransformStep>,
    /// The parts.
    pub objects: Vec<ObjectFile>,
}
