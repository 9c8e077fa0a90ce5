//! Recursive ray tracing. Source: Whitted 1980, "An improved illumination model for shaded display".
//!
//! L = Le + Ka Ia + sum over lights (Kd (N.L) + Ks (R.V)^n) I + Wr L(R) + Wt L(T)
//!
//! The terms are those of a [`ShadingPoint`]; the sum over lights is in `direct.rs`. What can be exchanged for a mistake is asked of
//! the [`Laws`].

mod gouraud;

use super::laws::Laws;
use super::state::{Path, Tracer, Vertex};
use crate::geometry::Hit;
use crate::math::Rgb;
use crate::probe::RayKind::{self, Reflected, Transmitted};
use crate::probe::{Absence, Event, NONE, Probe, Term, tell};
use crate::shading::{Interaction, Secondary, ShadingPoint};
use crate::world::{Contact, Interface, NextHit, OpenMedia, Surface};

/// Secondary ray, or why there is none.
type Wanted = Result<Secondary, Absence>;

impl<P: Probe, L: Laws> Tracer<'_, P, L> {
    /// Radiance that comes back along a ray.
    pub(super) fn radiance(&mut self, path: &mut Path) -> Rgb {
        self.tell_ray(path);
        if let Some(pixel) = path.prefetched {
            return match pixel.hit() {
                Some(closest) => self.radiance_of_hit(path, closest),
                None => self.background(),
            };
        }
        let closest = self.laws.closest(self.world, &path.ray, self.probe);
        let Some(hit) = &closest else {
            return self.background();
        };
        let at = self.laws.interaction(&self.world.scene, &path.ray, hit);
        self.radiance_of_hit(path, (hit, &at))
    }

    /// Radiance of a ray with this closest hit. (Never inlined, so that the hit stays where it was made.)
    #[inline(never)]
    fn radiance_of_hit(&mut self, path: &mut Path, (hit, at): (&Hit, &Interaction)) -> Rgb {
        if self.world.contact(hit.primitive) == Contact::None {
            self.shade(path, &NextHit::opaque(hit, at))
        } else {
            self.radiance_among_media(path, (hit, at))
        }
    }

    /// Radiance of a ray whose closest hit is on a transparent object or touches one: what it meets there is the next surface
    /// where light changes. (Never inlined, so that opaque surfaces pay nothing.)
    #[inline(never)]
    fn radiance_among_media(&mut self, path: &mut Path, closest: (&Hit, &Interaction)) -> Rgb {
        let media = (&mut path.media, &mut self.scratch);
        let mut surface = Surface::new(closest);
        let (world, rays) = (self.world, &mut self.rays);
        if world.next_interface(&path.ray, &mut surface, media, rays, self.probe) {
            self.shade(path, &surface.next_hit())
        } else {
            self.background()
        }
    }

    /// Radiance of a ray that leaves the scene.
    fn background(&mut self) -> Rgb {
        tell!(self.probe, Event::Miss);
        let mut sum = Rgb::BLACK;
        self.add(
            &mut sum,
            Some(Term::Background(self.world.scene.background)),
        );
        self.done(sum)
    }

    /// Radiance of a surface: the shading equation, term by term.
    #[inline(always)]
    fn shade(&mut self, path: &Path, surface: &NextHit) -> Rgb {
        tell!(self.probe, Event::Hit(*surface.hit));
        if self.by_model {
            return self.shade_by_model(path, surface);
        }
        let (effects, mut flat) = (self.settings.effects, None);
        let of_hit = (surface.hit, surface.at);
        let at = self.world.scene.shaded(of_hit, effects, &mut flat);
        self.shade_point(path, surface, at)
    }

    /// Radiance of a surface by what it is at the hit point.
    #[inline(always)]
    fn shade_point(&mut self, path: &Path, surface: &NextHit, at: &Interaction) -> Rgb {
        let scene = &self.world.scene;
        let (material, effects) = (scene.material_at(surface.hit), self.settings.effects);
        let point = ShadingPoint::new(at, material, effects);
        let vertex = Vertex { path, point };
        let mut sum = Rgb::BLACK;
        // What the surface sends out itself, and its share of the light that is everywhere.
        self.add(&mut sum, point.emitted());
        let ambient = self.laws.ambient(&point, scene.ambient, scene.lights.len());
        self.add(&mut sum, ambient);
        // What each light adds, unless something is in its way.
        self.direct_light(&mut sum, &vertex, surface.is_first);
        self.add_secondary(&mut sum, &vertex, surface);
        self.done(self.laws.returned(sum))
    }

    /// Adds what comes from the mirrored and from the refracted direction.
    #[inline(always)]
    fn add_secondary(&mut self, sum: &mut Rgb, vertex: &Vertex, surface: &NextHit) {
        if let Some(interface) = surface.interface {
            self.refract(sum, vertex, interface);
        } else {
            let reflected = self.laws.reflected(&vertex.point, None);
            *sum += self.secondary(vertex, Reflected, reflected, vertex.path.media);
            self.absent(Transmitted, NONE, Absence::NoTransmission);
        }
    }

    /// Adds the reflected and the transmitted ray where media change.
    #[inline(never)]
    fn refract(&mut self, sum: &mut Rgb, vertex: &Vertex, media: &Interface) {
        let Vertex { path, point } = vertex;
        let split = self.laws.split(point, self.settings.fresnel, media.ior);
        self.tell_split(&split);
        let reflected = self.laws.reflected(point, Some(&split));
        *sum += self.secondary(vertex, Reflected, reflected, path.media);
        let transmitted = self.laws.transmitted(point, &split);
        *sum += self.secondary(vertex, Transmitted, transmitted, media.beyond);
    }

    /// Weight x radiance of a secondary ray that the surface calls for; black if a limit forbids it. (Always inlined: that there
    /// are transmitted rays, too, costs nothing where surfaces are opaque.)
    #[inline(always)]
    fn secondary(&mut self, from: &Vertex, kind: RayKind, ray: Wanted, media: OpenMedia) -> Rgb {
        let allowed = ray.and_then(|ray| self.within_limits(from.path, ray));
        let Secondary { direction, weight } = match allowed {
            Ok(ray) => ray,
            Err(reason) => {
                self.absent(kind, NONE, reason);
                return Rgb::BLACK;
            }
        };
        let ray = self.laws.start(from.point.at, direction);
        self.rays.ray();
        let media = (media, self.medium(&ray, &media));
        weight * self.radiance(&mut from.path.then(kind, ray, weight, media))
    }
}
