//! Every place where a ray crosses a shape, not only the first: what media, parity and sums over a whole line ask for.

use super::Accel;
use crate::geometry::{Hit, Intersection, Shape, Shear};
use crate::math::{Interval, Ray};
use crate::probe::{Event, Probe, Verdict};

/// Writes down which primitives are crossed.
#[derive(Default)]
struct Crossed(Vec<u32>);

impl Probe for Crossed {
    const TRAVERSAL: bool = true;
    const EVERY: bool = true;

    fn event(&mut self, event: Event) {
        if let Event::Test {
            primitive,
            verdict: Verdict::Hit,
            ..
        } = event
        {
            self.0.push(primitive);
        }
    }
}

impl Accel {
    /// All crossings of `ray` inside `interval`, by t, and of equal t by primitive id. A solid is crossed twice.
    /// All accelerators say the same, bit for bit.
    pub fn crossings(&self, shapes: &[Shape], ray: &Ray, interval: Interval) -> Vec<Hit> {
        let mut crossed = Crossed::default();
        self.closest(shapes, ray, interval, &mut crossed);
        // A tree may refer to a primitive from many leaves.
        let mut primitives = crossed.0;
        primitives.sort_unstable();
        primitives.dedup();
        let shear = Shear::new(ray);
        let mut hits = Vec::with_capacity(primitives.len());
        for primitive in primitives {
            let mut rest = interval;
            while let Intersection::Hit { t, barycentric } =
                shapes[primitive as usize].intersect(ray, &shear, rest)
            {
                hits.push(Hit {
                    t,
                    primitive,
                    barycentric,
                });
                rest.min = t;
            }
        }
        hits.sort_by(|a, b| a.t.total_cmp(&b.t).then(a.primitive.cmp(&b.primitive)));
        hits
    }
}
