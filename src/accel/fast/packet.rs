//! Packets of sixteen rays: rays that start close to each other and go the same way meet the same nodes and the same
//! shapes, so each of these is fetched once and tested against all rays with the same instructions.
//!
//! Source: Wald, Slusallek, Benthin and Wagner 2001, "Interactive rendering with coherent ray tracing".
//!
//! A tree only says how it is traversed ([`PacketTree`]). The rays ([`RayPacket`]) and what they hit ([`PacketHits`]) are
//! the same for all trees. Rays that are not coherent are traced one by one; the answers are the same.

mod hits;
mod rays;
mod triangle8;
mod triangle_f32;

pub use hits::{PacketHits, set_bits};
pub use rays::{Lanes, PACKET_SIZE, RayPacket, reduce};
pub use triangle_f32::TriangleF32;

use super::local_ray::UnitBox;
use super::simd::{Isa, Level, SimdKernel};
use crate::geometry::{Hit, Shape};
use crate::math::{Interval, Ray};

/// A tree that packets can be traced through.
pub trait PacketTree {
    /// The stack; made once for many packets, since clearing it takes as long as a box or two.
    type Stack: Default;

    /// The space that the tree is in; `None` if packets are not traced through it.
    fn unit_box(&self) -> Option<&UnitBox>;

    /// Shapes without a sharp bound, which are tested first.
    fn unbounded(&self) -> &[u32];

    /// The instructions to traverse it with.
    fn isa(&self) -> Isa;

    /// Brings all shapes to `hits` that rays may hit before they end, the nearest first as far as the tree knows.
    fn trace<const ANY: bool, L: Level>(
        &self,
        level: L,
        rays: &mut RayPacket,
        hits: &mut PacketHits,
        stack: &mut Self::Stack,
    );
}

/// Memory for packets, made once for many.
pub struct PacketScratch<S> {
    rays: RayPacket,
    stack: S,
}

impl<S: Default> PacketScratch<S> {
    /// Memory for the first packet. (A function of its own in every program, so that instructions can be counted.)
    #[inline(never)]
    pub fn new() -> Self {
        Self {
            rays: RayPacket::default(),
            stack: S::default(),
        }
    }
}

/// The mask of rays that hit something, if any hit will do; else their hits are in `best`. `None`, and nothing done, if
/// the rays are not coherent.
#[inline]
pub fn search_packet<const ANY: bool, T: PacketTree>(
    isa: Isa,
    tree: &T,
    shapes: &[Shape],
    rays: &[(Ray, Interval)],
    best: &mut [Option<Hit>],
    scratch: &mut PacketScratch<T::Stack>,
) -> Option<u32> {
    let unit_box = tree.unit_box()?;
    isa.run(Search::<ANY, T> {
        tree,
        unit_box,
        shapes,
        rays,
        best,
        scratch,
    })
}

struct Search<'a, const ANY: bool, T: PacketTree> {
    tree: &'a T,
    unit_box: &'a UnitBox,
    shapes: &'a [Shape],
    rays: &'a [(Ray, Interval)],
    best: &'a mut [Option<Hit>],
    scratch: &'a mut PacketScratch<T::Stack>,
}

impl<const ANY: bool, T: PacketTree> SimdKernel for Search<'_, ANY, T> {
    type Output = Option<u32>;

    #[inline(always)]
    fn run<L: Level>(self, level: L) -> Option<u32> {
        let PacketScratch { rays, stack } = self.scratch;
        if !rays.set(level, self.unit_box, self.rays) {
            return None;
        }
        self.best.fill(None);
        let mut hits = PacketHits::new(self.shapes, self.rays, self.best);
        for &primitive in self.tree.unbounded() {
            for i in 0..self.rays.len().min(PACKET_SIZE) {
                hits.test::<ANY>(rays, i, primitive);
            }
        }
        self.tree.trace::<ANY, L>(level, rays, &mut hits, stack);
        hits.test_kept(level, rays);
        Some(hits.found)
    }
}

#[cfg(test)]
pub(in crate::accel) mod tests;
