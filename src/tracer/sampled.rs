//! A pixel that is being sampled.

use super::pixel::{Pixel, counted};
use super::samples::{Place, Weights, place};
use super::spread::Spread;
use super::tile_batch::PixelBatch;
use super::whitted::Tracer;
use crate::math::{Ray, Rgb};
use crate::probe::{Event, Probe, tell};
use crate::scene::{Budget, Pilot, Settings};

/// What is known of it.
pub struct Sampled {
    at: (u32, u32),
    pixel: Pixel,
    /// The samples after which it is decided whether more are needed.
    target: u32,
    /// The weights, if the number of samples is known.
    weights: Option<Weights>,
    /// What the samples brought until it is.
    kept: Option<Vec<(Rgb, f64)>>,
    /// For the standard error, if somebody wants to know it.
    spread: Option<Box<Spread>>,
}

impl Sampled {
    /// A pixel without samples.
    #[inline]
    pub fn new(settings: &Settings, budget: Budget, at: (u32, u32)) -> Self {
        let known = settings.pixel.adaptive.is_none().then_some(budget.samples);
        Self::with(settings, budget, at, known)
    }

    /// The same, where the number of samples may be known before.
    #[inline]
    pub fn with(settings: &Settings, budget: Budget, at: (u32, u32), known: Option<u32>) -> Self {
        let decides = known.is_none() && !settings.pixel.asks_around();
        let afforded = budget.samples;
        Self {
            at,
            pixel: Pixel {
                cut: afforded < settings.pixel.most_samples(),
                ..Pixel::default()
            },
            target: known.unwrap_or(settings.pixel.samples.min(afforded)),
            weights: known.map(|count| Weights::new(settings, at, count)),
            kept: known.is_none().then(Vec::new),
            spread: (decides || settings.pixel.errors).then(|| Box::new(new_spread(settings))),
        }
    }

    /// Samples that it has so far.
    pub fn samples(&self) -> u32 {
        self.pixel.samples
    }

    /// True if its own samples decide how many there are.
    pub fn decides(&self) -> bool {
        self.weights.is_none()
    }

    /// Samples that it is to have, as far as is known.
    pub fn target(&self) -> u32 {
        self.target
    }

    /// The pixel's place in the picture.
    pub fn at(&self) -> (u32, u32) {
        self.at
    }

    /// True if another sample is needed.
    #[inline]
    pub fn is_open(&mut self, settings: &Settings) -> bool {
        self.pixel.samples < self.target || self.raise_target(settings)
    }

    /// More samples for a pixel that may have more: true if it needs them.
    fn raise_target(&mut self, settings: &Settings) -> bool {
        let (None, Some(adaptive)) = (self.weights, settings.pixel.adaptive) else {
            return false;
        };
        let error = self.standard_error();
        let taken = self.pixel.samples;
        let more = match adaptive.pilot {
            // As many again, until the error is small enough.
            Pilot::Kept if error > adaptive.threshold && !self.pixel.cut => taken,
            // The error falls as n^-1/2 if the samples are independent, and faster if they are not.
            Pilot::Apart if taken == settings.pixel.pilot() => {
                self.spread = Some(Box::new(new_spread(settings)));
                let times = (error / adaptive.threshold).powi(2).clamp(1.0, 1e6);
                taken.saturating_mul((times.ceil() as u32).next_power_of_two())
            }
            _ => 0,
        };
        self.target = taken.saturating_add(more).min(settings.samples_afforded());
        self.target > taken
    }

    /// Adds what a sample brings along its eye ray. Rays are counted over all samples, since the budget is the pixel's.
    #[inline]
    pub fn add<P: Probe>(
        &mut self,
        tracer: &mut Tracer<P>,
        (place, ray): (&Place, Ray),
        prefetched: Option<PixelBatch>,
    ) {
        let rays = &mut tracer.rays;
        (rays.sent, rays.used) = (self.pixel.rays, self.pixel.spent);
        rays.truncated = self.pixel.cut;
        let brought = tracer.camera_ray(place.asker, ray, prefetched);
        let rays = tracer.rays;
        (self.pixel.rays, self.pixel.spent) = (rays.sent, rays.used);
        self.pixel.cut = rays.truncated;
        let index = self.pixel.samples;
        self.pixel.samples += 1;
        let radiance = counted(brought);
        if !brought.is_finite() {
            self.pixel.spoiled += 1;
            self.pixel.first_spoiled.get_or_insert(index);
        }
        if let Some(weights) = self.weights {
            self.pixel.color += radiance * weights.of(index, place.sign);
        } else if let Some(kept) = &mut self.kept {
            kept.push((radiance, place.sign));
        }
        if let Some(spread) = &mut self.spread {
            spread.add(radiance.luminance(), place.sign);
        }
    }

    /// Takes the next sample.
    #[inline]
    pub fn next<P: Probe>(&mut self, tracer: &mut Tracer<P>) {
        let settings = tracer.settings;
        let index = self.pixel.samples;
        let place = place(settings, self.at, index);
        if let Some(weights) = self.weights {
            tell!(
                tracer.probe,
                Event::Sample {
                    index,
                    film: place.film,
                    weight: weights.of(index, place.sign),
                }
            );
        }
        let camera = &tracer.world.scene.camera;
        let ray = camera.ray(place.film, settings.size());
        self.add(tracer, (&place, ray), None);
    }

    /// How much its first samples differ: the estimated variance of their mean.
    pub fn noise(&self, settings: &Settings) -> f64 {
        let mut spread = Spread::new(settings.pixel.samples.div_ceil(2));
        for (radiance, _) in self.kept.iter().flatten() {
            spread.add(radiance.luminance(), 1.0);
        }
        spread.standard_error().powi(2)
    }

    /// It is decided that it has `count` samples in all: now weights are known, also of those that it has.
    pub fn settle(&mut self, settings: &Settings, count: u32) {
        let weights = Weights::new(settings, self.at, count);
        for (index, (radiance, sign)) in (0..).zip(self.kept.take().into_iter().flatten()) {
            self.pixel.color += radiance * weights.of(index, sign);
        }
        self.weights = Some(weights);
        self.target = count;
    }

    /// Takes sample after sample, as many as it needs.
    #[inline]
    pub fn follow<P: Probe>(&mut self, tracer: &mut Tracer<P>) {
        while self.is_open(tracer.settings) {
            self.next(tracer);
        }
    }

    fn standard_error(&self) -> f64 {
        let spread = self.spread.as_ref();
        spread.map_or(f64::INFINITY, |spread| spread.standard_error())
    }

    /// The pixel with all its samples.
    pub fn finish(&mut self, settings: &Settings) -> &Pixel {
        self.pixel.error = self.standard_error();
        if self.kept.is_some() {
            self.settle(settings, self.pixel.samples);
        }
        &self.pixel
    }
}

/// Sets are groups; without them groups grow from single samples.
fn new_spread(settings: &Settings) -> Spread {
    Spread::new(if settings.pixel.sets > 1 {
        settings.pixel.set_size()
    } else {
        1
    })
}
