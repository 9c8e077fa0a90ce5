//! Faces of an object: its triangles, by number, whether each is a shape of the scene or all are in a mesh that is kept once.

use super::read::error::Problem;
use super::{Scene, SceneError, carried_normal};
use crate::geometry::{Hit, SurfacePoint};
use crate::math::DVec3;
use crate::scene::limits::MAX_PRIMITIVES;

impl Scene {
    /// The number of a primitive within its object, from 0.
    pub fn local_index(&self, primitive: u32) -> u32 {
        primitive - self.object_of(primitive).first_primitive
    }

    /// The number within its object of what is hit. Of a use of a mesh that is kept once it is the triangle, as if each of its triangles
    /// were a shape of the scene.
    pub fn face_of(&self, hit: &Hit) -> u32 {
        if self.object_of(hit.primitive).instance {
            hit.part
        } else {
            self.local_index(hit.primitive)
        }
    }

    /// The normals at the corners of the triangle that is hit, in the world and in the order of the hit's weights; `None` if it is
    /// flat. Zero stands for none.
    pub fn corner_normals(&self, hit: &Hit) -> Option<[DVec3; 3]> {
        let object = self.object_of(hit.primitive);
        let data = object.vertices.as_ref()?;
        let indices = *data.normal_indices.get(self.face_of(hit) as usize)?;
        let normals = indices.map(|i| data.normals[i as usize]);
        let shape = &self.shapes[hit.primitive as usize];
        let map = shape.mesh().and_then(|(_, map)| map);
        Some(map.map_or(normals, |map| {
            let mirror = map.axis_mirror();
            normals.map(|n| carried_normal(n, map, mirror))
        }))
    }

    /// The sum of the corners' normals, each times its weight: not unit. `None` if the mesh is flat.
    pub fn blended_normal(&self, hit: &Hit, [u, v, w]: [f64; 3]) -> Option<DVec3> {
        let [a, b, c] = self.corner_normals(hit)?;
        Some(u * a + v * b + w * c)
    }

    /// The blended unit normal of a mesh that is kept once; the surface gets u and v. (Never inlined: scenes without one pay nothing
    /// for it.)
    #[cold]
    #[inline(never)]
    pub(super) fn of_instance(&self, hit: &Hit, surface: &mut SurfacePoint) -> Option<DVec3> {
        let data = self.object_of(hit.primitive).vertices.as_ref()?;
        if let Some(uv) = data.uv(hit.part as usize, hit.place) {
            surface.uv = uv;
        }
        self.blended_normal(hit, hit.place)?.try_normalize()
    }

    /// Refuses what takes every triangle of every use of a mesh one by one, if these are too many.
    pub fn check_faces(&self) -> Result<(), SceneError> {
        let faces = self.shapes.iter().map(|s| u64::from(s.triangle_count()));
        let count: u64 = faces.sum();
        if count <= MAX_PRIMITIVES as u64 {
            return Ok(());
        }
        let what = format!(
            "one by one these are {count} triangles: {MAX_PRIMITIVES} at most are possible here"
        );
        let problem = Problem::new(what, "use parts with meshes less often");
        Err(problem.in_file(&self.name))
    }
}
