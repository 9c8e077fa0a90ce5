//! How things look: one colour for each kind of ray everywhere, and what becomes of colours where there are few.
//!
//! Panes paint as if every terminal had true colour. [`lower`] goes over the finished screen once and takes out what
//! the terminal at hand cannot show. State is never told by colour alone: the current thing has a ▶ as well.

use std::sync::OnceLock;

use ratatui::buffer::Buffer;
use ratatui::style::{Color, Modifier, Style};
use ratatui::text::Span;

use crate::math::Rgb;
use crate::probe::RayKind;

/// How many colours the terminal has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ColorLevel {
    /// None: letters, bold and reversed only.
    None,
    /// The 256 colours of xterm.
    Indexed,
    /// 8 bits a channel.
    #[default]
    True,
}

/// What stands before the current row.
pub const POINTER: &str = "▶";

/// From dark to bright.
const RAMP: &[u8] = b" .:-=+*#%@";

/// The colour of a kind of ray: of a middle brightness, to be read on light and on dark ground.
pub fn kind_color(kind: RayKind) -> Color {
    match kind {
        RayKind::Incident => Color::Rgb(140, 150, 160),
        RayKind::Light => Color::Rgb(204, 150, 30),
        RayKind::Reflected => Color::Rgb(222, 90, 80),
        RayKind::Transmitted => Color::Rgb(70, 145, 225),
    }
}

/// Letters of a kind of ray.
pub fn kind_style(kind: RayKind) -> Style {
    Style::new().fg(kind_color(kind)).bold()
}

/// What is less important.
pub fn dim() -> Style {
    Style::new().add_modifier(Modifier::DIM)
}

/// The current row.
pub fn current() -> Style {
    Style::new().add_modifier(Modifier::REVERSED | Modifier::BOLD)
}

/// Keys in the help and the hint line.
pub fn keycap() -> Style {
    Style::new().fg(Color::Rgb(60, 160, 150)).bold()
}

/// A colour to be seen: two cells of it; without colours, its brightness.
pub fn swatch(color: Rgb, level: ColorLevel) -> Span<'static> {
    if level == ColorLevel::None {
        let letter = ramp(color.luminance());
        return Span::raw(format!("{letter}{letter}"));
    }
    Span::styled("██", Style::new().fg(screen(color)))
}

/// Linear radiance as a screen shows it.
pub fn screen(color: Rgb) -> Color {
    let [r, g, b] = color.to_srgb8();
    Color::Rgb(r, g, b)
}

/// The letter whose ink is about as bright as a linear luminance.
pub fn ramp(luminance: f64) -> char {
    let [encoded, ..] = Rgb::grey(luminance).to_srgb8();
    let last = RAMP.len() - 1;
    char::from(RAMP[(usize::from(encoded) * last + 127) / 255])
}

/// Takes out of a finished screen what a terminal of this level cannot show.
pub fn lower(buffer: &mut Buffer, level: ColorLevel) {
    if level == ColorLevel::True {
        return;
    }
    for cell in &mut buffer.content {
        cell.fg = lowered(cell.fg, level);
        cell.bg = lowered(cell.bg, level);
    }
}

fn lowered(color: Color, level: ColorLevel) -> Color {
    match (level, color) {
        (ColorLevel::None, _) => Color::Reset,
        (ColorLevel::Indexed, Color::Rgb(r, g, b)) => Color::Indexed(indexed([r, g, b])),
        _ => color,
    }
}

/// The levels of a channel in xterm's 6 x 6 x 6 cube.
const LEVELS: [u8; 6] = [0, 95, 135, 175, 215, 255];

/// The nearest of the 6 x 6 x 6 cube and the 24 greys of xterm's palette: to the eye, that is in OKLab.
pub fn indexed(srgb: [u8; 3]) -> u8 {
    let wanted = oklab(srgb);
    // Of the cube only the eight corners around the colour can be nearest, of the greys only two.
    let around = srgb.map(|c| {
        let above = LEVELS.iter().position(|l| *l >= c).unwrap_or(5);
        [above.saturating_sub(1), above]
    });
    let grey = usize::from(srgb.iter().map(|c| u16::from(*c)).sum::<u16>() / 3);
    let grey = (grey.saturating_sub(8) / 10).min(23);
    let cube = (0..8).map(|i| {
        let [r, g, b] = [0, 1, 2].map(|axis| around[axis][i >> axis & 1]);
        16 + 36 * r + 6 * g + b
    });
    let candidates = cube.chain([232 + grey, 232 + (grey + 1).min(23)]);
    let distance = |index: &usize| {
        let p = palette()[*index - 16];
        (0..3).map(|i| (p[i] - wanted[i]).powi(2)).sum::<f32>()
    };
    candidates
        .min_by(|a, b| distance(a).total_cmp(&distance(b)))
        .unwrap_or(16) as u8
}

/// Colours 16 to 255 of xterm in OKLab.
fn palette() -> &'static [[f32; 3]; 240] {
    static PALETTE: OnceLock<[[f32; 3]; 240]> = OnceLock::new();
    PALETTE.get_or_init(|| {
        std::array::from_fn(|i| {
            if i < 216 {
                oklab([LEVELS[i / 36], LEVELS[i / 6 % 6], LEVELS[i % 6]])
            } else {
                oklab([(8 + 10 * (i - 216)) as u8; 3])
            }
        })
    })
}

/// sRGB to OKLab. Source: Ottosson 2020, "A perceptual color space for image processing".
fn oklab(srgb: [u8; 3]) -> [f32; 3] {
    let [r, g, b] = srgb.map(|c| linear()[usize::from(c)]);
    let l = (0.412_221_46 * r + 0.536_332_55 * g + 0.051_445_995 * b).cbrt();
    let m = (0.211_903_5 * r + 0.680_699_5 * g + 0.107_396_96 * b).cbrt();
    let s = (0.088_302_46 * r + 0.281_718_85 * g + 0.629_978_7 * b).cbrt();
    [
        0.210_454_26 * l + 0.793_617_8 * m - 0.004_072_047 * s,
        1.977_998_5 * l - 2.428_592_2 * m + 0.450_593_7 * s,
        0.025_904_037 * l + 0.782_771_77 * m - 0.808_675_77 * s,
    ]
}

/// The linear value of each 8-bit sRGB value.
fn linear() -> &'static [f32; 256] {
    static LINEAR: OnceLock<[f32; 256]> = OnceLock::new();
    LINEAR.get_or_init(|| {
        std::array::from_fn(|i| {
            let c = i as f32 / 255.0;
            if c <= 0.04045 {
                c / 12.92
            } else {
                ((c + 0.055) / 1.055).powf(2.4)
            }
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_of_the_palette_stay_what_they_are() {
        for i in 0..216usize {
            let srgb = [LEVELS[i / 36], LEVELS[i / 6 % 6], LEVELS[i % 6]];
            assert_eq!(usize::from(indexed(srgb)), 16 + i);
        }
        for i in 0..24usize {
            assert_eq!(usize::from(indexed([(8 + 10 * i) as u8; 3])), 232 + i);
        }
    }

    #[test]
    fn the_ramp_runs_from_dark_to_bright() {
        assert_eq!(ramp(0.0), ' ');
        assert_eq!(ramp(1.0), '@');
        assert_eq!(ramp(99.0), '@');
        assert_eq!(ramp(0.2140), '+');
    }
}
