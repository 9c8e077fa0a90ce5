//! Every place where a ray crosses a shape, not only the first: what media, parity and sums over a whole line ask for.

use super::Accel;
use crate::geometry::{Hit, Intersection, Shape, Shear};
use crate::math::{Interval, Ray};
use crate::probe::{Event, Probe};

/// Writes down what is crossed.
struct Crossed<'a>(&'a mut Vec<Hit>);

impl Probe for Crossed<'_> {
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
        let mut hits = Vec::new();
        self.crossings_into(&mut hits, shapes, ray, interval);
        hits
    }

    /// The same in the place of what was in `hits`.
    pub fn crossings_into(
        &self,
        hits: &mut Vec<Hit>,
        shapes: &[Shape],
        ray: &Ray,
        interval: Interval,
    ) {
        hits.clear();
        self.closest(shapes, ray, interval, &mut Crossed(hits));
        let in_order = |a: &Hit, b: &Hit| a.t.total_cmp(&b.t).then(a.primitive.cmp(&b.primitive));
        hits.sort_unstable_by(in_order);
        // A tree may refer to a primitive from many leaves.
        hits.dedup();
        let once = hits.len();
        for i in 0..once {
            let second = second(shapes, ray, &hits[i], interval);
            hits.extend(second);
        }
        if hits.len() > once {
            hits.sort_unstable_by(in_order);
        }
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
