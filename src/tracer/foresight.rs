//! Asking in bundles: what the pixels of a tile are about to ask, answered for all of them together.
//!
//! Neighbouring eye rays, and the shadow rays from where they arrive to one light, run through the same part of the
//! scene; an accelerator that follows them together is several times as fast. The tracer stays the one recursive
//! function that it is: it asks a foreseen question like any other, and the answer is the same to the last bit.

use std::ops::Range;

use super::area::AreaView;
use super::lights::{Asker, Question, Surface, question, samples};
use super::samples::{Place, place};
use super::shadow::Shadow;
use super::tile::Tile;
use crate::geometry::Hit;
use crate::math::{Interval, Ray};
use crate::probe::Absence;
use crate::scene::{Effect, Scene, Settings};
use crate::shading::Interaction;
use crate::world::World;

/// The edge of the blocks in which a tile's rays are put side by side: a block's rays make one bundle.
const BLOCK: u32 = 4;

/// Questions of a pixel that are foreseen at most; a light with more is asked hit by hit. It bounds the memory.
const MOST_QUESTIONS: usize = 64;

/// The answers for one sample of each of some pixels.
#[derive(Default)]
pub struct Foresight {
    places: Vec<Place>,
    rays: Vec<(Ray, Interval)>,
    hits: Vec<Option<Hit>>,
    /// For each pixel, where its ray arrives.
    arrivals: Vec<Option<Interaction>>,
    /// For each pixel its questions, light by light; `None` where its ray arrives nowhere.
    asked: Vec<Option<Asked>>,
    /// For each light, which of a pixel's questions are to it: none if it is not foreseen.
    spans: Vec<Range<usize>>,
    /// Questions of each pixel.
    stride: usize,
    shadow: Shadow,
}

/// What a place asks of a light with one ray.
#[derive(Clone, Copy, Debug)]
pub struct Asked {
    /// The question, or why there is none.
    pub question: Result<Question, Absence>,
    /// Whether something stands before the light.
    pub blocked: bool,
}

/// What is foreseen of one eye ray.
#[derive(Clone, Copy)]
pub struct Foreseen<'a> {
    /// Its closest hit, and the place.
    pub found: Option<(&'a Hit, &'a Interaction)>,
    asked: &'a [Option<Asked>],
    spans: &'a [Range<usize>],
}

impl Foresight {
    /// Asks for sample number `sample` of all `pixels`; false if there are none.
    pub fn ask(
        &mut self,
        world: &World,
        settings: &Settings,
        pixels: impl Iterator<Item = (u32, u32)>,
        sample: u32,
    ) -> bool {
        let (scene, camera) = (&world.scene, &world.scene.camera);
        self.places.clear();
        self.places
            .extend(pixels.map(|pixel| place(settings, pixel, sample)));
        if self.places.is_empty() {
            return false;
        }
        self.rays.clear();
        self.rays.extend(self.places.iter().map(|place| {
            let ray = camera.ray(place.film, settings.size());
            (ray, Interval::FORWARD)
        }));
        self.hits.clear();
        self.hits.resize(self.rays.len(), None);
        world
            .accel
            .closest_many(&scene.shapes, &self.rays, &mut self.hits);
        let rays_and_hits = self.rays.iter().zip(&self.hits);
        self.arrivals.clear();
        self.arrivals.extend(
            rays_and_hits.map(|((ray, _), hit)| Some(scene.interaction(ray, hit.as_ref()?))),
        );
        self.share_out(scene, settings);
        self.asked.clear();
        self.asked.resize(self.rays.len() * self.stride, None);
        for light in 0..self.spans.len() {
            self.ask_light(world, settings, light);
        }
        true
    }

    /// Which questions to which lights are foreseen.
    fn share_out(&mut self, scene: &Scene, settings: &Settings) {
        self.spans.clear();
        self.stride = 0;
        if !settings.effects.has(Effect::Shadows) {
            return;
        }
        for light in 0..scene.lights.len() as u32 {
            let wanted = samples(scene, settings, light) as usize;
            let fits = self.stride + wanted <= MOST_QUESTIONS;
            let count = if fits { wanted } else { 0 };
            self.spans.push(self.stride..self.stride + count);
            self.stride += count;
        }
    }

    /// Asks from each hit whether a light is seen.
    fn ask_light(&mut self, world: &World, settings: &Settings, light: usize) {
        let (scene, number) = (&world.scene, light as u32);
        let span = self.spans[light].clone();
        if span.is_empty() {
            return;
        }
        let to_area = scene.lights[light].source.is_area();
        self.shadow.clear();
        for (i, place) in self.places.iter().enumerate() {
            let Some((hit, at)) = self.hits[i].as_ref().zip(self.arrivals[i].as_ref()) else {
                continue;
            };
            let surface = Surface::new(at, scene.material_of(hit.primitive));
            let first = i * self.stride + span.start;
            let asked = &mut self.asked[first..][..span.len()];
            if to_area {
                let ask = (settings, place.asker, number);
                ask_area(scene, ask, &surface, &mut self.shadow, (first, asked));
            } else {
                let question = question(scene, settings, (&surface, None), (number, 0));
                asked[0] = Some(foresee(&mut self.shadow, question, first));
            }
        }
        for (index, blocked) in self.shadow.answers(world, to_area) {
            if let Some(asked) = &mut self.asked[index] {
                asked.blocked = blocked;
            }
        }
    }

    /// The samples in the order in which they were asked for, each with its eye ray and what is foreseen of it.
    pub fn samples(&self) -> impl Iterator<Item = (&Place, Ray, Foreseen<'_>)> {
        (0..self.places.len()).map(|i| {
            let foreseen = Foreseen {
                found: self.hits[i].as_ref().zip(self.arrivals[i].as_ref()),
                asked: &self.asked[i * self.stride..][..self.stride],
                spans: &self.spans,
            };
            (&self.places[i], self.rays[i].0, foreseen)
        })
    }
}

impl<'a> Foreseen<'a> {
    /// What the place asks of a light, ray by ray; `None` if that is not foreseen.
    #[inline]
    pub fn asked(&self, light: u32) -> Option<&'a [Option<Asked>]> {
        let span = self.spans.get(light as usize)?;
        (!span.is_empty()).then(|| &self.asked[span.clone()])
    }
}

/// What is asked of an area from one place. (On its own, so that scenes without areas pay nothing for it.)
#[inline(never)]
fn ask_area(
    scene: &Scene,
    (settings, asker, light): (&Settings, Asker, u32),
    surface: &Surface,
    shadow: &mut Shadow,
    (first, asked): (usize, &mut [Option<Asked>]),
) {
    let area = AreaView::new(scene, settings, asker, surface, light);
    for ((sample, index), asked) in (0..).zip(first..).zip(asked) {
        let question = question(scene, settings, (surface, area.as_ref()), (light, sample));
        *asked = Some(foresee(shadow, question, index));
    }
}

/// Question number `index`, whose ray is put to the others.
#[inline(always)]
fn foresee(shadow: &mut Shadow, question: Result<Question, Absence>, index: usize) -> Asked {
    if let Ok(Question { ray, lit, .. }) = question {
        shadow.push(ray, lit.distance, index);
    }
    Asked {
        question,
        blocked: false,
    }
}

/// The pixels of a tile, block after block.
pub fn in_blocks(tile: Tile) -> Vec<(u32, u32)> {
    let ([left, right], [top, bottom]) = (tile.x, tile.y);
    let mut pixels = Vec::with_capacity(((right - left) * (bottom - top)) as usize);
    for y0 in (top..bottom).step_by(BLOCK as usize) {
        for x0 in (left..right).step_by(BLOCK as usize) {
            for y in y0..(y0 + BLOCK).min(bottom) {
                pixels.extend((x0..(x0 + BLOCK).min(right)).map(|x| (x, y)));
            }
        }
    }
    pixels
}
