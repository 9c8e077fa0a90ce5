//! PPM, portable pixel map: `P6` (bytes) and `P3` (numbers as text), width, height, the largest value, then the pixels from the
//! top. Source: Netpbm, "ppm - Netpbm color image format".

use crate::scene::limits::size_problem;
use crate::scene::printable::excerpt;

/// First words of a PPM file.
struct PpmHeader {
    is_text: bool,
    width: u32,
    height: u32,
    /// What a channel is at most.
    largest: u32,
}

/// Words of a file, without comments.
struct Words<'a>(&'a [u8]);

impl<'a> Iterator for Words<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        loop {
            let start = self.0.iter().position(|b| !b.is_ascii_whitespace())?;
            self.0 = &self.0[start..];
            if self.0[0] != b'#' {
                break;
            }
            let end = self
                .0
                .iter()
                .position(|b| *b == b'\n')
                .unwrap_or(self.0.len());
            self.0 = &self.0[end..];
        }
        let end = self
            .0
            .iter()
            .position(|b| b.is_ascii_whitespace() || *b == b'#')
            .unwrap_or(self.0.len());
        let (word, rest) = self.0.split_at(end);
        self.0 = rest;
        Some(word)
    }
}

fn number(word: &[u8]) -> Option<u32> {
    str::from_utf8(word).ok()?.parse().ok()
}

/// The first words, and what comes after them.
fn header(bytes: &[u8]) -> Result<(PpmHeader, &[u8]), String> {
    let mut words = Words(bytes);
    let is_text = words.next() == Some(b"P3");
    let mut next = |what: &str| {
        let number = words.next().and_then(number);
        number.ok_or_else(|| format!("has no {what} in its first words"))
    };
    let header = PpmHeader {
        is_text,
        width: next("width")?,
        height: next("height")?,
        largest: next("largest value")?,
    };
    if !(1..65536).contains(&header.largest) {
        return Err(format!(
            "has {} for the largest value; write 255",
            header.largest
        ));
    }
    // One white space, then the pixels.
    Ok((header, words.0.get(1..).unwrap_or_default()))
}

/// Width and height that a PPM file claims; what is wrong with it, if it is none.
pub fn size(bytes: &[u8]) -> Result<(u32, u32), String> {
    header(bytes).map(|(header, _)| (header.width, header.height))
}

/// The pixels of a PPM file; what is wrong with it, if it is none.
pub fn decode(bytes: &[u8]) -> Result<Vec<[u8; 3]>, String> {
    let (header, rest) = header(bytes)?;
    if let Some(problem) = size_problem(header.width, header.height) {
        return Err(problem);
    }
    let wanted = 3 * header.width as usize * header.height as usize;
    let values: Vec<u32> = if header.is_text {
        text_values(rest, wanted)?
    } else {
        binary_values(rest, wanted, header.largest)?
    };
    if let Some((index, value)) = values
        .iter()
        .enumerate()
        .find(|(_, value)| **value > header.largest)
    {
        let (x, y) = (
            index / 3 % header.width as usize,
            index / 3 / header.width as usize,
        );
        let largest = header.largest;
        return Err(format!(
            "has {value}, above {largest}, at pixel {x},{y}; clamp colours before they are written"
        ));
    }
    // To the nearest of 0 to 255.
    let scaled = |value: &u32| ((value * 255 + header.largest / 2) / header.largest) as u8;
    let (pixels, _) = values.as_chunks::<3>();
    Ok(pixels
        .iter()
        .map(|pixel| pixel.each_ref().map(scaled))
        .collect())
}

fn text_values(rest: &[u8], wanted: usize) -> Result<Vec<u32>, String> {
    // A number takes two bytes at least: a file that is too short is refused before room is made.
    let mut values = Vec::with_capacity(wanted.min(rest.len() / 2 + 1));
    for word in Words(rest).take(wanted + 1) {
        let shown = || excerpt(&String::from_utf8_lossy(&word[..word.len().min(100)]));
        values.push(
            number(word).ok_or_else(|| format!("`{}` is no whole number from 0 up", shown()))?,
        );
    }
    if values.len() != wanted {
        let has = if values.len() > wanted {
            "more".to_owned()
        } else {
            values.len().to_string()
        };
        return Err(format!("has {has} numbers, and {wanted} are wanted"));
    }
    Ok(values)
}

fn binary_values(rest: &[u8], wanted: usize, largest: u32) -> Result<Vec<u32>, String> {
    let size = if largest > 255 { 2 } else { 1 };
    // Some programs write a line end behind the last pixel.
    let rest = match rest.strip_suffix(b"\n") {
        Some(shorter) if shorter.len() == wanted * size => shorter,
        _ => rest,
    };
    if rest.len() != wanted * size {
        return Err(format!(
            "has {} bytes, and {} are wanted; was it opened in text mode?",
            rest.len(),
            wanted * size
        ));
    }
    let value = |bytes: &[u8]| {
        bytes
            .iter()
            .fold(0, |value, byte| value << 8 | u32::from(*byte))
    };
    Ok(rest.chunks(size).map(value).collect())
}
