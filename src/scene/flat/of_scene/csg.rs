//! Solids that are cut from others, in the flat form.

use super::About;
use crate::geometry::{Csg, CsgNode, Shape, Solid};
use crate::math::DVec3;
use crate::scene::flat::FlatObject;

impl About<'_> {
    /// A csg with its parts.
    pub fn csg(&self, csg: &Csg) -> FlatObject {
        match csg.tree() {
            Some(CsgNode::Op(op, parts)) => self.node(csg, op.name(), &parts),
            leaf => self.node(csg, "union", leaf.as_slice()),
        }
    }

    fn node(&self, csg: &Csg, op: &str, parts: &[CsgNode]) -> FlatObject {
        let part = |part: &CsgNode| match part {
            CsgNode::Leaf(leaf) => self.leaf(csg, *leaf),
            CsgNode::Op(op, parts) => Some(self.node(csg, op.name(), parts)),
        };
        FlatObject::Csg {
            name: self.name.to_owned(),
            op: op.to_owned(),
            parts: parts.iter().filter_map(part).collect(),
            material: self.material.name.clone(),
        }
    }

    /// A part by its number.
    fn leaf(&self, csg: &Csg, number: u32) -> Option<FlatObject> {
        let leaf = self.object.leaves.get(number as usize)?;
        let about = About {
            name: &leaf.name,
            material: &self.scene.materials[leaf.material as usize],
            ..*self
        };
        Some(match csg.leaves().nth(number as usize)? {
            Solid::Shape(shape) => about.shape(shape, None)?,
            Solid::HalfSpace(space) => about.shape(&Shape::Plane(Box::new(space.plane)), None)?,
            Solid::Polyhedron(polyhedron) => {
                let (points, triangles) = polyhedron.mesh();
                FlatObject::Polyhedron {
                    name: leaf.name.clone(),
                    vertices: points.iter().map(DVec3::to_array).collect(),
                    triangles: triangles.to_vec(),
                    material: about.material.name.clone(),
                }
            }
        })
    }
}
