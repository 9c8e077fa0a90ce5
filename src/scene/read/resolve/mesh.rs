//! Meshes in the world, without triangles that have no area.

use rayon::prelude::*;

use super::header::Header;
use super::resolver::Resolver;
use crate::geometry::Triangle;
use crate::math::{DVec2, DVec3};
use crate::scene::read::error::SceneError;
use crate::scene::read::mesh::Mesh;
use crate::scene::warning::WarningCode;

impl Resolver {
    /// Adds a mesh. Triangles without area are left out: nothing can hit them, and they have no normal.
    pub fn add_mesh(
        &mut self,
        header: &Header,
        material: u32,
        mesh: Mesh,
    ) -> Result<(), SceneError> {
        self.begin(&header.name, material, &header.path)?;
        let Mesh {
            mut points,
            mut triangles,
            lines,
            mut corners,
        } = mesh;
        if let Some(map) = &header.to_world {
            points.par_iter_mut().for_each(|p| *p = map.point(*p));
            for n in corners.normals.iter_mut().filter(|n| **n != DVec3::ZERO) {
                *n = map.normal(*n);
            }
            // In a mirror, what ran counter-clockwise runs clockwise.
            if map.flips_handedness() {
                // Without texture coordinates of its own a triangle's u and v are the shares of its second and third corner.
                if corners.uv_indices.is_empty() {
                    corners.uvs = vec![DVec2::ZERO, DVec2::X, DVec2::Y];
                    corners.uv_indices = vec![[0, 1, 2]; triangles.len()];
                }
                if let Some(object) = self.scene.objects.last_mut() {
                    object.mirrored = true;
                }
                let lists = [&mut triangles, &mut corners.normal_indices];
                for list in lists.into_iter().chain([&mut corners.uv_indices]) {
                    for triangle in list.iter_mut() {
                        triangle.swap(1, 2);
                    }
                }
            }
        }
        let triangle = |t: &[u32; 3]| Triangle {
            corners: t.map(|i| points[i as usize]),
        };
        let count = triangles.len();
        let flat: Vec<u32> = (0..count as u32)
            .into_par_iter()
            .filter(|i| triangle(&triangles[*i as usize]).normal().is_none())
            .collect();
        if let Some(first) = flat.first() {
            let which = match lines.get(*first as usize) {
                Some(line) => format!("the first is on line {line}"),
                None => format!("the first is number {first}"),
            };
            let what = format!(
                "object `{}`: {} of {count} triangles have no area ({which}): they are left out",
                header.name,
                flat.len(),
            );
            let cure = "give each triangle three corners that are not on one line";
            self.warnings
                .add(WarningCode::NoArea, header.path.error(what, cure));
            leave_out(&flat, &mut triangles);
            leave_out(&flat, &mut corners.normal_indices);
            leave_out(&flat, &mut corners.uv_indices);
        }
        drop(lines);
        self.add_triangles(&triangles, triangle, &header.path)?;
        let plain = corners.normal_indices.is_empty() && corners.uv_indices.is_empty();
        if let Some(object) = self.scene.objects.last_mut() {
            object.vertices = (!plain).then_some(corners);
        }
        Ok(())
    }
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
