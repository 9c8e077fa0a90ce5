//! Recursive ray tracing. Source: Whitted 1980, "An improved illumination model for shaded display".
//!
//! L = Le + Ka Ia + sum over lights (Kd (N.L) + Ks (R.V)^n) I + Wr L(R) + Wt L(T)
//!
//! The terms are those of a [`ShadingPoint`]; the sum over lights is in [`super::direct`].

use super::path_id::PathId;
use super::shadow_batch::ShadowBatch;
use super::tile_batch::PixelBatch;
use crate::math::{Ray, Rgb};
use crate::probe::{Absence, Event, NONE, Probe, RayKind, Term, counting, tell};
use crate::scene::limits::MAX_DEPTH;
use crate::scene::{Budget, Settings};
use crate::shading::{FresnelSplit, Secondary, ShadingPoint};
use crate::world::{Interface, NextHit, OpenMedia, RayBudget, Scratch, World};

/// Ray tracer of one pixel after another, which tells a probe of all that happens.
pub struct Tracer<'a, P> {
    pub(super) world: &'a World,
    pub(super) settings: &'a Settings,
    pub(super) probe: &'a mut P,
    /// What a pixel may spend.
    pub(super) budget: Budget,
    /// Rays of the present pixel.
    pub rays: RayBudget,
    pub(super) shadow_batch: ShadowBatch,
    scratch: Scratch,
}

/// Ray on its way, with the path behind it.
pub(super) struct Path<'b> {
    pub(super) kind: RayKind,
    pub(super) ray: Ray,
    /// Bounces since the eye.
    pub(super) depth: u32,
    /// Factor in the parent's sum.
    pub(super) weight: Rgb,
    /// Product of the weights since the eye: what the ray's radiance counts in the pixel.
    throughput: Rgb,
    /// The open objects that the ray is inside of.
    media: OpenMedia,
    /// The object in whose medium it starts, or [`NONE`] for air; [`NONE`] as well if the probe is silent.
    pub(super) medium: u32,
    pub(super) id: PathId,
    /// What was traced before its turn, for the eye rays of a tile.
    prefetched: Option<PixelBatch<'b>>,
}

impl<'a, P: Probe> Tracer<'a, P> {
    /// A tracer that has sent no ray yet.
    pub fn new(world: &'a World, settings: &'a Settings, probe: &'a mut P) -> Self {
        let budget = settings.budget();
        Self {
            world,
            settings,
            probe,
            budget,
            rays: RayBudget::new(budget.further_rays),
            shadow_batch: ShadowBatch::default(),
            scratch: Scratch::default(),
        }
    }

    /// Radiance that arrives at the eye along `ray`, of which something may be prefetched.
    pub fn camera_ray(&mut self, id: PathId, ray: Ray, prefetched: Option<PixelBatch>) -> Rgb {
        let media = self.world.around_eye;
        self.rays.eye_ray();
        self.radiance(Path {
            kind: RayKind::Incident,
            ray,
            depth: 0,
            weight: Rgb::WHITE,
            throughput: Rgb::WHITE,
            media,
            medium: self.medium(&ray, &media),
            id,
            prefetched,
        })
    }

    /// Radiance that comes back along a ray.
    fn radiance(&mut self, mut path: Path) -> Rgb {
        self.tell_ray(&path);
        match self.next_interface(&mut path) {
            Some(surface) => self.shade(&path, &surface),
            None => self.background(),
        }
    }

    /// Next surface of a ray where light changes.
    #[inline]
    fn next_interface(&mut self, path: &mut Path) -> Option<NextHit> {
        let (world, ray) = (self.world, &path.ray);
        let traced;
        let closest = if let Some(pixel) = path.prefetched {
            pixel.hit()?
        } else {
            let hit = world.closest(ray, 0.0, self.probe)?;
            traced = (hit, world.scene.interaction(ray, &hit));
            (&traced.0, &traced.1)
        };
        let (rays, scratch) = (&mut self.rays, &mut self.scratch);
        world.next_interface(ray, closest, &mut path.media, rays, scratch, self.probe)
    }

    /// Radiance of a ray that leaves the scene.
    fn background(&mut self) -> Rgb {
        tell!(self.probe, Event::Miss);
        let mut sum = Rgb::BLACK;
        let background = self.world.scene.background;
        self.add(&mut sum, Some(Term::Background(background)));
        self.done(sum)
    }

    /// Radiance of a surface: the shading equation, term by term.
    fn shade(&mut self, path: &Path, surface: &NextHit) -> Rgb {
        tell!(self.probe, Event::Hit(surface.hit));
        let scene = &self.world.scene;
        let material = scene.material_of(surface.hit.primitive);
        let point = ShadingPoint::new(&surface.at, material, self.settings.effects);
        let mut sum = Rgb::BLACK;
        // What the surface sends out itself, and its share of the light that is everywhere.
        self.add(&mut sum, point.emitted());
        self.add(&mut sum, point.ambient(scene.ambient));
        // What each light adds, unless something is in its way.
        let prefetched = path.prefetched.filter(|_| surface.is_first);
        self.direct_light(&mut sum, &point, path, prefetched);
        // What comes from the mirrored and from the refracted direction.
        if let Some(interface) = surface.interface.as_ref().filter(|_| counting::REFRACTION) {
            self.refract(&mut sum, path, &point, interface);
        } else {
            let (r, t) = (RayKind::Reflected, RayKind::Transmitted);
            self.secondary(&mut sum, path, &point, r, point.reflected(None), path.media);
            self.absent(t, NONE, Absence::NoTransmission);
        }
        self.done(sum)
    }

    /// Adds the reflected and the transmitted ray where media change. (Never inlined, so that opaque surfaces pay nothing.)
    #[inline(never)]
    fn refract(&mut self, sum: &mut Rgb, path: &Path, point: &ShadingPoint, media: &Interface) {
        let [n1, n2] = media.ior;
        let split = point.split(self.settings.fresnel, n1, n2);
        let FresnelSplit { reflectance, .. } = split;
        tell!(
            self.probe,
            Event::Boundary {
                n1,
                n2,
                reflectance
            }
        );
        let (r, t) = (RayKind::Reflected, RayKind::Transmitted);
        self.secondary(
            sum,
            path,
            point,
            r,
            point.reflected(Some(&split)),
            path.media,
        );
        self.secondary(sum, path, point, t, point.transmitted(&split), media.beyond);
    }

    /// Adds weight x the radiance of a secondary ray that the surface calls for, unless a limit forbids it. (Always inlined:
    /// that there are transmitted rays, too, costs nothing where surfaces are opaque.)
    #[inline(always)]
    fn secondary(
        &mut self,
        sum: &mut Rgb,
        path: &Path,
        point: &ShadingPoint,
        kind: RayKind,
        ray: Result<Secondary, Absence>,
        media: OpenMedia,
    ) {
        let allowed = ray.and_then(|ray| self.within_limits(path, ray));
        let Secondary { direction, weight } = match allowed {
            Ok(ray) => ray,
            Err(reason) => return self.absent(kind, NONE, reason),
        };
        let ray = Ray::new(point.at.origin_towards(direction), direction);
        self.rays.ray();
        let radiance = self.radiance(Path {
            kind,
            ray,
            depth: path.depth + 1,
            weight,
            throughput: path.throughput * weight,
            media,
            medium: self.medium(&ray, &media),
            id: path.id.then(kind == RayKind::Transmitted),
            prefetched: None,
        });
        *sum += weight * radiance;
    }

    /// The ends of recursion besides a miss: depth, weight and budget.
    #[inline]
    fn within_limits(&mut self, path: &Path, ray: Secondary) -> Result<Secondary, Absence> {
        if path.depth >= self.settings.recursion.depth {
            return Err(Absence::DepthLimit);
        }
        let weight = (path.throughput * ray.weight).max_channel();
        if weight < self.settings.recursion.min_weight {
            return Err(Absence::MinWeight { weight });
        }
        if path.depth >= MAX_DEPTH {
            self.rays.truncated = true;
            return Err(Absence::DepthLimit);
        }
        if self.rays.is_spent() {
            return Err(Absence::RayBudget);
        }
        Ok(ray)
    }

    /// The medium where `ray` starts, if the probe is not silent.
    fn medium(&self, ray: &Ray, media: &OpenMedia) -> u32 {
        if P::LISTENS {
            self.world.medium_at_start(ray, media)
        } else {
            NONE
        }
    }
}
