//! Recursive ray tracing. Source: Whitted 1980, "An improved illumination model for shaded display".
//!
//! radiance = emission + Ka Ia + sum over lights (Kd (N.L) + Ks (R.V)^n) I + Wr radiance(R) + Wt radiance(T)

use super::foresight::Foreseen;
use crate::math::{DVec3, Ray, Rgb};
use crate::probe::{Absence, Event, NONE, Probe, RayKind, RaySent, Term};
use crate::scene::{Scene, Settings, World};
use crate::shading::{Illumination, Interaction, Material, Media, Side, optics, phong};

/// Rays nest at most this deep, whatever depth was asked for: recursion has to end before the stack does.
pub const MAX_DEPTH: u32 = 1000;

/// Follows rays and tells a probe about it.
pub struct Tracer<'a, P> {
    world: &'a World,
    settings: &'a Settings,
    probe: &'a mut P,
    /// Rays sent so far.
    pub rays: u64,
    /// True if a ray was left out only because of [`MAX_DEPTH`] or the ray budget: the picture is not what was asked.
    pub cut: bool,
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
    media: Media,
    /// Answers that were found ahead, for silent eye rays.
    foreseen: Option<Foreseen<'f>>,
}

/// What has to be known before a light counts: whether anything stands on this ray before the light.
pub struct Question {
    /// From the surface to the light.
    pub ray: Ray,
    /// The light as the surface sees it.
    pub lit: Illumination,
    /// N.L, positive.
    pub n_dot_l: f64,
}

/// The question to ask of a light, or the reason why none is asked.
pub fn shadow_question(
    scene: &Scene,
    at: &Interaction,
    m: &Material,
    light: u32,
) -> Result<Question, Absence> {
    if m.diffuse_at(at.uv).is_black() && m.specular.is_black() {
        return Err(Absence::NoLocalLight);
    }
    let source = &scene.lights[light as usize].source;
    let Some(lit) = source.at(at.point) else {
        return Err(Absence::FacingAway { n_dot_l: 0.0 });
    };
    // The light must be before the surface by both normals, or light would leak through a smooth mesh's back.
    let n_dot_l = at.normal.dot(lit.direction);
    let lowest = n_dot_l.min(at.geometric_normal.dot(lit.direction));
    if lowest <= 0.0 {
        return Err(Absence::FacingAway { n_dot_l: lowest });
    }
    if lit.intensity.is_black() {
        let cos_angle = lit.cos_angle;
        return Err(Absence::OutsideCone { cos_angle });
    }
    let ray = Ray::new(at.origin_towards(lit.direction), lit.direction);
    Ok(Question { ray, lit, n_dot_l })
}

/// What a surface does with a ray that arrived: the two directions and their shares.
struct Split {
    reflected: Rgb,
    transmitted: Rgb,
    /// The refracted direction, or the negative k of total internal reflection.
    refracted: Result<DVec3, f64>,
    /// The media behind the surface.
    beyond: Media,
}

impl<'a, P: Probe> Tracer<'a, P> {
    /// A tracer that has sent no ray yet.
    pub fn new(world: &'a World, settings: &'a Settings, probe: &'a mut P) -> Self {
        Self {
            world,
            settings,
            probe,
            rays: 0,
            cut: false,
        }
    }

    /// A tracer that already sent `rays` rays for this pixel.
    #[must_use]
    pub fn continuing(mut self, rays: u64) -> Self {
        self.rays = rays;
        self
    }

    /// The radiance that arrives at the eye along `ray`, of which something may be foreseen.
    pub fn eye(&mut self, ray: Ray, foreseen: Option<Foreseen>) -> Rgb {
        self.radiance(&Path {
            kind: RayKind::Incident,
            ray,
            depth: 0,
            weight: Rgb::WHITE,
            throughput: Rgb::WHITE,
            media: self.world.eye_media,
            foreseen,
        })
    }

    /// The radiance that comes back along a ray: the shading equation, term by term.
    fn radiance(&mut self, path: &Path) -> Rgb {
        self.send(path);
        let mut sum = Rgb::BLACK;
        let closest = match path.foreseen {
            Some(foreseen) => foreseen.hit,
            None => self.world.closest(&path.ray, self.probe),
        };
        let Some(hit) = closest else {
            self.probe.event(Event::Miss);
            self.add(
                &mut sum,
                Term::Background,
                NONE,
                self.world.scene.background,
            );
            return self.done(sum);
        };
        self.probe.event(Event::Hit(hit));
        let scene = &self.world.scene;
        let material = scene.material_of(hit.primitive);
        let at = scene.interaction(&path.ray, &hit);

        // What the surface sends out itself, and its share of the light that is everywhere.
        if !material.emission.is_black() {
            self.add(&mut sum, Term::Emission, NONE, material.emission);
        }
        let ambient = phong::ambient(material.ambient_at(at.uv), scene.ambient);
        if !ambient.is_black() {
            self.add(&mut sum, Term::Ambient, NONE, ambient);
        }
        // What each light adds, unless something stands in its way.
        for light in 0..scene.lights.len() as u32 {
            self.light(&mut sum, path, &at, material, light);
        }
        // What comes from the mirrored and from the refracted direction.
        let object = scene.owners[hit.primitive as usize];
        let split = self.split(path, &at, material, object);
        self.reflect(&mut sum, path, &at, &split);
        self.transmit(&mut sum, path, &at, &split);
        self.done(sum)
    }

    /// One light: a shadow ray to it, and if that arrives the diffuse and the specular term.
    fn light(&mut self, sum: &mut Rgb, path: &Path, at: &Interaction, m: &Material, light: u32) {
        let asked = shadow_question(&self.world.scene, at, m, light).and_then(|question| {
            if self.out_of_rays() {
                Err(Absence::RayBudget)
            } else {
                Ok(question)
            }
        });
        let question = match asked {
            Ok(question) => question,
            Err(reason) => {
                return self.probe.event(Event::Absent {
                    kind: RayKind::Light,
                    light,
                    reason,
                });
            }
        };
        if self.shadowed(path, light, &question) {
            return;
        }
        let Question { lit, n_dot_l, .. } = question;
        let diffuse = phong::diffuse(m.diffuse_at(at.uv), lit.intensity, n_dot_l);
        self.add(sum, Term::Diffuse, light, diffuse);
        if !m.specular.is_black() {
            let r = optics::reflect(-lit.direction, at.normal);
            let r_dot_v = r.dot(at.to_viewer);
            let specular = phong::specular(m.specular, lit.intensity, r_dot_v, m.shininess);
            self.add(sum, Term::Specular, light, specular);
        }
    }

    /// Sends a shadow ray: true if anything stands before the light. Transparent things block it as well.
    fn shadowed(&mut self, path: &Path, light: u32, question: &Question) -> bool {
        let Question { ray, lit, .. } = question;
        self.rays += 1;
        let foreseen = path.foreseen.and_then(|f| f.blocked[light as usize]);
        if let Some(blocked) = foreseen {
            return blocked;
        }
        self.probe.event(Event::Ray(RaySent {
            kind: RayKind::Light,
            depth: path.depth + 1,
            light,
            medium: path.media.current(),
            origin: ray.origin,
            direction: ray.direction,
            t_max: lit.distance,
            weight: Rgb::WHITE,
        }));
        let blocker = self.world.blocker(ray, lit.distance, self.probe);
        self.probe.event(blocker.map_or(Event::Lit, Event::Blocked));
        self.probe.event(Event::Return {
            radiance: Rgb::BLACK,
        });
        blocker.is_some()
    }

    /// How the surface shares light between reflection and transmission.
    ///
    /// A transparent surface reflects the share F of what it would let through (Fresnel): Wr = Kr + F Kt,
    /// Wt = (1 - F) Kt. Under total internal reflection F is 1, in every model.
    fn split(&mut self, path: &Path, at: &Interaction, m: &Material, object: u32) -> Split {
        if !m.is_transmissive() {
            return Split {
                reflected: m.mirror,
                transmitted: Rgb::BLACK,
                refracted: Err(0.0),
                beyond: path.media,
            };
        }
        let scene = &self.world.scene;
        let outside = path.media.left(object);
        let (n1, n2, beyond) = match at.side {
            Side::Front => {
                let n1 = scene.medium_ior(path.media.current());
                (n1, m.ior, path.media.entered(object))
            }
            Side::Back => (m.ior, scene.medium_ior(outside.current()), outside),
        };
        let refracted = optics::refract(-at.to_viewer, at.normal, n1, n2);
        let share = refracted.map_or(1.0, |t| {
            let (cos_i, cos_t) = (at.normal.dot(at.to_viewer), -at.normal.dot(t));
            self.settings.fresnel.reflectance(cos_i, cos_t, n1, n2)
        });
        self.probe.event(Event::Boundary {
            n1,
            n2,
            reflectance: share,
        });
        Split {
            reflected: m.mirror + m.transmission * share,
            transmitted: m.transmission * (1.0 - share),
            refracted,
            beyond,
        }
    }

    /// The reflected ray, if there is one: adds Wr radiance(R).
    fn reflect(&mut self, sum: &mut Rgb, path: &Path, at: &Interaction, split: &Split) {
        let direction = optics::reflect(-at.to_viewer, at.normal);
        let n_dot_r = at.geometric_normal.dot(direction);
        let absence = if split.reflected.is_black() {
            Some(Absence::NoReflection)
        } else if n_dot_r <= 0.0 {
            Some(Absence::BelowSurface { n_dot_r })
        } else {
            None
        };
        let way = absence.map_or(Ok((direction, path.media)), Err);
        self.follow(sum, path, at, RayKind::Reflected, split.reflected, way);
    }

    /// The transmitted ray, if there is one: adds Wt radiance(T).
    fn transmit(&mut self, sum: &mut Rgb, path: &Path, at: &Interaction, split: &Split) {
        let way = match split.refracted {
            Err(k) if k < 0.0 => Err(Absence::TotalInternalReflection { k }),
            _ if split.transmitted.is_black() => Err(Absence::NoTransmission),
            Err(_) => Err(Absence::NoTransmission),
            Ok(direction) => {
                // Through a surface means to the other side of it, by the geometric normal.
                let n_dot_r = at.geometric_normal.dot(direction);
                if n_dot_r < 0.0 {
                    Ok((direction, split.beyond))
                } else {
                    Err(Absence::BelowSurface { n_dot_r })
                }
            }
        };
        self.follow(sum, path, at, RayKind::Transmitted, split.transmitted, way);
    }

    /// Follows a secondary ray that physics allows, unless a limit forbids it: adds weight x its radiance.
    fn follow(
        &mut self,
        sum: &mut Rgb,
        path: &Path,
        at: &Interaction,
        kind: RayKind,
        weight: Rgb,
        way: Result<(DVec3, Media), Absence>,
    ) {
        let throughput = path.throughput * weight;
        let allowed = way.and_then(|way| self.within_limits(path.depth, throughput).map(|()| way));
        match allowed {
            Err(reason) => self.probe.event(Event::Absent {
                kind,
                light: NONE,
                reason,
            }),
            Ok((direction, media)) => {
                let radiance = self.radiance(&Path {
                    kind,
                    ray: Ray::new(at.origin_towards(direction), direction),
                    depth: path.depth + 1,
                    weight,
                    throughput,
                    media,
                    foreseen: None,
                });
                *sum += weight * radiance;
            }
        }
    }

    /// The three ends of recursion besides a miss: depth, weight and budget.
    fn within_limits(&mut self, depth: u32, throughput: Rgb) -> Result<(), Absence> {
        if depth >= self.settings.depth {
            return Err(Absence::DepthLimit);
        }
        let weight = throughput.max_channel();
        if weight < self.settings.min_weight {
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
        let out = self.rays >= self.settings.rays_per_pixel();
        self.cut |= out;
        out
    }

    /// Tells of a ray that sets out.
    fn send(&mut self, path: &Path) {
        self.rays += 1;
        self.probe.event(Event::Ray(RaySent {
            kind: path.kind,
            depth: path.depth,
            light: NONE,
            medium: path.media.current(),
            origin: path.ray.origin,
            direction: path.ray.direction,
            t_max: f64::INFINITY,
            weight: path.weight,
        }));
    }

    /// Adds a term to the sum, and tells of it.
    fn add(&mut self, sum: &mut Rgb, term: Term, light: u32, value: Rgb) {
        *sum += value;
        self.probe.event(Event::Term { term, light, value });
    }

    /// Tells of a ray that is done.
    fn done(&mut self, radiance: Rgb) -> Rgb {
        self.probe.event(Event::Return { radiance });
        radiance
    }
}
