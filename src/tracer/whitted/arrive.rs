//! Where a ray arrives: at the first surface that changes anything.

use super::{Path, Tracer};
use crate::geometry::Hit;
use crate::math::Ray;
use crate::probe::{Event, NONE, Probe, tell};
use crate::shading::Interaction;
use crate::world::Company;
use crate::world::Entered;
use crate::world::interface::{Boundary, Change};

/// Where a ray arrived.
pub struct Arrival {
    pub hit: Hit,
    pub at: Interaction,
    /// What changes there, if the surface is transparent.
    pub change: Option<Change>,
}

impl<P: Probe> Tracer<'_, P> {
    /// From the closest hit on, the first surface that counts. Those that change no medium are passed, and the path knows of
    /// it; each costs as much as a ray and counts as one.
    #[inline(never)]
    pub(super) fn arrive(&mut self, path: &mut Path, hit: Hit, at: Interaction) -> Option<Arrival> {
        let change = None;
        let mut arrival = Arrival { hit, at, change };
        while let Some(end) = self.pass(path, &mut arrival) {
            arrival.hit = self.world.closest(&path.ray, end, self.probe)?;
            arrival.at = self.world.scene.interaction(&path.ray, &arrival.hit);
        }
        Some(arrival)
    }

    /// What changes at the closest surface and at all that touch it. If it is nothing, they are passed: the t of the last.
    fn pass(&mut self, path: &mut Path, arrival: &mut Arrival) -> Option<f64> {
        let Arrival { hit, at, .. } = &*arrival;
        if self.world.company(hit.primitive) == Company::Away {
            return None;
        }
        let (world, room) = (self.world, &mut self.room);
        let crossed = Boundary::new(world, path.entered, &path.ray, (hit, at), room);
        if crossed.many {
            // What was foreseen was for one surface.
            path.foreseen = None;
            (arrival.hit, arrival.at) = (crossed.hit, crossed.at);
        }
        if !world
            .scene
            .material_of(arrival.hit.primitive)
            .is_transmissive()
        {
            return None;
        }
        let [medium, behind] = crossed.change.media;
        if medium != behind || self.out_of_rays() {
            arrival.change = Some(crossed.change);
            return None;
        }
        let hit = arrival.hit;
        tell!(self.probe, Event::Passed { hit, medium });
        self.rays += 1;
        self.spent += 1;
        path.entered = crossed.change.entered;
        path.foreseen = None;
        Some(crossed.end)
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
