//! Meshes and models of parts that were read already.

use std::collections::HashMap;
use std::rc::Rc;
use std::sync::Arc;

use crate::geometry::SharedMesh;
use crate::scene::VertexData;
use crate::scene::read::error::FieldPath;
use crate::scene::read::obj::Obj;

/// Meshes and models of parts.
#[derive(Default)]
pub struct KeptMeshes {
    /// By the path of the object in its part and the number of the mesh in that.
    pub meshes: HashMap<(String, usize), KeptMesh>,
    /// Models as they were read, by path, with or without materials of their own.
    pub models: HashMap<(String, bool), Rc<Obj>>,
    /// Triangles of all meshes.
    pub triangles: usize,
}

/// A mesh that is kept, and what its corners carry.
#[derive(Clone)]
pub struct KeptMesh {
    /// Its triangles.
    pub mesh: Arc<SharedMesh>,
    /// What its corners carry.
    pub vertices: Option<Arc<VertexData>>,
}

impl KeptMeshes {
    /// Whether the mesh of a scene file at this path is kept.
    pub fn has_mesh(&self, path: &FieldPath) -> bool {
        self.meshes.contains_key(&(path.text().to_owned(), 0))
    }
}
