//! Shadow rays to one light that are asked together, in an order in which neighbours go the same way.

use crate::accel::RAYS;
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
    /// The cell of each ray's direction, and its place among the rays; and room to put them in that order.
    order: Vec<(u32, u32)>,
    sorted_rays: Vec<(Ray, Interval)>,
    sorted_questions: Vec<u32>,
}

impl Shadow {
    /// Forgets all rays.
    pub fn clear(&mut self) {
        self.rays.clear();
        self.questions.clear();
    }

    /// Adds the ray of question number `question`, which ends at `distance`.
    #[inline]
    pub fn push(&mut self, ray: Ray, distance: f64, question: usize) {
        self.rays.push((ray, Interval::before(distance)));
        self.questions.push(question as u32);
    }

    /// Asks all rays, to an area or to a point; each question with whether something stands in the way.
    #[inline]
    pub fn answers(&mut self, world: &World, to_area: bool) -> impl Iterator<Item = (usize, bool)> {
        // From neighbours to one point, rays go together as they are. To an area they go all over it: in the order of
        // their directions, each bundle sees a small part of the light.
        if to_area && self.rays.len() > RAYS && world.accel.gains_from_bundles() {
            self.sort();
        }
        self.blocked.clear();
        self.blocked.resize(self.rays.len(), false);
        let shapes = &world.scene.shapes;
        world.accel.any_many(shapes, &self.rays, &mut self.blocked);
        let questions = self.questions.iter().zip(&self.blocked);
        questions.map(|(question, blocked)| (*question as usize, *blocked))
    }

    /// Puts the rays in the order of their directions.
    #[inline(never)]
    fn sort(&mut self) {
        self.order.clear();
        let rays = self.rays.iter().zip(0..);
        self.order
            .extend(rays.map(|((ray, _), i)| (cell(ray.direction), i)));
        let parts = self.order.chunks_mut(SORTED);
        parts.for_each(<[_]>::sort_unstable);
        let order = || self.order.iter().map(|(_, i)| *i as usize);
        self.sorted_rays.clear();
        self.sorted_rays.extend(order().map(|i| self.rays[i]));
        self.sorted_questions.clear();
        self.sorted_questions
            .extend(order().map(|i| self.questions[i]));
        std::mem::swap(&mut self.rays, &mut self.sorted_rays);
        std::mem::swap(&mut self.questions, &mut self.sorted_questions);
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
