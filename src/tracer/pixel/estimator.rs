//! The estimator of a pixel's colour: takes samples until there are enough, and adds them up by their weights.

use super::adaptive::{further_samples, neighbours, samples_by_neighbours};
use super::camera_sample::{CameraSample, camera_sample};
use super::estimate::Pixel;
use super::weights::Weights;
use crate::math::{Ray, Rgb};
use crate::probe::{Event, Probe, Silent, tell};
use crate::sampling::BatchMeans;
use crate::scene::{Budget, Settings};
use crate::tracer::laws::Laws;
use crate::tracer::state::Tracer;
use crate::tracer::tile::Tile;
use crate::tracer::tile_batch::PixelBatch;
use crate::world::World;

/// A pixel that is being sampled.
pub struct PixelEstimator {
    at: (u32, u32),
    pixel: Pixel,
    /// The number of samples after which it is decided whether more are needed.
    target: u32,
    /// The weights, once the number of samples is known.
    weights: Option<Weights>,
    /// Until then, the radiance and the filter's sign of each sample.
    pending: Option<Vec<(Rgb, f64)>>,
    /// For the standard error, if it is needed.
    means: Option<Box<BatchMeans>>,
}

impl PixelEstimator {
    /// A pixel without samples. (Always inlined, as what it calls: left to the compiler, that depends on code that has nothing to do
    /// with it.)
    #[inline(always)]
    pub fn new(settings: &Settings, budget: Budget, at: (u32, u32)) -> Self {
        let count = settings.pixel.adaptive.is_none().then_some(budget.samples);
        Self::with_samples(settings, budget, at, count)
    }

    /// A pixel that is to have `count` samples, if that is known.
    #[inline(always)]
    fn with_samples(
        settings: &Settings,
        budget: Budget,
        at: (u32, u32),
        count: Option<u32>,
    ) -> Self {
        let decides = count.is_none() && !settings.pixel.asks_around();
        let afforded = budget.samples;
        Self {
            at,
            pixel: Pixel {
                truncated: afforded < settings.pixel.most_samples(),
                ..Pixel::EMPTY
            },
            target: count.unwrap_or(settings.pixel.samples.min(afforded)),
            weights: count.map(|count| Weights::new(settings, at, count)),
            pending: count.is_none().then(Vec::new),
            means: (decides || settings.pixel.errors).then(|| Box::new(batch_means(settings))),
        }
    }

    /// A pixel that is traced on its own: if its neighbours decide how many samples it has, they are sampled first.
    #[inline]
    fn alone(world: &World, settings: &Settings, budget: Budget, at: (u32, u32)) -> Self {
        if settings.pixel.asks_around() {
            let count = Self::pilot_neighbours(world, settings, at);
            return Self::with_samples(settings, budget, at, Some(count));
        }
        Self::new(settings, budget, at)
    }

    /// Samples a pixel's neighbours, silently, for the number of its own samples.
    fn pilot_neighbours(world: &World, settings: &Settings, at: (u32, u32)) -> u32 {
        let mut silent = Silent;
        let mut tracer = Tracer::new(world, settings, &mut silent);
        let budget = tracer.budget;
        let around = neighbours(Tile::containing(settings, at), at);
        let variances = around.map(|at| {
            let mut neighbour = Self::new(settings, budget, at);
            neighbour.run(&mut tracer);
            neighbour.pilot_variance(settings)
        });
        samples_by_neighbours(settings, variances)
    }

    /// Traces a pixel on its own, with all its samples.
    ///
    /// Where its samples decide how many there are to be, their weights are known only after the last. Then a probe that
    /// listens hears of the second of two passes; the first, silent one finds out how many there are.
    #[inline]
    pub fn trace<P: Probe, L: Laws>(tracer: &mut Tracer<P, L>, at: (u32, u32)) -> Pixel {
        let (world, settings) = (tracer.world, tracer.settings);
        let mut estimator = Self::alone(world, settings, tracer.budget, at);
        if !P::LISTENS || estimator.weights.is_some() {
            estimator.run(tracer);
            return *estimator.finish(settings);
        }
        let mut silent = Silent;
        estimator.run(&mut Tracer::new(world, settings, &mut silent));
        let found = *estimator.finish(settings);
        Pixel {
            error: found.error,
            ..Self::trace_samples(tracer, at, found.samples)
        }
    }

    /// Traces a pixel that is to have `count` samples.
    pub fn trace_samples<P: Probe, L: Laws>(
        tracer: &mut Tracer<P, L>,
        at: (u32, u32),
        count: u32,
    ) -> Pixel {
        let settings = tracer.settings;
        let mut estimator = Self::with_samples(settings, tracer.budget, at, Some(count));
        estimator.run(tracer);
        *estimator.finish(settings)
    }

    /// Traces a pixel silently on its own; `None` as soon as `stopped` says so between two samples.
    pub fn trace_unless(
        world: &World,
        settings: &Settings,
        at: (u32, u32),
        stopped: &dyn Fn() -> bool,
    ) -> Option<Pixel> {
        let mut silent = Silent;
        let mut tracer = Tracer::new(world, settings, &mut silent);
        let mut estimator = Self::alone(world, settings, tracer.budget, at);
        while estimator.is_open(settings) {
            if stopped() {
                return None;
            }
            estimator.next(&mut tracer);
        }
        Some(*estimator.finish(settings))
    }

    /// The pixel's column and row.
    pub fn at(&self) -> (u32, u32) {
        self.at
    }

    /// The number of samples so far.
    pub fn samples(&self) -> u32 {
        self.pixel.samples
    }

    /// The number of samples that it is to have, as far as is known.
    pub fn target(&self) -> u32 {
        self.target
    }

    /// True if another sample is needed.
    #[inline]
    pub fn is_open(&mut self, settings: &Settings) -> bool {
        self.pixel.samples < self.target || (self.weights.is_none() && self.raise_target(settings))
    }

    /// Raises the target of a pixel that decides itself; true if it needs more samples.
    fn raise_target(&mut self, settings: &Settings) -> bool {
        let Some(adaptive) = settings.pixel.adaptive else {
            return false;
        };
        let taken = self.pixel.samples;
        let more = further_samples(settings, adaptive, &self.pixel, self.standard_error());
        if taken == settings.pixel.pilot() {
            // Pilot samples do not count, and are not in the error either.
            self.means = Some(Box::new(batch_means(settings)));
        }
        self.target = taken.saturating_add(more).min(settings.samples_afforded());
        self.target > taken
    }

    /// Takes the samples that it needs.
    #[inline]
    pub fn run<P: Probe, L: Laws>(&mut self, tracer: &mut Tracer<P, L>) {
        while self.is_open(tracer.settings) {
            self.next(tracer);
        }
    }

    /// Takes the next sample.
    #[inline]
    fn next<P: Probe, L: Laws>(&mut self, tracer: &mut Tracer<P, L>) {
        let settings = tracer.settings;
        let index = self.pixel.samples;
        let sample = camera_sample(settings, self.at, index);
        if let Some(weights) = self.weights {
            tell!(
                tracer.probe,
                Event::Sample {
                    index,
                    film: sample.film,
                    weight: weights.of(index, sample.sign),
                }
            );
        }
        let camera = &tracer.world.scene.camera;
        let ray = tracer.laws.eye_ray(camera, sample.film, settings.size());
        self.add(tracer, (&sample, ray), None);
    }

    /// Adds the radiance of a sample along its camera ray. Rays are counted over all samples, since the budget is the
    /// pixel's.
    #[inline]
    pub fn add<P: Probe, L: Laws>(
        &mut self,
        tracer: &mut Tracer<P, L>,
        (sample, ray): (&CameraSample, Ray),
        prefetched: Option<PixelBatch>,
    ) {
        let rays = &mut tracer.rays;
        (rays.sent, rays.used) = (self.pixel.rays, self.pixel.budget_used);
        rays.truncated = self.pixel.truncated;
        let traced = tracer.camera_ray(sample.path, ray, prefetched);
        let rays = tracer.rays;
        (self.pixel.rays, self.pixel.budget_used) = (rays.sent, rays.used);
        self.pixel.truncated = rays.truncated;
        if !tracer.cuts.is_empty() {
            self.pixel.cuts = self.pixel.cuts.plus(std::mem::take(&mut tracer.cuts));
        }
        let index = self.pixel.samples;
        self.pixel.samples += 1;
        let radiance = traced.finite_or_black();
        if !traced.is_finite() {
            self.pixel.non_finite += 1;
            self.pixel.first_non_finite.get_or_insert(index);
        }
        if let Some(weights) = self.weights {
            self.pixel.color += radiance * weights.of(index, sample.sign);
        } else if let Some(pending) = &mut self.pending {
            pending.push((radiance, sample.sign));
        }
        if let Some(means) = &mut self.means {
            means.add(radiance.luminance(), sample.sign);
        }
    }

    /// The variance of the mean of its first samples, estimated from their two halves.
    fn pilot_variance(&self, settings: &Settings) -> f64 {
        let mut halves = BatchMeans::new(settings.pixel.samples.div_ceil(2));
        for (radiance, _) in self.pending.iter().flatten() {
            halves.add(radiance.luminance(), 1.0);
        }
        halves.standard_error().powi(2)
    }

    /// Decides how many samples all pixels of a tile have, each by the first samples of its neighbours.
    pub fn settle_tile(settings: &Settings, tile: Tile, pixels: &mut [Self]) {
        let mut variances = vec![0.0; pixels.len()];
        for pixel in pixels.iter() {
            variances[tile.index(pixel.at)] = pixel.pilot_variance(settings);
        }
        for pixel in pixels {
            let around = neighbours(tile, pixel.at).map(|at| variances[tile.index(at)]);
            pixel.settle(settings, samples_by_neighbours(settings, around));
        }
    }

    /// Decides that it has `count` samples in all: now weights are known, also of those that it has.
    fn settle(&mut self, settings: &Settings, count: u32) {
        let weights = Weights::new(settings, self.at, count);
        for (index, (radiance, sign)) in (0..).zip(self.pending.take().into_iter().flatten()) {
            self.pixel.color += radiance * weights.of(index, sign);
        }
        self.weights = Some(weights);
        self.target = count;
    }

    /// The estimate from all its samples.
    #[inline]
    pub fn finish(&mut self, settings: &Settings) -> &Pixel {
        self.pixel.error = self.standard_error();
        if self.pending.is_some() {
            self.settle(settings, self.pixel.samples);
        }
        &self.pixel
    }

    fn standard_error(&self) -> f64 {
        let means = self.means.as_ref();
        means.map_or(f64::INFINITY, |means| means.standard_error())
    }
}

/// Batch means whose groups are the sample sets; without sets groups grow from single samples.
fn batch_means(settings: &Settings) -> BatchMeans {
    BatchMeans::new(if settings.pixel.sets > 1 {
        settings.pixel.set_size()
    } else {
        1
    })
}
