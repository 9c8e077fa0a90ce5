//! What a case looks like: a window of pixels, each of them really traced with the arithmetic that is looked at.

use rayon::prelude::*;

use crate::math::Rgb;
use crate::tracer::Film;

/// A picture of a case, one panel for each arithmetic.
#[derive(Clone, Copy, Debug)]
pub struct Picture {
    /// What is to be seen.
    pub shows: &'static str,
    /// What is wrong where a pixel is marked.
    pub wrong: &'static str,
    /// Traces it, so many pixels wide and high.
    pub draw: fn((u32, u32)) -> Vec<Panel>,
}

/// What one arithmetic makes of the picture.
#[derive(Clone, Debug)]
pub struct Panel {
    /// The arithmetic, as its flags say it.
    pub arithmetic: String,
    /// True for that of raytree.
    pub ours: bool,
    /// The picture.
    pub film: Film,
    /// Of each pixel whether it is wrong; they are red in the picture.
    pub wrong: Vec<bool>,
}

/// Where a pixel is in a square window from -1 to 1, x to the right and y upwards, and how far it reaches from its middle.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    pub x: f64,
    pub y: f64,
    pub half: [f64; 2],
}

/// What is seen in a pixel.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    /// How bright it is, from 0 to 1.
    pub brightness: f64,
    /// Whether something else should be seen.
    pub wrong: bool,
}

impl Seen {
    /// As grey as it is bright; red, bright or dark, where it is wrong.
    fn color(self) -> Rgb {
        let b = self.brightness;
        if self.wrong {
            Rgb::new(0.4 + 0.6 * b, 0.25 * b, 0.15 * b)
        } else {
            Rgb::grey(b)
        }
    }
}

/// Traces the pixels of one arithmetic.
pub fn panel(
    (arithmetic, ours): (&str, bool),
    (width, height): (u32, u32),
    pixel: impl Fn(Place) -> Seen + Sync,
) -> Panel {
    let half = [width, height].map(|n| 1.0 / f64::from(n));
    let place = |i: u32| Place {
        x: f64::from(2 * (i % width) + 1) * half[0] - 1.0,
        y: 1.0 - f64::from(2 * (i / width) + 1) * half[1],
        half,
    };
    let seen: Vec<Seen> = (0..width * height)
        .into_par_iter()
        .map(|i| pixel(place(i)))
        .collect();
    Panel {
        arithmetic: arithmetic.to_owned(),
        ours,
        wrong: seen.iter().map(|seen| seen.wrong).collect(),
        film: Film {
            width,
            height,
            pixels: seen.into_iter().map(Seen::color).collect(),
            ..Film::default()
        },
    }
}

#[cfg(test)]
mod tests {
    use super::super::CASES;
    use super::*;

    #[test]
    fn ours_has_no_wrong_pixel_and_something_common_has() {
        for size in [(24, 24), (24, 12), (19, 18), (19, 9), (64, 64)] {
            for case in CASES {
                let panels = (case.picture.draw)(size);
                let (ours, others): (Vec<_>, Vec<_>) = panels.iter().partition(|p| p.ours);
                let told = |panels: &[&Panel]| -> Vec<(String, usize)> {
                    let count = |p: &Panel| p.wrong.iter().filter(|wrong| **wrong).count();
                    let of = panels.iter().map(|p| (p.arithmetic.clone(), count(p)));
                    of.collect()
                };
                let name = case.name;
                assert_eq!(told(&ours), [("ours".to_owned(), 0)], "{name}");
                let measured = (case.measure)().into_iter().map(|o| o.arithmetic);
                let drawn = panels.iter().map(|p| p.arithmetic.clone());
                assert!(drawn.eq(measured), "{name}");
                let others = told(&others);
                let any = others.iter().any(|(_, wrong)| *wrong > 0);
                assert!(any, "{} {size:?}: {others:?}", case.name);
            }
        }
    }

    #[test]
    fn pixels_go_from_left_to_right_and_downwards() {
        let mark = |p: Place| Seen {
            brightness: f64::from(u8::from(p.x < 0.0 && p.y > 0.0)),
            wrong: p.x > 0.0 && p.y < 0.0,
        };
        let panel = panel(("ours", true), (2, 2), mark);
        assert_eq!(panel.wrong, [false, false, false, true]);
        let red = Rgb::new(0.4, 0.0, 0.0);
        assert_eq!(panel.film.pixels, [Rgb::WHITE, Rgb::BLACK, Rgb::BLACK, red]);
    }
}
