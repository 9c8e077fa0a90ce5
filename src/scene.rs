//! Scene: camera, lights, materials, objects and shapes, checked and in world space.
//!
//! [`load()`] reads it from a built-in scene, a computed one, a JSON file or an OBJ file, [`from_json`] from text; what passed
//! there cannot make the tracer panic. [`read`] is the reader, [`gallery`] the built-in scenes.

mod bend;
mod bends;
pub mod camera;
pub mod check;
pub mod effects;
mod file_id;
pub mod flat;
pub mod gallery;
pub mod kept;
mod law;
pub mod limits;
mod load;
mod object;
pub mod part;
pub mod patch;
pub mod printable;
pub mod read;
pub mod settings;
mod source;
mod trace_command;
pub mod warning;
pub mod write;

pub use crate::shading::{Effect, Effects};
pub use bend::Bend;
pub use bends::Bends;
pub use camera::Camera;
pub use file_id::FileId;
pub use gallery::builtin;
pub use gallery::procedural::list as generated;
pub use law::{BendEntry, Law};
pub use load::{
    from_json, from_stdin, is_built_in, label, list, load, load_from_memory, names, source,
    source_in_memory,
};
pub use object::{Object, VertexData};
pub use patch::Patch;
pub use read::error::SceneError;
pub use read::{error, file};
pub use settings::{
    Adaptive, AreaLightSampling, Budget, Image, Pilot, PixelSampling, Recursion, Sampling,
    Settings, flags,
};
pub use source::{Edit, SceneSource};
pub use trace_command::{changes, trace_command, view_command};
pub use warning::{Warning, WarningCode};

use crate::geometry::{Arithmetic, Hit, Shape};
use crate::math::{Ray, Rgb};
use crate::probe::NONE;
use crate::shading::{Interaction, Light, Material};
use printable::printable;

/// The index of refraction of the medium around everything.
pub const AIR_IOR: f64 = 1.0;

/// A scene, ready to be traced.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Its name.
    pub name: String,
    /// BLAKE3 hash of the files that it was read from: two trees with the same hash are of the same scene.
    pub hash: String,
    /// The camera.
    pub camera: Camera,
    /// Radiance of a ray that hits nothing.
    pub background: Rgb,
    /// Ia: ambient light, which reaches every surface.
    pub ambient: Rgb,
    /// Materials, by index.
    pub materials: Vec<Material>,
    /// Lights, by index.
    pub lights: Vec<Light>,
    /// Objects, by index.
    pub objects: Vec<Object>,
    /// All shapes in world space, by primitive id, those of one object next to each other.
    pub shapes: Vec<Shape>,
    /// The object of each primitive.
    pub owners: Vec<u32>,
    /// Settings that the scene asks for; those of the command line go before them.
    pub settings: Settings,
    /// Warnings about it and the files that it was read from.
    pub warnings: Vec<Warning>,
    /// The files on disk that it was read from.
    pub files: Vec<FileId>,
    /// Changes that were made to its file, as the values of `--change`.
    pub changes: Vec<String>,
}

impl Scene {
    /// The object that a primitive belongs to.
    pub fn object_of(&self, primitive: u32) -> &Object {
        &self.objects[self.owners[primitive as usize] as usize]
    }

    /// The material of a primitive.
    pub fn material_of(&self, primitive: u32) -> &Material {
        &self.materials[self.object_of(primitive).material as usize]
    }

    /// The shapes of an object.
    pub fn shapes_of(&self, object: u32) -> &[Shape] {
        let first = |o: usize| self.objects.get(o).map(|o| o.first_primitive as usize);
        let end = first(object as usize + 1).unwrap_or(self.shapes.len());
        &self.shapes[first(object as usize).unwrap_or(end)..end]
    }

    /// The number of a primitive within its object, from 0.
    pub fn local_index(&self, primitive: u32) -> u32 {
        primitive - self.object_of(primitive).first_primitive
    }

    /// The name of the medium inside an object, or of the air around all.
    pub fn medium_name(&self, object: u32) -> &str {
        self.medium_object(object)
            .map_or("air", |o| self.materials[o.material as usize].name.as_str())
    }

    /// The index of refraction inside an object, or that of the air.
    pub fn medium_ior(&self, object: u32) -> f64 {
        self.medium_object(object)
            .map_or(AIR_IOR, |o| self.materials[o.material as usize].ior)
    }

    /// The priority of what is inside an object; that of the air is the lowest.
    pub fn medium_priority(&self, object: u32) -> i32 {
        self.medium_object(object)
            .map_or(i32::MIN, |o| self.materials[o.material as usize].priority)
    }

    fn medium_object(&self, object: u32) -> Option<&Object> {
        (object != NONE).then(|| &self.objects[object as usize])
    }

    /// The scene with names as they are shown to people.
    #[must_use]
    pub fn with_printable_names(mut self) -> Self {
        let shown = |name: &mut String| *name = printable(name).into_owned();
        shown(&mut self.name);
        self.materials.iter_mut().for_each(|m| shown(&mut m.name));
        self.lights.iter_mut().for_each(|l| shown(&mut l.name));
        self.objects.iter_mut().for_each(|o| shown(&mut o.name));
        self
    }

    /// The scene with shapes that are tested with this arithmetic.
    #[must_use]
    pub fn computed_with(mut self, arithmetic: Arithmetic) -> Self {
        for shape in &mut self.shapes {
            *shape = shape.computed_with(arithmetic);
        }
        self
    }

    /// Interaction at a hit: point, normals, side and surface coordinates.
    pub fn interaction(&self, ray: &Ray, hit: &Hit) -> Interaction {
        let mut surface = self.shapes[hit.primitive as usize].surface(ray, hit.t, hit.barycentric);
        let mut normal = None;
        if let Some(data) = &self.object_of(hit.primitive).vertices {
            let triangle = self.local_index(hit.primitive) as usize;
            normal = data.normal(triangle, hit.barycentric);
            if let Some(uv) = data.uv(triangle, hit.barycentric) {
                surface.uv = uv;
            }
        }
        Interaction::new(&surface, ray.direction, normal)
    }
}
