//! Terminal image: two pixels a text cell, one above the other.

use std::fmt::Write;

use crate::math::Rgb;
use crate::tracer::Film;

/// Colour depth of a terminal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColorLevel {
    /// No colour: a ramp of characters.
    Never,
    /// The 256 colours of xterm.
    Palette,
    /// 24 bits.
    True,
}

/// Characters from dark to bright.
const RAMP: &[u8] = b" .:-=+*#%@";

/// The film as lines of text: with colours each cell is a half block, its upper pixel in the foreground and its lower
/// one in the background; without, a character as bright as both.
pub fn lines(film: &Film, exposure: f64, level: ColorLevel) -> String {
    let mut text = String::new();
    for y in (0..film.height).step_by(2) {
        let mut last = None;
        for x in 0..film.width {
            let upper = film.at(x, y) * exposure;
            // Under the last line of an odd height there is nothing.
            let lower = if y + 1 < film.height {
                film.at(x, y + 1) * exposure
            } else {
                Rgb::BLACK
            };
            if level == ColorLevel::Never {
                let single = y + 1 == film.height;
                text.push(ramp(if single { upper } else { (upper + lower) * 0.5 }));
                continue;
            }
            let colors = (upper.to_srgb8(), lower.to_srgb8());
            if last != Some(colors) {
                cell_colors(&mut text, colors, level);
                last = Some(colors);
            }
            text.push('▀');
        }
        text.push_str(if level == ColorLevel::Never {
            "\n"
        } else {
            "\x1b[0m\n"
        });
    }
    text
}

/// The escape sequence that sets foreground and background.
fn cell_colors(text: &mut String, (upper, lower): ([u8; 3], [u8; 3]), level: ColorLevel) {
    let color = |[r, g, b]: [u8; 3]| match level {
        ColorLevel::Palette => format!("5;{}", nearest_of_256([r, g, b])),
        _ => format!("2;{r};{g};{b}"),
    };
    // Writing to a string cannot fail.
    let _ = write!(text, "\x1b[38;{};48;{}m", color(upper), color(lower));
}

/// The index of the xterm colour nearest to an sRGB colour: from the cube or the greys, since the first 16 look
/// different in each terminal's theme.
pub fn nearest_of_256([r, g, b]: [u8; 3]) -> u8 {
    anstyle_lossy::rgb_to_xterm(anstyle::RgbColor(r, g, b)).index()
}

/// A character as bright as a colour, on the curve that a screen has.
pub fn ramp(color: Rgb) -> char {
    let [grey, ..] = Rgb::grey(color.luminance()).to_srgb8();
    char::from(RAMP[usize::from(grey) * (RAMP.len() - 1) / 255])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A film of 2 x 3: white, black; black, white; red, red.
    fn film() -> Film {
        let (white, black, red) = (Rgb::WHITE, Rgb::BLACK, Rgb::new(1.0, 0.0, 0.0));
        Film {
            width: 2,
            height: 3,
            pixels: vec![white, black, black, white, red, red],
            ..Film::default()
        }
    }

    #[test]
    fn without_colour_brightness_becomes_a_character() {
        // Half of white is sRGB 188, red has the luminance 0.2126: sRGB 127.
        assert_eq!(lines(&film(), 1.0, ColorLevel::Never), "**\n==\n");
    }

    #[test]
    fn with_colour_each_half_of_a_cell_is_a_pixel() {
        let text = lines(&film(), 1.0, ColorLevel::True);
        let first = "\x1b[38;2;255;255;255;48;2;0;0;0m▀\x1b[38;2;0;0;0;48;2;255;255;255m▀\x1b[0m\n";
        assert!(text.starts_with(first), "{text:?}");
        let palette = lines(&film(), 1.0, ColorLevel::Palette);
        assert!(palette.contains("\x1b[38;5;231;48;5;16m▀"), "{palette:?}");
    }
}
