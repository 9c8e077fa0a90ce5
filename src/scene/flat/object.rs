//! Objects of a flat scene: one shape each.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::scene::file::Triple;
use crate::shading::ShadingModel;

/// A shape. Shapes with the same name belong to one object.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum FlatObject {
    /// A triangle. Its front is the side from which the corners a, b, c run counter-clockwise: N = unit((b - a) x (c - a)).
    Triangle {
        /// The object's name.
        name: String,
        /// Its number within the object, from 0.
        primitive: u32,
        /// The corners.
        corners: [Triple; 3],
        /// If the surface is smooth: the normals at the corners. The normal for shading is their weighted sum, made unit; where
        /// that is 0 or faces away from the viewer it is N.
        #[serde(skip_serializing_if = "Option::is_none")]
        normals: Option<[Triple; 3]>,
        /// "gouraud" if light is computed at the corners, with their normals, and blended by the weights of the hit.
        #[serde(skip_serializing_if = "Option::is_none")]
        shading: Option<ShadingModel>,
        /// If the material has a checker: u and v at the corners.
        #[serde(skip_serializing_if = "Option::is_none")]
        uvs: Option<[[f64; 2]; 3]>,
        /// The material's name.
        material: String,
    },
    /// A sphere. u = atan2(-n.z, n.x) / (2 pi) + 0.5 and v = acos(-n.y) / pi, n the unit vector from the centre.
    Sphere {
        /// The object's name.
        name: String,
        /// The centre.
        center: Triple,
        /// The radius.
        radius: f64,
        /// If it was stretched or turned: the rest is in its own space, and this is the way from there to the world, as for a box.
        #[serde(skip_serializing_if = "Option::is_none")]
        to_world: Option<[f64; 12]>,
        /// The material's name.
        material: String,
    },
    /// An endless plane.
    Plane {
        /// The object's name.
        name: String,
        /// A point of it.
        point: Triple,
        /// The direction at right angles to it (unit), on its front.
        normal: Triple,
        /// If the material has a checker: the unit vectors along which u and v are metres from `point`.
        #[serde(skip_serializing_if = "Option::is_none")]
        axes: Option<[Triple; 2]>,
        /// The material's name.
        material: String,
    },
    /// A solid box with faces along the axes. On a face across axis i, u and v run from 0 to 1 along the axes i + 1 and i + 2
    /// (mod 3).
    Box {
        /// The object's name.
        name: String,
        /// The corner with the smallest coordinates.
        min: Triple,
        /// The corner with the largest.
        max: Triple,
        /// If it was stretched or turned: the rest is in its own space, and this is the way from there to the world, three rows of four
        /// numbers: X = m0 x + m1 y + m2 z + m3, Y = m4 x + m5 y + m6 z + m7, Z = m8 x + m9 y + m10 z + m11.
        #[serde(skip_serializing_if = "Option::is_none")]
        to_world: Option<[f64; 12]>,
        /// The material's name.
        material: String,
    },
    /// A flat polygon. A point of its plane is inside if a way from there to infinity, in the plane, crosses an odd number of edges.
    Polygon {
        /// The object's name.
        name: String,
        /// Its number within the object, from 0.
        primitive: u32,
        /// Loops of corners, each closed by an edge from the last to the first. The first is the rim, the others are holes; its front
        /// is the side from which the rim runs counter-clockwise.
        loops: Vec<Vec<Triple>>,
        /// If the material has a checker: the unit vectors along which u and v are metres from the first corner.
        #[serde(skip_serializing_if = "Option::is_none")]
        axes: Option<[Triple; 2]>,
        /// The material's name.
        material: String,
    },
    /// The points inside a box with A x^2 + B y^2 + C z^2 + D x y + E x z + F y z + G x + H y + I z + J <= 0: cylinders, cones, paraboloids,
    /// hyperboloids and others, in their own space.
    Quadric {
        /// The object's name.
        name: String,
        /// A to J.
        coefficients: [f64; 10],
        /// The corner of the box with the smallest coordinates.
        min: Triple,
        /// The corner with the largest.
        max: Triple,
        /// True if the faces of the box do not close it: only the curved wall is there.
        open: bool,
        /// The way from its own space to the world, as for a box.
        #[serde(skip_serializing_if = "Option::is_none")]
        to_world: Option<[f64; 12]>,
        /// The material's name.
        material: String,
    },
    /// A torus around the origin of its own space, with its axis along y.
    Torus {
        /// The object's name.
        name: String,
        /// The radius of the ring.
        major: f64,
        /// The radius of the tube.
        minor: f64,
        /// The way from its own space to the world, as for a box.
        #[serde(skip_serializing_if = "Option::is_none")]
        to_world: Option<[f64; 12]>,
        /// The material's name.
        material: String,
    },
    /// The points inside a box where a polynomial of the fourth degree is at most 0.
    Quartic {
        /// The object's name.
        name: String,
        /// The 35 coefficients, of x^4, x^3 y, x^3 z, x^3, x^2 y^2, ... z and 1, as in scene files.
        coefficients: Vec<f64>,
        /// The corner of the box with the smallest coordinates.
        min: Triple,
        /// The corner with the largest.
        max: Triple,
        /// The way from its own space to the world, as for a box.
        #[serde(skip_serializing_if = "Option::is_none")]
        to_world: Option<[f64; 12]>,
        /// The material's name.
        material: String,
    },
    /// A Bezier patch. Its front is the side that S_u x S_v points to.
    Bezier {
        /// The object's name.
        name: String,
        /// Its number within the object, from 0.
        primitive: u32,
        /// Rows of points along u.
        points: Vec<Vec<Triple>>,
        /// The weights of the points.
        weights: Vec<Vec<f64>>,
        /// u and v of the whole surface at its first corner and at its last.
        range: [[f64; 2]; 2],
        /// The material's name.
        material: String,
    },
    /// A convex solid, as a closed mesh: a part of a `csg`.
    Polyhedron {
        /// The part's name.
        name: String,
        /// Points.
        vertices: Vec<Triple>,
        /// Triples of numbers of points, counted from 0.
        triangles: Vec<[u32; 3]>,
        /// The material's name.
        material: String,
    },
    /// A solid that is cut from others. Of its parts a plane is all that lies behind it. A face that a part cuts has the material of
    /// the part.
    Csg {
        /// The object's name.
        name: String,
        /// `union`, `intersection` or `difference` (the first part without all others).
        op: String,
        /// The parts.
        parts: Vec<FlatObject>,
        /// The material's name.
        material: String,
    },
    /// A disc.
    Disc {
        /// The object's name.
        name: String,
        /// The centre.
        center: Triple,
        /// The direction at right angles to it (unit), on its front.
        normal: Triple,
        /// The radius.
        radius: f64,
        /// If the material has a checker: the unit vectors a and b with u = atan2(-p.b, -p.a) / (2 pi) + 0.5, p from the centre;
        /// v runs from 0 at the centre to 1 at the rim.
        #[serde(skip_serializing_if = "Option::is_none")]
        axes: Option<[Triple; 2]>,
        /// If it was stretched or turned: the rest is in its own space, and this is the way from there to the world, as for a box.
        #[serde(skip_serializing_if = "Option::is_none")]
        to_world: Option<[f64; 12]>,
        /// The material's name.
        material: String,
    },
}

impl FlatObject {
    /// The object's name.
    pub fn name(&self) -> &str {
        match self {
            Self::Triangle { name, .. }
            | Self::Sphere { name, .. }
            | Self::Plane { name, .. }
            | Self::Box { name, .. }
            | Self::Quadric { name, .. }
            | Self::Torus { name, .. }
            | Self::Bezier { name, .. }
            | Self::Quartic { name, .. }
            | Self::Polyhedron { name, .. }
            | Self::Csg { name, .. }
            | Self::Polygon { name, .. }
            | Self::Disc { name, .. } => name,
        }
    }
}
