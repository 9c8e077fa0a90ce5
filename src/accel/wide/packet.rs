//! Sixteen rays through the tree together: rays that start close to each other and go the same way meet the same
//! boxes and triangles.
//!
//! A node's eight boxes are first tested against all rays at once, by interval arithmetic; then each box that is left
//! against each ray. Source: Boulos, Wald and Shirley 2006, "Geometric and arithmetic culling methods for entire ray
//! packets"; Wald, Boulos and Shirley 2007, "Ray tracing deformable scenes using dynamic bounding volume
//! hierarchies".

use super::local::{Local, Plan};
use super::single::{larger, smaller};
use super::{BLOCK, DEEP, Node, WIDTH, Wide};
use crate::accel::Query;
use crate::accel::simd::{Level, Task};
use crate::geometry::{Hit, Shape, Shear};
use crate::math::{Interval, Ray};

mod half;

use half::{HALF, Half};

/// Rays in a packet.
pub const RAYS: usize = 2 * HALF;

/// Fewer rays are followed one by one.
const FEWEST: usize = 4;

/// The closest hits of at most [`RAYS`] rays; false, and nothing done, if they do not go together.
#[inline]
pub fn closest(
    wide: &Wide,
    shapes: &[Shape],
    rays: &[(Ray, Interval)],
    out: &mut [Option<Hit>],
) -> bool {
    let Some(packet) = wide.isa.run(Together::<false> { wide, shapes, rays }) else {
        return false;
    };
    for (i, out) in out.iter_mut().enumerate().take(rays.len()) {
        *out = packet.halves[i / HALF].hit(i % HALF);
    }
    true
}

/// Whether each of at most [`RAYS`] rays hits anything; false, and nothing done, if they do not go together.
#[inline]
pub fn any(wide: &Wide, shapes: &[Shape], rays: &[(Ray, Interval)], out: &mut [bool]) -> bool {
    let Some(packet) = wide.isa.run(Together::<true> { wide, shapes, rays }) else {
        return false;
    };
    for (i, out) in out.iter_mut().enumerate().take(rays.len()) {
        *out = packet.halves[i / HALF].hit(i % HALF).is_some();
    }
    true
}

/// Rays that may go together.
struct Together<'a, const ANY: bool> {
    wide: &'a Wide,
    shapes: &'a [Shape],
    rays: &'a [(Ray, Interval)],
}

impl<const ANY: bool> Task for Together<'_, ANY> {
    type Output = Option<Packet>;

    #[inline(always)]
    fn run<L: Level>(self, level: L) -> Option<Packet> {
        let Self { wide, shapes, rays } = self;
        let mut packet = Packet::new(wide, rays)?;
        for &primitive in &wide.outside {
            for (i, (ray, interval)) in rays.iter().enumerate() {
                let query = Query::new(shapes, ray, *interval);
                packet.halves[i / HALF].test(&query, i % HALF, primitive);
            }
        }
        packet.shorten::<ANY>();
        packet.follow::<ANY, L>(level, wide, shapes, rays);
        Some(packet)
    }
}

/// Sixteen rays, each of their numbers side by side.
struct Packet {
    /// As in [`Local`].
    inverse: [[f32; RAYS]; 3],
    near: [[f32; RAYS]; 3],
    far: [[f32; RAYS]; 3],
    min: [f32; RAYS],
    /// Less than min for rays that are done with.
    max: [f32; RAYS],
    /// What is double: the rays for the triangles, and their hits.
    halves: [Half; 2],
    /// The same for all rays: which planes are near, and the order of the axes for the triangles' tests.
    backwards: [usize; 3],
    axes: [usize; 3],
    all: Bounds,
}

/// Bounds for all rays of a packet.
struct Bounds {
    /// The origins, moved by the pad, from which near planes are nearest and far planes farthest.
    near: [f32; 3],
    far: [f32; 3],
    /// The least and greatest inverses of the directions.
    least: [f32; 3],
    greatest: [f32; 3],
    min: f32,
    max: f32,
}

impl Packet {
    /// `None` if the rays do not go together: one is odd, they are few, or they go different ways.
    #[inline(always)]
    fn new(wide: &Wide, rays: &[(Ray, Interval)]) -> Option<Self> {
        if wide.nodes.is_empty() || rays.len() < FEWEST {
            return None;
        }
        let mut packet = Self {
            inverse: [[1.0; RAYS]; 3],
            near: [[0.0; RAYS]; 3],
            far: [[0.0; RAYS]; 3],
            min: [0.0; RAYS],
            max: [-1.0; RAYS],
            halves: [Half::NONE, Half::NONE],
            backwards: [0; 3],
            axes: [0; 3],
            all: Bounds::NONE,
        };
        let mut count = 0;
        for (i, (ray, interval)) in rays.iter().enumerate().take(RAYS) {
            let local = match wide.frame.plan(ray, *interval) {
                Plan::Miss => continue,
                Plan::TestAll => return None,
                Plan::Follow(local) => local,
            };
            let shear = Shear::new(ray);
            if count == 0 {
                (packet.backwards, packet.axes) = (local.backwards, shear.axes);
            } else if (packet.backwards, packet.axes) != (local.backwards, shear.axes) {
                return None;
            }
            count += 1;
            for k in 0..3 {
                packet.inverse[k][i] = local.inverse[k];
                packet.near[k][i] = local.near[k];
                packet.far[k][i] = local.far[k];
            }
            (packet.min[i], packet.max[i]) = (local.min, local.max);
            packet.all.add(&local);
            packet.halves[i / HALF].set(i % HALF, &shear, *interval, &local);
        }
        Some(packet)
    }

    /// Shortens the rays to their hits, or to nothing if any hit will do.
    #[inline(always)]
    fn shorten<const ANY: bool>(&mut self) {
        for (i, half) in self.halves.iter().enumerate() {
            let max = &mut self.max[i * HALF..][..HALF];
            half.shorten::<ANY>(max);
        }
        // The largest, in few steps.
        let mut max = self.max;
        for length in [8, 4, 2, 1] {
            for i in 0..length {
                max[i] = larger(max[i], max[i + length]);
            }
        }
        self.all.max = max[0];
    }

    #[inline(always)]
    fn follow<const ANY: bool, L: Level>(
        &mut self,
        level: L,
        wide: &Wide,
        shapes: &[Shape],
        rays: &[(Ray, Interval)],
    ) {
        // Children that wait, the nearest on top: where the first ray enters at the earliest, and the place of the
        // child in all nodes.
        let mut stack = [0u64; DEEP];
        let mut waiting = 0;
        let mut id = 0;
        loop {
            let node = &wide.nodes[id as usize];
            let (near, far) = self.all.cross(node, self.backwards);
            let mut met = level.le8(&near, &far);
            let first = waiting;
            while met != 0 {
                let child = met.trailing_zeros();
                met &= met - 1;
                let key = u64::from(near[child as usize].to_bits()) << 32
                    | (u64::from(id) * WIDTH as u64 + u64::from(child));
                let mut place = waiting;
                while place > first && stack[place - 1] < key {
                    stack[place] = stack[place - 1];
                    place -= 1;
                }
                stack[place] = key;
                waiting += 1;
            }
            id = loop {
                if waiting == 0 {
                    return;
                }
                waiting -= 1;
                let enter = f32::from_bits((stack[waiting] >> 32) as u32);
                // As for one ray: a hit at the very entry does not count.
                if enter > self.all.max {
                    continue;
                }
                let place = stack[waiting] as u32 as usize;
                let (node, slot) = (&wide.nodes[place / WIDTH], place % WIDTH);
                let met = self.cross(level, node, slot);
                if met == 0 {
                    continue;
                }
                let child = node.children[slot];
                if child & BLOCK == 0 {
                    break child;
                }
                let block = &wide.blocks[(child & !BLOCK) as usize];
                let [x, y, z] = self.axes;
                let rows = [&block.corners[x], &block.corners[y], &block.corners[z]];
                let mut hit = false;
                for (lane, &primitive) in block.primitives().iter().enumerate() {
                    for (h, half) in self.halves.iter_mut().enumerate() {
                        let met = met >> (h * HALF) & 0xff;
                        if met == 0 {
                            continue;
                        }
                        let (taken, mut rare) = half.cross(level, rows, lane, primitive, met);
                        hit |= taken != 0 || rare != 0;
                        while rare != 0 {
                            let i = rare.trailing_zeros() as usize;
                            rare &= rare - 1;
                            let (ray, interval) = &rays[h * HALF + i];
                            half.test(&Query::new(shapes, ray, *interval), i, primitive);
                        }
                    }
                }
                if hit {
                    self.shorten::<ANY>();
                    if self.all.max < 0.0 {
                        return;
                    }
                }
            };
        }
    }

    /// Which rays meet a box.
    #[inline(always)]
    fn cross<L: Level>(&self, level: L, node: &Node, slot: usize) -> u32 {
        let Self {
            inverse: inv,
            near,
            far,
            min,
            max,
            ..
        } = self;
        let n: [f32; 3] = std::array::from_fn(|k| node.planes[2 * k + self.backwards[k]][slot]);
        let f: [f32; 3] = std::array::from_fn(|k| node.planes[2 * k + 1 - self.backwards[k]][slot]);
        let (mut enter, mut leave) = ([0.0; RAYS], [0.0; RAYS]);
        for i in 0..RAYS {
            let t = |k: usize| level.multiply_subtract(n[k], inv[k][i], near[k][i]);
            enter[i] = larger(larger(larger(t(0), t(1)), t(2)), min[i]);
            let t = |k: usize| level.multiply_subtract(f[k], inv[k][i], far[k][i]);
            leave[i] = smaller(smaller(smaller(t(0), t(1)), t(2)), max[i]);
        }
        level.le16(&enter, &leave)
    }
}

impl Bounds {
    const NONE: Self = Self {
        near: [0.0; 3],
        far: [0.0; 3],
        least: [f32::INFINITY; 3],
        greatest: [f32::NEG_INFINITY; 3],
        min: f32::INFINITY,
        max: -1.0,
    };

    #[inline(always)]
    fn add(&mut self, local: &Local) {
        let first = self.min == f32::INFINITY;
        for k in 0..3 {
            let (o, i) = (local.origin[k], local.inverse[k]);
            let (high, low) = (o + local.pad, o - local.pad);
            (self.near[k], self.far[k]) = match (first, i > 0.0) {
                (true, true) => (high, low),
                (true, false) => (low, high),
                (false, true) => (larger(self.near[k], high), smaller(self.far[k], low)),
                (false, false) => (smaller(self.near[k], low), larger(self.far[k], high)),
            };
            self.least[k] = smaller(self.least[k], i);
            self.greatest[k] = larger(self.greatest[k], i);
        }
        self.min = smaller(self.min, local.min);
        self.max = larger(self.max, local.max);
    }

    /// Bounds for where the first ray enters each box and the last one leaves it.
    #[inline(always)]
    fn cross(&self, node: &Node, backwards: [usize; 3]) -> ([f32; WIDTH], [f32; WIDTH]) {
        let (mut enter, mut leave) = ([self.min; WIDTH], [self.max; WIDTH]);
        for (k, backwards) in backwards.into_iter().enumerate() {
            let (n, f) = (
                &node.planes[2 * k + backwards],
                &node.planes[2 * k + 1 - backwards],
            );
            for i in 0..WIDTH {
                let d = n[i] - self.near[k];
                enter[i] = larger(enter[i], smaller(d * self.least[k], d * self.greatest[k]));
                let d = f[i] - self.far[k];
                leave[i] = smaller(leave[i], larger(d * self.least[k], d * self.greatest[k]));
            }
        }
        (enter, leave)
    }
}
