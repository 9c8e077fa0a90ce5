//! Part of a scene: a scene of the shapes and lights that are kept, as its file will have them.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::kept::Kept;
use super::{Object, Scene, VertexData};
use crate::geometry::Shape;
use crate::math::Rgb;

/// Part of a scene.
#[derive(Clone, Debug)]
pub struct ScenePart {
    /// The part as a scene.
    pub scene: Scene,
    /// Objects that have another name there than in the whole scene: theirs, and that in the whole.
    pub names: BTreeMap<String, String>,
}

/// The part of a scene that is kept. In a scene file an object has one shape, or triangles: where a computed scene has an object of
/// several others, each becomes an object, and all but the first have a number in their name.
pub fn part(scene: &Scene, kept: &Kept) -> ScenePart {
    let color = |kept, color| if kept { color } else { Rgb::BLACK };
    let lights = kept.lights.iter();
    let mut part = ScenePart {
        scene: Scene {
            name: scene.name.clone(),
            hash: String::new(),
            camera: scene.camera,
            background: color(kept.background, scene.background),
            ambient: color(kept.ambient, scene.ambient),
            materials: scene.materials.clone(),
            lights: lights.map(|i| scene.lights[*i as usize].clone()).collect(),
            objects: Vec::new(),
            frames: scene.frames.clone(),
            shapes: Vec::with_capacity(kept.shapes.len()),
            owners: Vec::with_capacity(kept.shapes.len()),
            settings: scene.settings,
            warnings: Vec::new(),
            files: Vec::new(),
            changes: Vec::new(),
        },
        names: BTreeMap::new(),
    };
    let owner = |shape: &u32| scene.owners[*shape as usize];
    for shapes in kept.shapes.chunk_by(|a, b| owner(a) == owner(b)) {
        part.add_object(scene, shapes);
    }
    part
}

impl ScenePart {
    /// Adds some shapes of one object.
    fn add_object(&mut self, whole: &Scene, shapes: &[u32]) {
        let is_triangle = |shape: &u32| {
            let shape = &whole.shapes[*shape as usize];
            matches!(shape.plain(), Shape::Triangle(_))
        };
        let (triangles, others): (Vec<u32>, Vec<u32>) = shapes.iter().partition(|s| is_triangle(s));
        if !triangles.is_empty() {
            self.add(whole, &triangles, false);
        }
        for (i, shape) in others.iter().enumerate() {
            self.add(whole, &[*shape], i > 0 || !triangles.is_empty());
        }
    }

    /// Adds shapes of one object as an object; with a number in its name if it is not the `first` of them.
    fn add(&mut self, whole: &Scene, shapes: &[u32], numbered: bool) {
        let Some(&first) = shapes.first() else { return };
        let object = whole.object_of(first);
        let mut name = object.name.clone();
        if numbered {
            name = format!("{name}#{}", whole.local_index(first));
            while whole.objects.iter().any(|other| other.name == name) {
                name.push('\'');
            }
            self.names.insert(name.clone(), object.name.clone());
        }
        let local: Vec<usize> = shapes
            .iter()
            .map(|shape| whole.local_index(*shape) as usize)
            .collect();
        let part = &mut self.scene;
        part.objects.push(Object {
            name,
            material: object.material,
            shading: object.shading,
            first_primitive: part.shapes.len() as u32,
            mirrored: object.mirrored,
            vertices: match &object.vertices {
                Some(data) if !object.instance => Some(Arc::new(corners(data, &local))),
                all => all.clone(),
            },
            instance: object.instance,
            leaves: object.leaves.clone(),
            frame: object.frame,
        });
        let number = part.objects.len() as u32 - 1;
        for &shape in shapes {
            part.shapes.push(whole.shapes[shape as usize].clone());
            part.owners.push(number);
        }
    }
}

/// What the corners of some triangles of a mesh carry.
fn corners(data: &VertexData, triangles: &[usize]) -> VertexData {
    let some = |indices: &[[u32; 3]]| -> Vec<[u32; 3]> {
        let kept = triangles.iter().filter_map(|t| indices.get(*t));
        kept.copied().collect()
    };
    VertexData {
        normal_indices: some(&data.normal_indices),
        uv_indices: some(&data.uv_indices),
        ..data.clone()
    }
}
