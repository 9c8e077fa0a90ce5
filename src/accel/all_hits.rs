//! All hits of a ray, not only the closest: for media, parity and sums along a whole line.

use super::Accel;
use super::collect::AllHits;
use super::query::Query;
use crate::geometry::{Hit, Intersection, Shape, Shear};
use crate::math::{Interval, Ray};
use crate::probe::Silent;

impl Accel {
    /// All hits of `ray` inside `interval`, by t, and of equal t by primitive id. A solid is crossed twice.
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
        let query = Query::new(shapes, ray, interval);
        self.search(&query, &mut AllHits(hits), &mut Silent);
        let in_order = |a: &Hit, b: &Hit| a.t.total_cmp(&b.t).then(a.primitive.cmp(&b.primitive));
        hits.sort_unstable_by(in_order);
        // A tree may refer to a primitive from many leaves.
        hits.dedup();
        let once = hits.len();
        for i in 0..once {
            let exit = exit_of_solid(shapes, ray, &hits[i], interval);
            hits.extend(exit);
        }
        if hits.len() > once {
            hits.sort_unstable_by(in_order);
        }
    }
}

/// Exit of a ray from the solid that it enters at `first`; `None` if that is no solid.
pub fn exit_of_solid(shapes: &[Shape], ray: &Ray, first: &Hit, interval: Interval) -> Option<Hit> {
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
