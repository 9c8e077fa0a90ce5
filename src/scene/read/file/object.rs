//! Objects in a scene file.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{TransformStep, Triple};

/// Kind of object in a scene file: the fields that all of one material share, then its own.
macro_rules! object_file {
    ($(#[$doc:meta])* $name:ident { $($own:tt)* }) => {
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
        #[serde(deny_unknown_fields)]
        pub struct $name {
            /// Its name.
            pub name: String,
            /// What it is there for.
            pub note: Option<String>,
            /// The name of its material.
            pub material: String,
            /// How it is placed.
            #[serde(default)]
            pub transform: Vec<TransformStep>,
            $($own)*
        }
    };
}

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

/// Fields that objects of all kinds have.
pub struct Common<'a> {
    /// The kind, as the file writes it.
    pub kind: &'static str,
    /// The name.
    pub name: &'a str,
    /// The name of the material, if it has one of its own.
    pub material: Option<&'a str>,
    /// How it is placed.
    pub transform: &'a [TransformStep],
}

impl ObjectFile {
    /// Kind, name, material and transform.
    pub fn common(&self) -> Common<'_> {
        macro_rules! common {
            ($kind:literal, $object:ident, $material:expr) => {
                Common {
                    kind: $kind,
                    name: &$object.name,
                    material: $material,
                    transform: &$object.transform,
                }
            };
        }
        match self {
            Self::Sphere(o) => common!("sphere", o, Some(&o.material)),
            Self::Plane(o) => common!("plane", o, Some(&o.material)),
            Self::Disc(o) => common!("disc", o, Some(&o.material)),
            Self::Triangle(o) => common!("triangle", o, Some(&o.material)),
            Self::Quad(o) => common!("quad", o, Some(&o.material)),
            Self::Box(o) => common!("box", o, Some(&o.material)),
            Self::Mesh(o) => common!("mesh", o, Some(&o.material)),
            Self::Obj(o) => common!("obj", o, o.material.as_deref()),
            Self::Group(o) => common!("group", o, None),
        }
    }
}

object_file! {
    /// A sphere. u runs once around the y axis, v from the lowest point (0) to the highest (1).
    SphereFile {
        /// The centre.
        pub center: Triple,
        /// The radius, above 0.
        pub radius: f64,
    }
}

object_file! {
    /// An endless plane. u and v are metres from `point`.
    PlaneFile {
        /// A point of it.
        pub point: Triple,
        /// The direction at right angles to it; any length but 0.
        pub normal: Triple,
    }
}

object_file! {
    /// A disc. u runs once around it, v from the centre (0) to the rim (1).
    DiscFile {
        /// The centre.
        pub center: Triple,
        /// The direction at right angles to it, on its front; any length but 0.
        pub normal: Triple,
        /// The radius, above 0.
        pub radius: f64,
    }
}

object_file! {
    /// A triangle. Its front is the side from which the corners run counter-clockwise.
    TriangleFile {
        /// The corners.
        pub corners: [Triple; 3],
        /// Normals at the corners, for a look as if it were curved; any length but 0.
        pub normals: Option<[Triple; 3]>,
    }
}

object_file! {
    /// The parallelogram between `corner`, `corner` + u, `corner` + u + v and `corner` + v, whose front shows along u x v.
    /// u and v run from 0 to 1.
    QuadFile {
        /// One corner.
        pub corner: Triple,
        /// The edge to the next corner.
        pub u: Triple,
        /// The other edge from the same corner.
        pub v: Triple,
    }
}

object_file! {
    /// A solid box with faces along the axes. u and v run from 0 to 1 over each face.
    BoxFile {
        /// The corner with the smallest coordinates.
        pub min: Triple,
        /// The corner with the largest.
        pub max: Triple,
    }
}

object_file! {
    /// A triangle mesh.
    MeshFile {
        /// Points.
        pub vertices: Vec<Triple>,
        /// Triples of numbers of vertices, counted from 0.
        pub triangles: Vec<[u32; 3]>,
        /// A normal for each vertex, for a look as if it were curved; any length but 0.
        pub normals: Option<Vec<Triple>>,
        /// Surface coordinates for each vertex.
        pub uvs: Option<Vec<[f64; 2]>>,
    }
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
