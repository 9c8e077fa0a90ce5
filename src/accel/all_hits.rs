//! All hits of a ray, not only the closest: for media, parity and sums along a whole line.

use super::Accel;
use super::collect::AllHits;
use crate::geometry::{Hit, Intersection, Shape, Shear};
use crate::math::{Interval, Ray};
use crate::probe::Silent;

impl Accel {
    /// All hits of `ray` inside `interval`, by t, and of equal t by primitive id. A solid is crossed an even number of times.
    /// All accelerators agree, bit for bit.
    pub fn all_hits(&self, shapes: &[Shape], ray: &Ray, interval: Interval) -> Vec<Hit> {
        let mut hits = Vec::new();
        self.all_hits_into(&mut hits, shapes, ray, interval);
        hits
    }

    /// Replaces `hits` by all hits of `ray`, as [`Accel::all_hits`] gives them.
    pub fn all_hits_into(
        &self,
        hits: &mut Vec<Hit>,
        shapes: &[Shape],
        ray: &Ray,
        interval: Interval,
    ) {
        hits.clear();
        let query = self.query(shapes, ray, interval);
        self.search(&query, &mut AllHits(hits), &mut Silent);
        let in_order = |a: &Hit, b: &Hit| a.t.total_cmp(&b.t).then(a.primitive.cmp(&b.primitive));
        hits.sort_unstable_by(in_order);
        // A tree may refer to a primitive from many leaves.
        hits.dedup();
        let once = hits.len();
        for i in 0..once {
            let first = hits[i];
            further_hits(shapes, ray, &first, interval, hits);
        }
        if hits.len() > once {
            hits.sort_unstable_by(in_order);
        }
    }
}

/// Adds the hits of a ray with a shape behind the `first`: the exit of a solid, and where it goes in and out again, or where a folded
/// patch is crossed once more.
pub fn further_hits(
    shapes: &[Shape],
    ray: &Ray,
    first: &Hit,
    interval: Interval,
    hits: &mut Vec<Hit>,
) {
    let shape = &shapes[first.primitive as usize];
    if !shape.is_crossed_often() {
        return;
    }
    let shear = Shear::new(ray);
    let mut from = first.t;
    // As often as it is tested; a solid of one span is met once more at most.
    while let Intersection::Hit { t, place, part } =
        shape.intersect(ray, &shear, Interval::new(from, interval.max))
    {
        hits.push(Hit {
            t,
            primitive: first.primitive,
            part,
            place,
        });
        if shape.is_convex() {
            return;
        }
        from = t;
    }
}
