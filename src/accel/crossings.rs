//! Every place where a ray crosses a shape, not only the first: what media, parity and sums over a whole line ask for.

use super::Accel;
use crate::geometry::{Hit, Intersection, Shape, Shear};
use crate::math::{Interval, Ray};
use crate::probe::{Event, Probe};

/// Writes down what is crossed.
#[derive(Default)]
struct Crossed(Vec<Hit>);

impl Probe for Crossed {
    const TRAVERSAL: bool = false;
    const EVERY: bool = true;

    #[inline]
    fn event(&mut self, _: Event) {}

    #[inline]
    fn crossing(&mut self, hit: Hit) {
        self.0.push(hit);
    }
}

impl Accel {
    /// All crossings of `ray` inside `interval`, by t, and of equal t by primitive id. A solid is crossed twice.
    /// All accelerators say the same, bit for bit.
    pub fn crossings(&self, shapes: &[Shape], ray: &Ray, interval: Interval) -> Vec<Hit> {
        let mut crossed = Crossed::default();
        self.closest(shapes, ray, interval, &mut crossed);
        let Crossed(mut hits) = crossed;
        let in_order = |a: &Hit, b: &Hit| a.t.total_cmp(&b.t).then(a.primitive.cmp(&b.primitive));
        hits.sort_unstable_by(in_order);
        // A tree may refer to a primitive from many leaves.
        hits.dedup();
        let once = hits.len();
        for i in 0..once {
            hits.extend(second(shapes, ray, &hits[i], interval));
        }
        if hits.len() > once {
            hits.sort_unstable_by(in_order);
        }
        hits
    }
}

/// Where a ray comes out of a solid again that it crosses at `first`.
pub fn second(shapes: &[Shape], ray: &Ray, first: &Hit, interval: Interval) -> Option<Hit> {
    let shape = &shapes[first.primitive as usize];
    if !shape.is_solid() {
        return None;
    }
    let rest = Interval::new(first.t, interval.max);
    match shape.intersect(ray, &Shear::new(ray), rest) {
        Intersection::Hit { t, barycentric } => Some(Hit {
            t,
            primitive: first.primitive,
            barycentric,
        }),
        _ => None,
    }
}
