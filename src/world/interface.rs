//! Interface: the next surface of a ray where light changes, an opaque one or the boundary of two media.
//!
//! Surfaces that rounding cannot tell apart are crossed as one. So water that ends exactly where its glass begins has one
//! interface, from water to glass, and no film of air in between that would mirror like silver. A surface with the same medium
//! on both sides changes nothing and is passed.

use std::cmp::Reverse;

use super::medium::{Crossing, OpenMedia};
use super::{Contact, RayBudget, Scratch, World};
use crate::geometry::Hit;
use crate::math::{Interval, Ray};
use crate::probe::{Event, Probe, tell};
use crate::shading::Interaction;

/// Next hit of a ray where light changes.
#[derive(Clone, Copy, Debug)]
pub struct NextHit<'f> {
    /// The hit.
    pub hit: &'f Hit,
    /// Its point.
    pub at: &'f Interaction,
    /// The media, if the surface is transparent.
    pub interface: Option<&'f Interface>,
    /// True if it is the closest hit of the ray as it was found, and nothing touches it.
    pub is_first: bool,
}

/// Surface among media.
#[derive(Clone, Copy, Debug)]
pub struct Surface {
    hit: Hit,
    at: Interaction,
    interface: Option<Interface>,
    is_first: bool,
}

/// Media on both sides of a transparent surface.
#[derive(Clone, Copy, Debug)]
pub struct Interface {
    /// Before and behind, as objects or [`crate::probe::NONE`].
    pub media: [u32; 2],
    /// Indices of refraction, likewise.
    pub ior: [f64; 2],
    /// The open objects that a ray is inside of behind.
    pub beyond: OpenMedia,
}

/// What a ray crosses at one point.
struct Crossed {
    /// t of the last surface that is crossed.
    end: f64,
    media: [u32; 2],
    beyond: OpenMedia,
}

impl<'f> NextHit<'f> {
    /// The closest hit of a ray, on an opaque object that touches no transparent one.
    #[inline(always)]
    pub fn opaque(hit: &'f Hit, at: &'f Interaction) -> Self {
        Self {
            hit,
            at,
            interface: None,
            is_first: true,
        }
    }
}

impl Surface {
    /// The closest hit of a ray, before anything is known of its media.
    pub fn new((hit, at): (&Hit, &Interaction)) -> Self {
        Self {
            hit: *hit,
            at: *at,
            interface: None,
            is_first: true,
        }
    }

    /// The surface as the next hit of its ray.
    pub fn next_hit(&self) -> NextHit<'_> {
        NextHit {
            hit: &self.hit,
            at: &self.at,
            interface: self.interface.as_ref(),
            is_first: self.is_first,
        }
    }
}

impl World {
    /// Moves from the closest hit of a ray that is inside the open objects `media` to the next interface; false if there is none, and
    /// the ray leaves the scene.
    ///
    /// Surfaces that change nothing are passed and told of; each costs as much as a ray and counts as one.
    #[inline(always)]
    pub fn next_interface<P: Probe>(
        &self,
        ray: &Ray,
        surface: &mut Surface,
        (media, scratch): (&mut OpenMedia, &mut Scratch),
        rays: &mut RayBudget,
        probe: &mut P,
    ) -> bool {
        while self.contact(surface.hit.primitive) != Contact::None {
            let crossed = self.cross(ray, surface, *media, scratch);
            if !self.is_transmissive(surface.hit.primitive) {
                break;
            }
            let [before, behind] = crossed.media;
            if before != behind || rays.is_spent() {
                surface.interface = Some(Interface {
                    media: crossed.media,
                    ior: crossed.media.map(|medium| self.scene.medium_ior(medium)),
                    beyond: crossed.beyond,
                });
                break;
            }
            let hit = surface.hit;
            tell!(
                probe,
                Event::Passed {
                    hit,
                    medium: before
                }
            );
            rays.ray();
            *media = crossed.beyond;
            let Some(hit) = self.closest(ray, crossed.end, probe) else {
                return false;
            };
            surface.hit = hit;
            surface.at = self.scene.interaction_for_shading(ray, &surface.hit);
            surface.is_first = false;
        }
        true
    }

    /// What `ray` crosses at its closest `surface`, together with all that touches it; moves to the surface that counts: an
    /// opaque one if there is one, then that of the highest priority, then of the smallest id.
    fn cross(
        &self,
        ray: &Ray,
        surface: &mut Surface,
        media: OpenMedia,
        scratch: &mut Scratch,
    ) -> Crossed {
        let hit = surface.hit;
        let ahead = self.crossings_from(ray, (&hit, &surface.at), scratch);
        let (crossed, rest) = ahead.split_at(self.coincident(ray, ahead, &hit, &surface.at));
        let beyond = crossed
            .iter()
            .fold(media, |inside, crossing| match crossing.enters {
                Some(true) if self.is_open(crossing.object) => inside.and(crossing.object),
                Some(false) => inside.without(crossing.object),
                _ => inside,
            });
        let is_medium = |c: &Crossing| self.is_transmissive(c.hit.primitive);
        if crossed.len() > 1 && crossed.iter().any(is_medium) {
            self.move_to_highest_priority(ray, crossed, surface);
        }
        Crossed {
            end: crossed.last().map_or(hit.t, |last| last.hit.t),
            media: [self.medium(&media, ahead), self.medium(&beyond, rest)],
            beyond,
        }
    }

    /// Moves to the surface that counts, of many. The error of its point covers all of them, so that rays that leave it are
    /// clear of all.
    fn move_to_highest_priority(&self, ray: &Ray, crossed: &[Crossing], surface: &mut Surface) {
        let scene = &self.scene;
        let rank = |crossing: &&Crossing| {
            let opaque = !self.is_transmissive(crossing.hit.primitive);
            let priority = scene.medium_priority(crossing.object);
            (opaque, priority, Reverse(crossing.hit.primitive))
        };
        // Of equal ones the first.
        if let Some(first) = crossed.iter().rev().max_by_key(rank) {
            surface.hit = first.hit;
            surface.at = scene.interaction_for_shading(ray, &surface.hit);
        }
        let cos = surface.at.geometric_normal.dot(surface.at.to_viewer);
        let errors = crossed.iter().map(|crossing| {
            let gap = (crossing.hit.t - surface.hit.t).abs() * cos;
            gap + scene
                .interaction_for_shading(ray, &crossing.hit)
                .normal_error()
        });
        let largest = errors.fold(0.0, f64::max);
        surface.at = surface.at.with_normal_error(largest);
        surface.is_first = false;
    }

    /// Number of the crossings `ahead`, the first of which is `hit`, that are crossed as one with it.
    fn coincident(&self, ray: &Ray, ahead: &[Crossing], hit: &Hit, at: &Interaction) -> usize {
        let touches = |crossing: &&Crossing| {
            let other = self.scene.interaction_for_shading(ray, &crossing.hit);
            touch((hit.t, at), (crossing.hit.t, &other))
        };
        (1 + ahead.iter().skip(1).take_while(touches).count()).min(ahead.len())
    }

    /// Other objects whose surfaces touch that of `hit` where `ray` meets it, for explanations.
    pub fn touching(&self, ray: &Ray, hit: &Hit) -> Vec<u32> {
        let at = self.scene.interaction(ray, hit);
        let own = self.scene.owners[hit.primitive as usize];
        let mut objects = Vec::new();
        for crossing in self.crossings(ray, Interval::FORWARD) {
            let other = self.scene.interaction(ray, &crossing.hit);
            let new = crossing.object != own && !objects.contains(&crossing.object);
            if new && touch((hit.t, &at), (crossing.hit.t, &other)) {
                objects.push(crossing.object);
            }
        }
        objects
    }

    fn is_transmissive(&self, primitive: u32) -> bool {
        self.scene.material_of(primitive).is_transmissive()
    }
}

/// True if two points on a ray cannot be told apart: their distance, measured at right angles to the steeper of the two
/// surfaces, is within the errors of both.
fn touch((t, at): (f64, &Interaction), (u, other): (f64, &Interaction)) -> bool {
    let steepness = |at: &Interaction| at.geometric_normal.dot(at.to_viewer);
    let gap = (u - t).abs() * steepness(at).max(steepness(other));
    gap <= at.normal_error() + other.normal_error()
}
