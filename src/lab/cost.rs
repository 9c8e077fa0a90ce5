//! Turning one knob: what each position costs, and how far from the reference it stays.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use super::error::{Errors, errors};
use super::front;
use super::knobs::Knob;
use crate::accel::Accel;
use crate::probe::{Probe, Silent};
use crate::scene::{Settings, World};
use crate::trace::Counts;
use crate::tracer::{Film, Flow, render};

/// One position of a knob, measured.
#[derive(Clone, Debug)]
pub struct Measured {
    /// Its name.
    pub step: String,
    /// The median time of a render, in seconds.
    pub seconds: f64,
    /// The shortest and the longest.
    pub spread: [f64; 2],
    /// How many renders were timed, after one to warm up.
    pub runs: usize,
    /// What was counted: the same on every machine.
    pub counts: Counts,
    /// Against the reference, if the picture changes at all.
    pub errors: Option<Errors>,
    /// True if nothing else on this knob is both cheaper and nearer.
    pub on_front: bool,
}

/// A knob with all its positions measured.
#[derive(Clone, Debug)]
pub struct Sweep {
    /// The knob.
    pub knob: Knob,
    /// Its positions, in order; fewer if time ran out.
    pub steps: Vec<Measured>,
    /// The fitted slopes of log error over log rays and over log time, if there are enough positions with an error.
    pub slopes: Option<[f64; 2]>,
}

/// How long it may take.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// When to end: what is not done by then is left out.
    pub end: Instant,
    /// Timed renders of each position.
    pub runs: usize,
    /// Threads, 0 for one a core.
    pub threads: usize,
}

/// A scene that is measured, and the references that are known already.
pub struct Lab {
    /// The scene and the accelerator of the knob that is turned.
    pub world: World,
    limits: Limits,
    references: Vec<(Settings, Film)>,
}

impl Lab {
    /// Nothing is measured yet.
    pub fn new(world: World, limits: Limits) -> Self {
        Self {
            world,
            limits,
            references: Vec::new(),
        }
    }

    /// Measures all positions of a knob. `told` hears of each that begins.
    pub fn measure(&mut self, knob: Knob, told: &dyn Fn(&str)) -> Sweep {
        let mut steps = Vec::new();
        told("the reference");
        let reference = knob.reference.map(|settings| self.reference(settings));
        for (step, settings) in &knob.steps {
            if reference == Some(None) {
                break;
            }
            told(step);
            // What never changes the picture is the accelerator: only then another one is to be built.
            if knob.reference.is_none() {
                self.world.accel = Accel::build(settings.accel, &self.world.scene.shapes);
            }
            let number = reference.flatten();
            let Some(measured) = self.step(step, settings, number) else {
                break;
            };
            steps.push(measured);
        }
        front::mark(&mut steps);
        let slopes = front::slopes(&steps);
        Sweep {
            knob,
            steps,
            slopes,
        }
    }

    /// The number of the reference with these settings, rendered if it is new; `None` if time has run out.
    fn reference(&mut self, settings: Settings) -> Option<usize> {
        let known = self.references.iter().position(|(s, _)| *s == settings);
        if known.is_some() {
            return known;
        }
        let film = self.film::<Silent>(&settings)?.0;
        self.references.push((settings, film));
        Some(self.references.len() - 1)
    }

    /// A picture, and what its probes heard; `None` if time runs out before it is done.
    fn film<P: Probe + Default + Send>(&self, settings: &Settings) -> Option<(Film, Vec<P>)> {
        let Limits { end, threads, .. } = self.limits;
        let stopped = AtomicBool::new(false);
        let watch = |_, _| {
            if Instant::now() < end {
                return Flow::Continue;
            }
            stopped.store(true, Ordering::Relaxed);
            Flow::Stop
        };
        let done = render(&self.world, settings, threads, &watch);
        (!stopped.load(Ordering::Relaxed)).then_some(done)
    }

    /// One position: rendered once to warm up, once to count, and then some times with the clock; `None` if time runs
    /// out before the first of these.
    fn step(&self, step: &str, settings: &Settings, reference: Option<usize>) -> Option<Measured> {
        let picture = self.film::<Silent>(settings)?.0;
        let counts = self.film::<Counts>(settings)?.1;
        let mut seconds = Vec::with_capacity(self.limits.runs);
        while seconds.len() < self.limits.runs {
            let start = Instant::now();
            let done = std::hint::black_box(self.film::<Silent>(settings));
            if done.is_none() {
                break;
            }
            seconds.push(start.elapsed().as_secs_f64());
        }
        seconds.sort_by(f64::total_cmp);
        Some(Measured {
            step: step.to_owned(),
            seconds: *seconds.get(seconds.len() / 2)?,
            spread: [*seconds.first()?, *seconds.last()?],
            runs: seconds.len(),
            counts: counts.iter().fold(Counts::default(), Counts::plus),
            errors: reference
                .and_then(|number| errors(&picture, &self.references[number].1, settings.exposure)),
            on_front: false,
        })
    }
}
