//! Recursive ray tracing. Source: Whitted 1980, "An improved illumination model for shaded display".
//!
//! radiance = emission + Ka Ia + sum over lights (Kd (N.L) + Ks (R.V)^n) I + Wr radiance(R) + Wt radiance(T)

mod arrive;
mod light;
mod split;

use super::foresight::Foreseen;
use super::lights::{Asker, Bundle, Surface};
use crate::geometry::Hit;
use crate::math::{DVec3, Ray, Rgb};
use crate::probe::{Absence, Event, NONE, Probe, RayKind, RayRecord, Term, counting, tell};
use crate::scene::{Budget, Effect, Settings};
use crate::shading::{Interaction, Material, optics, phong};
use crate::world::Entered;
use crate::world::interface::Change;
use crate::world::{Company, Room, World};
use arrive::Arrival;
use split::Through;

pub use crate::scene::limits::MAX_DEPTH;

/// Follows rays and tells a probe about it.
pub struct Tracer<'a, P> {
    pub(super) world: &'a World,
    pub(super) settings: &'a Settings,
    pub(super) probe: &'a mut P,
    /// What the pixel may spend.
    pub(super) budget: Budget,
    /// Rays sent so far for the pixel.
    pub rays: u64,
    /// What counts against the budget for all but eye rays: rays, and questions to lights that needed none, since those
    /// cost time, too.
    pub spent: u64,
    /// True if a ray was left out only because of [`MAX_DEPTH`] or the ray budget: the picture is not what was asked.
    pub cut: bool,
    bundle: Bundle,
    room: Room,
}

/// A ray on its way, and what it knows of the path behind it.
struct Path<'f> {
    kind: RayKind,
    ray: Ray,
    depth: u32,
    /// Factor in the parent's sum.
    weight: Rgb,
    /// Product of the weights since the eye: what this ray's radiance counts in the pixel.
    throughput: Rgb,
    /// The open objects that it is inside of.
    entered: Entered,
    /// The object in whose medium it starts, or [`NONE`] for air; [`NONE`] as well if nobody listens.
    medium: u32,
    /// Who it is, for the points on area lights.
    asker: Asker,
    /// Answers that were found ahead, for silent eye rays.
    foreseen: Option<Foreseen<'f>>,
}

impl<'a, P: Probe> Tracer<'a, P> {
    /// A tracer that has sent no ray yet.
    pub fn new(world: &'a World, settings: &'a Settings, probe: &'a mut P) -> Self {
        Self {
            world,
            settings,
            probe,
            budget: settings.budget(),
            rays: 0,
            spent: 0,
            cut: false,
            bundle: Bundle::default(),
            room: Room::default(),
        }
    }

    /// The radiance that arrives at the eye along `ray`, of which something may be foreseen.
    pub fn eye(&mut self, asker: Asker, ray: Ray, foreseen: Option<Foreseen>) -> Rgb {
        let entered = self.world.around_eye;
        self.radiance(&mut Path {
            kind: RayKind::Incident,
            ray,
            depth: 0,
            weight: Rgb::WHITE,
            throughput: Rgb::WHITE,
            entered,
            medium: self.medium(&ray, &entered),
            asker,
            foreseen,
        })
    }

    /// The radiance that comes back along a ray.
    fn radiance(&mut self, path: &mut Path) -> Rgb {
        self.send(path);
        if let Some(foreseen) = path.foreseen {
            return match foreseen.found {
                Some((hit, at)) => self.arrived(path, hit, at),
                None => self.background(),
            };
        }
        match self.world.closest(&path.ray, 0.0, self.probe) {
            Some(hit) => {
                let at = self.world.scene.interaction(&path.ray, &hit);
                self.arrived(path, &hit, &at)
            }
            None => self.background(),
        }
    }

    /// The radiance that comes back from the closest hit.
    #[inline]
    fn arrived(&mut self, path: &mut Path, hit: &Hit, at: &Interaction) -> Rgb {
        if self.world.company(hit.primitive) == Company::Away {
            return self.shade(path, hit, at, None);
        }
        self.arrived_among_media(path, *hit, *at)
    }

    /// The same where media may change. (On its own, so that scenes without media pay nothing for it.)
    #[inline(never)]
    fn arrived_among_media(&mut self, path: &mut Path, hit: Hit, at: Interaction) -> Rgb {
        match self.arrive(path, hit, at) {
            Some(Arrival { hit, at, change }) => self.shade(path, &hit, &at, change.as_ref()),
            None => self.background(),
        }
    }

    /// What a ray brings back that leaves the scene.
    fn background(&mut self) -> Rgb {
        let mut sum = Rgb::BLACK;
        tell!(self.probe, Event::Miss);
        let background = self.world.scene.background;
        self.add(&mut sum, Term::Background, (NONE, 0), background);
        self.done(sum)
    }

    /// The radiance of a place on a surface: the shading equation, term by term.
    fn shade(&mut self, path: &Path, hit: &Hit, at: &Interaction, change: Option<&Change>) -> Rgb {
        let mut sum = Rgb::BLACK;
        tell!(self.probe, Event::Hit(*hit));
        let scene = &self.world.scene;
        let material = scene.material_of(hit.primitive);

        // What the surface sends out itself, and its share of the light that is everywhere.
        if !material.emission.is_black() {
            self.add(&mut sum, Term::Emission, (NONE, 0), material.emission);
        }
        let ambient = phong::ambient(material.ambient_at(at.uv), scene.ambient);
        if !ambient.is_black() {
            self.add(&mut sum, Term::Ambient, (NONE, 0), ambient);
        }
        // What each light adds, unless something stands in its way.
        let surface = Surface::new(at, material);
        for light in 0..scene.lights.len() as u32 {
            self.light(&mut sum, path, &surface, light);
        }
        // What comes from the mirrored and from the refracted direction.
        if counting::REFRACTION
            && let Some(change) = change
        {
            self.split(&mut sum, path, (at, material), change);
        } else {
            self.reflect(&mut sum, path, at, material.mirror);
            self.absent(RayKind::Transmitted, Absence::NoTransmission);
        }
        self.done(sum)
    }

    /// The reflected ray, if there is one: adds Wr radiance(R). (Always inlined, and [`Tracer::follow`] as well: that there are
    /// transmitted rays, too, must cost nothing where surfaces are opaque.)
    #[inline(always)]
    fn reflect(&mut self, sum: &mut Rgb, path: &Path, at: &Interaction, weight: Rgb) {
        let kind = RayKind::Reflected;
        if weight.is_black() {
            return self.absent(kind, Absence::NoReflection);
        }
        if !self.settings.effects.has(Effect::Reflection) {
            return self.absent(kind, Absence::EffectOff);
        }
        let direction = optics::reflect(-at.to_viewer, at.normal);
        let n_dot_r = at.geometric_normal.dot(direction);
        if n_dot_r <= 0.0 {
            return self.absent(kind, Absence::BelowSurface { n_dot_r });
        }
        let way = (direction, path.entered);
        self.follow(sum, path, at, kind, weight, way);
    }

    /// The reflected and the transmitted ray where media change.
    #[inline(never)]
    fn split(
        &mut self,
        sum: &mut Rgb,
        path: &Path,
        (at, material): (&Interaction, &Material),
        change: &Change,
    ) {
        let split = self.split_by_fresnel(at, material, change);
        self.reflect(sum, path, at, split.reflected);
        match &split.transmitted {
            Ok(through) => self.transmit(sum, path, at, through),
            Err(reason) => self.absent(RayKind::Transmitted, *reason),
        }
    }

    /// The transmitted ray: adds Wt radiance(T).
    fn transmit(&mut self, sum: &mut Rgb, path: &Path, at: &Interaction, through: &Through) {
        let kind = RayKind::Transmitted;
        if !self.settings.effects.has(Effect::Refraction) {
            return self.absent(kind, Absence::EffectOff);
        }
        // Through a surface means to the other side of it, by the geometric normal.
        let n_dot_r = at.geometric_normal.dot(through.direction);
        if n_dot_r >= 0.0 {
            return self.absent(kind, Absence::BelowSurface { n_dot_r });
        }
        let way = (through.direction, through.beyond);
        self.follow(sum, path, at, kind, through.share, way);
    }

    /// Follows a secondary ray that physics allows, unless a limit forbids it: adds weight x its radiance.
    #[inline(always)]
    fn follow(
        &mut self,
        sum: &mut Rgb,
        path: &Path,
        at: &Interaction,
        kind: RayKind,
        weight: Rgb,
        (direction, entered): (DVec3, Entered),
    ) {
        let throughput = path.throughput * weight;
        if let Err(reason) = self.within_limits(path.depth, throughput) {
            return self.absent(kind, reason);
        }
        let ray = Ray::new(at.origin_towards(direction), direction);
        let radiance = self.radiance(&mut Path {
            kind,
            ray,
            depth: path.depth + 1,
            weight,
            throughput,
            entered,
            medium: self.medium(&ray, &entered),
            asker: path.asker.follow(kind == RayKind::Transmitted),
            foreseen: None,
        });
        *sum += weight * radiance;
    }

    /// Tells of a secondary ray that is not sent.
    #[inline]
    fn absent(&mut self, kind: RayKind, reason: Absence) {
        tell!(
            self.probe,
            Event::Absent {
                kind,
                light: NONE,
                reason,
            }
        );
    }

    /// The three ends of recursion besides a miss: depth, weight and budget.
    fn within_limits(&mut self, depth: u32, throughput: Rgb) -> Result<(), Absence> {
        if depth >= self.settings.recursion.depth {
            return Err(Absence::DepthLimit);
        }
        let weight = throughput.max_channel();
        if weight < self.settings.recursion.min_weight {
            return Err(Absence::MinWeight { weight });
        }
        if depth >= MAX_DEPTH {
            self.cut = true;
            return Err(Absence::DepthLimit);
        }
        if self.out_of_rays() {
            return Err(Absence::RayBudget);
        }
        Ok(())
    }

    /// True, and noted, if the pixel has sent its share of rays.
    fn out_of_rays(&mut self) -> bool {
        let out = self.spent >= self.budget.further_rays;
        self.cut |= out;
        out
    }

    /// Tells of a ray that sets out.
    fn send(&mut self, path: &Path) {
        self.rays += 1;
        self.spent += u64::from(path.depth > 0);
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

    /// Adds a term to the sum, and tells of it.
    fn add(&mut self, sum: &mut Rgb, term: Term, (light, sample): (u32, u32), value: Rgb) {
        *sum += value;
        tell!(
            self.probe,
            Event::Term {
                term,
                sample: sample as u16,
                light,
                value,
            }
        );
    }

    /// Tells of a ray that is done.
    fn done(&mut self, radiance: Rgb) -> Rgb {
        tell!(self.probe, Event::Return { radiance });
        radiance
    }
}
