//! Events that the tracer tells its probe, beside the sums that they are about.

use super::whitted::{Path, Tracer};
use crate::math::Rgb;
use crate::probe::{Absence, Event, NONE, Probe, RayKind, RayRecord, Term, tell};

impl<P: Probe> Tracer<'_, P> {
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

    /// A term, if there is one, is added to the sum.
    #[inline(always)]
    pub(super) fn add(&mut self, sum: &mut Rgb, term: Option<Term>) {
        if let Some(term) = term {
            self.add_light(sum, term, (NONE, 0));
        }
    }

    /// A term of a sample of a light is added to the sum.
    #[inline(always)]
    pub(super) fn add_light(&mut self, sum: &mut Rgb, term: Term, (light, sample): (u32, u32)) {
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
