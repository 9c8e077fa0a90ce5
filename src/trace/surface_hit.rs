//! Where a recorded ray arrived, computed again: the log keeps decisions, this is the arithmetic.

use super::View;
use super::tree::Outcome;
use crate::geometry::{Hit, Shape};
use crate::math::{Ray, Rgb};
use crate::probe::RayKind;
use crate::scene::Object;
use crate::shading::{Illumination, Interaction, Material, optics};
use crate::tracer::area::AreaView;
use crate::tracer::lights::{Asker, Surface, illumination};
use crate::world::interface;

/// A solid that is met again after this part of the coordinates has not really been left.
const CLOSE: f64 = 1e-6;

/// A ray's arrival on a surface, with all that shading used.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceHit<'a> {
    /// The hit.
    pub hit: Hit,
    /// The place.
    pub at: Interaction,
    /// The object.
    pub object: &'a Object,
    /// The number of the primitive within the object.
    pub primitive: u32,
    /// Its material.
    pub material: &'a Material,
}

/// The factors of a light's diffuse and specular terms.
#[derive(Clone, Copy, Debug)]
pub struct Lighting {
    /// The light as the point sees it.
    pub light: Illumination,
    /// P: the projected solid angle of an area light, if its samples are chosen by it.
    pub projected: Option<f64>,
    /// N.L.
    pub n_dot_l: f64,
    /// R.V, where R is L mirrored at N; negative if R points away from the viewer.
    pub r_dot_v: f64,
    /// Kd at the point.
    pub kd: Rgb,
}

impl<'a> View<'a> {
    /// Where the ray of a node ended on a surface; for blocked L rays the blocker. `None` if it hit nothing.
    pub fn surface_hit(self, node: u32) -> Option<SurfaceHit<'a>> {
        let node = self.trace.tree.node(node);
        let (Outcome::Hit(hit) | Outcome::Blocked(hit)) = node.outcome? else {
            return None;
        };
        let scene = &self.world.scene;
        let ray = Ray::new(node.ray.origin, node.ray.direction);
        Some(SurfaceHit {
            hit,
            at: scene.interaction(&ray, &hit),
            object: scene.object_of(hit.primitive),
            primitive: scene.local_index(hit.primitive),
            material: scene.material_of(hit.primitive),
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
        let objects = interface::touching(self.world, &ray, &hit);
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
        let left = match self.trace.tree.node(parent).outcome {
            Some(Outcome::Hit(left)) => left.primitive,
            _ => return false,
        };
        let flat =
            |shape: &Shape| matches!(shape, Shape::Triangle(_) | Shape::Plane(_) | Shape::Disc(_));
        let close = CLOSE * this.ray.origin.abs().max_element();
        let shape = &self.world.scene.shapes[hit.primitive as usize];
        hit.primitive == left && (flat(shape.plain()) || hit.t <= close)
    }

    /// The factors of the terms of a light's sample at the hit of a node; `None` if the light stands just there.
    pub fn lighting(self, node: u32, light: (u32, u32)) -> Option<Lighting> {
        let scene = &self.world.scene;
        let arrival = self.surface_hit(node)?;
        scene.lights.get(light.0 as usize)?;
        let (asker, at) = (self.asker(node), &arrival.at);
        let surface = Surface::new(at, arrival.material);
        let area = AreaView::new(scene, self.settings, asker, &surface, light.0);
        let seen = illumination(scene, (at, area.as_ref()), light)?;
        let r = optics::reflect(-seen.direction, arrival.at.normal);
        Some(Lighting {
            light: seen,
            projected: area.and_then(|area| area.projected()),
            n_dot_l: arrival.at.normal.dot(seen.direction),
            r_dot_v: r.dot(arrival.at.to_viewer),
            kd: surface.diffuse,
        })
    }

    /// P, the projected solid angle of a light as the hit of a node sees it, if its samples are chosen by that.
    pub fn projected(self, node: u32, light: u32) -> Option<f64> {
        let arrival = self.surface_hit(node)?;
        let surface = Surface::new(&arrival.at, arrival.material);
        let asker = self.asker(node);
        AreaView::new(&self.world.scene, self.settings, asker, &surface, light)?.projected()
    }

    /// Who asks at the hit of a node: its pixel, its sample and its path from the eye.
    fn asker(self, node: u32) -> Asker {
        let tree = &self.trace.tree;
        let mut path = Vec::new();
        let mut here = tree.node(node);
        while let Some(parent) = here.parent {
            path.push(here.ray.kind == RayKind::Transmitted);
            here = tree.node(parent);
        }
        let sample = tree.sample_of_node(node).map_or(0, |s| s.index);
        let eye = Asker::eye((self.trace.x, self.trace.y), sample);
        path.into_iter().rev().fold(eye, Asker::follow)
    }

    /// True if a light has an area, so that many rays are sent to it.
    pub fn is_area(self, light: u32) -> bool {
        let light = self.world.scene.lights.get(light as usize);
        light.is_some_and(|l| l.source.is_area())
    }

    /// The name of a light.
    pub fn light_name(self, light: u32) -> &'a str {
        let lights = &self.world.scene.lights;
        lights.get(light as usize).map_or("", |l| l.name.as_str())
    }

    /// The share of the pixel's brightness that a node's subtree brings, 0 to 1: luminance of throughput x radiance
    /// x sample weight over that of the pixel. For an L ray, that of the terms it let through.
    pub fn fraction(self, node: u32) -> f64 {
        let weight = self
            .trace
            .tree
            .sample_of_node(node)
            .map_or(1.0, |s| s.weight);
        let pixel = self.trace.pixel.color.luminance();
        if pixel > 0.0 {
            (self.contribution(node) * weight).luminance() / pixel
        } else {
            0.0
        }
    }

    /// What a node's subtree adds to its sample: throughput x radiance; for an L ray the light's terms at its parent.
    pub fn contribution(self, node: u32) -> Rgb {
        let tree = &self.trace.tree;
        let this = tree.node(node);
        let (RayKind::Light, Some(parent)) = (this.ray.kind, this.parent) else {
            return this.total();
        };
        tree.node(parent).throughput * tree.lit_by(node)
    }
}
