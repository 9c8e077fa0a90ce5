//! Turning knobs: what each position costs, and how far from the reference it stays.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::arithmetic_sweep;
use super::error::{Errors, Reference, errors};
use super::measured::{Measured, Sweep};
use super::parameter::{Parameter, ParameterStep};
use super::pareto;
use crate::accel::{Accel, AccelKind};
use crate::geometry::Arithmetic;
use crate::probe::{Probe, Silent};
use crate::scene::Settings;
use crate::trace::Counts;
use crate::tracer::{Film, render};
use crate::world::World;

/// A scene that is measured.
pub struct Lab {
    /// The scene.
    pub world: World,
    /// Its accelerator.
    pub accel: AccelKind,
    /// What its shapes are tested with.
    pub arithmetic: Arithmetic,
    /// Timed renders of each position.
    pub runs: usize,
    /// Threads, 0 for one a core.
    pub threads: usize,
    /// What everything is compared with, instead of references that are rendered.
    pub given: Option<Reference>,
    /// What the last group was compared with.
    pub reference: Option<Reference>,
}

/// What a position is rendered with instead of the lab's own.
enum Other {
    /// Another structure over the same shapes.
    Accel(Box<Accel>),
    /// A world of these shapes, tested with other arithmetic.
    World(Box<World>),
}

/// A position that is being measured.
struct Bench<'a> {
    parameter: usize,
    step: &'a ParameterStep,
    other: Option<Other>,
    built: Option<f64>,
    counts: Counts,
    errors: Option<Errors>,
    seconds: Vec<f64>,
}

impl Lab {
    /// Measures the knobs of one group until `end`. What is not done by then is left out, the dearest first. Times
    /// are taken in turns, so that other work on the machine meets all alike. `told` hears of everything that begins.
    pub fn measure(
        &mut self,
        parameters: Vec<Parameter>,
        end: Instant,
        told: &dyn Fn(&str),
    ) -> Vec<Sweep> {
        let wanted = parameters.first().and_then(|parameter| parameter.reference);
        let rendered = match wanted {
            Some(settings) if self.given.is_none() => {
                told("the reference");
                let mut other = self.other(&settings, false);
                swap(&mut other, &mut self.world);
                let film = self.film::<Silent>(&settings, end);
                swap(&mut other, &mut self.world);
                let Some((film, _)) = film else {
                    self.reference = None;
                    return parameters
                        .into_iter()
                        .map(|k| Sweep::new(k, vec![]))
                        .collect();
                };
                Some(Reference::new(film, settings.image.exposure))
            }
            _ => None,
        };
        let reference = match wanted {
            Some(_) => rendered.or_else(|| self.given.clone()),
            None => None,
        };
        let mut benches = self.first_renders(&parameters, reference.as_ref(), end, told);
        self.timed_renders(&mut benches, end, told);
        self.reference = reference;

        let mut steps: Vec<Vec<Measured>> = parameters.iter().map(|_| Vec::new()).collect();
        for bench in benches {
            steps[bench.parameter].extend(bench.measured());
        }
        let sweeps = parameters.into_iter().zip(steps);
        let mut sweeps: Vec<Sweep> = sweeps
            .map(|(parameter, s)| Sweep::new(parameter, s))
            .collect();
        pareto::mark(&mut sweeps);
        sweeps
    }

    /// Every position once, the first of each knob first: to count, to compare, and to warm up.
    fn first_renders<'a>(
        &mut self,
        parameters: &'a [Parameter],
        reference: Option<&Reference>,
        end: Instant,
        told: &dyn Fn(&str),
    ) -> Vec<Bench<'a>> {
        let most = parameters
            .iter()
            .map(|parameter| parameter.steps.len())
            .max()
            .unwrap_or(0);
        let order = (0..most).flat_map(|s| (0..parameters.len()).map(move |k| (k, s)));
        let mut benches = Vec::new();
        for (parameter, step) in order.filter_map(|(k, s)| Some((k, parameters[k].steps.get(s)?))) {
            if Instant::now() >= end {
                break;
            }
            told(&step.name);
            let start = Instant::now();
            let other = self.other(&step.settings, step.one_by_one);
            let is_accel = matches!(other, Some(Other::Accel(_)));
            let mut bench = Bench {
                parameter,
                step,
                other,
                built: is_accel.then(|| start.elapsed().as_secs_f64()),
                counts: Counts::default(),
                errors: None,
                seconds: Vec::with_capacity(self.runs),
            };
            swap(&mut bench.other, &mut self.world);
            let done = self.film::<Counts>(&step.settings, end);
            swap(&mut bench.other, &mut self.world);
            let Some((film, counts)) = done else { break };
            bench.counts = counts.iter().fold(Counts::default(), Counts::plus);
            bench.errors = reference.and_then(|r| errors(&film, r, step.settings.image.exposure));
            benches.push(bench);
        }
        benches
    }

    /// Every position with the clock, in turns.
    fn timed_renders(&mut self, benches: &mut [Bench], end: Instant, told: &dyn Fn(&str)) {
        for _ in 0..self.runs {
            for bench in &mut *benches {
                told(&bench.step.name);
                swap(&mut bench.other, &mut self.world);
                let start = Instant::now();
                let done = std::hint::black_box(self.film::<Silent>(&bench.step.settings, end));
                let seconds = start.elapsed().as_secs_f64();
                swap(&mut bench.other, &mut self.world);
                if done.is_none() {
                    return;
                }
                bench.seconds.push(seconds);
            }
        }
    }

    /// What these settings need, if it is not there already.
    fn other(&self, settings: &Settings, one_by_one: bool) -> Option<Other> {
        let (kind, arithmetic) = (settings.accel, settings.arithmetic);
        let scene = &self.world.scene;
        if one_by_one {
            let scene = arithmetic_sweep::one_by_one(scene, arithmetic);
            Some(Other::World(Box::new(World::new(scene, kind))))
        } else if arithmetic != self.arithmetic {
            let scene = scene.clone().computed_with(arithmetic);
            Some(Other::World(Box::new(World::new(scene, kind))))
        } else {
            (kind != self.accel).then(|| Other::Accel(Box::new(Accel::build(kind, &scene.shapes))))
        }
    }

    /// A picture, and what its probes heard; `None` if time runs out before it is done.
    pub fn film<P: Probe + Default + Send>(
        &self,
        settings: &Settings,
        end: Instant,
    ) -> Option<(Film, Vec<P>)> {
        let stopped = AtomicBool::new(false);
        let watch = |_, _| {
            if Instant::now() < end {
                return ControlFlow::Continue(());
            }
            stopped.store(true, Ordering::Relaxed);
            ControlFlow::Break(())
        };
        let done = render(&self.world, settings, self.threads, &watch);
        (!stopped.load(Ordering::Relaxed)).then_some(done)
    }
}

/// Puts something else into the world, or in its place, and after its use takes it out again.
fn swap(other: &mut Option<Other>, world: &mut World) {
    match other {
        Some(Other::Accel(accel)) => std::mem::swap(&mut **accel, &mut world.accel),
        Some(Other::World(other)) => std::mem::swap(&mut **other, world),
        None => {}
    }
}

impl Bench<'_> {
    /// `None` if it was never timed.
    fn measured(mut self) -> Option<Measured> {
        self.seconds.sort_by(f64::total_cmp);
        let seconds = &self.seconds;
        Some(Measured {
            step: self.step.name.clone(),
            samples: self.step.samples,
            seconds: *seconds.get(seconds.len() / 2)?,
            spread: [*seconds.first()?, *seconds.last()?],
            runs: seconds.len(),
            built: self.built,
            counts: self.counts,
            errors: self.errors,
            on_front: false,
        })
    }
}
