//! Meshes of parts that are kept once: every use of such a part is one shape of the scene.
//!
//! Whether a mesh is kept is decided by itself, its material and its place alone, not by how often its part is used: so a further use
//! changes no bit of the picture of the others.

use std::sync::Arc;

use super::header::Header;
use super::kept_meshes::KeptMesh;
use super::resolver::Resolver;
use super::shapes::in_world;
use crate::geometry::{Shape, SharedMesh};
use crate::scene::limits::{FEW_TRIANGLES, MAX_CONDITION};
use crate::scene::read::error::SceneError;
use crate::scene::read::mesh::Mesh;

impl Resolver {
    /// Whether a mesh of so many triangles is kept once. One that light passes or that shines is not: media and area lights are
    /// made of triangles in the world; nor is one that is stretched so much that rounding would be seen.
    pub fn keeps(&self, header: &Header, material: u32, triangles: usize) -> bool {
        let material = &self.scene.materials[material as usize];
        header.in_part
            && triangles > FEW_TRIANGLES
            && !material.is_transmissive()
            && !material.is_emissive()
            && header
                .to_world
                .is_none_or(|map| map.condition() <= MAX_CONDITION)
    }

    /// Adds a further use of the mesh with this number in its object; false if it is not known yet, or not kept here.
    pub fn use_again(
        &mut self,
        header: &Header,
        material: u32,
        number: usize,
    ) -> Result<bool, SceneError> {
        let key = (header.path.text().to_owned(), number);
        let Some(kept) = self.kept.meshes.get(&key) else {
            return Ok(false);
        };
        let kept = kept.clone();
        if !self.keeps(header, material, kept.mesh.triangles().len()) {
            return Ok(false);
        }
        self.begin(header, material)?;
        if let Some(object) = self.scene.objects.last_mut() {
            object.instance = true;
            object.vertices = kept.vertices;
        }
        let shape = in_world(Shape::Mesh(kept.mesh), header.to_world.as_ref());
        self.add_shape(shape, &header.path)?;
        Ok(true)
    }

    /// Adds a mesh in its own space that is to be kept, unless too few of its triangles have an area: then it is given back.
    pub fn keep(
        &mut self,
        header: &Header,
        material: u32,
        (number, mesh): (usize, Mesh),
    ) -> Result<Option<Mesh>, SceneError> {
        if !self.keeps(header, material, with_area(&mesh)) {
            return Ok(Some(mesh));
        }
        let mesh = self.checked(header, mesh);
        let key = (header.path.text().to_owned(), number);
        self.check_count(mesh.triangles.len(), &header.path)?;
        self.kept.triangles += mesh.triangles.len();
        let kept = KeptMesh {
            mesh: Arc::new(SharedMesh::new(mesh.corners_of_all().collect())),
            vertices: mesh.corners.unless_plain(),
        };
        self.kept.meshes.insert(key, kept);
        self.use_again(header, material, number)?;
        Ok(None)
    }
}

/// How many triangles have an area.
fn with_area(mesh: &Mesh) -> usize {
    let all = mesh.corners_of_all();
    all.filter(|triangle| triangle.normal().is_some()).count()
}
