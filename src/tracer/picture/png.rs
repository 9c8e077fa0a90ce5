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
    write(film.width, film.height, &bytes, ExtendedColorType::Rgb8)
}

/// One byte a pixel, row after row from the top, as the bytes of a PNG file.
pub fn encode_grey(width: u32, height: u32, bytes: &[u8]) -> Result<Vec<u8>, ImageError> {
    write(width, height, bytes, ExtendedColorType::L8)
}

fn write(
    width: u32,
    height: u32,
    bytes: &[u8],
    color: ExtendedColorType,
) -> Result<Vec<u8>, ImageError> {
    let mut png = Vec::new();
    PngEncoder::new(&mut png).write_image(bytes, width, height, color)?;
    Ok(png)
}
