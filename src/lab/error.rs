//! How far a picture is from a reference.

use crate::math::Rgb;
use crate::tracer::Film;

/// Keeps the relative error finite where the reference is black.
/// Source: Rousselle, Knaus and Zwicker 2011, "Adaptive sampling and reconstruction using greedy error minimization".
const BLACK: f64 = 1e-2;

/// The distance of two pictures, in linear radiance over all pixels and channels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Errors {
    /// The root of the mean square of x - r.
    pub rmse: f64,
    /// The mean of (x - r)^2 / (r^2 + 0.01).
    pub relative_mse: f64,
    /// The largest |x - r|.
    pub max: f64,
    /// The share of pixels of which a channel, as a screen shows it, is off by more than 1/255.
    pub seen: f64,
}

/// The errors of a picture; `None` if the reference has another size.
pub fn errors(film: &Film, reference: &Film, exposure: f64) -> Option<Errors> {
    if (film.width, film.height) != (reference.width, reference.height) {
        return None;
    }
    let (mut squares, mut relative, mut max, mut seen) = (0.0, 0.0, 0.0f64, 0u64);
    for (x, r) in film.pixels.iter().zip(&reference.pixels) {
        for (x, r) in x.channels().into_iter().zip(r.channels()) {
            let square = (x - r) * (x - r);
            squares += square;
            relative += square / (r * r + BLACK);
            max = max.max((x - r).abs());
        }
        seen += u64::from(differ(*x * exposure, *r * exposure));
    }
    let pixels = film.pixels.len().max(1) as f64;
    Some(Errors {
        rmse: (squares / (3.0 * pixels)).sqrt(),
        relative_mse: relative / (3.0 * pixels),
        max,
        seen: seen as f64 / pixels,
    })
}

/// True if a screen shows two colours more than one step of its 255 apart.
fn differ(a: Rgb, b: Rgb) -> bool {
    let pairs = a.to_srgb8().into_iter().zip(b.to_srgb8());
    pairs.into_iter().any(|(a, b)| a.abs_diff(b) > 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn film(pixels: [f64; 2]) -> Film {
        Film {
            width: 2,
            height: 1,
            pixels: pixels.map(Rgb::grey).to_vec(),
            rays: 0,
            cut: false,
        }
    }

    #[test]
    fn errors_are_those_known_on_paper() {
        let found = errors(&film([0.5, 0.2]), &film([0.5, 0.5]), 1.0).expect("one size");
        assert!((found.rmse - 0.3 / 2.0f64.sqrt()).abs() < 1e-15);
        assert!((found.relative_mse - 0.09 / 0.26 / 2.0).abs() < 1e-15);
        assert!((found.max - 0.3).abs() < 1e-15);
        assert_eq!(found.seen, 0.5);
        assert_eq!(
            errors(&film([0.5, 0.2]), &film([0.5, 0.2]), 1.0),
            Some(Errors::default())
        );
    }

    #[test]
    fn pictures_of_two_sizes_have_no_distance() {
        let mut other = film([0.0, 0.0]);
        (other.width, other.height) = (1, 2);
        assert_eq!(errors(&film([0.0, 0.0]), &other, 1.0), None);
    }
}
