//! Pictures that were handed in: PNG, PFM, and PPM as most first tracers write it. The size is known before anything is decoded.

mod ppm;

use crate::tracer::image::{pfm, png};

/// A picture that was handed in.
#[derive(Clone, Debug, PartialEq)]
pub struct SubmittedPicture {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Its pixels, row after row from the top.
    pub pixels: SubmittedPixels,
}

/// Pixels as a file tells them.
#[derive(Clone, Debug, PartialEq)]
pub enum SubmittedPixels {
    /// For the screen, 0 to 255, sRGB.
    Screen(Vec<[u8; 3]>),
    /// Linear radiance. A channel may be no number: that pixel is wrong, and no other.
    Linear(Vec<[f32; 3]>),
}

/// A kind of file, by its first bytes.
#[derive(Clone, Copy)]
enum PictureKind {
    Png,
    Pfm,
    Ppm,
}

fn kind(bytes: &[u8]) -> Result<PictureKind, String> {
    match bytes {
        [0x89, b'P', b'N', b'G', ..] => Ok(PictureKind::Png),
        [b'P', b'F' | b'f', ..] => Ok(PictureKind::Pfm),
        [b'P', b'3' | b'6', ..] => Ok(PictureKind::Ppm),
        [b'P', b'1'..=b'7', ..] => {
            Err("is a picture in grey; write a PPM file, P3 or P6".to_owned())
        }
        [0xff, 0xd8, ..] => {
            Err("is a JPEG file, which changes colours; write PNG, PPM or PFM".to_owned())
        }
        _ => Err("is neither a PNG nor a PPM (P3, P6) nor a PFM file".to_owned()),
    }
}

/// True if a file says of itself that it is a picture.
pub fn is_picture(bytes: &[u8]) -> bool {
    kind(bytes).is_ok()
}

/// Width and height that a file claims, from its first bytes; what is wrong with it, if it is no picture.
pub fn picture_size(bytes: &[u8]) -> Result<(u32, u32), String> {
    match kind(bytes)? {
        PictureKind::Png => png::size(bytes),
        PictureKind::Pfm => pfm::size(bytes),
        PictureKind::Ppm => ppm::size(bytes),
    }
}

/// The picture in a file, which must have this size; what is wrong with it, if it has not or cannot be read.
pub fn picture(bytes: &[u8], size: (u32, u32)) -> Result<SubmittedPicture, String> {
    let (width, height) = picture_size(bytes)?;
    if (width, height) != size {
        return Err(format!(
            "has {width}x{height} pixels; {}x{} are wanted",
            size.0, size.1
        ));
    }
    let pixels = match kind(bytes)? {
        PictureKind::Png => SubmittedPixels::Screen(png::decode_screen(bytes)?),
        PictureKind::Ppm => SubmittedPixels::Screen(ppm::decode(bytes)?),
        PictureKind::Pfm => {
            let (_, pixels) = pfm::pixels(bytes)?;
            let single = |pixel: &crate::math::Rgb| pixel.channels().map(|channel| channel as f32);
            SubmittedPixels::Linear(pixels.iter().map(single).collect())
        }
    };
    Ok(SubmittedPicture {
        width,
        height,
        pixels,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;
    use crate::tracer::Film;

    fn film() -> Film {
        let pixels = (0..6)
            .map(|i| Rgb::new(f64::from(i) / 6.0, 0.25, 1.0))
            .collect();
        Film {
            width: 3,
            height: 2,
            pixels,
            ..Film::default()
        }
    }

    #[test]
    fn pictures_are_read_as_they_are_written() {
        let film = film();
        let screen: Vec<[u8; 3]> = film.pixels.iter().map(|pixel| pixel.to_srgb8()).collect();
        let png = png::encode(&film, 1.0).expect("a PNG file");
        let bytes: Vec<u8> = screen.iter().flatten().copied().collect();
        let binary = [b"P6 3 2 255\n".as_slice(), &bytes].concat();
        let words: Vec<String> = bytes.iter().map(u8::to_string).collect();
        let text = format!("P3\n# by hand\n3 2\n255\n{}\n", words.join("\n"));
        for file in [png, binary, text.into_bytes()] {
            assert_eq!(picture_size(&file), Ok((3, 2)));
            let read = picture(&file, (3, 2)).expect("a picture");
            assert_eq!((read.width, read.height), (3, 2));
            assert_eq!(read.pixels, SubmittedPixels::Screen(screen.clone()));
        }
        let pfm = pfm::encode(&film);
        let single: Vec<[f32; 3]> = film
            .pixels
            .iter()
            .map(|p| p.channels().map(|c| c as f32))
            .collect();
        let read = picture(&pfm, (3, 2)).expect("a picture");
        assert_eq!(read.pixels, SubmittedPixels::Linear(single));
        // One pixel that is no number costs itself.
        let mut broken = pfm;
        let last = broken.len() - 4;
        broken[last..].copy_from_slice(&f32::NAN.to_le_bytes());
        let read = picture(&broken, (3, 2)).expect("a picture");
        let SubmittedPixels::Linear(pixels) = read.pixels else {
            panic!("linear")
        };
        assert_eq!(pixels.iter().flatten().filter(|c| c.is_nan()).count(), 1);
    }

    #[test]
    fn sizes_are_checked_before_anything_is_decoded() {
        for (file, said) in [
            (
                b"P6 99999 99999 255\n".as_slice(),
                "has 99999x99999 pixels; 3x2 are wanted",
            ),
            (b"PF\n99999 99999\n-1\n", "3x2 are wanted"),
            (b"P6 2 3 255\n123456789012345678", "has 2x3 pixels"),
            (b"P6 3 2 255\n1234567", "has 7 bytes, and 18 are wanted"),
            (b"P3 3 2 255\n1 2 3", "has 3 numbers, and 18 are wanted"),
            (b"P5 3 2 255\n123456", "in grey"),
            (b"\xff\xd8\xff", "JPEG"),
            (b"GIF89a", "neither"),
            (b"P6 3 2 0\n123456789012345678", "largest value"),
            (b"P6 -3 2 255\n", "no width"),
            (b"P6 3", "no height"),
            (
                b"P3 3 2 255 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 300",
                "has 300, above 255",
            ),
            (
                b"P3 3 2 255 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 nan",
                "`nan` is no whole number",
            ),
            (b"\x89PNG\r\n", "no PNG file"),
        ] {
            let error = picture(file, (3, 2)).expect_err("no such picture");
            assert!(error.contains(said), "{error}, not {said}");
        }
    }
}
