//! PNG: sRGB, 8 bits a channel.

use std::io::Cursor;

use image::codecs::png::{PngDecoder, PngEncoder};
use image::{DynamicImage, ExtendedColorType, ImageDecoder, ImageEncoder, ImageError};

use crate::math::Rgb;
use crate::scene::limits::size_problem;
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

/// Width and height that a PNG file claims; what is wrong with it, if it is none.
pub fn size(bytes: &[u8]) -> Result<(u32, u32), String> {
    PngDecoder::new(Cursor::new(bytes))
        .map(|d| d.dimensions())
        .map_err(|e| unreadable(&e))
}

fn unreadable(error: &ImageError) -> String {
    format!("is no PNG file that can be read: {error}")
}

/// A decoder of a PNG file whose pixels can be in it; what is wrong with it, if they cannot.
fn decoder(bytes: &[u8]) -> Result<PngDecoder<Cursor<&[u8]>>, String> {
    let decoder = PngDecoder::new(Cursor::new(bytes)).map_err(|e| unreadable(&e))?;
    let (width, height) = decoder.dimensions();
    if let Some(problem) = size_problem(width, height) {
        return Err(problem);
    }
    // A byte of the file makes 1032 at most when it is unpacked (Gailly and Adler, zlib technical details): so many pixels are
    // not in it, and no room need be made for them.
    let bits = u64::from(decoder.original_color_type().bits_per_pixel());
    let unpacked = u64::from(width) * u64::from(height) * bits / 8;
    if unpacked > 1032 * bytes.len() as u64 {
        return Err(format!(
            "ends before the last of its {width}x{height} pixels"
        ));
    }
    Ok(decoder)
}

/// The film that a PNG file shows with this exposure, as far as its bits tell; what is wrong with it, if it is none.
pub fn decode(bytes: &[u8], exposure: f64) -> Result<Film, String> {
    let decoder = decoder(bytes)?;
    let (width, height) = decoder.dimensions();
    if exposure <= 0.0 {
        return Err("tells nothing: with an exposure of 0 every picture is black".to_owned());
    }
    let image = DynamicImage::from_decoder(decoder)
        .map_err(|e| unreadable(&e))?
        .to_rgb16();
    let shown = |p: &image::Rgb<u16>| Rgb::from_srgb(p.0.map(|c| f64::from(c) / 65535.0));
    Ok(Film {
        width,
        height,
        pixels: image
            .pixels()
            .map(|p| shown(p) * (1.0 / exposure))
            .collect(),
        ..Film::default()
    })
}

/// The pixels of a PNG file from the top as a screen shows them, without their opacity; what is wrong with it, if it is none.
pub fn decode_screen(bytes: &[u8]) -> Result<Vec<[u8; 3]>, String> {
    let image = DynamicImage::from_decoder(decoder(bytes)?).map_err(|e| unreadable(&e))?;
    Ok(image.to_rgb8().pixels().map(|pixel| pixel.0).collect())
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
