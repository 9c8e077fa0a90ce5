//! State of the tracer: the ray under way, the limits of recursion, and what a probe is told.

use super::laws::{Laws, Ours};
use super::light_sampler::ShadowRay;
use super::path_id::PathId;
use super::shadow_batch::ShadowBatch;
use super::tile_batch::PixelBatch;
use crate::geometry::Hit;
use crate::math::{Ray, Rgb};
use crate::probe::{Absence, Event, NONE, Probe, RayKind, RayRecord, Term, tell};
use crate::scene::limits::MAX_DEPTH;
use crate::scene::{Budget, Settings};
use crate::shading::{FresnelSplit, Secondary, ShadingPoint};
use crate::world::{OpenMedia, RayBudget, RayCuts, Scratch, World};

/// Ray tracer of one pixel after another, which tells a probe of all that happens.
pub struct Tracer<'a, P, L = Ours> {
    pub(super) world: &'a World,
    pub(super) settings: &'a Settings,
    pub(super) probe: &'a mut P,
    pub(super) laws: L,
    /// What a pixel may spend.
    pub(super) budget: Budget,
    /// Whether a shading model is named that surfaces may have to be shaded by.
    pub(super) by_model: bool,
    /// Rays of the present pixel.
    pub rays: RayBudget,
    /// Rays of the present sample that limits left out.
    pub cuts: RayCuts,
    pub(super) shadow_batch: ShadowBatch,
    pub(super) scratch: Scratch,
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
    pub(super) throughput: Rgb,
    /// The open objects that the ray is inside of.
    pub(super) media: OpenMedia,
    /// The object in whose medium it starts, or [`NONE`] for air; [`NONE`] as well if the probe is silent.
    pub(super) medium: u32,
    pub(super) id: PathId,
    /// What was traced before its turn, for the eye rays of a tile.
    pub(super) prefetched: Option<PixelBatch<'b>>,
}

/// Vertex of a path: where it meets a surface.
pub(super) struct Vertex<'a> {
    pub(super) path: &'a Path<'a>,
    pub(super) point: ShadingPoint<'a>,
}

impl Path<'_> {
    /// The path with one more ray, which starts in the open objects `media` and in `medium`.
    #[inline]
    pub(super) fn then(
        &self,
        kind: RayKind,
        ray: Ray,
        weight: Rgb,
        (media, medium): (OpenMedia, u32),
    ) -> Self {
        Self {
            kind,
            ray,
            depth: self.depth + 1,
            weight,
            throughput: self.throughput * weight,
            media,
            medium,
            id: self.id.then(kind == RayKind::Transmitted),
            prefetched: None,
        }
    }
}

impl<'a, P: Probe> Tracer<'a, P> {
    /// A tracer that has sent no ray yet.
    pub fn new(world: &'a World, settings: &'a Settings, probe: &'a mut P) -> Self {
        Self::by_laws(world, settings, probe, Ours)
    }
}

impl<'a, P: Probe, L: Laws> Tracer<'a, P, L> {
    /// A tracer that follows these laws.
    pub fn by_laws(world: &'a World, settings: &'a Settings, probe: &'a mut P, laws: L) -> Self {
        let budget = settings.budget();
        Self {
            world,
            settings,
            probe,
            laws,
            budget,
            by_model: world.shades_by_model(settings),
            rays: RayBudget::new(budget.further_rays),
            cuts: RayCuts::default(),
            shadow_batch: ShadowBatch::default(),
            scratch: Scratch::default(),
        }
    }

    /// Radiance that arrives at the eye along `ray`, of which something may be prefetched.
    pub fn camera_ray(&mut self, id: PathId, ray: Ray, prefetched: Option<PixelBatch>) -> Rgb {
        let media = self.world.around_eye;
        self.rays.eye_ray();
        self.radiance(&mut Path {
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

    /// The ends of recursion besides a miss: depth, weight and budget.
    #[inline]
    pub(super) fn within_limits(
        &mut self,
        path: &Path,
        ray: Secondary,
    ) -> Result<Secondary, Absence> {
        let throughput = path.throughput * ray.weight;
        if path.depth >= self.laws.depth(self.settings.recursion.depth) {
            self.cuts.depth(throughput);
            return Err(Absence::DepthLimit);
        }
        let weight = throughput.max_channel();
        if weight < self.settings.recursion.min_weight {
            self.cuts.weight(throughput);
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
    pub(super) fn medium(&self, ray: &Ray, media: &OpenMedia) -> u32 {
        if P::LISTENS {
            self.world.medium_at_start(ray, media)
        } else {
            NONE
        }
    }
}

/// What a probe is told, beside the sums that it is about.
impl<P: Probe, L: Laws> Tracer<'_, P, L> {
    /// A ray is sent.
    #[inline]
    pub(super) fn tell_ray(&mut self, path: &Path) {
        tell!(
            self.probe,
            Event::Ray(RayRecord {
                kind: path.kind,
                sample: 0,
                depth: path.depth,
                light: NONE,
                medium: path.medium,
                origin: path.ray.origin,
                direction: path.ray.direction,
                t_max: f64::INFINITY,
                weight: path.weight,
            })
        );
    }

    /// A transparent surface shares light between R and T.
    pub(super) fn tell_split(&mut self, split: &FresnelSplit) {
        let FresnelSplit {
            n1,
            n2,
            reflectance,
            ..
        } = *split;
        tell!(
            self.probe,
            Event::Boundary {
                n1,
                n2,
                reflectance
            }
        );
    }

    /// A shadow ray is sent to a sample of a light.
    #[inline]
    pub(super) fn tell_shadow_ray(
        &mut self,
        path: &Path,
        shadow: &ShadowRay,
        (light, sample): (u32, u32),
    ) {
        tell!(
            self.probe,
            Event::Ray(RayRecord {
                kind: RayKind::Light,
                sample: sample as u16,
                depth: path.depth + 1,
                light,
                medium: path.medium,
                origin: shadow.ray.origin,
                direction: shadow.ray.direction,
                t_max: shadow.light.distance,
                weight: Rgb::WHITE,
            })
        );
    }

    /// A shadow ray is done.
    #[inline]
    pub(super) fn tell_occluder(&mut self, occluder: Option<Hit>) {
        tell!(self.probe, occluder.map_or(Event::Lit, Event::Blocked));
        tell!(
            self.probe,
            Event::Return {
                radiance: Rgb::BLACK
            }
        );
    }

    /// A term, if there is one, is added to the sum.
    #[inline(always)]
    pub(super) fn add(&mut self, sum: &mut Rgb, term: Option<Term>) {
        if let Some(term) = term {
            self.add_term(sum, term, (NONE, 0));
        }
    }

    /// A term of a sample of a light is added to the sum.
    #[inline(always)]
    pub(super) fn add_term(&mut self, sum: &mut Rgb, term: Term, (light, sample): (u32, u32)) {
        *sum += term.value();
        let sample = sample as u16;
        tell!(
            self.probe,
            Event::Term {
                term,
                sample,
                light
            }
        );
    }

    /// A ray is not sent.
    #[inline]
    pub(super) fn absent(&mut self, kind: RayKind, light: u32, reason: Absence) {
        tell!(
            self.probe,
            Event::Absent {
                kind,
                light,
                reason
            }
        );
    }

    /// A ray is done.
    #[inline]
    pub(super) fn done(&mut self, radiance: Rgb) -> Rgb {
        tell!(self.probe, Event::Return { radiance });
        radiance
    }
}
