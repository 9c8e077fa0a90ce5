//! Parts of a scene file: the meshes that are kept once, each with the objects that use it.

use super::fields::{Fields, quoted};
use super::mesh::mesh;
use super::solid::matrix;
use crate::geometry::{Shape, SharedMesh};
use crate::scene::{Object, Scene, VertexData};

/// What tells a part from others: the mesh, what its corners carry, and its name in the part.
type PartKey<'s> = (*const SharedMesh, Option<*const VertexData>, &'s str);

/// Parts that are written so far.
#[derive(Default)]
pub struct WrittenParts<'s> {
    keys: Vec<PartKey<'s>>,
    /// Name and text of each.
    pub texts: Vec<String>,
}

impl<'s> WrittenParts<'s> {
    /// The text of an object that is a use of a mesh that is kept once, whose part is added if it is new; `None` if it is something
    /// else. Its name is that of the use and, behind the last `/`, that of the mesh in the part.
    pub fn use_of(&mut self, scene: &'s Scene, number: u32) -> Option<String> {
        let object = &scene.objects[number as usize];
        let [shape] = scene.shapes_of(number) else {
            return None;
        };
        let (shared, map) = shape.mesh()?;
        let (use_name, name) = object.name.rsplit_once('/')?;
        let material = &scene.materials[object.material as usize].name;
        let vertices = object.vertices.as_deref().map(std::ptr::from_ref);
        let key = (std::ptr::from_ref(shared), vertices, name);
        let found = self.keys.iter().position(|known| *known == key);
        let part = if let Some(part) = found {
            part
        } else {
            let text = part_text(object, shared, name, material)?;
            self.texts
                .push(format!("\"mesh-{}\": [{text}]", self.keys.len()));
            self.keys.push(key);
            self.keys.len() - 1
        };
        let fields = Fields::default()
            .text("name", use_name)
            .raw("part", &quoted(&format!("mesh-{part}")))
            .text("material", material);
        let fields = match map {
            Some(map) => fields.raw("transform", &matrix(map)),
            None => fields,
        };
        Some(fields.kind("use"))
    }
}

/// The mesh in its own space.
fn part_text(object: &Object, shared: &SharedMesh, name: &str, material: &str) -> Option<String> {
    let triangles = shared.triangles().iter();
    let shapes: Vec<Shape> = triangles.map(|t| Shape::Triangle(*t)).collect();
    let fields = Fields::default()
        .text("name", name)
        .text("material", material);
    mesh(object, &shapes, fields)
}
