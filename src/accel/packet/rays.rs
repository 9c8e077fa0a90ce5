//! Sixteen rays side by side in the tree's space: what `Frame::plan` says of one, of all with the same instructions.

// Plain loops are what becomes vector instructions.
#![allow(clippy::needless_range_loop)]

use crate::accel::local::{FAR, FLATTEST, Frame, Plan, U, larger, round_up, smaller};
use crate::accel::simd::Level;
use crate::math::{Interval, Ray};

/// Rays in a packet: a bundle of more is followed in several.
pub const RAYS: usize = 16;

/// Fewer rays are followed one by one.
const FEWEST: usize = 4;

/// The mask of all rays.
pub const ALL: u32 = 0xffff;

/// No ray goes aside faster than this times as fast as along the last axis of the view.
const STEEPEST: f32 = 2.0;

/// A number of each ray.
pub type Row<T> = [T; RAYS];

/// Rays that go together; numbers as in `Local`.
pub struct Rays {
    pub origin: [Row<f32>; 3],
    pub inverse: [Row<f32>; 3],
    pub near: [Row<f32>; 3],
    pub far: [Row<f32>; 3],
    pub min: Row<f32>,
    /// Less than min for rays that are done with.
    pub max: Row<f32>,
    /// x' = x - s.x z and y' = y - s.y z, in the order of the view.
    pub slope: [Row<f32>; 2],
    start: Row<f64>,
    rate: Row<f64>,
    pub world: World,
    /// The largest of all.
    pub pad: f32,
    /// The same for all rays: which planes are near, and the order of the axes in the view.
    pub backwards: [usize; 3],
    pub axes: [usize; 3],
}

/// The same rays in world space, in double precision.
pub struct World {
    pub origin: [Row<f64>; 3],
    pub direction: [Row<f64>; 3],
    pub min: Row<f64>,
    pub max: Row<f64>,
}

impl Default for Rays {
    /// Room for rays.
    fn default() -> Self {
        let (row, wide) = ([0.0; RAYS], [0.0; RAYS]);
        Self {
            origin: [row; 3],
            inverse: [row; 3],
            near: [row; 3],
            far: [row; 3],
            min: row,
            max: row,
            slope: [row; 2],
            start: wide,
            rate: wide,
            world: World {
                origin: [wide; 3],
                direction: [wide; 3],
                min: wide,
                max: wide,
            },
            pad: 0.0,
            backwards: [0; 3],
            axes: [0; 3],
        }
    }
}

impl Rays {
    /// Puts rays in; false if they do not go together: one is odd, they are few, or they go different ways. In place, since
    /// moving so much takes as long as a box or two.
    #[inline(always)]
    pub fn set<L: Level>(&mut self, level: L, frame: &Frame, rays: &[(Ray, Interval)]) -> bool {
        let count = rays.len().min(RAYS);
        if count < FEWEST || !Frame::is_usable(frame.scale) {
            return false;
        }
        // Where there is no ray the last one stands, and counts for nothing.
        let World {
            origin: o,
            direction: d,
            min: start,
            max: end,
        } = &mut self.world;
        for i in 0..RAYS {
            let (ray, interval) = &rays[i.min(count - 1)];
            let (from, way) = (ray.origin.to_array(), ray.direction.to_array());
            for k in 0..3 {
                o[k][i] = from[k];
                d[k][i] = way[k];
            }
            (start[i], end[i]) = (interval.min, interval.max);
        }

        let center = frame.center.to_array();
        let (mut plain, mut pads) = ([0.0; RAYS], [0.0; RAYS]);
        let mut local = [[0.0; RAYS]; 3];
        let max = |a: f64, b: f64| if a > b { a } else { b };
        let min = |a: f64, b: f64| if a < b { a } else { b };
        for i in 0..RAYS {
            for k in 0..3 {
                local[k][i] = (o[k][i] - center[k]) * frame.scale;
            }
            let longest = max(max(d[0][i].abs(), d[1][i].abs()), d[2][i].abs());
            let reach = max(max(local[0][i].abs(), local[1][i].abs()), local[2][i].abs());
            let farthest = max(max(o[0][i].abs(), o[1][i].abs()), o[2][i].abs());
            pads[i] = frame.slack.within(farthest) * frame.scale + 16.0 * U * (1.0 + reach);
            // Negative where the ray is not an ordinary one; NaN where a number is none.
            let sum = d[0][i] + d[1][i] + d[2][i] + o[0][i] + o[1][i] + o[2][i];
            let direction = min(1.0 - longest, longest - 0.5);
            let place = min(min(FAR - reach, 0.5 - pads[i]), start[i]);
            plain[i] = min(direction, place) + 0.0 * sum;
        }
        for i in 0..RAYS {
            pads[i] = if plain[i] >= 0.0 { pads[i] } else { 0.0 };
        }
        let (plain, starts, ends) = (halves(&plain), halves(start), halves(end));
        let mut odd = ALL;
        for h in 0..2 {
            let ordinary = level.positive8(&plain[h]) & level.less8(&starts[h], &ends[h]);
            odd &= !(ordinary << (8 * h));
        }

        self.pad = round_up(folded(pads, max));
        self.start = [0.0; RAYS];
        self.rate = [frame.scale; RAYS];
        for k in 0..3 {
            for i in 0..RAYS {
                let way = d[k][i] as f32;
                let least = FLATTEST.copysign(way);
                let lifted = if way.abs() < FLATTEST { least } else { way };
                let (origin, inverse) = (local[k][i] as f32, 1.0 / lifted);
                let (middle, aside) = (origin * inverse, self.pad * inverse.abs());
                self.origin[k][i] = origin;
                self.inverse[k][i] = inverse;
                self.near[k][i] = middle + aside;
                self.far[k][i] = middle - aside;
            }
        }
        for i in 0..RAYS {
            self.min[i] = larger(before((start[i] * frame.scale) as f32), 0.0);
            self.max[i] = beyond((end[i] * frame.scale) as f32);
        }
        let missing = ALL << count & ALL;
        let mut dead = missing;
        if odd & !missing != 0 {
            match self.set_odd(frame, rays, odd & !missing) {
                Some(none) => dead |= none,
                None => return false,
            }
        }
        if dead != 0 {
            self.bury(dead);
        }
        self.agree(level)
    }

    /// Sets rays that are not ordinary, one by one; returns those that meet nothing.
    #[cold]
    #[inline(never)]
    fn set_odd(&mut self, frame: &Frame, rays: &[(Ray, Interval)], odd: u32) -> Option<u32> {
        let mut dead = 0;
        for i in (0..RAYS).filter(|i| odd >> i & 1 == 1) {
            let local = match frame.plan(&rays[i].0, rays[i].1) {
                Plan::TestAll => return None,
                Plan::Miss => {
                    dead |= 1 << i;
                    continue;
                }
                Plan::Follow(local) => local,
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

    /// Makes the rays of a mask count for nothing: each becomes a copy of another that ends before it starts.
    fn bury(&mut self, dead: u32) {
        let alive = (!dead).trailing_zeros() as usize % RAYS;
        for i in (0..RAYS).filter(|i| dead >> i & 1 == 1) {
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
    fn agree<L: Level>(&mut self, level: L) -> bool {
        let nothing = [0.0; RAYS];
        for k in 0..3 {
            self.backwards[k] = match level.le16(&self.inverse[k], &nothing) {
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
        let mut steep = [0.0; RAYS];
        for k in 0..2 {
            let along = &self.inverse[self.axes[k]];
            for i in 0..RAYS {
                self.slope[k][i] = self.inverse[z][i] / along[i];
                steep[i] = larger(steep[i], self.slope[k][i].abs());
            }
        }
        level.le16(&steep, &[STEEPEST; RAYS]) == ALL
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

/// The row's numbers folded into one, in few steps.
#[inline(always)]
pub fn folded<T: Copy>(mut row: Row<T>, f: impl Fn(T, T) -> T) -> T {
    for length in [8, 4, 2, 1] {
        for i in 0..length {
            row[i] = f(row[i], row[i + length]);
        }
    }
    row[0]
}

/// Two rows of half the length.
#[inline(always)]
fn halves(row: &Row<f64>) -> &[[f64; 8]] {
    row.as_chunks().0
}
