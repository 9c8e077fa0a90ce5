//! Object in a scene file: one shape, or a mesh.

use super::body::body;
use super::csg::csg;
use super::fields::Fields;
use super::mesh::mesh;
use super::patches::patches;
use super::solid::solid;
use crate::geometry::{Body, Shape};
use crate::scene::{Leaf, Scene};

/// An object, or why it cannot be written.
pub fn object(scene: &Scene, number: u32) -> Result<String, String> {
    let object = &scene.objects[number as usize];
    let material = &scene.materials[object.material as usize];
    let mut fields = Fields::default()
        .text("name", &object.name)
        .text("material", &material.name);
    if let Some(model) = object.shading {
        fields = fields.text("shading", model.word());
    }
    let written = match scene.shapes_of(number) {
        [shape] => match shape.plain() {
            Shape::Body(own) => of_body(scene, own, &object.leaves, fields.clone()),
            shape => solid(shape, fields.clone()).map(|(kind, fields)| fields.kind(kind)),
        },
        _ => None,
    };
    written
        .or_else(|| patches(scene.shapes_of(number), fields.clone()))
        .or_else(|| mesh(object, scene.shapes_of(number), fields))
        .ok_or_else(|| {
            let name = &object.name;
            format!("object `{name}` is neither one shape nor triangles")
        })
}

fn of_body(scene: &Scene, own: &Body, leaves: &[Leaf], fields: Fields) -> Option<String> {
    match own {
        Body::Csg(own) => csg(scene, own, leaves, fields).map(|fields| fields.kind("csg")),
        own => body(own, fields).map(|(kind, fields)| fields.kind(kind)),
    }
}
