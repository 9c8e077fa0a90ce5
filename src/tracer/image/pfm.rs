//! PFM, portable float map: the film's linear radiance as 32-bit floats, for programs that measure pictures.
//!
//! `PF`, width and height, and a scale whose sign tells the order of bytes (negative: the low byte first); then rows
//! from the bottom to the top, three floats a pixel. Source: Debevec, "PFM portable float map image format".

use crate::math::Rgb;
use crate::scene::limits::size_problem;
use crate::tracer::Film;

/// The film as the bytes of a PFM file: no exposure, no clamp but to what 32 bits can hold.
pub fn encode(film: &Film) -> Vec<u8> {
    let mut pfm = format!("PF\n{} {}\n-1.0\n", film.width, film.height).into_bytes();
    pfm.reserve(film.pixels.len() * 3 * size_of::<f32>());
    for row in film.pixels.chunks(film.width.max(1) as usize).rev() {
        for value in row.iter().flat_map(|color| color.channels()) {
            pfm.extend(single(value).to_le_bytes());
        }
    }
    pfm
}

/// First lines of a PFM file.
struct Header {
    /// Numbers a pixel.
    channels: usize,
    width: u32,
    height: u32,
    /// Whether the low byte of a number is the first.
    low_first: bool,
}

/// The first lines, and what comes after them.
fn header(bytes: &[u8]) -> Result<(Header, &[u8]), String> {
    let mut rest = bytes;
    let mut word = || {
        let end = rest.iter().take(32).position(u8::is_ascii_whitespace)?;
        let word = str::from_utf8(&rest[..end]).ok()?;
        rest = &rest[end + 1..];
        Some(word)
    };
    let channels = match word() {
        Some("PF") => 3,
        Some("Pf") => 1,
        _ => return Err("is neither a PFM nor a PNG file".to_owned()),
    };
    let mut number = |what: &str| {
        let number = word().and_then(|w| w.parse::<f64>().ok());
        number.ok_or_else(|| format!("has no {what} in its first lines"))
    };
    let header = Header {
        channels,
        width: number("width")? as u32,
        height: number("height")? as u32,
        low_first: number("scale")? < 0.0,
    };
    Ok((header, rest))
}

/// Width and height that a PFM file claims; what is wrong with it, if it is none.
pub fn size(bytes: &[u8]) -> Result<(u32, u32), String> {
    header(bytes).map(|(header, _)| (header.width, header.height))
}

/// The film of a PFM file in colour (`PF`) or grey (`Pf`); what is wrong with it, if it is none.
pub fn decode(bytes: &[u8]) -> Result<Film, String> {
    let ((width, height), pixels) = pixels(bytes)?;
    if !pixels.iter().all(|pixel| pixel.is_finite()) {
        return Err("has pixels that are no finite numbers".to_owned());
    }
    Ok(Film {
        width,
        height,
        pixels,
        ..Film::default()
    })
}

/// Width and height of a PFM file, and its pixels from the top, finite or not; what is wrong with it, if it is none.
pub fn pixels(bytes: &[u8]) -> Result<((u32, u32), Vec<Rgb>), String> {
    let (header, rest) = header(bytes)?;
    let Header {
        channels,
        width,
        height,
        low_first,
    } = header;
    if let Some(problem) = size_problem(width, height) {
        return Err(problem);
    }
    let (data, []) = rest.as_chunks::<4>() else {
        return Err("ends inside a number".to_owned());
    };
    let row = width as usize * channels;
    if data.len() != row * height as usize {
        let (has, needs) = (data.len(), row * height as usize);
        return Err(format!(
            "has {has} numbers, and {width}x{height} pixels need {needs}"
        ));
    }
    let value = |bytes: &[u8; 4]| {
        f64::from(if low_first {
            f32::from_le_bytes(*bytes)
        } else {
            f32::from_be_bytes(*bytes)
        })
    };
    let pixel = |of: &[[u8; 4]]| Rgb::from([0, 1, 2].map(|i| value(&of[i.min(channels - 1)])));
    let rows = data.chunks(row).rev();
    let pixels = rows
        .flat_map(|row| row.chunks(channels).map(pixel))
        .collect();
    Ok(((width, height), pixels))
}

/// The nearest 32-bit float; never infinite.
fn single(value: f64) -> f32 {
    (value as f32).clamp(f32::MIN, f32::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_go_from_the_bottom_to_the_top() {
        let film = Film {
            width: 2,
            height: 2,
            pixels: vec![
                Rgb::new(1.0, 2.0, 3.0),
                Rgb::BLACK,
                Rgb::grey(0.1),
                Rgb::grey(1e300),
            ],
            ..Film::default()
        };
        let pfm = encode(&film);
        let header = b"PF\n2 2\n-1.0\n";
        assert!(pfm.starts_with(header));
        let floats: Vec<f32> = pfm[header.len()..]
            .as_chunks()
            .0
            .iter()
            .map(|bytes| f32::from_le_bytes(*bytes))
            .collect();
        let (low, huge) = (0.1f32, f32::MAX);
        let bottom = [low, low, low, huge, huge, huge];
        let top = [1.0, 2.0, 3.0, 0.0, 0.0, 0.0];
        assert_eq!(floats, [bottom, top].concat());
        let back = decode(&pfm).expect("a film");
        assert_eq!((back.width, back.height), (2, 2));
        assert_eq!(back.at(0, 0), film.at(0, 0));
        assert_eq!(back.at(0, 1), Rgb::grey(f64::from(0.1f32)));
    }

    #[test]
    fn grey_is_read_in_either_order_of_bytes() {
        let file = |scale: &str, bytes: [u8; 4]| {
            [format!("Pf\n1 1\n{scale}\n").as_bytes(), &bytes].concat()
        };
        for file in [
            file("-1.0", 0.25f32.to_le_bytes()),
            file("1.0", 0.25f32.to_be_bytes()),
        ] {
            let film = decode(&file).expect("a film");
            assert_eq!(film.pixels, [Rgb::grey(0.25)]);
        }
        for (file, said) in [
            (&b"P6\n1 1\n255\n"[..], "neither"),
            (b"PF\n1 x\n-1\n", "no height"),
            (b"PF\n-1 1\n-1\n", "no pixels"),
            (b"PF\n1 1\n-1\n1234", "has 1 numbers"),
            (b"PF\n1 1\n-1\n12345", "ends inside"),
            (b"Pf\n1 1\n-1\n\0\0\xc0\x7f", "finite"),
            (b"PF\n99999 99999\n-1\n", "too large"),
            (b"PF", "neither"),
        ] {
            let error = decode(file).expect_err("no film");
            assert!(error.contains(said), "{error}, not {said}");
        }
    }
}
