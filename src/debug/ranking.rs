//! Pixels in the order of what they show, and those that stand out from their neighbours.

use super::picture::PartialPicture;
use super::window::Window;
use crate::lab::show::ShownValue;

/// How many times as bright as the median of its neighbours a pixel must be to stand out: far more than an edge makes of most.
const FACTOR: f64 = 4.0;

/// Luminances below this are dark: no pixel stands out from nothing by less.
const DARK: f64 = 0.02;

/// A pixel that stands out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outlier {
    /// Column and row.
    pub at: (u32, u32),
    /// Its number.
    pub value: f64,
    /// The median of the up to eight pixels around it.
    pub around: f64,
}

/// What orders the pixels: the number that is shown, or the luminance of the colour.
pub fn number(value: ShownValue) -> Option<f64> {
    match value {
        ShownValue::Number(x) => Some(x).filter(|x| !x.is_nan()),
        ShownValue::Color(color) => Some(color.luminance()).filter(|x| !x.is_nan()),
        ShownValue::Nothing => None,
    }
}

fn pixels(window: Window) -> impl Iterator<Item = (u32, u32)> {
    let Window {
        x,
        y,
        width,
        height,
    } = window;
    (y..y + height).flat_map(move |row| (x..x + width).map(move |column| (column, row)))
}

/// The known pixels of the window with their numbers, the largest first; of equal ones the first in the order of reading.
pub fn ranked(picture: &PartialPicture) -> Vec<((u32, u32), f64)> {
    let known = pixels(picture.window);
    let known = known.filter_map(|at| Some((at, number(picture.exact(at)?)?)));
    let mut ranked: Vec<_> = known.collect();
    ranked.sort_by(|a, b| b.1.total_cmp(&a.1));
    ranked
}

/// The pixels that are far larger than those around them, the furthest first.
pub fn outliers(picture: &PartialPicture) -> Vec<Outlier> {
    let mut found: Vec<_> = pixels(picture.window)
        .filter_map(|at| outlier(picture, at))
        .collect();
    let ratio = |o: &Outlier| o.value / o.around.max(DARK);
    found.sort_by(|a, b| ratio(b).total_cmp(&ratio(a)));
    found
}

fn outlier(picture: &PartialPicture, at: (u32, u32)) -> Option<Outlier> {
    let value = number(picture.exact(at)?)?;
    let rows = at.1.saturating_sub(1)..=at.1.saturating_add(1);
    let around =
        rows.flat_map(|y| (at.0.saturating_sub(1)..=at.0.saturating_add(1)).map(move |x| (x, y)));
    let numbers = around.filter(|other| *other != at);
    let mut numbers: Vec<f64> = numbers
        .filter_map(|other| number(picture.exact(other)?))
        .collect();
    numbers.sort_by(f64::total_cmp);
    let around = *numbers.get(numbers.len() / 2)?;
    (value > FACTOR * around.max(DARK)).then_some(Outlier { at, value, around })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Rgb;

    fn picture(numbers: &[[f64; 4]; 3]) -> PartialPicture {
        let mut picture = PartialPicture::new((4, 3), (4, 3), (0, 0));
        for (y, row) in (0..).zip(numbers) {
            for (x, value) in (0..).zip(row) {
                picture.set((x, y), ShownValue::Color(Rgb::grey(*value)));
            }
        }
        picture
    }

    #[test]
    fn all_known_pixels_are_ranked_once() {
        let picture = picture(&[
            [0.1, 0.5, 0.2, 0.2],
            [0.3, 0.0, 0.9, 0.2],
            [0.1, 0.1, 0.1, 0.7],
        ]);
        let ranked = ranked(&picture);
        assert_eq!(ranked.len(), 12);
        assert!(ranked.windows(2).all(|pair| pair[0].1 >= pair[1].1));
        assert_eq!(ranked[0].0, (2, 1));
        assert_eq!(ranked[11].0, (1, 1));
        let places: std::collections::BTreeSet<_> = ranked.iter().map(|(at, _)| at).collect();
        assert_eq!(places.len(), 12);
    }

    #[test]
    fn a_spike_stands_out_and_an_edge_does_not() {
        let edge = picture(&[[0.1, 0.1, 0.9, 0.9]; 3]);
        assert_eq!(outliers(&edge), [], "an edge");
        let spike = picture(&[[0.1; 4], [0.1, 5.0, 0.1, 0.1], [0.1; 4]]);
        let found = outliers(&spike);
        assert_eq!(found.len(), 1);
        assert_eq!(
            (found[0].at, found[0].around),
            ((1, 1), Rgb::grey(0.1).luminance())
        );
        let even = picture(&[[0.3; 4]; 3]);
        assert!(outliers(&even).is_empty());
    }
}
