//! A packet of sixteen rays in the tree's space: `UnitBox::localize` for all of them, with the same instructions.

// Plain loops are what becomes vector instructions.
#![allow(clippy::needless_range_loop)]

use crate::accel::fast::local_ray::{
    FAR, FLATTEST, Localized, U, UnitBox, larger, round_up, smaller,
};
use crate::accel::fast::simd::Level;
use crate::math::{Interval, Ray};

/// Rays in a packet.
pub const PACKET_SIZE: usize = 16;

/// Fewer rays are traced one by one.
const FEWEST: usize = 4;

/// The mask of all rays.
pub const ALL: u32 = 0xffff;

/// No ray goes aside faster than this times as fast as along the last axis of the view.
const STEEPEST: f32 = 2.0;

/// A number of each ray.
pub type Lanes<T> = [T; PACKET_SIZE];

/// Coherent rays; numbers as in `LocalRay`.
#[derive(Default)]
pub struct RayPacket {
    pub origin: [Lanes<f32>; 3],
    pub inverse: [Lanes<f32>; 3],
    pub near: [Lanes<f32>; 3],
    pub far: [Lanes<f32>; 3],
    pub min: Lanes<f32>,
    /// Less than min for rays that are done with.
    pub max: Lanes<f32>,
    /// x' = x - s.x z and y' = y - s.y z, in the order of the view.
    pub slope: [Lanes<f32>; 2],
    start: Lanes<f64>,
    rate: Lanes<f64>,
    pub world: WorldRays,
    /// The largest of all.
    pub pad: f32,
    /// Shared by all rays: which planes are near, and the order of the axes in the view.
    pub negative: [usize; 3],
    pub axes: [usize; 3],
}

/// Rays in world space, in double precision.
#[derive(Default)]
pub struct WorldRays {
    pub origin: [Lanes<f64>; 3],
    pub direction: [Lanes<f64>; 3],
    pub min: Lanes<f64>,
    pub max: Lanes<f64>,
}

/// Origins of rays in the tree's space, and which rays are regular: of about unit direction, from nearby, and with an
/// interval that is not empty. The others take the long way, [`UnitBox::localize`].
struct LocalOrigins {
    origin: [Lanes<f64>; 3],
    /// The largest pad of a regular ray.
    pad: f32,
    /// The mask of rays that are not regular.
    irregular: u32,
}

impl RayPacket {
    /// Replaces the rays; false if they are not coherent: few, in different directions, or one has no useful bound. In place,
    /// since moving so much takes as long as a box or two.
    #[inline(always)]
    pub fn set<L: Level>(
        &mut self,
        level: L,
        unit_box: &UnitBox,
        rays: &[(Ray, Interval)],
    ) -> bool {
        let count = rays.len().min(PACKET_SIZE);
        if count < FEWEST || !UnitBox::is_usable(unit_box.scale) {
            return false;
        }
        self.world.set(&rays[..count]);
        let local = self.world.localize(level, unit_box);
        self.set_regular(unit_box, &local);
        let missing = ALL << count & ALL;
        let mut dead = missing;
        if local.irregular & !missing != 0 {
            match self.set_irregular(unit_box, rays, local.irregular & !missing) {
                Some(none) => dead |= none,
                None => return false,
            }
        }
        if dead != 0 {
            self.deactivate(dead);
        }
        self.is_coherent(level)
    }

    /// Sets all rays as if they were regular.
    #[inline(always)]
    fn set_regular(&mut self, unit_box: &UnitBox, local: &LocalOrigins) {
        self.pad = local.pad;
        self.start = [0.0; PACKET_SIZE];
        self.rate = [unit_box.scale; PACKET_SIZE];
        for k in 0..3 {
            for i in 0..PACKET_SIZE {
                let direction = self.world.direction[k][i] as f32;
                let least = FLATTEST.copysign(direction);
                let is_flat = direction.abs() < FLATTEST;
                let inverse = 1.0 / if is_flat { least } else { direction };
                let origin = local.origin[k][i] as f32;
                let (middle, aside) = (origin * inverse, self.pad * inverse.abs());
                self.origin[k][i] = origin;
                self.inverse[k][i] = inverse;
                self.near[k][i] = middle + aside;
                self.far[k][i] = middle - aside;
            }
        }
        for i in 0..PACKET_SIZE {
            let [start, end] = [self.world.min[i], self.world.max[i]];
            self.min[i] = larger(before((start * unit_box.scale) as f32), 0.0);
            self.max[i] = beyond((end * unit_box.scale) as f32);
        }
    }

    /// Sets the rays of a mask one by one; returns those that meet nothing. `None` if one has no useful bound.
    #[cold]
    #[inline(never)]
    fn set_irregular(
        &mut self,
        unit_box: &UnitBox,
        rays: &[(Ray, Interval)],
        mask: u32,
    ) -> Option<u32> {
        let mut dead = 0;
        for i in (0..PACKET_SIZE).filter(|i| mask >> i & 1 == 1) {
            let local = match unit_box.localize(&rays[i].0, rays[i].1) {
                Localized::Unbounded => return None,
                Localized::Miss => {
                    dead |= 1 << i;
                    continue;
                }
                Localized::Ray(local) => local,
            };
            for k in 0..3 {
                self.origin[k][i] = local.origin[k];
                self.inverse[k][i] = local.inverse[k];
                self.near[k][i] = local.near[k];
                self.far[k][i] = local.far[k];
            }
            (self.min[i], self.max[i]) = (local.min, local.max);
            (self.start[i], self.rate[i]) = (local.start, local.rate);
            self.pad = larger(self.pad, local.pad);
        }
        Some(dead)
    }

    /// Makes the rays of a mask count for nothing: each becomes a copy of another that ends before it starts. (Never inlined: the
    /// few packets with such rays must not decide how all others are compiled.)
    #[cold]
    #[inline(never)]
    fn deactivate(&mut self, dead: u32) {
        let alive = (!dead).trailing_zeros() as usize % PACKET_SIZE;
        for i in (0..PACKET_SIZE).filter(|i| dead >> i & 1 == 1) {
            for row in self.origin.iter_mut().chain(&mut self.inverse) {
                row[i] = row[alive];
            }
            for row in self.near.iter_mut().chain(&mut self.far) {
                row[i] = row[alive];
            }
            self.min[i] = if dead == ALL { 0.0 } else { self.min[alive] };
            self.max[i] = -1.0;
        }
    }

    /// Finds what is the same for all rays; false if it is not.
    #[inline(always)]
    fn is_coherent<L: Level>(&mut self, level: L) -> bool {
        let nothing = [0.0; PACKET_SIZE];
        for k in 0..3 {
            self.negative[k] = match level.le16(&self.inverse[k], &nothing) {
                0 => 0,
                ALL => 1,
                _ => return false,
            };
        }
        // The axis along which the first ray goes fastest; the others do nearly so.
        let [x, y, z] = &self.inverse;
        let (x, y, z) = (x[0].abs(), y[0].abs(), z[0].abs());
        let z = if x < y && x < z {
            0
        } else {
            1 + usize::from(z <= y)
        };
        self.axes = [(z + 1) % 3, (z + 2) % 3, z];
        let mut steep = [0.0; PACKET_SIZE];
        for k in 0..2 {
            let along = &self.inverse[self.axes[k]];
            for i in 0..PACKET_SIZE {
                self.slope[k][i] = self.inverse[z][i] / along[i];
                steep[i] = larger(steep[i], self.slope[k][i].abs());
            }
        }
        level.le16(&steep, &[STEEPEST; PACKET_SIZE]) == ALL
    }

    /// Ends a ray at a hit at t.
    #[inline(always)]
    pub fn end(&mut self, lane: usize, t: f64) {
        let end = beyond(larger(
            ((t - self.start[lane]) * self.rate[lane]) as f32,
            0.0,
        ));
        self.max[lane] = smaller(self.max[lane], end);
    }
}

impl WorldRays {
    /// Replaces the rays; the last one stands for those that are missing.
    #[inline(always)]
    fn set(&mut self, rays: &[(Ray, Interval)]) {
        for i in 0..PACKET_SIZE {
            let (ray, interval) = &rays[i.min(rays.len() - 1)];
            let (origin, direction) = (ray.origin.to_array(), ray.direction.to_array());
            for k in 0..3 {
                self.origin[k][i] = origin[k];
                self.direction[k][i] = direction[k];
            }
            (self.min[i], self.max[i]) = (interval.min, interval.max);
        }
    }

    /// The origins in the tree's space, and which rays are regular.
    #[inline(always)]
    fn localize<L: Level>(&self, level: L, unit_box: &UnitBox) -> LocalOrigins {
        let Self {
            origin: o,
            direction: d,
            min: start,
            max: end,
        } = self;
        let center = unit_box.center.to_array();
        let max = |a: f64, b: f64| if a > b { a } else { b };
        let min = |a: f64, b: f64| if a < b { a } else { b };
        let largest =
            |v: &[Lanes<f64>; 3], i: usize| max(max(v[0][i].abs(), v[1][i].abs()), v[2][i].abs());
        let (mut margin, mut pads) = ([0.0; PACKET_SIZE], [0.0; PACKET_SIZE]);
        let mut local = [[0.0; PACKET_SIZE]; 3];
        for i in 0..PACKET_SIZE {
            for k in 0..3 {
                local[k][i] = (o[k][i] - center[k]) * unit_box.scale;
            }
            let (longest, farthest) = (largest(d, i), largest(&local, i));
            let tolerance = unit_box.tolerance.for_coordinate(largest(o, i));
            pads[i] = tolerance * unit_box.scale + 16.0 * U * (1.0 + farthest);
            // Negative if one of the conditions fails; NaN if any number is NaN or infinite.
            let direction = min(1.0 - longest, longest - 0.5);
            let origin = min(min(FAR - farthest, 0.5 - pads[i]), start[i]);
            let sum = d[0][i] + d[1][i] + d[2][i] + o[0][i] + o[1][i] + o[2][i];
            margin[i] = min(direction, origin) + 0.0 * sum;
        }
        for i in 0..PACKET_SIZE {
            pads[i] = if margin[i] >= 0.0 { pads[i] } else { 0.0 };
        }
        let (margin, start, end) = (halves(&margin), halves(start), halves(end));
        let mut irregular = ALL;
        for h in 0..2 {
            let regular = level.positive8(&margin[h]) & level.less8(&start[h], &end[h]);
            irregular &= !(regular << (8 * h));
        }
        LocalOrigins {
            origin: local,
            pad: round_up(reduce(pads, max)),
            irregular,
        }
    }
}

/// A number that is less than x before it was rounded twice.
#[inline(always)]
fn before(x: f32) -> f32 {
    x * (1.0 - 2.0 * f32::EPSILON) - f32::MIN_POSITIVE
}

/// A number that is greater than x before it was rounded twice.
#[inline(always)]
fn beyond(x: f32) -> f32 {
    x * (1.0 + 2.0 * f32::EPSILON) + f32::MIN_POSITIVE
}

/// The row's numbers reduce into one, in few steps.
#[inline(always)]
pub fn reduce<T: Copy>(mut row: Lanes<T>, f: impl Fn(T, T) -> T) -> T {
    for length in [8, 4, 2, 1] {
        for i in 0..length {
            row[i] = f(row[i], row[i + length]);
        }
    }
    row[0]
}

/// Two rows of half the length.
#[inline(always)]
fn halves(row: &Lanes<f64>) -> &[[f64; 8]] {
    row.as_chunks().0
}
