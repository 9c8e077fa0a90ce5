//! Objects in a scene file.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::common::object_file;
use super::solid::{
    BoxFile, ConeFile, CsgFile, CylinderFile, EllipsoidFile, HyperboloidFile, ParaboloidFile,
    PlaneFile, QuadricFile, QuarticFile, SphereFile, TorusFile,
};
use super::{Common, TransformStep, Triple};
use crate::shading::ShadingModel;

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
    /// A cylinder.
    Cylinder(CylinderFile),
    /// A cone, or a part of one.
    Cone(ConeFile),
    /// A paraboloid.
    Paraboloid(ParaboloidFile),
    /// A hyperboloid.
    Hyperboloid(HyperboloidFile),
    /// An ellipsoid.
    Ellipsoid(EllipsoidFile),
    /// A surface of the second degree inside a box.
    Quadric(QuadricFile),
    /// A torus.
    Torus(TorusFile),
    /// A surface of the fourth degree inside a box.
    Quartic(QuarticFile),
    /// A solid that is cut from others.
    Csg(CsgFile),
    /// A polygon.
    Polygon(PolygonFile),
    /// Bezier patches.
    Bezier(BezierFile),
    /// A NURBS surface.
    Nurbs(NurbsFile),
    /// A triangle mesh.
    Mesh(MeshFile),
    /// A triangle mesh from an OBJ file.
    Obj(ObjFile),
    /// Objects that are placed together.
    Group(GroupFile),
    /// A part of the scene file, placed once more.
    Use(UseFile),
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
                    shading: None,
                }
            };
        }
        macro_rules! triangles {
            ($kind:literal, $object:ident, $material:expr) => {
                Common {
                    shading: $object.shading,
                    ..common!($kind, $object, $material)
                }
            };
        }
        match self {
            Self::Sphere(o) => common!("sphere", o, Some(&o.material)),
            Self::Plane(o) => common!("plane", o, Some(&o.material)),
            Self::Disc(o) => common!("disc", o, Some(&o.material)),
            Self::Triangle(o) => triangles!("triangle", o, Some(&o.material)),
            Self::Quad(o) => triangles!("quad", o, Some(&o.material)),
            Self::Box(o) => common!("box", o, Some(&o.material)),
            Self::Cylinder(o) => common!("cylinder", o, Some(&o.material)),
            Self::Cone(o) => common!("cone", o, Some(&o.material)),
            Self::Paraboloid(o) => common!("paraboloid", o, Some(&o.material)),
            Self::Hyperboloid(o) => common!("hyperboloid", o, Some(&o.material)),
            Self::Ellipsoid(o) => common!("ellipsoid", o, Some(&o.material)),
            Self::Quadric(o) => common!("quadric", o, Some(&o.material)),
            Self::Torus(o) => common!("torus", o, Some(&o.material)),
            Self::Quartic(o) => common!("quartic", o, Some(&o.material)),
            Self::Csg(o) => common!("csg", o, Some(&o.material)),
            Self::Bezier(o) => common!("bezier", o, Some(&o.material)),
            Self::Nurbs(o) => common!("nurbs", o, Some(&o.material)),
            Self::Polygon(o) => triangles!("polygon", o, Some(&o.material)),
            Self::Mesh(o) => triangles!("mesh", o, Some(&o.material)),
            Self::Obj(o) => triangles!("obj", o, o.material.as_deref()),
            Self::Group(o) => common!("group", o, None),
            Self::Use(o) => common!("use", o, o.material.as_deref()),
        }
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
        /// How it is shaded: "flat", "gouraud" or "phong"; without it by Phong's model.
        pub shading: Option<ShadingModel>,
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
        /// How it is shaded: "flat", "gouraud" or "phong"; without it by Phong's model.
        pub shading: Option<ShadingModel>,
    }
}

object_file! {
    /// A flat polygon, convex or not. Its front is the side from which `points` run counter-clockwise. u and v are metres from the
    /// first point, or those of `uvs`.
    PolygonFile {
        /// The corners.
        pub points: Vec<Triple>,
        /// Loops of corners that are cut out.
        #[serde(default)]
        pub holes: Vec<Vec<Triple>>,
        /// A normal for each corner, for a look as if it were curved; any length but 0.
        pub normals: Option<Vec<Triple>>,
        /// Surface coordinates for each corner.
        pub uvs: Option<Vec<[f64; 2]>>,
        /// How it is shaded: "flat", "gouraud" or "phong"; without it by Phong's model.
        pub shading: Option<ShadingModel>,
    }
}

object_file! {
    /// Bezier patches that form one surface. Its front is the side that S_u x S_v points to. u and v run from 0 to 1 over each patch.
    BezierFile {
        /// The degrees along u and along v, from 1 to 5.
        #[serde(default = "cubic")]
        pub degree: [u32; 2],
        /// The patches: each a list of rows of points, a row along u.
        pub patches: Vec<Vec<Vec<Triple>>>,
        /// The weights of the points, above 0; without them all are 1.
        pub weights: Option<Vec<Vec<Vec<f64>>>>,
        /// Of leaves of a larger surface, which are not cut further: u and v at the first corner of each and at its last.
        pub ranges: Option<Vec<[[f64; 2]; 2]>>,
        /// True if the patches close: then each edge must be that of exactly one other patch.
        #[serde(default)]
        pub closed: bool,
    }
}

object_file! {
    /// A NURBS surface. Its front is the side that S_u x S_v points to. u and v run from 0 to 1 over all of it.
    NurbsFile {
        /// The degrees along u and along v, from 1 to 5.
        #[serde(default = "cubic")]
        pub degree: [u32; 2],
        /// The knots along u and along v: never falling, as many as there are points plus the degree plus 1.
        pub knots: [Vec<f64>; 2],
        /// The points, in rows along u.
        pub points: Vec<Vec<Triple>>,
        /// The weights of the points, above 0; without them all are 1.
        pub weights: Option<Vec<Vec<f64>>>,
        /// True if the surface closes: then each edge must meet another.
        #[serde(default)]
        pub closed: bool,
    }
}

object_file! {
    /// A mesh of triangles and polygons.
    MeshFile {
        /// Points.
        pub vertices: Vec<Triple>,
        /// Triples of numbers of vertices, counted from 0.
        #[serde(default)]
        pub triangles: Vec<[u32; 3]>,
        /// Faces with any number of corners, as numbers of vertices.
        #[serde(default)]
        pub polygons: Vec<Vec<u32>>,
        /// A normal for each vertex, for a look as if it were curved; any length but 0.
        pub normals: Option<Vec<Triple>>,
        /// Surface coordinates for each vertex.
        pub uvs: Option<Vec<[f64; 2]>>,
        /// How it is shaded: "flat", "gouraud" or "phong"; without it by Phong's model.
        pub shading: Option<ShadingModel>,
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
    /// How it is shaded: "flat", "gouraud" or "phong"; without it by Phong's model.
    pub shading: Option<ShadingModel>,
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

/// A part of the scene file, placed as a group is. The names of its objects begin with that of the use: `use/object`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UseFile {
    /// Its name.
    pub name: String,
    /// What it is there for.
    pub note: Option<String>,
    /// The name of the part, under `parts`.
    pub part: String,
    /// The name of a material that takes the place of all those in the part.
    pub material: Option<String>,
    /// How it is placed, after the transforms in the part.
    #[serde(default)]
    pub transform: Vec<TransformStep>,
}

fn cubic() -> [u32; 2] {
    [3, 3]
}
