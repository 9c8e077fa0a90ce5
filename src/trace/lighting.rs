//! The factors of the terms of the shading equation, computed again with the tracer's own functions.

use super::document::TermFactors;
use super::{SurfaceHit, View};
use crate::math::Rgb;
use crate::probe::{RayKind, Term};
use crate::shading::{Illumination, optics};
use crate::tracer::area::AreaView;
use crate::tracer::lights::{Asker, Surface, illumination};

/// The factors of a light's diffuse and specular terms.
#[derive(Clone, Copy, Debug)]
pub struct Lighting {
    /// The light as the hit point sees it.
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

impl View<'_> {
    /// The factors of a term at the hit of a node; `light`: the light and the number of its sample.
    pub fn factors(
        self,
        node: u32,
        hit: &SurfaceHit,
        term: Term,
        light: (u32, u32),
    ) -> TermFactors {
        let lighting = self.lighting(node, hit, light);
        let intensity = lighting.map(|l| l.light.intensity);
        let none = TermFactors::default();
        match term {
            Term::Emission | Term::Background => none,
            Term::Ambient => TermFactors {
                ka: Some(hit.material.ambient_at(hit.at.uv)),
                ambient_light: Some(self.world.scene.ambient),
                ..none
            },
            Term::Diffuse => TermFactors {
                kd: lighting.map(|l| l.kd),
                intensity,
                n_dot_l: lighting.map(|l| l.n_dot_l),
                projected_solid_angle: lighting.and_then(|l| l.projected),
                ..none
            },
            Term::Specular => TermFactors {
                ks: Some(hit.material.specular),
                intensity,
                r_dot_v: lighting.map(|l| l.r_dot_v.max(0.0)),
                shininess: Some(hit.material.shininess),
                ..none
            },
        }
    }

    /// The light of a term at the hit of a node; `None` if there is none, or if it stands just there.
    pub fn lighting(self, node: u32, hit: &SurfaceHit, light: (u32, u32)) -> Option<Lighting> {
        let scene = &self.world.scene;
        scene.lights.get(light.0 as usize)?;
        let surface = Surface::new(&hit.at, hit.material);
        let area = AreaView::new(scene, self.settings, self.asker(node), &surface, light.0);
        let seen = illumination(scene, (&hit.at, area.as_ref()), light)?;
        let r = optics::reflect(-seen.direction, hit.at.normal);
        Some(Lighting {
            light: seen,
            projected: area.and_then(|area| area.projected()),
            n_dot_l: hit.at.normal.dot(seen.direction),
            r_dot_v: r.dot(hit.at.to_viewer),
            kd: surface.diffuse,
        })
    }

    /// P, the projected solid angle of a light as the hit of a node sees it, if its samples are chosen by that.
    pub fn projected(self, node: u32, light: u32) -> Option<f64> {
        let hit = self.surface_hit(node)?;
        let surface = Surface::new(&hit.at, hit.material);
        let asker = self.asker(node);
        AreaView::new(&self.world.scene, self.settings, asker, &surface, light)?.projected()
    }

    /// The key of a node's points on area lights: its pixel, its sample and its path from the eye.
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
}
