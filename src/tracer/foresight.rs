//! Asking in bundles: what the pixels of a tile are about to ask, answered for all of them together.
//!
//! Neighbouring eye rays, and the shadow rays from where they arrive to one light, run through the same part of the
//! scene; an accelerator that follows them together is several times as fast. The tracer stays the one recursive
//! function that it is: it asks a foreseen question like any other, and the answer is the same to the last bit.

use super::film::Tile;
use super::lights::{Question, question, samples, seen};
use super::samples::{Place, place};
use crate::geometry::Hit;
use crate::math::{Interval, Ray};
use crate::scene::{Effect, Settings, World};

/// The edge of the blocks in which a tile's rays are put side by side: a block's rays make one bundle.
const BLOCK: u32 = 4;

/// The answers for one sample of each of some pixels.
#[derive(Default)]
pub struct Foresight {
    places: Vec<Place>,
    rays: Vec<(Ray, Interval)>,
    hits: Vec<Option<Hit>>,
    /// For each pixel, light by light: whether something stands before it; `None` where it is not asked.
    blocked: Vec<Option<bool>>,
    lights: usize,
}

/// What is foreseen of one eye ray.
#[derive(Clone, Copy)]
pub struct Foreseen<'a> {
    /// Its closest hit.
    pub hit: Option<Hit>,
    /// Light by light, whether something stands between it and the hit.
    pub blocked: &'a [Option<bool>],
}

impl Foresight {
    /// Asks for sample number `sample` of all `pixels`.
    pub fn ask(
        &mut self,
        world: &World,
        settings: &Settings,
        pixels: impl Iterator<Item = (u32, u32)>,
        sample: u32,
    ) {
        let camera = &world.scene.camera;
        self.places.clear();
        self.places
            .extend(pixels.map(|pixel| place(settings, pixel, sample)));
        self.rays.clear();
        self.rays.extend(self.places.iter().map(|place| {
            let ray = camera.ray(place.film, settings.size());
            (ray, Interval::FORWARD)
        }));
        self.hits.clear();
        self.hits.resize(self.rays.len(), None);
        world
            .accel
            .closest_many(&world.scene.shapes, &self.rays, &mut self.hits);
        self.lights = world.scene.lights.len();
        self.blocked.clear();
        self.blocked.resize(self.rays.len() * self.lights, None);
        for light in 0..self.lights {
            let one_ray = samples(&world.scene, settings, light as u32) == 1;
            if one_ray && settings.effects.has(Effect::Shadows) {
                self.ask_light(world, settings, light);
            }
        }
    }

    /// Asks whether each hit sees a light to which one ray is sent. (Many rays to an area make a bundle at each hit.)
    fn ask_light(&mut self, world: &World, settings: &Settings, light: usize) {
        let scene = &world.scene;
        let number = light as u32;
        let (mut places, mut rays) = (Vec::new(), Vec::new());
        for (place, ((ray, _), hit)) in self.rays.iter().zip(&self.hits).enumerate() {
            let Some(hit) = hit else { continue };
            let at = scene.interaction(ray, hit);
            let material = scene.material_of(hit.primitive);
            let asker = self.places[place].asker;
            let projected = seen(scene, settings, (&at, material), number);
            let surface = (&at, material, projected.as_deref());
            let asked = question(scene, settings, asker, surface, (number, 0));
            if let Ok(Question { ray, lit, .. }) = asked {
                places.push(place);
                rays.push((ray, Interval::before(lit.distance)));
            }
        }
        let mut blocked = vec![false; rays.len()];
        world.accel.any_many(&scene.shapes, &rays, &mut blocked);
        for (place, blocked) in places.into_iter().zip(blocked) {
            self.blocked[place * self.lights + light] = Some(blocked);
        }
    }

    /// The samples in the order in which they were asked for, each with its eye ray and what is foreseen of it.
    pub fn samples(&self) -> impl Iterator<Item = (&Place, Ray, Foreseen<'_>)> {
        (0..self.places.len()).map(|i| {
            let foreseen = Foreseen {
                hit: self.hits[i],
                blocked: &self.blocked[i * self.lights..][..self.lights],
            };
            (&self.places[i], self.rays[i].0, foreseen)
        })
    }
}

/// The pixels of a tile, block after block.
pub fn in_blocks(tile: Tile) -> Vec<(u32, u32)> {
    let blocks = |[start, end]: [u32; 2]| {
        (start..end)
            .step_by(BLOCK as usize)
            .map(move |a| (a, (a + BLOCK).min(end)))
    };
    blocks(tile.y)
        .flat_map(|rows| blocks(tile.x).map(move |columns| (rows, columns)))
        .flat_map(|(rows, columns)| {
            (rows.0..rows.1).flat_map(move |y| (columns.0..columns.1).map(move |x| (x, y)))
        })
        .collect()
}
