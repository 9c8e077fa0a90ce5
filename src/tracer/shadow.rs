//! Shadow rays to one light that are asked together, in an order in which neighbours go the same way.

use crate::accel::RAYS;
use crate::math::{DVec3, Interval, Ray};
use crate::world::World;

/// Rays that are put in order together: more would start too far from each other.
const SORTED: usize = 1 << PLACE;

/// Bits of a ray's place among these.
const PLACE: u32 = 9;

/// Levels of the grid of directions, along each axis, in bits.
const LEVELS: u32 = 6;

/// Rays, each with the index of its question; room that is used again and again.
#[derive(Default)]
pub struct Shadow {
    rays: Vec<(Ray, Interval)>,
    /// Ray by ray, the index of its question.
    questions: Vec<u32>,
    blocked: Vec<bool>,
    /// The cell of each ray's direction, above its place among those that are sorted with it; and room to put them in
    /// that order.
    order: Vec<u32>,
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
        const LAST: u32 = SORTED as u32 - 1;
        self.order.clear();
        let rays = self.rays.iter().zip(0..);
        self.order
            .extend(rays.map(|((ray, _), i)| cell(ray.direction) << PLACE | (i & LAST)));
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
    fn each_ray_keeps_its_question() {
        let mut shadow = Shadow::default();
        let direction = |i: usize| {
            let turn = i as f64 * 2.4;
            DVec3::new(libm::cos(turn), 0.1, libm::sin(turn)).normalize()
        };
        for i in 0..2 * SORTED {
            shadow.push(Ray::new(DVec3::ZERO, direction(i)), 1.0, i + 7);
        }
        shadow.sort();
        for (half, rays) in shadow.rays.chunks(SORTED).enumerate() {
            let cells = rays.iter().map(|(ray, _)| cell(ray.direction));
            assert!(cells.is_sorted(), "{half}");
        }
        let both = shadow.rays.iter().zip(&shadow.questions);
        for ((ray, _), question) in both {
            assert_eq!(ray.direction, direction(*question as usize - 7));
        }
        let mut questions = shadow.questions.clone();
        questions.sort_unstable();
        assert!(
            questions
                .iter()
                .eq(&(7..7 + 2 * SORTED as u32).collect::<Vec<_>>())
        );
    }
}
