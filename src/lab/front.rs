//! What measurements say together: the Pareto front, and slopes on log axes.

use super::cost::Measured;

/// Errors below this are rounding, not lack of samples.
const EXACT: f64 = 1e-12;

/// Marks what nothing else beats: no other is at once as cheap and as near, and better in one of the two. Rays are the
/// price, since they are the same in every run.
pub fn mark(steps: &mut [Measured]) {
    let points: Vec<Option<(u64, f64)>> = steps
        .iter()
        .map(|s| s.errors.map(|e| (s.counts.rays(), e.rmse)))
        .collect();
    for (step, point) in steps.iter_mut().zip(&points) {
        let Some((rays, rmse)) = *point else { continue };
        step.on_front = !points
            .iter()
            .flatten()
            .any(|&(r, e)| r <= rays && e <= rmse && (r, e) != (rays, rmse));
    }
}

/// The slopes of log error over log rays and over log seconds; `None` for fewer than three points with an error.
pub fn slopes(steps: &[Measured]) -> Option<[f64; 2]> {
    let points: Vec<[f64; 3]> = steps
        .iter()
        .filter_map(|s| {
            let error = s.errors?.rmse;
            (error > EXACT).then(|| [error, s.counts.rays() as f64, s.seconds].map(libm::log))
        })
        .collect();
    let over = |axis: usize| fit(&points.iter().map(|p| [p[axis], p[0]]).collect::<Vec<_>>());
    (points.len() >= 3).then(|| Some([over(1)?, over(2)?]))?
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
            seconds: rays as f64,
            spread: [0.0; 2],
            runs: 1,
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

    #[test]
    fn what_costs_more_and_errs_more_is_not_on_the_front() {
        let mut steps = [step(1, 0.5), step(2, 0.6), step(3, 0.1), step(4, 0.1)];
        mark(&mut steps);
        assert_eq!(steps.map(|s| s.on_front), [true, false, true, false]);
    }

    #[test]
    fn halving_the_error_at_four_times_the_rays_is_a_slope_of_one_half() {
        let steps = [step(10, 0.4), step(40, 0.2), step(160, 0.1)];
        let [rays, seconds] = slopes(&steps).expect("three points");
        assert!((rays + 0.5).abs() < 1e-12 && (seconds + 0.5).abs() < 1e-12);
        assert_eq!(slopes(&steps[..2]), None);
        assert_eq!(slopes(&[step(1, 0.1), step(1, 0.1), step(1, 0.1)]), None);
    }
}
