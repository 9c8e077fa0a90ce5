//! Queries of many rays at once, in packets where the structure gains from them.

use super::Accel;
use super::fast::{CompactTree, PACKET_SIZE, PacketScratch, PacketTree, search_packet};
use crate::geometry::{Hit, Shape};
use crate::math::{Interval, Ray};
use crate::probe::Silent;

impl Accel {
    /// Whether many rays at once are quicker than one by one.
    pub fn gains_from_packets(&self) -> bool {
        matches!(self, Self::Bvh8(_)) || self.compact().is_some()
    }

    /// The tree in single precision that packets are traced through, if there is one.
    fn compact(&self) -> Option<&CompactTree> {
        match self {
            Self::Compact(tree) => tree.unit_box().is_some().then_some(tree),
            Self::Bsp(_, compact) => compact.as_deref(),
            _ => None,
        }
    }

    /// The closest hits of many rays, each inside its own interval: those of [`Accel::closest`]. Rays that start close to
    /// each other and go the same way should stand next to each other; that is what makes it fast. Answers as many as
    /// both slices have room for.
    pub fn closest_many(
        &self,
        shapes: &[Shape],
        rays: &[(Ray, Interval)],
        out: &mut [Option<Hit>],
    ) {
        match (self, self.compact()) {
            (Self::Bvh8(bvh8), _) => self.closest_packets(bvh8, shapes, rays, out),
            (_, Some(tree)) => self.closest_packets(tree, shapes, rays, out),
            _ => self.closest_each(shapes, rays, out),
        }
    }

    /// Whether each of many rays hits anything inside its interval, as [`Accel::any_hit`] finds; in the same order.
    pub fn occluded_many(&self, shapes: &[Shape], rays: &[(Ray, Interval)], out: &mut [bool]) {
        match (self, self.compact()) {
            (Self::Bvh8(bvh8), _) => self.occluded_packets(bvh8, shapes, rays, out),
            (_, Some(tree)) => self.occluded_packets(tree, shapes, rays, out),
            _ => self.occluded_each(shapes, rays, out),
        }
    }

    fn closest_each(&self, shapes: &[Shape], rays: &[(Ray, Interval)], out: &mut [Option<Hit>]) {
        for ((ray, interval), out) in rays.iter().zip(out) {
            *out = self.closest(shapes, ray, *interval, &mut Silent);
        }
    }

    fn occluded_each(&self, shapes: &[Shape], rays: &[(Ray, Interval)], out: &mut [bool]) {
        for ((ray, interval), out) in rays.iter().zip(out) {
            *out = self.any_hit(shapes, ray, *interval, &mut Silent).is_some();
        }
    }

    fn closest_packets<T: PacketTree>(
        &self,
        tree: &T,
        shapes: &[Shape],
        rays: &[(Ray, Interval)],
        out: &mut [Option<Hit>],
    ) {
        let scratch = &mut PacketScratch::new();
        for (rays, out) in rays.chunks(PACKET_SIZE).zip(out.chunks_mut(PACKET_SIZE)) {
            let rays = &rays[..rays.len().min(out.len())];
            if search_packet::<false, T>(tree.isa(), tree, shapes, rays, out, scratch).is_none() {
                self.closest_each(shapes, rays, out);
            }
        }
    }

    fn occluded_packets<T: PacketTree>(
        &self,
        tree: &T,
        shapes: &[Shape],
        rays: &[(Ray, Interval)],
        out: &mut [bool],
    ) {
        let (scratch, best) = (&mut PacketScratch::new(), &mut [None; PACKET_SIZE]);
        for (rays, out) in rays.chunks(PACKET_SIZE).zip(out.chunks_mut(PACKET_SIZE)) {
            let rays = &rays[..rays.len().min(out.len())];
            match search_packet::<true, T>(tree.isa(), tree, shapes, rays, best, scratch) {
                Some(found) => {
                    for (i, out) in out.iter_mut().enumerate() {
                        *out = found >> i & 1 == 1;
                    }
                }
                None => self.occluded_each(shapes, rays, out),
            }
        }
    }
}
