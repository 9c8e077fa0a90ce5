//! Sixteen rays through a tree together: rays that start close to each other and go the same way meet the same nodes
//! and the same shapes, so each of these is fetched once and tested against all with the same instructions.
//!
//! Source: Wald, Slusallek, Benthin and Wagner 2001, "Interactive rendering with coherent ray tracing".
//!
//! A tree only says how it is followed ([`Follow`]). The rays ([`Rays`]) and what they hit ([`Hits`]) are the same for
//! all trees. Rays that do not go together are followed one by one; the answers are the same.

mod decide;
mod hits;
mod outline;
mod rays;

pub use hits::{Hits, each};
pub use outline::Outline;
pub use rays::{RAYS, Rays, Row, folded};

use super::Accel;
use super::local::Frame;
use super::simd::{Isa, Level, Task};
use crate::geometry::{Hit, Shape};
use crate::math::{Interval, Ray};
use crate::probe::Silent;

/// A tree that can be followed by many rays at once.
pub trait Follow {
    /// Room for what waits on the way; made once for many packets, since clearing it takes as long as a box or two.
    type Waiting: Default;

    /// The space that the tree is in; `None` if it is not followed together.
    fn frame(&self) -> Option<&Frame>;

    /// What is outside the tree and tested first.
    fn outside(&self) -> &[u32];

    /// The instructions to follow it with.
    fn isa(&self) -> Isa;

    /// Brings all shapes to `hits` that rays may hit before they end, the nearest first as far as the tree knows.
    fn follow<const ANY: bool, L: Level>(
        &self,
        level: L,
        rays: &mut Rays,
        hits: &mut Hits,
        waiting: &mut Self::Waiting,
    );
}

impl Accel {
    /// Whether asking for many rays at once is quicker than one by one.
    pub fn gains_from_bundles(&self) -> bool {
        match self {
            Self::Wide(_) => true,
            Self::Planes(planes) => planes.frame().is_some(),
            Self::Bsp(bsp) => bsp.rounded().is_some(),
            _ => false,
        }
    }

    /// The closest hits of many rays, each inside its own interval: what [`Accel::closest`] says of each. Rays that
    /// start close to each other and go the same way should stand next to each other; that is what makes it fast.
    /// Answers as many as both slices have room for.
    pub fn closest_many(
        &self,
        shapes: &[Shape],
        rays: &[(Ray, Interval)],
        out: &mut [Option<Hit>],
    ) {
        match self {
            Self::Wide(wide) => self.closest_together(wide, shapes, rays, out),
            Self::Planes(planes) => self.closest_together(planes, shapes, rays, out),
            Self::Bsp(bsp) => match bsp.rounded() {
                Some(planes) => self.closest_together(planes, shapes, rays, out),
                None => self.closest_each(shapes, rays, out),
            },
            _ => self.closest_each(shapes, rays, out),
        }
    }

    /// Whether each of many rays hits anything inside its interval, as [`Accel::any`] says; in the same order.
    pub fn any_many(&self, shapes: &[Shape], rays: &[(Ray, Interval)], out: &mut [bool]) {
        match self {
            Self::Wide(wide) => self.any_together(wide, shapes, rays, out),
            Self::Planes(planes) => self.any_together(planes, shapes, rays, out),
            Self::Bsp(bsp) => match bsp.rounded() {
                Some(planes) => self.any_together(planes, shapes, rays, out),
                None => self.any_each(shapes, rays, out),
            },
            _ => self.any_each(shapes, rays, out),
        }
    }

    fn closest_each(&self, shapes: &[Shape], rays: &[(Ray, Interval)], out: &mut [Option<Hit>]) {
        for ((ray, interval), out) in rays.iter().zip(out) {
            *out = self.closest(shapes, ray, *interval, &mut Silent);
        }
    }

    fn any_each(&self, shapes: &[Shape], rays: &[(Ray, Interval)], out: &mut [bool]) {
        for ((ray, interval), out) in rays.iter().zip(out) {
            *out = self.any(shapes, ray, *interval, &mut Silent).is_some();
        }
    }

    fn closest_together<T: Follow>(
        &self,
        tree: &T,
        shapes: &[Shape],
        rays: &[(Ray, Interval)],
        out: &mut [Option<Hit>],
    ) {
        let room = &mut Room::default();
        for (rays, out) in rays.chunks(RAYS).zip(out.chunks_mut(RAYS)) {
            let rays = &rays[..rays.len().min(out.len())];
            if together::<false, T>(tree.isa(), tree, shapes, rays, out, room).is_none() {
                self.closest_each(shapes, rays, out);
            }
        }
    }

    fn any_together<T: Follow>(
        &self,
        tree: &T,
        shapes: &[Shape],
        rays: &[(Ray, Interval)],
        out: &mut [bool],
    ) {
        let (room, best) = (&mut Room::default(), &mut [None; RAYS]);
        for (rays, out) in rays.chunks(RAYS).zip(out.chunks_mut(RAYS)) {
            let rays = &rays[..rays.len().min(out.len())];
            match together::<true, T>(tree.isa(), tree, shapes, rays, best, room) {
                Some(found) => {
                    for (i, out) in out.iter_mut().enumerate() {
                        *out = found >> i & 1 == 1;
                    }
                }
                None => self.any_each(shapes, rays, out),
            }
        }
    }
}

/// The mask of rays that hit something, if any hit will do; else their hits are in `best`. `None`, and nothing done, if
/// the rays do not go together.
#[inline]
fn together<const ANY: bool, T: Follow>(
    isa: Isa,
    tree: &T,
    shapes: &[Shape],
    rays: &[(Ray, Interval)],
    best: &mut [Option<Hit>],
    room: &mut Room<T::Waiting>,
) -> Option<u32> {
    let frame = tree.frame()?;
    isa.run(Together::<ANY, T> {
        tree,
        frame,
        shapes,
        rays,
        best,
        room,
    })
}

/// Room for packets, made once for many.
#[derive(Default)]
struct Room<W> {
    rays: Rays,
    waiting: W,
}

struct Together<'a, const ANY: bool, T: Follow> {
    tree: &'a T,
    frame: &'a Frame,
    shapes: &'a [Shape],
    rays: &'a [(Ray, Interval)],
    best: &'a mut [Option<Hit>],
    room: &'a mut Room<T::Waiting>,
}

impl<const ANY: bool, T: Follow> Task for Together<'_, ANY, T> {
    type Output = Option<u32>;

    #[inline(always)]
    fn run<L: Level>(self, level: L) -> Option<u32> {
        let Room { rays, waiting } = self.room;
        if !rays.set(level, self.frame, self.rays) {
            return None;
        }
        self.best.fill(None);
        let mut hits = Hits::new(self.shapes, self.rays, self.best);
        for &primitive in self.tree.outside() {
            for i in 0..self.rays.len().min(RAYS) {
                hits.test::<ANY>(rays, i, primitive);
            }
        }
        self.tree.follow::<ANY, L>(level, rays, &mut hits, waiting);
        hits.decide(level, rays);
        Some(hits.found)
    }
}

#[cfg(test)]
pub(super) mod tests;
