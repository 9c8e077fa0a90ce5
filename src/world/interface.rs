//! What changes where a ray crosses transparent surfaces: the medium, or nothing at all.
//!
//! Surfaces that rounding cannot tell apart are crossed as one. So water that ends exactly where its glass begins has one
//! boundary, from water to glass, and no film of air in between that would mirror like silver.

use std::cmp::Reverse;

use crate::geometry::Hit;
use crate::math::{Interval, Ray};
use crate::shading::Interaction;
use crate::world::medium::{Crossing, Entered};
use crate::world::{Room, World};

/// What a ray crosses at one place.
#[derive(Clone, Copy, Debug)]
pub struct Boundary {
    /// The surface that counts: an opaque one, if there is, then that of the highest priority, then of the smallest id.
    pub hit: Hit,
    /// The place on it. Its error covers all surfaces that are crossed, so rays that leave it are clear of all.
    pub at: Interaction,
    /// What changes.
    pub change: Change,
    /// Where the last of the surfaces is crossed.
    pub end: f64,
    /// True if there are many surfaces, and some of them are transparent.
    pub many: bool,
}

/// What changes where a ray goes through.
#[derive(Clone, Copy, Debug)]
pub struct Change {
    /// The media before and behind, as objects or [`crate::probe::NONE`].
    pub media: [u32; 2],
    /// The open objects that a ray is inside of behind.
    pub entered: Entered,
}

impl Boundary {
    /// What `ray`, which is inside the open objects `entered`, crosses at its closest `hit`, the place `at`.
    pub fn new(
        world: &World,
        entered: Entered,
        ray: &Ray,
        (hit, at): (&Hit, &Interaction),
        room: &mut Room,
    ) -> Self {
        let ahead = world.crossings_from(ray, hit, room);
        let (crossed, beyond) = ahead.split_at(together(world, ray, ahead, hit, at));
        let after = crossed
            .iter()
            .fold(entered, |inside, crossing| match crossing.enters {
                Some(true) if world.is_open(crossing.object) => inside.and(crossing.object),
                Some(false) => inside.without(crossing.object),
                _ => inside,
            });
        let is_medium = |c: &Crossing| world.scene.material_of(c.hit.primitive).is_transmissive();
        let many = crossed.len() > 1 && crossed.iter().any(is_medium);
        let boundary = Self {
            hit: *hit,
            at: *at,
            change: Change {
                media: [world.medium(&entered, ahead), world.medium(&after, beyond)],
                entered: after,
            },
            end: crossed.last().map_or(hit.t, |last| last.hit.t),
            many,
        };
        if many {
            boundary.at_what_counts(world, ray, crossed)
        } else {
            boundary
        }
    }

    /// Moves to the surface that counts, of many.
    fn at_what_counts(mut self, world: &World, ray: &Ray, crossed: &[Crossing]) -> Self {
        let scene = &world.scene;
        let rank = |crossing: &&Crossing| {
            let opaque = !scene.material_of(crossing.hit.primitive).is_transmissive();
            let priority = scene.medium_priority(crossing.object);
            (opaque, priority, Reverse(crossing.hit.primitive))
        };
        // Of equal ones the first.
        if let Some(first) = crossed.iter().rev().max_by_key(rank) {
            self.hit = first.hit;
            self.at = scene.interaction(ray, &self.hit);
        }
        let cos = self.at.geometric_normal.dot(self.at.to_viewer);
        let reach = crossed.iter().map(|crossing| {
            let gap = (crossing.hit.t - self.hit.t).abs() * cos;
            gap + scene.interaction(ray, &crossing.hit).reach()
        });
        let furthest = reach.fold(0.0, f64::max);
        self.at = self.at.with_reach(furthest);
        self
    }
}

/// How many of the crossings `ahead`, the first of which is `hit`, are crossed as one with it.
fn together(world: &World, ray: &Ray, ahead: &[Crossing], hit: &Hit, at: &Interaction) -> usize {
    let touches = |crossing: &&Crossing| {
        let other = world.scene.interaction(ray, &crossing.hit);
        touch((hit.t, at), (crossing.hit.t, &other))
    };
    (1 + ahead.iter().skip(1).take_while(touches).count()).min(ahead.len())
}

/// True if two places on a ray cannot be told apart: their distance, measured at right angles to the steeper of the two
/// surfaces, is within the errors of both.
fn touch((t, at): (f64, &Interaction), (u, other): (f64, &Interaction)) -> bool {
    let steepness = |at: &Interaction| at.geometric_normal.dot(at.to_viewer);
    let gap = (u - t).abs() * steepness(at).max(steepness(other));
    gap <= at.reach() + other.reach()
}

/// For explanations: the other objects whose surfaces touch that of `hit` where `ray` met it.
pub fn touching(world: &World, ray: &Ray, hit: &Hit) -> Vec<u32> {
    let at = world.scene.interaction(ray, hit);
    let own = world.scene.owners[hit.primitive as usize];
    let mut objects = Vec::new();
    for crossing in world.crossings(ray, Interval::FORWARD) {
        let other = world.scene.interaction(ray, &crossing.hit);
        let new = crossing.object != own && !objects.contains(&crossing.object);
        if new && touch((hit.t, &at), (crossing.hit.t, &other)) {
            objects.push(crossing.object);
        }
    }
    objects
}
