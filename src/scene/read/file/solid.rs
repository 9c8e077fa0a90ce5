//! Solids in a scene file, alone or as parts of a `csg`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::common::{Common, solid_file};
use super::{TransformStep, Triple};

solid_file! {
    /// A sphere. u runs once around the y axis, v from the lowest point (0) to the highest (1).
    SphereFile {
        /// The centre.
        pub center: Triple,
        /// The radius, above 0.
        pub radius: f64,
    }
}

solid_file! {
    /// An endless plane. u and v are metres from `point`.
    PlaneFile {
        /// A point of it.
        pub point: Triple,
        /// The direction at right angles to it; any length but 0.
        pub normal: Triple,
    }
}

solid_file! {
    /// A solid box with faces along the axes. u and v run from 0 to 1 over each face.
    BoxFile {
        /// The corner with the smallest coordinates.
        pub min: Triple,
        /// The corner with the largest.
        pub max: Triple,
    }
}

solid_file! {
    /// A cylinder. u runs once around it, v from the base (0) to the top (1).
    CylinderFile {
        /// The middle of the base.
        pub base: Triple,
        /// The middle of the top.
        pub top: Triple,
        /// The radius, above 0.
        pub radius: f64,
        /// True to leave the caps off: then it bounds no part of space.
        #[serde(default)]
        pub open: bool,
    }
}

solid_file! {
    /// A cone, or the part of one between two radii. u runs once around it, v from the base (0) to the top (1).
    ConeFile {
        /// The middle of the base.
        pub base: Triple,
        /// The middle of the top.
        pub top: Triple,
        /// The radius at the base, above 0.
        pub radius: f64,
        /// The radius at the top: 0 for a tip.
        #[serde(default)]
        pub top_radius: f64,
        /// True to leave the caps off: then it bounds no part of space.
        #[serde(default)]
        pub open: bool,
    }
}

solid_file! {
    /// A paraboloid, a bowl. u runs once around it, v from the vertex (0) to the rim (1).
    ParaboloidFile {
        /// The vertex, its deepest point.
        pub vertex: Triple,
        /// The middle of the rim.
        pub top: Triple,
        /// The radius of the rim, above 0.
        pub radius: f64,
        /// True to leave the cap off: then it bounds no part of space.
        #[serde(default)]
        pub open: bool,
    }
}

solid_file! {
    /// A hyperboloid of one sheet, a cooling tower, or of two sheets, two bowls back to back. u runs once around it, v from the base (0)
    /// to the top (1).
    HyperboloidFile {
        /// The middle of the base.
        pub base: Triple,
        /// The middle of the top.
        pub top: Triple,
        /// One sheet: the radius midway. Two sheets: half the gap between them.
        pub waist: f64,
        /// The radius at both ends.
        pub radius: f64,
        /// 1 or 2.
        #[serde(default = "one_sheet")]
        pub sheets: u32,
        /// True to leave the caps off: then it bounds no part of space.
        #[serde(default)]
        pub open: bool,
    }
}

solid_file! {
    /// An ellipsoid with axes along x, y and z. u and v are those of a sphere that was stretched.
    EllipsoidFile {
        /// The centre.
        pub center: Triple,
        /// Half the extent along x, y and z, above 0.
        pub radii: Triple,
    }
}

solid_file! {
    /// The points inside a box with A x^2 + B y^2 + C z^2 + D x y + E x z + F y z + G x + H y + I z + J <= 0. The faces of the box close it.
    QuadricFile {
        /// A to J.
        pub coefficients: [f64; 10],
        /// The corner of the box with the smallest coordinates.
        pub min: Triple,
        /// The corner with the largest.
        pub max: Triple,
    }
}

solid_file! {
    /// A torus, a ring. u runs once around the axis, v once around the tube.
    TorusFile {
        /// The centre.
        pub center: Triple,
        /// The direction of the axis; any length but 0.
        #[serde(default = "up")]
        pub axis: Triple,
        /// The radius of the ring, above 0.
        pub major: f64,
        /// The radius of the tube, above 0.
        pub minor: f64,
    }
}

solid_file! {
    /// The points inside a box where a polynomial of the fourth degree is at most 0. The faces of the box close it.
    QuarticFile {
        /// The 35 coefficients, of x^4, x^3 y, x^3 z, x^3, x^2 y^2, x^2 y z, x^2 y, x^2 z^2, x^2 z, x^2, x y^3, x y^2 z, x y^2, x y z^2,
        /// x y z, x y, x z^3, x z^2, x z, x, y^4, y^3 z, y^3, y^2 z^2, y^2 z, y^2, y z^3, y z^2, y z, y, z^4, z^3, z^2, z and 1.
        pub coefficients: Vec<f64>,
        /// The corner of the box with the smallest coordinates.
        pub min: Triple,
        /// The corner with the largest.
        pub max: Triple,
    }
}

solid_file! {
    /// A convex solid: a closed mesh of triangles.
    ConvexFile {
        /// Points.
        pub vertices: Vec<Triple>,
        /// Triples of numbers of vertices, counted from 0.
        pub triangles: Vec<[u32; 3]>,
    }
}

solid_file! {
    /// A solid that is cut from others. A face that a part cuts has the part's material, if it has one of its own.
    CsgFile {
        /// What is done with the parts.
        pub op: CsgOpFile,
        /// The parts.
        pub parts: Vec<CsgPartFile>,
    }
}

/// What is done with the parts of a csg.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(rename = "CsgOp")]
pub enum CsgOpFile {
    /// What is inside any part.
    Union,
    /// What is inside all parts.
    Intersection,
    /// What is inside the first part and inside none of the others.
    Difference,
}

/// A part of a csg: a solid, or the half of space behind a plane.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CsgPartFile {
    /// A sphere.
    Sphere(SphereFile<Option<String>>),
    /// All that is behind a plane, where its normal does not point.
    Plane(PlaneFile<Option<String>>),
    /// A box with faces along the axes.
    Box(BoxFile<Option<String>>),
    /// A cylinder.
    Cylinder(CylinderFile<Option<String>>),
    /// A cone.
    Cone(ConeFile<Option<String>>),
    /// A paraboloid.
    Paraboloid(ParaboloidFile<Option<String>>),
    /// A hyperboloid.
    Hyperboloid(HyperboloidFile<Option<String>>),
    /// An ellipsoid.
    Ellipsoid(EllipsoidFile<Option<String>>),
    /// A surface of the second degree inside a box.
    Quadric(QuadricFile<Option<String>>),
    /// A torus.
    Torus(TorusFile<Option<String>>),
    /// A surface of the fourth degree inside a box.
    Quartic(QuarticFile<Option<String>>),
    /// A convex solid with flat faces.
    Mesh(ConvexFile<Option<String>>),
    /// A csg inside.
    Csg(CsgFile<Option<String>>),
}

impl CsgPartFile {
    /// Kind, name, material and transform.
    pub fn common(&self) -> Common<'_> {
        macro_rules! common {
            ($($kind:literal $variant:ident),*) => {
                match self {
                    $(Self::$variant(o) => Common {
                        kind: $kind,
                        name: &o.name,
                        material: o.material.as_deref(),
                        transform: &o.transform,
                        shading: None,
                    },)*
                }
            };
        }
        common! {
            "sphere" Sphere, "plane" Plane, "box" Box, "cylinder" Cylinder, "cone" Cone, "paraboloid" Paraboloid,
            "hyperboloid" Hyperboloid, "ellipsoid" Ellipsoid, "quadric" Quadric, "torus" Torus, "quartic" Quartic,
            "mesh" Mesh, "csg" Csg
        }
    }
}

fn one_sheet() -> u32 {
    1
}

fn up() -> Triple {
    [0.0, 1.0, 0.0]
}
