//! A picture that was handed in, as a film that ours can be compared with.

use crate::grade::submission::picture::{SubmittedPixels, picture};
use crate::math::Rgb;
use crate::tracer::Film;

/// The picture in a file, which must have this size; `exposure` is taken out of those for the screen. What is wrong with it, if it
/// cannot be read.
pub fn read_picture(bytes: &[u8], size: (u32, u32), exposure: f64) -> Result<Film, String> {
    let picture = picture(bytes, size)?;
    let pixels = match picture.pixels {
        SubmittedPixels::Screen(pixels) if exposure > 0.0 => {
            let linear = |pixel: [u8; 3]| {
                let encoded = pixel.map(|channel| f64::from(channel) / 255.0);
                Rgb::from_srgb(encoded) * (1.0 / exposure)
            };
            pixels.into_iter().map(linear).collect()
        }
        SubmittedPixels::Screen(_) => {
            return Err("tells nothing: with an exposure of 0 every picture is black".to_owned());
        }
        SubmittedPixels::Linear(pixels) => {
            let linear = |pixel: [f32; 3]| Rgb::from(pixel.map(f64::from));
            pixels.into_iter().map(linear).collect()
        }
    };
    Ok(Film {
        width: picture.width,
        height: picture.height,
        pixels,
        ..Film::default()
    })
}
