//! Measurements: a step, a parameter with its steps, and the slopes fitted to them.

use super::error::Errors;
use super::parameter::Parameter;
use crate::trace::Counts;

/// One position of a knob, measured.
#[derive(Clone, Debug)]
pub struct Measured {
    /// Its name.
    pub step: String,
    /// The samples that it takes, if it is about samples.
    pub samples: Option<u32>,
    /// The median time of a render, in seconds.
    pub seconds: f64,
    /// The shortest and the longest.
    pub spread: [f64; 2],
    /// How many renders were timed, after one that counted.
    pub runs: usize,
    /// Seconds that it took to build the acceleration structure, if it is another one.
    pub built: Option<f64>,
    /// What was counted: the same on every machine.
    pub counts: Counts,
    /// Against the reference, if the picture changes at all.
    pub errors: Option<Errors>,
    /// True if nothing else of this group is both cheaper and nearer.
    pub on_front: bool,
}

/// A knob with its positions measured.
#[derive(Clone, Debug)]
pub struct Sweep {
    /// The knob.
    pub parameter: Parameter,
    /// Its positions, in order; fewer if time ran out.
    pub steps: Vec<Measured>,
    /// The fitted slopes, if there are enough positions with an error.
    pub slopes: Option<Slopes>,
}

/// The slopes of log error, fitted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slopes {
    /// Over log samples, if the knob is about samples: what theory speaks of.
    pub samples: Option<f64>,
    /// Over log rays.
    pub rays: f64,
    /// Over log seconds, of the last three positions: with few samples, it is other things that take the time.
    pub seconds: f64,
}

impl Slopes {
    /// How many times the time is needed for half the error; `None` if it does not fall.
    pub fn halving(&self) -> Option<f64> {
        (self.seconds < -0.05).then(|| libm::exp2(-1.0 / self.seconds))
    }
}
