//! The pictures that a render leaves behind.

use crate::cli::Failure;
use crate::cli::output::Destination;
use crate::math::Rgb;
use crate::tracer::Film;
use crate::tracer::image::{pfm, png};

/// Endings of the names of pictures.
pub const PICTURE: &[&str] = &["png", "pfm"];

/// The film as a PFM file if the name ends so, else as a PNG file.
pub fn picture(to: Destination, film: &Film, exposure: f64) -> Result<(), Failure> {
    let is_pfm = to
        .path()
        .extension()
        .is_some_and(|e| e.eq_ignore_ascii_case("pfm"));
    let bytes = if is_pfm {
        Ok(pfm::encode(film))
    } else {
        png::encode(film, exposure).map_err(std::io::Error::other)
    };
    to.write(|out| out.write_all(&bytes?))
}

/// Each pixel's standard error as grey: in a PFM file the number itself, in a PNG file white for the largest.
pub fn errors(to: Destination, film: &Film) -> Result<(), Failure> {
    let finite = film.errors.iter().filter(|error| error.is_finite());
    let largest = finite.fold(0.0f64, |most, error| most.max(*error));
    let grey = |error: &f64| Rgb::grey(error.min(f64::MAX));
    let map = Film {
        width: film.width,
        height: film.height,
        pixels: film.errors.iter().map(grey).collect(),
        ..Film::default()
    };
    picture(to, &map, 1.0 / largest.max(f64::MIN_POSITIVE))
}

/// The samples of each pixel: black for the fewest, white for the most, and even steps where they double.
pub fn samples(to: Destination, film: &Film) -> Result<(), Failure> {
    let [fewest, most] = range(film).map(|n| f64::from(n.max(1)));
    let shade = |n: &u32| {
        let doubled = libm::log2(f64::from((*n).max(1)) / fewest);
        let all = libm::log2(most / fewest);
        (255.0 * doubled / all.max(1e-9)).round() as u8
    };
    let bytes: Vec<u8> = film.samples.iter().map(shade).collect();
    let png = png::encode_grey(film.width, film.height, &bytes).map_err(std::io::Error::other);
    to.write(|out| out.write_all(&png?))
}

/// The fewest samples of a pixel, and the most.
pub fn range(film: &Film) -> [u32; 2] {
    let fewest = film.samples.iter().min();
    let most = film.samples.iter().max();
    [fewest, most].map(|n| n.copied().unwrap_or(0))
}
