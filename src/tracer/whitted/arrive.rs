//! Where a ray arrives: at the first surface that changes anything.

use super::{Path, Tracer};
use crate::geometry::Hit;
use crate::math::Ray;
use crate::probe::{Event, NONE, Probe};
use crate::shading::{Entered, Interaction};
use crate::tracer::boundary::{Boundary, Change};

/// Where a ray arrived.
pub struct Arrival {
    pub hit: Hit,
    pub at: Interaction,
    /// What changes there, if the surface is transparent.
    pub change: Option<Change>,
}

impl<P: Probe> Tracer<'_, P> {
    /// The first surface that counts. Those that change no medium are passed, and the path knows of it; each costs as much
    /// as a ray and counts as one.
    pub(super) fn arrive(&mut self, path: &mut Path) -> Option<Arrival> {
        let mut closest = match path.foreseen {
            Some(foreseen) => foreseen.hit,
            None => self.world.closest(&path.ray, 0.0, self.probe),
        }?;
        loop {
            let scene = &self.world.scene;
            let at = scene.interaction(&path.ray, &closest);
            let material = scene.material_of(closest.primitive);
            // Where nothing goes on, nothing can be out of step. (A mirror may touch a medium.)
            let goes_on = material.is_transmissive() || !material.mirror.is_black();
            if !(self.world.has_media && goes_on) {
                let (hit, change) = (closest, None);
                return Some(Arrival { hit, at, change });
            }
            let crossed = Boundary::new(self.world, path.entered, &path.ray, &closest, at);
            if crossed.surfaces > 1 {
                // What was foreseen was for one surface.
                path.foreseen = None;
            }
            let material = scene.material_of(crossed.hit.primitive);
            if crossed.counts(material) || self.out_of_rays() {
                return Some(Arrival {
                    hit: crossed.hit,
                    at: crossed.at,
                    change: material.is_transmissive().then_some(crossed.change),
                });
            }
            let (hit, medium) = (crossed.hit, crossed.change.media[0]);
            self.probe.event(Event::Passed { hit, medium });
            self.rays += 1;
            path.entered = crossed.change.entered;
            path.foreseen = None;
            closest = self.world.closest(&path.ray, crossed.end, self.probe)?;
        }
    }

    /// The medium where `ray` starts, for those who listen.
    pub(super) fn medium(&self, ray: &Ray, entered: &Entered) -> u32 {
        if P::LISTENS {
            self.world.medium_at_start(ray, entered)
        } else {
            NONE
        }
    }
}
