//! How far a picture is from a reference.

use super::flip::{Seen, flip};
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
    /// How much an eye that switches between both sees them differ, 0 to 1: see [`super::flip`].
    pub flip: f64,
}

/// What pictures are compared with.
#[derive(Clone, Debug)]
pub struct Reference {
    film: Film,
    seen: Seen,
}

impl Reference {
    /// Shown with this exposure.
    pub fn new(film: Film, exposure: f64) -> Self {
        Self {
            seen: Seen::new(&film, exposure),
            film,
        }
    }

    /// Width and height.
    pub fn size(&self) -> (u32, u32) {
        (self.film.width, self.film.height)
    }

    /// The picture.
    pub fn film(&self) -> &Film {
        &self.film
    }
}

/// The errors of a picture; `None` if the reference has another size.
pub fn errors(film: &Film, reference: &Reference, exposure: f64) -> Option<Errors> {
    if (film.width, film.height) != reference.size() {
        return None;
    }
    let flip = flip(&reference.seen, &Seen::new(film, exposure));
    let reference = &reference.film;
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
        flip,
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
            ..Film::default()
        }
    }

    fn reference(pixels: [f64; 2]) -> Reference {
        Reference::new(film(pixels), 1.0)
    }

    #[test]
    fn errors_are_those_known_on_paper() {
        let found = errors(&film([0.5, 0.2]), &reference([0.5, 0.5]), 1.0).expect("one size");
        assert!((found.rmse - 0.3 / 2.0f64.sqrt()).abs() < 1e-15);
        assert!((found.relative_mse - 0.09 / 0.26 / 2.0).abs() < 1e-15);
        assert!((found.max - 0.3).abs() < 1e-15);
        assert_eq!(found.seen, 0.5);
        assert!(found.flip > 0.1 && found.flip < 1.0);
        assert_eq!(
            errors(&film([0.5, 0.2]), &reference([0.5, 0.2]), 1.0),
            Some(Errors::default())
        );
    }

    #[test]
    fn pictures_of_two_sizes_have_no_distance() {
        let mut other = film([0.0, 0.0]);
        (other.width, other.height) = (1, 2);
        let other = Reference::new(other, 1.0);
        assert_eq!(errors(&film([0.0, 0.0]), &other, 1.0), None);
    }
}
