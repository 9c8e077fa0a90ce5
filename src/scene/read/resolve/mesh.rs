//! Meshes in the world, without triangles that have no area.

use rayon::prelude::*;

use super::header::Header;
use super::resolver::Resolver;
use crate::geometry::Triangle;
use crate::scene::VertexData;
use crate::scene::read::error::SceneError;
use crate::scene::read::mesh::Mesh;
use crate::scene::warning::WarningCode;

impl Resolver {
    /// Adds a mesh in its own space.
    pub fn add_mesh(
        &mut self,
        header: &Header,
        material: u32,
        mut mesh: Mesh,
    ) -> Result<(), SceneError> {
        if let Some(map) = &header.to_world {
            mesh.place(map);
        }
        self.add_placed(header, material, mesh)
    }

    /// Adds a mesh whose points and normals are in world space. Triangles without area are left out: nothing can hit them,
    /// and they have no normal.
    pub fn add_placed(
        &mut self,
        header: &Header,
        material: u32,
        mut mesh: Mesh,
    ) -> Result<(), SceneError> {
        self.begin(header, material)?;
        if header.to_world.is_some_and(|map| map.flips_handedness()) {
            mesh.turn();
            if let Some(object) = self.scene.objects.last_mut() {
                object.mirrored = true;
            }
        }
        let mesh = self.checked(header, mesh);
        let points = &mesh.points;
        let triangle = |t: &[u32; 3]| Triangle {
            corners: t.map(|i| points[i as usize]),
        };
        self.add_triangles(&mesh.triangles, triangle, &header.path)?;
        if let Some(object) = self.scene.objects.last_mut() {
            object.vertices = mesh.corners.unless_plain();
        }
        Ok(())
    }

    /// The mesh without triangles that have no area, with warnings about these and about normals on the back.
    pub fn checked(&mut self, header: &Header, mesh: Mesh) -> Mesh {
        let Mesh {
            points,
            mut triangles,
            lines,
            mut corners,
        } = mesh;
        let triangle = |t: &[u32; 3]| Triangle {
            corners: t.map(|i| points[i as usize]),
        };
        let count = triangles.len();
        let flat: Vec<u32> = (0..count as u32)
            .into_par_iter()
            .filter(|i| triangle(&triangles[*i as usize]).normal().is_none())
            .collect();
        let which = |number: u32| match lines.get(number as usize) {
            Some(line) => format!("the first is on line {line}"),
            None => format!("the first is number {number}"),
        };
        if let Some(&first) = flat.first() {
            let which = which(first);
            let what = format!(
                "object `{}`: {} of {count} triangles have no area ({which}): they are left out",
                header.name,
                flat.len(),
            );
            let cure = "give each triangle three corners that are not on one line";
            self.warnings
                .add(WarningCode::NoArea, header.path.error(what, cure));
        }
        if let Some((first, turned)) = against_winding(&triangles, triangle, &corners) {
            let what = format!(
                "object `{}`: {turned} of {count} triangles have corner normals on their back ({which}): they are shaded flat",
                header.name,
                which = which(first),
            );
            let cure = "turn the normals, or the order of the corners: counter-clockwise, seen from where the normals point";
            self.warnings.add(
                WarningCode::NormalsAgainstWinding,
                header.path.error(what, cure),
            );
        }
        if !flat.is_empty() {
            leave_out(&flat, &mut triangles);
            leave_out(&flat, &mut corners.normal_indices);
            leave_out(&flat, &mut corners.uv_indices);
        }
        Mesh {
            points,
            triangles,
            lines: Vec::new(),
            corners,
        }
    }
}

/// Of the triangles whose corner normals all point to their back, so that shading cannot use them: the number of the first,
/// and how many there are.
fn against_winding(
    triangles: &[[u32; 3]],
    triangle: impl Fn(&[u32; 3]) -> Triangle + Sync,
    corners: &VertexData,
) -> Option<(u32, usize)> {
    let turned = |(i, (points, normals)): (usize, (&[u32; 3], &[u32; 3]))| {
        let front = triangle(points).normal()?;
        let behind = |n: &u32| corners.normals[*n as usize].dot(front) < 0.0;
        normals.iter().all(behind).then_some((i as u32, 1))
    };
    triangles
        .par_iter()
        .zip(&corners.normal_indices)
        .enumerate()
        .filter_map(turned)
        .reduce_with(|a, b| (a.0.min(b.0), a.1 + b.1))
}

/// Takes the elements with these numbers, which ascend, out of a list.
fn leave_out<T>(numbers: &[u32], list: &mut Vec<T>) {
    let (mut left, mut number) = (numbers.iter().peekable(), 0);
    list.retain(|_| {
        let out = left.next_if_eq(&&number).is_some();
        number += 1;
        !out
    });
}
