//! What measurements say together: the Pareto front, and slopes on log axes.

use super::measured::{Measured, Slopes, Sweep};
use super::parameter::Parameter;

/// Errors below this are rounding, not lack of samples.
const EXACT: f64 = 1e-12;

/// How many of the most accurate positions tell what the next step takes.
const LAST: usize = 3;

impl Sweep {
    /// What was measured, with its slopes.
    pub fn new(parameter: Parameter, steps: Vec<Measured>) -> Self {
        Self {
            // Between kinds of arithmetic there is no slope.
            slopes: (!parameter.is_arithmetic())
                .then(|| slopes(&steps))
                .flatten(),
            parameter,
            steps,
        }
    }
}

/// Marks what nothing else in these sweeps, which share a reference, beats: no other is at once as cheap and as near,
/// and better in one of the two. Rays are the price, since they are the same in every run.
pub fn mark(sweeps: &mut [Sweep]) {
    let model = |s: &Measured| s.errors.map(|e| (s.counts.rays(), e.rmse));
    let all = sweeps.iter().flat_map(|s| &s.steps);
    let points: Vec<(u64, f64)> = all.filter_map(model).collect();
    for step in sweeps.iter_mut().flat_map(|s| &mut s.steps) {
        let Some((rays, rmse)) = model(step) else {
            continue;
        };
        step.on_front = !points
            .iter()
            .any(|&(r, e)| r <= rays && e <= rmse && (r, e) != (rays, rmse));
    }
}

/// The slopes; `None` for fewer than three points with an error.
pub fn slopes(steps: &[Measured]) -> Option<Slopes> {
    let wrong = |s: &&Measured| s.errors.is_some_and(|e| e.rmse > EXACT);
    let steps: Vec<&Measured> = steps.iter().filter(wrong).collect();
    let over = |steps: &[&Measured], axis: &dyn Fn(&Measured) -> Option<f64>| {
        let point = |s: &&Measured| Some([axis(s)?, s.errors?.rmse].map(libm::log));
        fit(&steps.iter().filter_map(point).collect::<Vec<_>>())
    };
    let last = steps.get(steps.len().checked_sub(LAST)?..)?;
    Some(Slopes {
        samples: over(&steps, &|s| s.samples.map(f64::from)),
        rays: over(&steps, &|s| Some(s.counts.rays() as f64))?,
        seconds: over(last, &|s| Some(s.seconds))?,
    })
}

/// The slope of the line through points that leaves the least squares; `None` if they stand above each other.
pub fn fit(points: &[[f64; 2]]) -> Option<f64> {
    let n = points.len() as f64;
    let mean = |axis: usize| points.iter().map(|p| p[axis]).sum::<f64>() / n;
    let [x, y] = [mean(0), mean(1)];
    let (mut xx, mut xy) = (0.0, 0.0);
    for [px, py] in points {
        xx += (px - x) * (px - x);
        xy += (px - x) * (py - y);
    }
    (xx > 0.0).then_some(xy / xx)
}

#[cfg(test)]
mod tests {
    use super::super::error::Errors;
    use super::*;
    use crate::trace::Counts;

    fn step(rays: u64, rmse: f64) -> Measured {
        Measured {
            step: String::new(),
            samples: Some(rays as u32),
            seconds: rays as f64,
            spread: [0.0; 2],
            runs: 1,
            built: None,
            counts: Counts {
                light: rays,
                ..Counts::default()
            },
            errors: Some(Errors {
                rmse,
                ..Errors::default()
            }),
            on_front: false,
        }
    }

    fn sweep(steps: &[Measured]) -> Sweep {
        let parameter = Parameter {
            group: "knob",
            variant: None,
            steps: Vec::new(),
            reference: None,
            theory: None,
        };
        Sweep::new(parameter, steps.to_vec())
    }

    #[test]
    fn what_costs_more_and_errs_more_is_not_on_the_front() {
        let mut sweeps = [
            sweep(&[step(1, 0.5), step(2, 0.6), step(4, 0.1)]),
            sweep(&[step(2, 0.7), step(3, 0.1)]),
        ];
        mark(&mut sweeps);
        let marks = sweeps.map(|s| s.steps.iter().map(|m| m.on_front).collect::<Vec<_>>());
        assert_eq!(marks, [vec![true, false, false], vec![false, true]]);
    }

    #[test]
    fn halving_the_error_at_four_times_the_price_is_a_slope_of_one_half() {
        let mut steps = [step(10, 0.4), step(40, 0.2), step(160, 0.1)];
        let found = slopes(&steps).expect("three points");
        for slope in [found.samples, Some(found.rays), Some(found.seconds)] {
            assert!((slope.expect("a slope") + 0.5).abs() < 1e-12);
        }
        assert!((found.halving().expect("it falls") - 4.0).abs() < 1e-9);
        assert_eq!(slopes(&steps[..2]), None);
        assert_eq!(slopes(&[step(1, 0.1), step(1, 0.1), step(1, 0.1)]), None);
        for s in &mut steps {
            s.samples = None;
            s.seconds = libm::log(s.seconds);
        }
        let found = slopes(&steps).expect("three points");
        assert!(found.samples.is_none() && found.seconds < -0.5);
        let stalled = slopes(&[step(10, 0.4), step(40, 0.4), step(160, 0.4)]);
        assert_eq!(stalled.expect("three points").halving(), None);
    }
}
