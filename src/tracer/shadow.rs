//! Shadow rays to one light that are asked together, in an order in which neighbours go the same way.

use crate::math::{DVec3, Interval, Ray};
use crate::scene::World;

/// Rays that are put in order together: more would start too far from each other.
const SORTED: usize = 512;

/// Levels of the grid of directions, along each axis, in bits.
const LEVELS: u32 = 6;

/// Rays, each with the index of its question; room that is used again and again.
#[derive(Default)]
pub struct Shadow {
    rays: Vec<(Ray, Interval)>,
    /// Ray by ray, the index of its question.
    questions: Vec<u32>,
    blocked: Vec<bool>,
    /// The cell of each ray's direction, and its place among the rays.
    order: Vec<(u32, u32)>,
    asked: Vec<(Ray, Interval)>,
}

impl Shadow {
    /// Forgets all rays.
    pub fn clear(&mut self) {
        self.rays.clear();
        self.questions.clear();
        self.order.clear();
        self.asked.clear();
        self.blocked.clear();
    }

    /// Adds the ray of question number `question`, which ends at `distance`.
    #[inline]
    pub fn push(&mut self, ray: Ray, distance: f64, question: usize) {
        self.rays.push((ray, Interval::before(distance)));
        self.questions.push(question as u32);
    }

    /// Asks all rays; each question with whether something stands in the way.
    pub fn answers(&mut self, world: &World, to_area: bool) -> impl Iterator<Item = (usize, bool)> {
        // From neighbours to one point, rays go together as they are. To an area they go all over it: in the order of
        // their directions, each bundle sees a small part of the light.
        let keyed = self.rays.iter().zip(0..);
        self.order.extend(keyed.map(|((ray, _), i)| {
            let cell = if to_area { cell(ray.direction) } else { 0 };
            (cell, i)
        }));
        if to_area {
            let parts = self.order.chunks_mut(SORTED);
            parts.for_each(<[_]>::sort_unstable);
            let order = self.order.iter();
            self.asked
                .extend(order.map(|(_, i)| self.rays[*i as usize]));
        }
        let rays = if to_area { &self.asked } else { &self.rays };
        self.blocked.resize(rays.len(), false);
        let shapes = &world.scene.shapes;
        world.accel.any_many(shapes, rays, &mut self.blocked);
        let order = self.order.iter().zip(&self.blocked);
        order.map(|((_, i), blocked)| (self.questions[*i as usize] as usize, *blocked))
    }
}

/// The cell of a direction in a grid over the cube that holds all of them, by Morton's curve: what is near on it is near
/// in space. Source: Morton 1966, "A computer oriented geodetic data base".
fn cell(direction: DVec3) -> u32 {
    let (half, last) = (f64::from(1 << (LEVELS - 1)), (1 << LEVELS) - 1);
    let place = |d: f64| (((d + 1.0) * half) as u32).min(last);
    let places = direction.to_array().map(place);
    (0..LEVELS).rev().fold(0, |key, bit| {
        places.iter().fold(key, |key, p| key << 1 | (p >> bit & 1))
    })
}
