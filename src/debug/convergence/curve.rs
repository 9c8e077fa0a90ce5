//! Convergence curve of a pixel, its slope, its range and its last point in words.

use super::sampling::with_samples;
use crate::lab::pareto::fit;
use crate::sampling::Sampler;
use crate::scene::{Sampling, Settings};
use crate::tracer::Pixel;

/// Points whose standard errors are those of few samples, and too uncertain to tell a slope.
const UNSURE: usize = 4;

/// What is known of a pixel so far.
#[derive(Clone, Debug, Default)]
pub struct Convergence {
    /// The pixel with 1, 2, 4 and so on samples.
    pub pixels: Vec<Pixel>,
    /// Why no more will come.
    pub end: Option<&'static str>,
}

/// A point of the curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvePoint {
    /// The power of 2 of the samples.
    pub power: f64,
    /// The pixel's luminance.
    pub luminance: f64,
    /// Its standard error; 0 if unknown.
    pub error: f64,
}

impl Convergence {
    /// The curve.
    pub fn points(&self) -> impl Iterator<Item = CurvePoint> {
        let finite = |error: f64| if error.is_finite() { error } else { 0.0 };
        self.pixels.iter().map(move |pixel| CurvePoint {
            power: libm::log2(f64::from(pixel.samples)),
            luminance: pixel.color.luminance(),
            error: finite(pixel.error),
        })
    }

    /// The power of n with which the standard error falls, from those that are well known and not 0.
    fn slope(&self) -> Option<f64> {
        let points = self.points().skip(UNSURE).filter(|p| p.error > 0.0);
        let points: Vec<[f64; 2]> = points.map(|p| [p.power, libm::log2(p.error)]).collect();
        fit(&points).filter(|_| points.len() > 2)
    }

    /// The luminances with their standard errors and a margin; `None` if there are none.
    pub fn range(&self) -> Option<[f64; 2]> {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for point in self.points() {
            low = low.min(point.luminance - point.error);
            high = high.max(point.luminance + point.error);
        }
        if !(low.is_finite() && high.is_finite()) {
            return None;
        }
        // Equal values stand in the middle.
        let least = 1e-6 * (1.0 + high.abs());
        let margin = if high - low < least {
            least
        } else {
            0.05 * (high - low)
        };
        Some([low - margin, high + margin])
    }

    /// The cost of the last point, the slope, and why no more will come.
    pub fn summary(&self, pixel: &Pixel, settings: &Settings) -> String {
        let settings = with_samples(settings, pixel.samples);
        let sets = match settings.pixel.sets {
            1 => String::new(),
            n => format!(" in {n} sets"),
        };
        let slope = self.slope();
        let slope = slope.map_or(String::new(), |slope| format!("± falls as n^{slope:.2}; "));
        format!(
            "{} {} samples{sets}, {} rays; {slope}{}",
            pixel.samples,
            Sampling::of(settings.pixel.sampler).name(),
            pixel.rays,
            self.end.unwrap_or("more are coming")
        )
    }
}

/// What stands before the standard error: Sobol's points do better than independent ones, whose error it is.
pub fn bound(settings: &Settings, samples: u32) -> &'static str {
    match with_samples(settings, samples).pixel.sampler {
        Sampler::Sobol => "at most ",
        _ => "",
    }
}

/// A standard error with five decimals, or two digits if it is smaller than that.
pub fn error_text(pixel: &Pixel) -> String {
    match pixel.error {
        x if !x.is_finite() => "?".to_owned(),
        x if x == 0.0 || x >= 1e-4 => format!("{x:.5}"),
        x => format!("{x:.1e}"),
    }
}
