//! Shadow-ray batch: rays to one light that are traced together, those to an area sorted by direction (Morton order).

use super::light_sampler::{AreaSampler, LightSampler, SampledRay, ShadowRay};
use crate::accel::PACKET_SIZE;
use crate::math::{DVec3, Interval, Ray};
use crate::probe::Absence;
use crate::world::World;

/// Rays that are sorted together: more would start too far from each other.
const SORTED: usize = 1 << INDEX_BITS;

/// Bits of a ray's index among these.
const INDEX_BITS: u32 = 9;

/// Levels of the grid of directions, along each axis, in bits.
const LEVELS: u32 = 6;

/// Shadow ray that was traced before its turn.
#[derive(Clone, Copy, Debug)]
pub struct Prefetched {
    /// The ray, or why none is sent.
    pub ray: SampledRay,
    /// True if something is in its way.
    pub occluded: bool,
}

/// Shadow rays from a point to a light: sampled and traced one after the other ([`LightSampler`]), or before ([`Prefetched`]).
pub trait ShadowRays {
    /// Number of samples of the light.
    fn count(&self) -> u32;

    /// Shadow ray number `sample`, or why none is sent, and whether something is in its way, if that is known. A ray that has
    /// not been sampled yet is put into `slot`.
    fn get<'s>(&'s self, sample: u32, slot: &'s mut Slot) -> (&'s SampledRay, Option<bool>);
}

/// Memory for one shadow ray.
pub type Slot = Option<SampledRay>;

impl<S: LightSampler> ShadowRays for S {
    #[inline]
    fn count(&self) -> u32 {
        self.samples()
    }

    #[inline(always)]
    fn get<'s>(&'s self, sample: u32, slot: &'s mut Slot) -> (&'s SampledRay, Option<bool>) {
        (slot.insert(self.shadow_ray(sample)), None)
    }
}

impl ShadowRays for [Prefetched] {
    #[inline]
    fn count(&self) -> u32 {
        self.len() as u32
    }

    #[inline(always)]
    fn get<'s>(&'s self, sample: u32, _: &'s mut Slot) -> (&'s SampledRay, Option<bool>) {
        let Prefetched { ray, occluded } = &self[sample as usize];
        (ray, Some(*occluded))
    }
}

/// Shadow rays that are traced together; memory that is used again and again.
#[derive(Default)]
pub struct ShadowBatch {
    /// All rays since [`ShadowBatch::clear`], with what was found.
    prefetched: Vec<Prefetched>,
    /// Rays that are still to be traced, and for each its index in `prefetched`.
    rays: Vec<(Ray, Interval)>,
    indices: Vec<u32>,
    occluded: Vec<bool>,
    /// Sort keys: the cell of a ray's direction above its index among those that are sorted with it.
    order: Vec<u32>,
    sorted_rays: Vec<(Ray, Interval)>,
    sorted_indices: Vec<u32>,
}

impl ShadowBatch {
    /// Forgets all rays.
    pub fn clear(&mut self) {
        self.prefetched.clear();
    }

    /// Rays since [`ShadowBatch::clear`], in the order in which they were added.
    #[inline]
    pub fn prefetched(&self) -> &[Prefetched] {
        &self.prefetched
    }

    /// Adds the first `count` shadow rays of a sampler.
    #[inline]
    pub fn sample(&mut self, sampler: &impl LightSampler, count: u32) {
        for sample in 0..count {
            let (ray, occluded) = (sampler.shadow_ray(sample), false);
            if let Ok(ShadowRay { ray, light, .. }) = &ray {
                self.rays.push((*ray, Interval::before(light.distance)));
                self.indices.push(self.prefetched.len() as u32);
            }
            self.prefetched.push(Prefetched { ray, occluded });
        }
    }

    /// Samples and traces the first `count` shadow rays of a sampler of an area light, and no others.
    pub fn trace_all(&mut self, world: &World, sampler: &AreaSampler, count: u32) -> &[Prefetched] {
        self.clear();
        self.sample(sampler, count);
        self.trace(world, true);
        &self.prefetched
    }

    /// Adds `count` rays that are not sent, for a pixel whose eye ray hits nothing.
    pub fn skip(&mut self, count: u32) {
        let none = Prefetched {
            ray: Err(Absence::NoLocalLight),
            occluded: false,
        };
        let len = self.prefetched.len() + count as usize;
        self.prefetched.resize(len, none);
    }

    /// Traces the rays that were added since the last call, all to one light.
    #[inline]
    pub fn trace(&mut self, world: &World, to_area: bool) {
        // From neighbours to one point, rays are coherent as they are. To an area they go all over it: in the order of
        // their directions, each packet sees a small part of the light.
        if to_area && self.rays.len() > PACKET_SIZE && world.accel.gains_from_packets() {
            self.sort();
        }
        self.occluded.clear();
        self.occluded.resize(self.rays.len(), false);
        let shapes = &world.scene.shapes;
        world
            .accel
            .occluded_many(shapes, &self.rays, &mut self.occluded);
        for (index, occluded) in self.indices.iter().zip(&self.occluded) {
            self.prefetched[*index as usize].occluded = *occluded;
        }
        self.rays.clear();
        self.indices.clear();
    }

    /// Sorts the rays by direction.
    #[inline(never)]
    fn sort(&mut self) {
        const LAST: u32 = SORTED as u32 - 1;
        self.order.clear();
        let rays = self.rays.iter().zip(0..);
        self.order
            .extend(rays.map(|((ray, _), i)| cell(ray.direction) << INDEX_BITS | (i & LAST)));
        let parts = self.order.chunks_mut(SORTED);
        parts.for_each(<[_]>::sort_unstable);
        let ordered = self.order.iter().zip(0..);
        let order = || {
            ordered
                .clone()
                .map(|(key, i)| ((i & !LAST) | (key & LAST)) as usize)
        };
        self.sorted_rays.clear();
        self.sorted_rays.extend(order().map(|i| self.rays[i]));
        self.sorted_indices.clear();
        self.sorted_indices.extend(order().map(|i| self.indices[i]));
        std::mem::swap(&mut self.rays, &mut self.sorted_rays);
        std::mem::swap(&mut self.indices, &mut self.sorted_indices);
    }
}

/// Cell of a direction in a grid over the cube that holds all of them, on Morton's curve: what is near on it is near in space.
/// Source: Morton 1966, "A computer oriented geodetic data base".
fn cell(direction: DVec3) -> u32 {
    let (half, last) = (f64::from(1 << (LEVELS - 1)), (1 << LEVELS) - 1);
    let index = |d: f64| (((d + 1.0) * half) as u32).min(last);
    let indices = direction.to_array().map(index);
    (0..LEVELS).rev().fold(0, |key, bit| {
        indices.iter().fold(key, |key, i| key << 1 | (i >> bit & 1))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_keep_neighbours_together() {
        // The first three bits are the octant, whatever else a direction is.
        for i in 0..1000 {
            let turn = 2.4 * f64::from(i);
            let y = 1.0 - f64::from(2 * i + 1) / 1000.0;
            let r = (1.0 - y * y).sqrt();
            let direction = DVec3::new(r * libm::cos(turn), y, r * libm::sin(turn));
            let signs = direction.to_array().map(|d| u32::from(d >= 0.0));
            let octant = signs.iter().fold(0, |octant, sign| octant << 1 | sign);
            assert_eq!(cell(direction) >> (3 * (LEVELS - 1)), octant, "{direction}");
        }
        // The ends of the axes are in the grid.
        for axis in DVec3::AXES {
            assert!(cell(axis) < 1 << (3 * LEVELS) && cell(-axis) < 1 << (3 * LEVELS));
        }
        assert!(cell(DVec3::Y) > cell(DVec3::new(0.0, 0.9, 0.0)));
    }

    #[test]
    fn each_ray_keeps_its_index() {
        let mut batch = ShadowBatch::default();
        let direction = |i: usize| {
            let turn = i as f64 * 2.4;
            DVec3::new(libm::cos(turn), 0.1, libm::sin(turn)).normalize()
        };
        for i in 0..2 * SORTED {
            let ray = Ray::new(DVec3::ZERO, direction(i));
            batch.rays.push((ray, Interval::before(1.0)));
            batch.indices.push(i as u32);
            batch.skip(1);
        }
        batch.sort();
        for (half, rays) in batch.rays.chunks(SORTED).enumerate() {
            let cells = rays.iter().map(|(ray, _)| cell(ray.direction));
            assert!(cells.is_sorted(), "{half}");
        }
        for ((ray, _), index) in batch.rays.iter().zip(&batch.indices) {
            assert_eq!(ray.direction, direction(*index as usize));
        }
        let mut indices = batch.indices.clone();
        indices.sort_unstable();
        assert!(indices.into_iter().eq(0..2 * SORTED as u32));
    }
}
