//! PNG: sRGB, 8 bits a channel.

use image::{ExtendedColorType, ImageEncoder, ImageError, codecs::png::PngEncoder};

use crate::tracer::Film;

/// The film as the bytes of a PNG file; `exposure` is multiplied in before the clamp.
pub fn encode(film: &Film, exposure: f64) -> Result<Vec<u8>, ImageError> {
    let bytes: Vec<u8> = film
        .pixels
        .iter()
        .flat_map(|color| (*color * exposure).to_srgb8())
        .collect();
    let mut png = Vec::new();
    PngEncoder::new(&mut png).write_image(
        &bytes,
        film.width,
        film.height,
        ExtendedColorType::Rgb8,
    )?;
    Ok(png)
}
