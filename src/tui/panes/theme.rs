//! Colours and styles: one colour for each kind of ray everywhere, quantized where the terminal has few.
//!
//! Panes paint as if every terminal had true colour. [`quantize_colors`] goes over the finished screen once and takes out what
//! the terminal at hand cannot show. State is never told by colour alone: the current thing has a ▶ as well.

use ratatui::buffer::Buffer;
use ratatui::style::{Color, Modifier, Style};
use ratatui::text::Span;

use crate::math::Rgb;
use crate::probe::RayKind;
use crate::tracer::image::ColorLevel;
use crate::tracer::image::terminal::{nearest_of_256, ramp};

/// Mark before the current row.
pub const POINTER: &str = "▶";

/// The colour of a kind of ray: of a middle brightness, to be read on light and on dark ground.
pub fn kind_color(kind: RayKind) -> Color {
    match kind {
        RayKind::Incident => Color::Rgb(140, 150, 160),
        RayKind::Light => Color::Rgb(204, 150, 30),
        RayKind::Reflected => Color::Rgb(222, 90, 80),
        RayKind::Transmitted => Color::Rgb(70, 145, 225),
    }
}

/// Style of the letter of a kind of ray.
pub fn kind_style(kind: RayKind) -> Style {
    Style::new().fg(kind_color(kind)).bold()
}

/// Style of what is less important.
pub fn dim() -> Style {
    Style::new().add_modifier(Modifier::DIM)
}

/// Style of the current row.
pub fn current() -> Style {
    Style::new().add_modifier(Modifier::REVERSED | Modifier::BOLD)
}

/// Style of keys in the help and the hint line.
pub fn keycap() -> Style {
    Style::new().fg(Color::Rgb(60, 160, 150)).bold()
}

/// Colour of what is code, or stands as it was printed.
pub fn code() -> Color {
    Color::Rgb(60, 160, 150)
}

/// Style of what must not be overlooked.
pub fn warning() -> Style {
    Style::new().add_modifier(Modifier::REVERSED)
}

/// Colour swatch: two cells of it; without colours, its brightness.
pub fn swatch(color: Rgb, level: ColorLevel) -> Span<'static> {
    if level == ColorLevel::Never {
        let letter = ramp(color);
        return Span::raw(format!("{letter}{letter}"));
    }
    Span::styled("██", Style::new().fg(screen(color)))
}

/// Linear radiance as a screen shows it.
pub fn screen(color: Rgb) -> Color {
    let [r, g, b] = color.to_srgb8();
    Color::Rgb(r, g, b)
}

/// Takes out of a finished screen what a terminal of this level cannot show.
pub fn quantize_colors(buffer: &mut Buffer, level: ColorLevel) {
    if level == ColorLevel::True {
        return;
    }
    for cell in &mut buffer.content {
        cell.fg = quantized(cell.fg, level);
        cell.bg = quantized(cell.bg, level);
    }
}

fn quantized(color: Color, level: ColorLevel) -> Color {
    match (level, color) {
        (ColorLevel::Never, _) => Color::Reset,
        (ColorLevel::Palette, Color::Rgb(r, g, b)) => Color::Indexed(nearest_of_256([r, g, b])),
        _ => color,
    }
}
