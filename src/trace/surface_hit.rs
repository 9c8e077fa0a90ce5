//! The surface that a recorded ray hit, computed again: the log keeps decisions, this is the arithmetic.

use super::View;
use super::tree::Outcome;
use crate::geometry::Hit;
use crate::math::{DVec3, Ray};
use crate::scene::Object;
use crate::shading::{Interaction, Material, ShadingModel};
use crate::tracer::laws::Laws as _;

/// A solid that is met again after this part of the coordinates has not really been left.
const CLOSE: f64 = 1e-6;

/// The surface that a ray ended on, with all that shading used.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceHit<'a> {
    /// The hit.
    pub hit: Hit,
    /// The hit point with its normals.
    pub at: Interaction,
    /// The object.
    pub object: &'a Object,
    /// The number of the primitive within the object.
    pub primitive: u32,
    /// The model by which it is shaded, if one is named.
    pub shading: Option<ShadingModel>,
    /// The part of the shape, if it has parts.
    pub part: Option<&'a str>,
    /// Weights of a triangle's corners.
    pub barycentric: Option<[f64; 3]>,
    /// The gradient of the equation of a curved surface that has one, outwards; a sphere's is twice the way from its middle.
    pub gradient: Option<DVec3>,
    /// Its material.
    pub material: &'a Material,
}

impl<'a> View<'a> {
    /// Where the ray of a node ended on a surface; for blocked L rays the occluder. `None` if it hit nothing.
    pub fn surface_hit(self, node: u32) -> Option<SurfaceHit<'a>> {
        let node = self.trace.tree.node(node);
        let (Outcome::Hit(hit) | Outcome::Blocked(hit)) = node.outcome? else {
            return None;
        };
        let scene = &self.world.scene;
        let ray = Ray::new(node.ray.origin, node.ray.direction);
        let at = self.laws().interaction(scene, &ray, &hit);
        Some(SurfaceHit {
            hit,
            at: scene.shaded_with((&hit, &at), self.settings),
            object: scene.object_of(hit.primitive),
            primitive: scene.face_of(&hit),
            shading: scene.model(hit.primitive, self.settings),
            part: scene.part_name(&hit),
            barycentric: scene.barycentric(&hit),
            gradient: scene.shapes[hit.primitive as usize].gradient(at.point, hit.part),
            material: scene.material_at(&hit),
        })
    }

    /// The other objects whose surfaces touch the one that the ray of a node arrived on: they were crossed as one.
    pub fn touching(self, node: u32) -> Vec<&'a str> {
        let node = self.trace.tree.node(node);
        let Some(Outcome::Hit(hit)) = node.outcome else {
            return Vec::new();
        };
        let ray = Ray::new(node.ray.origin, node.ray.direction);
        let name = |object: u32| self.world.scene.objects[object as usize].name.as_str();
        let objects = self.world.touching(&ray, &hit);
        objects.into_iter().map(name).collect()
    }

    /// True if the ray of a node ended on the very surface that it was sent from, which a sound offset rules out: a
    /// flat shape cannot be met again, and a solid not so close to where the ray set out.
    pub fn is_self_hit(self, node: u32) -> bool {
        let this = self.trace.tree.node(node);
        let (Some(parent), Some(Outcome::Hit(hit) | Outcome::Blocked(hit))) =
            (this.parent, this.outcome)
        else {
            return false;
        };
        let Some(Outcome::Hit(left)) = self.trace.tree.node(parent).outcome else {
            return false;
        };
        let close = CLOSE * this.ray.origin.abs().max_element();
        let shape = &self.world.scene.shapes[hit.primitive as usize];
        let is_same = hit.primitive == left.primitive;
        match shape.mesh() {
            // Its triangles are flat, and others of them may be near.
            Some(_) => is_same && hit.part == left.part,
            None => is_same && (shape.is_flat() || hit.t <= close),
        }
    }
}
