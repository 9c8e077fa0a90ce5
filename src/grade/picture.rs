//! Pictures that students hand in: PNG, PFM, and PPM (P3 and P6).

use crate::math::Rgb;
use crate::scene::limits::size_problem;
use crate::tracer::Film;
use crate::tracer::image::{pfm, png};

/// A picture of this size as a film; `exposure` is taken out of those that are encoded for a screen. What is wrong with it, if it
/// is none. The size is looked at before anything is decoded.
pub fn read_picture(bytes: &[u8], size: (u32, u32), exposure: f64) -> Result<Film, String> {
    let check = |found: (u32, u32)| {
        let ((width, height), (w, h)) = (size, found);
        if found == size {
            Ok(())
        } else {
            Err(format!("is {w}x{h} pixels, and {width}x{height} are asked"))
        }
    };
    match bytes {
        [0x89, b'P', b'N', b'G', ..] => {
            check(png::size(bytes)?)?;
            png::decode(bytes, exposure)
        }
        [b'P', b'F', ..] => {
            check(pfm::size(bytes)?)?;
            pfm::decode(bytes)
        }
        [b'P', b'3' | b'6', ..] => {
            let mut header = Header { bytes, next: 2 };
            let numbers = [header.number()?, header.number()?, header.number()?];
            check((numbers[0], numbers[1]))?;
            ppm(header, bytes[1] == b'6', numbers, exposure)
        }
        _ => Err("is no PNG, PFM or PPM file".to_owned()),
    }
}

/// The words of a PPM file, with comments between them.
struct Header<'a> {
    bytes: &'a [u8],
    next: usize,
}

impl Header<'_> {
    fn number(&mut self) -> Result<u32, String> {
        let broken = || format!("byte {}: a number is missing", self.next);
        let mut at = self.next;
        while let Some(byte) = self.bytes.get(at) {
            match byte {
                b'#' => {
                    let line = self.bytes[at..].iter().position(|byte| *byte == b'\n');
                    at += line.ok_or_else(broken)?;
                }
                byte if byte.is_ascii_whitespace() => at += 1,
                _ => break,
            }
        }
        let digits = self.bytes[at..]
            .iter()
            .take_while(|byte| byte.is_ascii_digit())
            .count();
        let text = std::str::from_utf8(&self.bytes[at..at + digits]).map_err(|_| broken())?;
        let number = text.parse().map_err(|_| broken())?;
        self.next = at + digits;
        Ok(number)
    }
}

/// A PPM file behind its header. Source: the netpbm documentation, "PPM Format Specification".
fn ppm(
    mut header: Header,
    binary: bool,
    [width, height, most]: [u32; 3],
    exposure: f64,
) -> Result<Film, String> {
    if let Some(problem) = size_problem(width, height) {
        return Err(problem);
    }
    if most == 0 || most > 65535 || exposure <= 0.0 {
        return Err("has no values between 1 and 65535".to_owned());
    }
    let count = 3 * width as usize * height as usize;
    let encoded: Vec<f64> = if binary {
        let wide = most > 255;
        let body = header.bytes.get(header.next + 1..).unwrap_or_default();
        let bytes = if wide { 2 * count } else { count };
        if body.len() < bytes {
            return Err(format!(
                "ends before the last of its {width}x{height} pixels"
            ));
        }
        let values = body[..bytes].chunks(if wide { 2 } else { 1 });
        values
            .map(|v| {
                v.iter()
                    .fold(0.0, |sum, byte| 256.0 * sum + f64::from(*byte))
            })
            .collect()
    } else {
        // A value takes two bytes at least, so that no room is made for values that are not there.
        if header.bytes.len() < 2 * count {
            return Err(format!(
                "ends before the last of its {width}x{height} pixels"
            ));
        }
        (0..count)
            .map(|_| header.number().map(f64::from))
            .collect::<Result<_, _>>()?
    };
    let pixels = encoded.chunks(3).map(|p| {
        let shown = [p[0], p[1], p[2]].map(|c| (c / f64::from(most)).min(1.0));
        Rgb::from_srgb(shown) * (1.0 / exposure)
    });
    Ok(Film {
        width,
        height,
        pixels: pixels.collect(),
        ..Film::default()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_kinds_of_ppm_are_read() {
        let text = b"P3 # red, green\n2 1\n255\n255 0 0  0 128 0\n";
        let binary = b"P6 2 1 255\n\xff\0\0\0\x80\0";
        for bytes in [&text[..], &binary[..]] {
            let film = read_picture(bytes, (2, 1), 1.0).expect("a picture");
            assert_eq!(
                film.pixels.iter().map(|p| p.to_srgb8()).collect::<Vec<_>>(),
                [[255, 0, 0], [0, 128, 0]]
            );
            assert!(read_picture(bytes, (1, 2), 1.0).is_err_and(|e| e.contains("2x1")));
            assert!(read_picture(&bytes[..bytes.len() - 4], (2, 1), 1.0).is_err());
        }
        assert!(read_picture(b"P6 4000000000 4000000000 255\n", (1, 1), 1.0).is_err());
        assert!(read_picture(b"GIF89a", (1, 1), 1.0).is_err());
    }
}
