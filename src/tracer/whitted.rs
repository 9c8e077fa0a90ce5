//! Recursive ray tracing. Source: Whitted 1980, "An improved illumination model for shaded display".
//!
//! L = Le + Ka Ia + sum over lights (Kd (N.L) + Ks (R.V)^n) I + Wr L(R) + Wt L(T)
//!
//! The terms are those of a [`ShadingPoint`]; the sum over lights is in `direct.rs`. What can be exchanged for a mistake is asked of
//! the [`Laws`].

use super::laws::Laws;
use super::state::{Path, Tracer, Vertex};
use crate::math::Rgb;
use crate::probe::RayKind::{self, Reflected, Transmitted};
use crate::probe::{Absence, Event, NONE, Probe, Term, counting, tell};
use crate::shading::{Secondary, ShadingPoint};
use crate::world::{Found, Interface, NextHit, OpenMedia};

/// Secondary ray, or why there is none.
type Wanted = Result<Secondary, Absence>;

impl<P: Probe, L: Laws> Tracer<'_, P, L> {
    /// Radiance that comes back along a ray.
    pub(super) fn radiance(&mut self, path: &mut Path) -> Rgb {
        self.tell_ray(path);
        match self.next_interface(path, &mut Found::default()) {
            Some(surface) => self.shade(path, &surface),
            None => self.background(),
        }
    }

    /// Next surface of a ray where light changes.
    #[inline]
    fn next_interface<'b: 'f, 'f>(
        &mut self,
        path: &mut Path<'b>,
        found: &'f mut Found,
    ) -> Option<NextHit<'f>> {
        let (world, ray, rays) = (self.world, &path.ray, &mut self.rays);
        let (hit, at) = if let Some(pixel) = path.prefetched {
            pixel.hit()?
        } else {
            let (hit, at) = found
                .closest
                .insert(self.laws.closest_point(world, ray, self.probe)?);
            (&*hit, &*at)
        };
        let media = (&mut path.media, &mut self.scratch);
        world.next_interface(ray, (hit, at), &mut found.surface, media, rays, self.probe)
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
    fn shade(&mut self, path: &Path, surface: &NextHit) -> Rgb {
        tell!(self.probe, Event::Hit(*surface.hit));
        let scene = &self.world.scene;
        let material = scene.material_of(surface.hit.primitive);
        let point = ShadingPoint::new(surface.at, material, self.settings.effects);
        let vertex = Vertex { path, point };
        let mut sum = Rgb::BLACK;
        // What the surface sends out itself, and its share of the light that is everywhere.
        self.add(&mut sum, point.emitted());
        let ambient = self.laws.ambient(&point, scene.ambient, scene.lights.len());
        self.add(&mut sum, ambient);
        // What each light adds, unless something is in its way.
        self.direct_light(&mut sum, &vertex, surface.is_first);
        // What comes from the mirrored and from the refracted direction.
        if let Some(interface) = surface.interface.filter(|_| counting::REFRACTION) {
            self.refract(&mut sum, &vertex, interface);
        } else {
            let reflected = self.laws.reflected(&point, None);
            sum += self.secondary(&vertex, Reflected, reflected, path.media);
            self.absent(Transmitted, NONE, Absence::NoTransmission);
        }
        self.done(self.laws.returned(sum))
    }

    /// Adds the reflected and the transmitted ray where media change. (Never inlined, so that opaque surfaces pay nothing.)
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
