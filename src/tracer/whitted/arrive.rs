//! Where a ray arrives: at the first surface that changes anything.

use super::{Path, Tracer};
use crate::geometry::Hit;
use crate::math::Ray;
use crate::probe::{Event, NONE, Probe};
use crate::scene::Company;
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
    #[inline]
    pub(super) fn arrive(&mut self, path: &mut Path) -> Option<Arrival> {
        let hit = match path.foreseen {
            Some(foreseen) => foreseen.hit,
            None => self.world.closest(&path.ray, 0.0, self.probe),
        }?;
        let mut arrival = self.at(path, hit);
        if self.world.company(hit.primitive) == Company::Away {
            return Some(arrival);
        }
        while let Some(end) = self.cross(path, &mut arrival) {
            let hit = self.world.closest(&path.ray, end, self.probe)?;
            arrival = self.at(path, hit);
        }
        Some(arrival)
    }

    fn at(&self, path: &Path, hit: Hit) -> Arrival {
        Arrival {
            hit,
            at: self.world.scene.interaction(&path.ray, &hit),
            change: None,
        }
    }

    /// What changes at the closest surface and at all that touch it. If it is nothing, they are passed: the t of the last.
    #[inline(never)]
    fn cross(&mut self, path: &mut Path, arrival: &mut Arrival) -> Option<f64> {
        if self.world.company(arrival.hit.primitive) == Company::Away {
            return None;
        }
        let Arrival { hit, at, .. } = arrival;
        let crossed = Boundary::new(self.world, path.entered, &path.ray, hit, at);
        if crossed.many {
            // What was foreseen was for one surface.
            path.foreseen = None;
            (arrival.hit, arrival.at) = (crossed.hit, crossed.at);
        }
        let material = self.world.scene.material_of(arrival.hit.primitive);
        if !material.is_transmissive() {
            return None;
        }
        let [medium, behind] = crossed.change.media;
        if medium != behind || self.out_of_rays() {
            arrival.change = Some(crossed.change);
            return None;
        }
        let hit = arrival.hit;
        self.probe.event(Event::Passed { hit, medium });
        self.rays += 1;
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
