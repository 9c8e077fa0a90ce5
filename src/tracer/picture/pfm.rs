//! PFM, portable float map: the film's linear radiance as 32-bit floats, for programs that measure pictures.
//!
//! `PF`, width and height, and a scale whose sign tells the order of bytes (negative: the low byte first); then rows
//! from the bottom to the top, three floats a pixel. Source: Debevec, "PFM portable float map image format".

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

/// The nearest 32-bit float; never infinite.
fn single(value: f64) -> f32 {
    (value as f32).clamp(f32::MIN, f32::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;

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
    }
}
