//! Solids that are cut from others in a scene file.

use super::fields::{Fields, quoted, row, rows};
use super::solid::solid;
use crate::geometry::{Csg, CsgNode, Solid};
use crate::math::DVec3;
use crate::scene::{Leaf, Scene};

/// The fields of a csg; `leaves` are the names and materials of its parts.
pub fn csg(scene: &Scene, csg: &Csg, leaves: &[Leaf], fields: Fields) -> Option<Fields> {
    let writer = CsgWriter { scene, csg, leaves };
    writer.parts(&csg.tree()?, fields)
}

struct CsgWriter<'a> {
    scene: &'a Scene,
    csg: &'a Csg,
    leaves: &'a [Leaf],
}

impl CsgWriter<'_> {
    fn parts(&self, node: &CsgNode, fields: Fields) -> Option<Fields> {
        let (op, parts) = match node {
            CsgNode::Leaf(_) => ("union", std::slice::from_ref(node)),
            CsgNode::Op(op, parts) => (op.name(), &parts[..]),
        };
        let written: Option<Vec<String>> = parts
            .iter()
            .enumerate()
            .map(|(i, part)| self.part(part, i))
            .collect();
        let fields = fields.raw("op", &quoted(op));
        Some(fields.raw("parts", &format!("[{}]", written?.join(", "))))
    }

    fn part(&self, node: &CsgNode, number: usize) -> Option<String> {
        let CsgNode::Leaf(leaf) = node else {
            let fields = Fields::default().text("name", &format!("part-{number}"));
            return Some(self.parts(node, fields)?.kind("csg"));
        };
        let about = self.leaves.get(*leaf as usize)?;
        let material = &self.scene.materials[about.material as usize];
        let name = about
            .name
            .split_once('/')
            .map_or(&*about.name, |(_, rest)| rest);
        let fields = Fields::default()
            .text("name", name)
            .text("material", &material.name);
        let (kind, fields) = match self.csg.leaves().nth(*leaf as usize)? {
            Solid::Shape(shape) => solid(shape, fields)?,
            Solid::HalfSpace(space) => {
                let fields = fields.row("point", &space.plane.origin().to_array());
                let normal = space.plane.normal().to_array();
                ("plane", fields.row("normal", &normal))
            }
            Solid::Polyhedron(polyhedron) => {
                let (points, triangles) = polyhedron.mesh();
                let points: Vec<[f64; 3]> = points.iter().map(DVec3::to_array).collect();
                let triangles = triangles.iter().map(|t| row(&t.map(f64::from)));
                let triangles: Vec<String> = triangles.collect();
                let fields = fields.raw("vertices", &rows(&points));
                (
                    "mesh",
                    fields.raw("triangles", &format!("[{}]", triangles.join(", "))),
                )
            }
        };
        Some(fields.kind(kind))
    }
}
