//! The film: the colours of all pixels, and what is known of them.

use std::ops::Range;

use super::CutShare;
use crate::math::Rgb;
use crate::scene::Settings;
use crate::tracer::pixel::Pixel;
use crate::tracer::tile::Tile;

/// A rendered picture in linear radiance.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Film {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Row after row from the top.
    pub pixels: Vec<Rgb>,
    /// Rays that it cost.
    pub rays: u64,
    /// True if a limit cut a pixel short.
    pub truncated: bool,
    /// The number of samples of each pixel, in the order of `pixels`; empty if all have as many as were asked for.
    pub samples: Vec<u32>,
    /// The estimated standard error of each pixel's luminance; empty if they were not asked for.
    pub errors: Vec<f64>,
    /// Samples whose radiance was NaN or infinite.
    pub non_finite: NonFinite,
    /// What the limits of recursion left out.
    pub cuts: CutShare,
}

/// Samples whose radiance was NaN or infinite; they count as black.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NonFinite {
    /// Their number.
    pub count: u64,
    /// The pixel of the first, and its index there.
    pub first: Option<((u32, u32), u32)>,
}

impl Film {
    /// The colour of a pixel.
    pub fn at(&self, x: u32, y: u32) -> Rgb {
        self.pixels[y as usize * self.width as usize + x as usize]
    }

    /// The root of the mean square of the pixels' estimated standard errors; `None` if they were not asked
    /// for.
    pub fn error(&self) -> Option<f64> {
        let squares: f64 = self.errors.iter().map(|error| error * error).sum();
        let count = self.errors.len();
        (count > 0).then(|| (squares / count as f64).sqrt())
    }

    /// A black film.
    pub fn black((width, height): (u32, u32), settings: &Settings) -> Self {
        let count = width as usize * height as usize;
        let if_wanted = |wanted: bool| if wanted { count } else { 0 };
        Self {
            width,
            height,
            pixels: vec![Rgb::BLACK; count],
            samples: vec![0; if_wanted(settings.pixel.adaptive.is_some())],
            errors: vec![f64::INFINITY; if_wanted(settings.pixel.errors)],
            ..Self::default()
        }
    }

    /// Stores pixel number `index` of the film, which is pixel `at` of the whole picture.
    #[inline(always)]
    pub fn put(&mut self, index: usize, at: (u32, u32), pixel: &Pixel) {
        self.pixels[index] = pixel.color;
        if let Some(samples) = self.samples.get_mut(index) {
            *samples = pixel.samples;
        }
        if let Some(error) = self.errors.get_mut(index) {
            *error = pixel.error;
        }
        self.rays += pixel.rays;
        self.truncated |= pixel.truncated;
        self.cuts.add(at, pixel);
        if pixel.non_finite > 0 {
            self.non_finite = self.non_finite.plus(NonFinite {
                count: u64::from(pixel.non_finite),
                first: pixel.first_non_finite.map(|sample| (at, sample)),
            });
        }
    }

    /// Moves the pixels of a tile's film into the picture.
    pub(super) fn paste(&mut self, tile: Tile, film: &mut Self) {
        let (columns, rows) = tile.size();
        let columns = columns as usize;
        for row in 0..rows as usize {
            let from = row * columns..(row + 1) * columns;
            let start = (tile.y[0] as usize + row) * self.width as usize + tile.x[0] as usize;
            let to = start..start + columns;
            copy(&mut self.pixels, to.clone(), &film.pixels, from.clone());
            copy(&mut self.samples, to.clone(), &film.samples, from.clone());
            copy(&mut self.errors, to, &film.errors, from);
        }
        (film.pixels, film.samples, film.errors) = Default::default();
    }

    /// Adds what is counted over all pixels of a tile. In the order of the tiles, whichever is drawn first, the sums are the same to
    /// the last bit.
    pub(super) fn add_counts(&mut self, film: &Self) {
        self.rays += film.rays;
        self.truncated |= film.truncated;
        self.non_finite = self.non_finite.plus(film.non_finite);
        self.cuts = self.cuts.plus(film.cuts);
    }
}

/// Copies a range, if there is anything to copy and to copy to.
fn copy<T: Copy>(to: &mut [T], there: Range<usize>, from: &[T], here: Range<usize>) {
    if let (Some(to), Some(from)) = (to.get_mut(there), from.get(here)) {
        to.copy_from_slice(from);
    }
}

impl NonFinite {
    /// Both, those of `self` first.
    fn plus(self, other: Self) -> Self {
        Self {
            count: self.count + other.count,
            first: self.first.or(other.first),
        }
    }
}
