//! The flags about the samples of a pixel.

use clap::Args;
use clap::builder::TypedValueParser;

use super::named;
use crate::cli::Failure;
use crate::math::{Filter, Sampler};
use crate::scene::{Adaptive, Pilot, PixelSampling, Sampling, limits};

/// The first samples of a pixel that may have more, unless the scene or the user wants others.
const FIRST: u32 = 4;

/// The most samples of such a pixel.
const MOST: u32 = 256;

#[derive(Args, Clone, Debug, Default)]
#[command(next_help_heading = "Samples of a pixel")]
pub struct SampleArgs {
    /// Samples a pixel; with --adaptive the first ones
    #[arg(long, value_name = "N", value_parser = count())]
    pub samples: Option<u32>,
    /// Where the samples of a pixel lie
    #[arg(long, value_name = "WHERE", value_parser = named(Sampling::ALL, Sampling::name))]
    pub sampling: Option<Sampling>,
    /// Sets that the samples are parted into, each spread evenly by itself: the standard error is estimated from how
    /// much they differ
    #[arg(long, value_name = "N", value_parser = count(), conflicts_with = "adaptive")]
    sets: Option<u32>,
    /// How much samples count by their distance from the pixel's middle
    #[arg(long, value_name = "FILTER", value_parser = named(Filter::ALL, Filter::name))]
    filter: Option<Filter>,
    /// How far from the middle they lie, in pixels [default: box 0.5, tent 1, gaussian 1.5, mitchell 2]
    #[arg(long, value_name = "R", value_parser = parse_radius)]
    filter_radius: Option<f64>,
    /// More samples where they are needed: until a pixel's estimated standard error (of linear luminance) is at most
    /// this; with --pilot around as many as the standard deviation of a sample is times this
    #[arg(long, value_name = "THRESHOLD", value_parser = parse_positive)]
    pub adaptive: Option<f64>,
    /// The most samples of a pixel [default: 256]
    #[arg(long, value_name = "N", value_parser = count(), requires = "adaptive")]
    max_samples: Option<u32>,
    /// What becomes of the samples that decide how many there are: kept (a small bias), apart (they do not count: no
    /// bias) or around (they decide for the pixels around, and count: no bias, and little is missed)
    #[arg(long, value_name = "WHAT", value_parser = named(Pilot::ALL, Pilot::name), requires = "adaptive")]
    pilot: Option<Pilot>,
}

impl SampleArgs {
    /// What the scene asks for with what the command line changes.
    pub fn over(&self, asked: &PixelSampling) -> PixelSampling {
        let adaptive = self.adaptive.map(|threshold| Adaptive {
            threshold,
            most: self.max_samples.unwrap_or(MOST),
            pilot: self.pilot.unwrap_or_default(),
        });
        let least = if adaptive.is_some() { FIRST } else { 1 };
        let filter = self.filter.unwrap_or(asked.filter);
        let radius = if self.filter.is_some() {
            filter.usual_radius()
        } else {
            asked.filter_radius
        };
        PixelSampling {
            samples: self.samples.unwrap_or(asked.samples.max(least)),
            sets: self.sets.unwrap_or(asked.sets),
            // A grid that is full has no place for more.
            sampler: self.sampling.map_or(
                match asked.sampler {
                    Sampler::Grid if adaptive.is_some() => Sampler::Sobol,
                    sampler => sampler,
                },
                Sampling::sampler,
            ),
            filter,
            filter_radius: self.filter_radius.unwrap_or(radius),
            adaptive,
            ..*asked
        }
    }
}

/// An error if some of what was asked for does not go together.
pub fn check(pixel: &PixelSampling) -> Result<(), Failure> {
    let PixelSampling { samples, sets, .. } = *pixel;
    if sets > samples {
        return Err(Failure::Usage(format!(
            "--sets {sets}: {samples} samples cannot be parted into so many (see --samples)"
        )));
    }
    let regular = pixel.sampler == Sampler::Grid;
    if sets > 1 && regular {
        return Err(Failure::Usage(format!(
            "--sets {sets}: regular samples would lie at the same places in each set; choose --sampling random, \
jittered or sobol"
        )));
    }
    let Some(adaptive) = pixel.adaptive else {
        return Ok(());
    };
    if regular {
        return Err(Failure::Usage(
            "--adaptive: a regular grid has no place for more samples; choose --sampling random, jittered or sobol"
                .to_owned(),
        ));
    }
    let (first, most) = (pixel.samples, adaptive.most);
    let least = match adaptive.pilot {
        Pilot::Kept | Pilot::Around => first,
        Pilot::Apart => first.saturating_mul(2),
    };
    if pixel.asks_around() && first < 2 {
        return Err(Failure::Usage(format!(
            "--samples {first}: with --pilot around the first samples decide by how much they differ; take at least 2"
        )));
    }
    if most < least {
        return Err(Failure::Usage(format!(
            "--max-samples {most} is too few: the first {first} samples (see --samples) with pilot {} take {least}",
            adaptive.pilot.name()
        )));
    }
    Ok(())
}

/// A number of samples.
fn count() -> impl TypedValueParser<Value = u32> {
    clap::value_parser!(u32).range(1..=i64::from(limits::MAX_SAMPLES))
}

/// A finite number above 0.
pub fn parse_positive(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(x) if x.is_finite() && x > 0.0 => Ok(x),
        _ => Err("must be a number above 0".to_owned()),
    }
}

fn parse_radius(text: &str) -> Result<f64, String> {
    let most = limits::MAX_FILTER_RADIUS;
    match parse_positive(text) {
        Ok(radius) if radius <= most => Ok(radius),
        _ => Err(format!(
            "must be a number of pixels above 0, at most {most}"
        )),
    }
}
