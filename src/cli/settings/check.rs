//! Checks of settings that go together, or not.

use crate::cli::Failure;
use crate::sampling::Sampler;
use crate::scene::settings::knob::{Kind, Value, parse_whole};
use crate::scene::{Pilot, PixelSampling, Settings};
use crate::trace::format::counted;

/// An error if some of what was asked for does not go together.
pub fn pixel(pixel: &PixelSampling) -> Result<(), Failure> {
    let PixelSampling { samples, sets, .. } = *pixel;
    if sets > samples {
        return Err(Failure::Usage(format!(
            "--sets {sets}: {} cannot be parted into so many (see --samples)",
            counted(samples.into(), "sample")
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
            "--max-samples {most} is too few: the first {first} (see --samples) with pilot {} take {least}",
            adaptive.pilot.name()
        )));
    }
    Ok(())
}

/// An error if there is not even an eye ray for each pixel.
pub fn rays(settings: &Settings) -> Result<(), Failure> {
    let ((width, height), most) = (settings.size(), settings.recursion.max_rays);
    let pixels = u64::from(width) * u64::from(height);
    if most >= pixels {
        return Ok(());
    }
    Err(Failure::Usage(format!(
        "--max-rays {most}: a picture of {width}x{height} takes at least {pixels} rays, one a pixel; allow more, or take a \
smaller --size"
    )))
}

/// An error if a pixel lies outside of the picture.
pub fn inside(settings: &Settings, (x, y): (u32, u32)) -> Result<(), Failure> {
    let (width, height) = settings.size();
    if x < width && y < height {
        return Ok(());
    }
    let (last_x, last_y) = (width - 1, height - 1);
    Err(Failure::Usage(format!(
        "pixel {x},{y} is outside the picture of {width}x{height}; the last one is {last_x},{last_y} (see --size)"
    )))
}

/// Parser of whole numbers from 1 to `most`.
pub fn parse_count(most: u32) -> impl Fn(&str) -> Result<u32, String> + Clone {
    move |text| parse_whole(text, 1..=most.into()).map(|n| n as u32)
}

/// A finite number above 0.
pub fn parse_positive(text: &str) -> Result<f64, String> {
    match Kind::POSITIVE.parse(text)? {
        Value::Real(x) => Ok(x),
        _ => Err("must be a number".to_owned()),
    }
}
