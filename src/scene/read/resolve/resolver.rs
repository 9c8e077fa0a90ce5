//! Scene in the making: the materials, objects and shapes so far, and their names.

use std::collections::HashMap;

use rayon::prelude::*;

use super::checks;
use super::header::Header;
use super::kept_meshes::KeptMeshes;
use crate::geometry::{Shape, Triangle};
use crate::math::DVec3;
use crate::scene::limits::{MAX_COORDINATE, MAX_PRIMITIVES};
use crate::scene::read::did_you_mean::did_you_mean;
use crate::scene::read::error::{FieldPath, Problem, SceneError};
use crate::scene::read::files::Files;
use crate::scene::warning::{WarningCode, Warnings};
use crate::scene::{Object, Scene};
use crate::shading::Material;

/// Scene in the making.
pub struct Resolver {
    /// The scene so far.
    pub scene: Scene,
    /// Indices of the objects so far, by name.
    pub objects: HashMap<String, u32>,
    /// Indices of the materials so far, by name.
    pub materials: HashMap<String, u32>,
    /// Objects and groups in parts so far, counted at each use.
    pub placed: usize,
    /// Meshes and models of parts.
    pub kept: KeptMeshes,
    /// The files that the scene names.
    pub files: Files,
    /// What was strange so far.
    pub warnings: Warnings,
}

impl Resolver {
    /// Adds a material with a name that none has yet; gives its index.
    pub fn add_material(&mut self, material: Material) -> u32 {
        let index = self.scene.materials.len() as u32;
        self.materials.insert(material.name.clone(), index);
        self.scene.materials.push(material);
        index
    }

    /// Index of the material that the object at `path` names.
    pub fn material(&self, name: &str, path: &FieldPath) -> Result<u32, SceneError> {
        if let Some(&index) = self.materials.get(name) {
            return Ok(index);
        }
        let names = || self.scene.materials.iter().map(|m| m.name.as_str());
        let listed = names().take(12).collect::<Vec<_>>().join(", ");
        let cure = match did_you_mean(name, names()) {
            Some(near) => format!("did you mean `{near}`? There are: {listed}"),
            None if listed.is_empty() => format!("describe it: \"materials\": {{\"{name}\": ...}}"),
            None => format!("describe it under \"materials\", or use one of: {listed}"),
        };
        let path = path.key("material");
        Err(path.error(format!("there is no material `{name}`"), cure))
    }

    /// Begins an object: the shapes that follow belong to it.
    pub fn begin(&mut self, header: &Header, material: u32) -> Result<(), SceneError> {
        let Header {
            name,
            path,
            frame,
            shading,
            ..
        } = header;
        let (frame, shading) = (*frame, *shading);
        checks::name(name, &path.key("name"))?;
        let index = self.scene.objects.len() as u32;
        if self.objects.insert(name.clone(), index).is_some() {
            return Err(path.key("name").error(
                format!("there are two objects named `{name}`"),
                "give one of them a different name",
            ));
        }
        self.scene.objects.push(Object {
            name: name.clone(),
            material,
            shading,
            first_primitive: self.scene.shapes.len() as u32,
            mirrored: false,
            vertices: None,
            instance: false,
            leaves: Vec::new(),
            frame,
        });
        Ok(())
    }

    /// Adds a shape to the object that was begun last.
    pub fn add_shape(&mut self, shape: Shape, path: &FieldPath) -> Result<(), SceneError> {
        self.check_count(1, path)?;
        if let Shape::Plane(plane) = &shape {
            check_extent(plane.origin(), path)?;
        } else if let Some(bounds) = shape.bounds() {
            check_extent(bounds.min, path)?;
            check_extent(bounds.max, path)?;
        }
        self.scene.shapes.push(shape);
        self.scene.owners.push(self.scene.objects.len() as u32 - 1);
        Ok(())
    }

    /// Adds triangles to it; `triangle` looks up the corners of one by their indices.
    pub fn add_triangles(
        &mut self,
        indices: &[[u32; 3]],
        triangle: impl Fn(&[u32; 3]) -> Triangle + Sync,
        path: &FieldPath,
    ) -> Result<(), SceneError> {
        self.check_count(indices.len(), path)?;
        let corners = |t| triangle(t).corners.map(DVec3::abs);
        let extent = indices
            .par_iter()
            .map(|t| corners(t).into_iter().fold(DVec3::ZERO, DVec3::max))
            .reduce(|| DVec3::ZERO, DVec3::max);
        check_extent(extent, path)?;
        let shapes = &mut self.scene.shapes;
        shapes.reserve(indices.len());
        shapes.par_extend(indices.par_iter().map(|t| Shape::Triangle(triangle(t))));
        let owner = self.scene.objects.len() as u32 - 1;
        self.scene.owners.resize(shapes.len(), owner);
        Ok(())
    }

    /// Reserves memory for so many more objects and shapes, if there may be so many.
    pub fn reserve(
        &mut self,
        objects: usize,
        shapes: usize,
        path: &FieldPath,
    ) -> Result<(), SceneError> {
        self.check_count(shapes, path)?;
        self.scene.shapes.reserve(shapes);
        self.scene.objects.reserve(objects);
        self.objects.reserve(objects);
        Ok(())
    }

    /// The scene, with its warnings and its hash.
    pub fn finish(mut self) -> Scene {
        if self.scene.objects.is_empty() {
            let problem = Problem::new(
                "the scene has no objects: the picture shows the background alone",
                "add one to `objects`, such as a sphere",
            );
            self.warnings
                .add(WarningCode::NoObjects, problem.in_file(&self.scene.name));
        }
        self.scene.warnings = self.warnings.into_list(&self.scene.name);
        self.scene.hash = self.files.hash();
        self.scene.files = self.files.read_from;
        self.scene
    }

    /// Refuses so many more shapes, if they are too many. Of a mesh that is kept once the triangles count once.
    pub fn check_count(&self, more: usize, path: &FieldPath) -> Result<(), SceneError> {
        if self.scene.shapes.len() + self.kept.triangles + more <= MAX_PRIMITIVES {
            return Ok(());
        }
        Err(path.error(
            format!("the scene has more than {MAX_PRIMITIVES} triangles and other shapes"),
            "use models with fewer triangles",
        ))
    }
}

/// Refuses an object with a point, after all transforms, that is too far away.
fn check_extent(point: DVec3, path: &FieldPath) -> Result<(), SceneError> {
    let limit = DVec3::splat(MAX_COORDINATE * 1.000_001);
    if point.abs().cmple(limit).all() {
        return Ok(());
    }
    Err(path.error(
        format!("the object reaches farther than {MAX_COORDINATE:e} metres from the origin"),
        "move it nearer, or make it smaller",
    ))
}
