//! World: a scene with the acceleration structure over it, and the media that its rays travel in.

pub mod checks;
mod closed;
mod contact;
pub mod interface;
pub mod medium;
mod neighbour;
mod rank;
mod ray_budget;
mod ray_cuts;
mod shells;

use crate::accel::{Accel, AccelKind, Progress, further_hits};
use crate::geometry::{Hit, Shear};
use crate::math::{Interval, Ray};
use crate::probe::{NONE, Probe, counting};
use crate::scene::{Object, Scene, Settings};
use crate::shading::Interaction;
use contact::{Contacts, contacts};
use medium::medium;
use neighbour::is_clear;

pub use contact::Contact;
pub use interface::{Interface, NextHit, Surface};
pub use medium::{Crossing, OpenMedia};
pub use ray_budget::RayBudget;
pub use ray_cuts::RayCuts;

/// Scene and the acceleration structure over it: what can be traced.
#[derive(Clone, Debug)]
pub struct World {
    /// The scene.
    pub scene: Scene,
    /// The structure over its shapes.
    pub accel: Accel,
    /// True if an object asks for a shading model.
    names_models: bool,
    /// True if anything is transparent.
    has_media: bool,
    /// How each object is in contact with media.
    contacts: Contacts,
    /// Which objects are transparent and bound no part of space: see [`OpenMedia`].
    open: Vec<bool>,
    /// Which object a point is in, where they overlap: see `world/rank.rs`.
    ranks: Vec<u32>,
    /// The open objects that the eye is inside of.
    pub around_eye: OpenMedia,
}

/// Scratch for crossings that is used again and again.
#[derive(Debug, Default)]
pub struct Scratch {
    hits: Vec<Hit>,
    crossings: Vec<Crossing>,
}

impl World {
    /// Builds the acceleration structure.
    pub fn new(scene: Scene, kind: AccelKind) -> Self {
        Self::watched(scene, kind, &|_| ())
    }

    /// Builds the acceleration structure, and reports its progress.
    pub fn watched(scene: Scene, kind: AccelKind, progress: Progress) -> Self {
        let accel = Accel::build_with_progress(kind, &scene.shapes, progress);
        let is_medium = |o: &Object| scene.materials[o.material as usize].is_transmissive();
        let open: Vec<bool> = (0u32..)
            .zip(&scene.objects)
            .map(|(i, o)| is_medium(o) && !closed::is_closed(scene.shapes_of(i)))
            .collect();
        let contacts = contacts(&scene);
        let has_media = contacts.of.iter().any(|c| *c != Contact::None);
        let ranks = if has_media {
            rank::ranks(&scene, &open)
        } else {
            Vec::new()
        };
        let mut world = Self {
            names_models: scene.names_models(),
            scene,
            accel,
            has_media,
            contacts,
            ranks,
            open,
            around_eye: OpenMedia::NOTHING,
        };
        world.around_eye = world.entered_by_eye();
        world
    }

    /// The open objects that the eye is inside of, as far as can be told: those that the straight line ahead leaves without
    /// having entered them. Outermost first, so those left last are put in first.
    fn entered_by_eye(&self) -> OpenMedia {
        let mut around = OpenMedia::NOTHING;
        if self.open.contains(&true) {
            let camera = &self.scene.camera;
            let line = Ray::new(camera.eye, -camera.frame.w);
            let crossings = self.crossings(&line, Interval::FORWARD);
            for (i, crossing) in crossings.iter().enumerate().rev() {
                let before = &crossings[..i];
                let met = before.iter().any(|c| c.object == crossing.object);
                if crossing.enters == Some(false) && self.is_open(crossing.object) && !met {
                    around = around.and(crossing.object);
                }
            }
        }
        around
    }

    /// True if triangles are shaded by a model that the settings or an object name.
    pub fn shades_by_model(&self, settings: &Settings) -> bool {
        self.names_models || settings.shading.is_some()
    }

    /// True if an object is transparent and bounds no part of space.
    pub fn is_open(&self, object: u32) -> bool {
        self.open[object as usize]
    }

    /// Contact with media of the object that a primitive belongs to.
    #[inline]
    pub fn contact(&self, primitive: u32) -> Contact {
        if counting::REFRACTION && self.has_media {
            self.contacts.of[self.scene.owners[primitive as usize] as usize]
        } else {
            Contact::None
        }
    }

    /// The closest hit of a ray behind t = `from`.
    pub fn closest<P: Probe>(&self, ray: &Ray, from: f64, probe: &mut P) -> Option<Hit> {
        let interval = Interval::new(from, f64::INFINITY);
        self.accel.closest(&self.scene.shapes, ray, interval, probe)
    }

    /// An occluder: something that stands on the ray before `distance`.
    pub fn occluder<P: Probe>(&self, ray: &Ray, distance: f64, probe: &mut P) -> Option<Hit> {
        let interval = Interval::before(distance);
        self.accel.any_hit(&self.scene.shapes, ray, interval, probe)
    }

    /// Every surface that a ray crosses inside an interval, by t.
    pub fn crossings(&self, ray: &Ray, interval: Interval) -> Vec<Crossing> {
        let mut scratch = Scratch::default();
        let shapes = &self.scene.shapes;
        let hits = &mut scratch.hits;
        self.accel.all_hits_into(hits, shapes, ray, interval);
        self.describe(ray, &mut scratch);
        scratch.crossings
    }

    /// What a ray crosses from its closest `hit` on, as far as that object's media depend on it.
    pub fn crossings_from<'r>(
        &self,
        ray: &Ray,
        (hit, at): (&Hit, &Interaction),
        scratch: &'r mut Scratch,
    ) -> &'r [Crossing] {
        let interval = Interval::new(hit.t.next_down(), f64::INFINITY);
        let (shapes, hits) = (&self.scene.shapes, &mut scratch.hits);
        let object = self.scene.owners[hit.primitive as usize] as usize;
        let is_alone = match self.contact(hit.primitive) {
            Contact::Isolated => true,
            Contact::Resting => is_clear(&self.contacts.neighbours[object], ray, hit.t, at),
            Contact::None | Contact::Touching => false,
        };
        if is_alone {
            hits.clear();
            hits.push(*hit);
            further_hits(shapes, ray, hit, interval, hits);
        } else {
            self.accel.all_hits_into(hits, shapes, ray, interval);
        }
        self.describe(ray, scratch);
        &scratch.crossings
    }

    /// What objects are crossed where, and whether the ray goes in or comes out.
    fn describe(&self, ray: &Ray, scratch: &mut Scratch) {
        let scene = &self.scene;
        let shear = Shear::new(ray);
        scratch.crossings.clear();
        scratch.crossings.extend(scratch.hits.iter().map(|hit| {
            let shape = &scene.shapes[hit.primitive as usize];
            let is_medium = scene.material_of(hit.primitive).is_transmissive();
            Crossing {
                hit: *hit,
                object: scene.owners[hit.primitive as usize],
                enters: is_medium
                    .then(|| shape.enters(ray, &shear, hit.t))
                    .flatten(),
            }
        }));
    }

    /// The medium before `ahead`, the crossings that a ray is going to meet: an object, or [`NONE`] for air.
    #[inline(always)]
    pub fn medium(&self, entered: &OpenMedia, ahead: &[Crossing]) -> u32 {
        medium(entered, ahead, |object| self.ranks[object as usize])
    }

    /// The medium where `ray` starts: an object, or [`NONE`] for air.
    pub fn medium_at_start(&self, ray: &Ray, entered: &OpenMedia) -> u32 {
        if self.has_media {
            self.medium(entered, &self.crossings(ray, Interval::FORWARD))
        } else {
            NONE
        }
    }
}
