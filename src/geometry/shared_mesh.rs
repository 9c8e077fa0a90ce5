//! A mesh that is kept once and seen in many places: triangles in a space of their own, with a tree of boxes over them.
//!
//! One use of it is one [`Shape`](super::Shape), as a rule inside of a [`Transformed`](super::Transformed), which takes the ray into
//! this space and the point back. The part of a hit is the triangle. All triangles of a use see one ray and one
//! [`Shear`], so that a mesh is as watertight here as it is in the world.
//!
//! Errors: a point is as exact in this space as [`Triangle::surface`] says, and the way into the world adds what is said there. t is
//! the same in both, and within 40 u (m + |o|) of the triangle along the ray, m being the largest coordinate here and o the origin of
//! the ray here; the sum in `src/accel/tolerance.rs` has room for both.
//!
//! The tree is this shape's own search, as a patch has its own: nothing outside depends on it. What is found does not depend on it
//! either: it is the hit with the smallest t, and of equal t the first triangle, as if all were tested.

mod box_node;
mod box_tree;
mod build;

#[cfg(test)]
mod tests;

use super::{Aabb, Intersection, Shear, SurfacePoint, Triangle};
use crate::math::{DVec3, Interval, Ray};
use box_tree::BoxTree;

/// Triangles that are kept once.
#[derive(Clone, Debug)]
pub struct SharedMesh {
    triangles: Vec<Triangle>,
    tree: BoxTree,
}

/// What a search in a mesh cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MeshSteps {
    /// Boxes that were looked at.
    pub boxes: u32,
    /// Triangles that were tested.
    pub triangles: u32,
}

impl SharedMesh {
    /// The mesh of these triangles; a triangle's place in the list is its part number.
    pub fn new(triangles: Vec<Triangle>) -> Self {
        let tree = BoxTree::new(&triangles);
        Self { triangles, tree }
    }

    /// Its triangles in its own space, by part.
    pub fn triangles(&self) -> &[Triangle] {
        &self.triangles
    }

    /// The box around it.
    pub fn bounds(&self) -> Aabb {
        self.tree.bounds()
    }

    /// Memory that it takes, in bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.triangles[..]) + self.tree.bytes()
    }

    /// The first crossing inside the interval; its part is the triangle, its place the weights of the corners.
    #[inline(never)]
    pub fn intersect(&self, ray: &Ray, interval: Interval) -> Intersection {
        let shear = Shear::new(ray);
        self.search(ray, interval, &mut MeshSteps::default(), |triangle| {
            triangle.intersect(&shear, interval)
        })
    }

    /// The first crossing as another `test` of a triangle finds it. Only triangles near the ray are asked.
    pub fn intersect_with(
        &self,
        ray: &Ray,
        interval: Interval,
        test: impl FnMut(&Triangle) -> Intersection,
    ) -> Intersection {
        self.search(ray, interval, &mut MeshSteps::default(), test)
    }

    /// What the search for the first crossing costs.
    pub fn steps(&self, ray: &Ray, interval: Interval) -> MeshSteps {
        let (shear, mut steps) = (Shear::new(ray), MeshSteps::default());
        self.search(ray, interval, &mut steps, |triangle| {
            triangle.intersect(&shear, interval)
        });
        steps
    }

    #[inline(always)]
    fn search(
        &self,
        ray: &Ray,
        interval: Interval,
        steps: &mut MeshSteps,
        mut test: impl FnMut(&Triangle) -> Intersection,
    ) -> Intersection {
        let mut found = Intersection::Miss;
        let (mut nearest, mut first) = (interval.max, u32::MAX);
        self.tree.visit(ray, interval, steps, |part| {
            if let Intersection::Hit { t, place, .. } = test(&self.triangles[part as usize])
                && (t, part) < (nearest, first)
            {
                (nearest, first) = (t, part);
                found = Intersection::Hit { t, place, part };
            }
            nearest
        });
        found
    }

    /// Whether the ray goes into the mesh at a crossing at `t`: whether it meets the triangle there from the front.
    #[inline(never)]
    pub fn enters(&self, ray: &Ray, t: f64) -> Option<bool> {
        let at = Interval::new(t.next_down(), t.next_up());
        match self.intersect(ray, at) {
            Intersection::Hit { part, .. } => {
                let triangle = &self.triangles[part as usize];
                Some(triangle.is_met_in_front(&Shear::new(ray)))
            }
            _ => None,
        }
    }

    /// The point of a triangle with these weights: see [`Triangle::surface`].
    #[inline(never)]
    pub fn surface(&self, place: [f64; 3], part: u32) -> SurfacePoint {
        match self.triangles.get(part as usize) {
            Some(triangle) => triangle.surface(place),
            // No hit has such a part.
            None => SurfacePoint {
                point: DVec3::ZERO,
                error: DVec3::ZERO,
                normal: DVec3::Y,
                uv: glam::DVec2::ZERO,
            },
        }
    }
}
