//! A ray query, and the test of one primitive against it.

use super::collect::Collect;
use super::tolerance::Tolerance;
use super::volume::Volume;
use crate::geometry::{Hit, Intersection, Shape, Shear};
use crate::math::{Interval, Ray};
use crate::probe::{Choice, Event, Probe, Verdict, Visit, tell};

/// A ray with what is computed once for all the tests that it goes through.
#[derive(Clone, Copy, Debug)]
pub struct Query<'a> {
    pub(super) shapes: &'a [Shape],
    /// The ray.
    pub ray: Ray,
    pub(super) shear: Shear,
    /// The part of it that counts.
    pub interval: Interval,
}

impl<'a> Query<'a> {
    /// Prepares `ray` for tests against `shapes`.
    #[inline]
    pub fn new(shapes: &'a [Shape], ray: &Ray, interval: Interval) -> Self {
        Self {
            shapes,
            ray: *ray,
            shear: Shear::new(ray),
            interval,
        }
    }

    /// Prepares `ray` for tests against those of `shapes` that need no view along it: that takes three divisions.
    #[inline]
    pub fn without_view(shapes: &'a [Shape], ray: &Ray, interval: Interval) -> Self {
        Self {
            shapes,
            ray: *ray,
            shear: Shear::NONE,
            interval,
        }
    }

    /// The start of a traversal: tests the `unbounded` primitives, then cuts the ray to the volume of the `root`, grown by
    /// the tolerance. Gives that tolerance in metres and the part of the ray inside; `None` if the search is over.
    #[inline(always)]
    pub fn enter<C: Collect, P: Probe>(
        &self,
        unbounded: &[u32],
        root: Option<Volume>,
        tolerance: &Tolerance,
        found: &mut C,
        probe: &mut P,
    ) -> Option<(f64, Interval)> {
        if self.test_all(unbounded, found, probe) {
            return None;
        }
        let root = root?;
        let tolerance = tolerance.for_origin(self.ray.origin);
        let inside = root.clip(&self.ray, self.interval, tolerance);
        if P::TRAVERSAL && inside.is_none() {
            tell!(probe, Visit::end(0, self.interval, Choice::SkippedOutside));
        }
        inside.map(|inside| (tolerance, inside))
    }

    /// Tests primitives in order; true if the search is over.
    #[inline]
    pub fn test_all<C: Collect, P: Probe>(
        &self,
        primitives: &[u32],
        found: &mut C,
        probe: &mut P,
    ) -> bool {
        for &primitive in primitives {
            self.test(primitive, found, probe);
            if found.is_over() {
                return true;
            }
        }
        false
    }

    /// Tests one primitive. A hit counts if it is closer than the closest one, or as close with a smaller id.
    #[inline]
    pub fn test<C: Collect, P: Probe>(&self, primitive: u32, found: &mut C, probe: &mut P) {
        let shape = &self.shapes[primitive as usize];
        let (verdict, t) = match shape.intersect(&self.ray, &self.shear, self.interval) {
            Intersection::Hit { t, place, part } => {
                let best = found.closest();
                if best.is_none_or(|b| (t, primitive) < (b.t, b.primitive)) {
                    found.add(Hit {
                        t,
                        primitive,
                        part,
                        place,
                    });
                    (Verdict::Hit, t)
                } else {
                    (Verdict::TooFar, t)
                }
            }
            Intersection::Behind(t) => (Verdict::Behind, t),
            Intersection::TooFar(t) => (Verdict::TooFar, t),
            Intersection::Miss => (Verdict::Miss, f64::NAN),
        };
        if P::TRAVERSAL {
            tell!(
                probe,
                Event::Test {
                    primitive,
                    verdict,
                    t,
                }
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::gallery::builtin;
    use crate::scene::load;

    #[test]
    fn shapes_that_need_no_view_are_met_alike_without_one() {
        let mut met = 0;
        for name in builtin::names() {
            let scene = load(name).expect("a scene");
            for i in 0..48 * 36 {
                let film = [f64::from(i % 48) + 0.5, f64::from(i / 48) + 0.5];
                let ray = scene.camera.ray(film, (48, 36));
                for shape in scene.shapes.iter().filter(|shape| !shape.needs_view()) {
                    let seen = shape.intersect(&ray, &Shear::new(&ray), Interval::FORWARD);
                    let unseen = shape.intersect(&ray, &Shear::NONE, Interval::FORWARD);
                    assert_eq!(seen, unseen, "{name}: {shape:?}");
                    met += u32::from(matches!(seen, Intersection::Hit { .. }));
                }
            }
        }
        assert!(met > 10_000, "{met}");
    }
}
