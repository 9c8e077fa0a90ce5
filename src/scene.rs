//! Scene: camera, lights, materials, objects and shapes, checked and in world space.
//!
//! [`load()`] reads it from a built-in scene, a computed one, a JSON file or an OBJ file, [`from_json`] from text; what passed
//! there cannot make the tracer panic. [`read`] is the reader, [`gallery`] the built-in scenes.

mod bend;
mod bends;
pub mod camera;
pub mod check;
pub mod effects;
mod faces;
mod file_id;
pub mod flat;
pub mod gallery;
pub mod kept;
mod law;
pub mod limits;
mod load;
mod models;
mod object;
mod object_frame;
pub mod part;
pub mod patch;
pub mod printable;
pub mod read;
pub mod settings;
mod source;
mod tessellated;
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
pub use object::{Leaf, Object, VertexData, carried_normal};
pub use object_frame::ObjectFrame;
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

use crate::geometry::{Arithmetic, Body, Csg, Hit, PatchMethod, Shape};
use crate::math::{Ray, Rgb};
use crate::probe::NONE;
use crate::shading::{Interaction, Light, Material};
use printable::printable;
use tessellated::tessellated;
pub use tessellated::{squares_that_fit, triangles_of};

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
    /// Frames of groups.
    pub frames: Vec<ObjectFrame>,
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

/// A surface as a flat mesh has it. Few scenes leave smooth normals out: where they do not, nothing is paid for it.
#[cold]
#[inline(never)]
fn flattened<'a>(at: &Interaction, flat: &'a mut Option<Interaction>) -> &'a Interaction {
    flat.insert(at.flat())
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

    /// The materials that an object shows: its own, and those of the parts that it is cut from.
    pub fn materials_of<'s>(&'s self, object: &'s Object) -> impl Iterator<Item = &'s Material> {
        let leaves = object.leaves.iter().map(|leaf| leaf.material);
        let all = std::iter::once(object.material).chain(leaves);
        all.map(|index| &self.materials[index as usize])
    }

    /// Material at a hit: of a solid that is cut from others, that of the leaf.
    #[inline(always)]
    pub fn material_at(&self, hit: &Hit) -> &Material {
        // Parts of other shapes have small numbers.
        if hit.part < Csg::part(0, 0) {
            self.material_of(hit.primitive)
        } else {
            &self.materials[self.leaf_material(hit) as usize]
        }
    }

    #[cold]
    #[inline(never)]
    fn leaf_material(&self, hit: &Hit) -> u32 {
        let object = self.object_of(hit.primitive);
        let leaf = object.leaves.get(Csg::leaf_of(hit.part) as usize);
        leaf.map_or(object.material, |leaf| leaf.material)
    }

    /// The name of the part that is hit, of a shape that has parts.
    pub fn part_name(&self, hit: &Hit) -> Option<&str> {
        let mut shape = self.shapes[hit.primitive as usize].plain();
        while let Shape::Transformed(moved) = shape {
            shape = &moved.shape;
        }
        match shape {
            Shape::Body(body) if matches!(**body, Body::Csg(_)) => {
                let leaves = &self.object_of(hit.primitive).leaves;
                let leaf = leaves.get(Csg::leaf_of(hit.part) as usize);
                leaf.map(|leaf| leaf.name.as_str())
            }
            Shape::Body(body) => body.part_name(hit.part),
            _ => None,
        }
    }

    /// Weights of a triangle's corners at a hit, in the order in which the file has them.
    pub fn barycentric(&self, hit: &Hit) -> Option<[f64; 3]> {
        let object = self.object_of(hit.primitive);
        let shape = self.shapes[hit.primitive as usize].plain();
        let is_triangle = object.instance || matches!(shape, Shape::Triangle(_));
        is_triangle.then(|| object.in_order_of_file(hit.place))
    }

    /// The frames of the groups that an object stands in, from the innermost outwards.
    pub fn frames_of(&self, object: &Object) -> impl Iterator<Item = &ObjectFrame> {
        let frame = |index: u32| self.frames.get(index as usize);
        std::iter::successors(object.frame.and_then(frame), move |inner| {
            inner.outer.and_then(frame)
        })
    }

    /// The shapes of an object.
    pub fn shapes_of(&self, object: u32) -> &[Shape] {
        let first = |o: usize| self.objects.get(o).map(|o| o.first_primitive as usize);
        let end = first(object as usize + 1).unwrap_or(self.shapes.len());
        &self.shapes[first(object as usize).unwrap_or(end)..end]
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

    /// The scene with shapes that are tested with this arithmetic. (Patches that became triangles stay triangles.)
    #[must_use]
    pub fn computed_with(mut self, arithmetic: Arithmetic) -> Self {
        if let PatchMethod::Triangles(squares) = arithmetic.patch {
            self = tessellated(self, squares);
        }
        let arithmetic = Arithmetic {
            patch: PatchMethod::Exact,
            ..arithmetic
        };
        for shape in &mut self.shapes {
            *shape = shape.computed_with(arithmetic);
        }
        self
    }

    /// Interaction at a hit: point, normals, side and surface coordinates.
    pub fn interaction(&self, ray: &Ray, hit: &Hit) -> Interaction {
        self.interaction_with::<true>(ray, hit)
    }

    /// Interaction at a hit, as [`Scene::interaction`] gives it, but for u and v of a sphere: where no material asks for them they
    /// are 0, since they take longer than all the rest.
    #[inline]
    pub fn interaction_for_shading(&self, ray: &Ray, hit: &Hit) -> Interaction {
        self.interaction_with::<false>(ray, hit)
    }

    #[inline(always)]
    fn interaction_with<const UV: bool>(&self, ray: &Ray, hit: &Hit) -> Interaction {
        let mut surface = match &self.shapes[hit.primitive as usize] {
            Shape::Sphere(sphere) if !UV && self.material_of(hit.primitive).checker.is_none() => {
                sphere.bare_surface(ray, hit.t)
            }
            shape => shape.surface(ray, hit.t, hit.place, hit.part),
        };
        let mut normal = None;
        let object = self.object_of(hit.primitive);
        if let Some(data) = &object.vertices {
            if object.instance {
                normal = self.of_instance(hit, &mut surface);
            } else {
                let triangle = self.local_index(hit.primitive) as usize;
                normal = data.normal(triangle, hit.place);
                if let Some(uv) = data.uv(triangle, hit.place) {
                    surface.uv = uv;
                }
            }
        }
        Interaction::new(&surface, ray.direction, normal)
    }

    /// Interaction at a hit as it is shaded where `effects` are simulated: without [`Effect::Smooth`] a mesh is flat. `flat` is memory
    /// for that.
    #[inline]
    pub fn shaded<'a>(
        &self,
        (hit, at): (&Hit, &'a Interaction),
        effects: Effects,
        flat: &'a mut Option<Interaction>,
    ) -> &'a Interaction {
        let vertices = || self.object_of(hit.primitive).vertices.as_ref();
        if effects.has(Effect::Smooth) || vertices().is_none_or(|data| data.of_surface) {
            return at;
        }
        flattened(at, flat)
    }
}
