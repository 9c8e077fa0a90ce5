//! Picture pane: half a cell is exactly one traced pixel, with its own colour.

use ratatui::buffer::Buffer;
use ratatui::style::{Color, Modifier, Style};

use super::theme;
use crate::debug::QuerySearch;
use crate::lab::show::{ShownRange, ShownValue};
use crate::math::Rgb;
use crate::trace::explain::UNKNOWN;
use crate::tracer::image::ColorLevel;
use crate::tracer::image::terminal::ramp;
use crate::tui::model::Model;
use crate::tui::model::placement::Placement;

/// How much darker the pixels are that a search has not found.
const DARKER: f64 = 0.15;

/// Draws the picture and the marks around the pixel under the cursor.
pub fn draw(model: &Model, placement: &Placement, buffer: &mut Buffer) {
    pixels(model, placement, buffer);
    if !placement.cells.is_empty() {
        mark(model, placement, model.picture.cursor, buffer);
        unknown(model, placement, buffer);
    }
}

/// Draws the pixels.
pub fn pixels(model: &Model, placement: &Placement, buffer: &mut Buffer) {
    let cells = placement.cells;
    let exposure = model.settings.image.exposure;
    let (picture, unit) = (model.shown(), model.unit());
    let range = picture.range().unwrap_or(ShownRange(0.0, 0.0));
    let color = |column, half| {
        let at = placement.half(column, half)?;
        let color = match picture.nearest(at)? {
            ShownValue::Color(color) if unit.is_none() => color * exposure,
            value => range.color(value),
        };
        let is_left_out = |search: &QuerySearch| search.is_found(at) == Some(false);
        let is_left_out = model.search.as_ref().is_some_and(is_left_out);
        Some(if is_left_out { color * DARKER } else { color })
    };
    for row in 0..cells.height {
        for column in 0..cells.width {
            let (upper, lower) = (color(column, 2 * row), color(column, 2 * row + 1));
            if let Some(cell) = buffer.cell_mut((cells.x + column, cells.y + row)) {
                if model.options.color == ColorLevel::Never {
                    cell.set_char(letter(upper, lower));
                } else {
                    paint(cell, upper, lower);
                }
            }
        }
    }
}

/// The sign of what is not known, at the pixel that is asked for.
fn unknown(model: &Model, placement: &Placement, buffer: &mut Buffer) {
    let is_inside = |at: &(u32, u32)| model.picture.window.contains(*at);
    if let Some(at) = model.picture.hidden.filter(is_inside)
        && let Some(cell) = buffer.cell_mut(placement.cell(at))
    {
        // The colours of its neighbours would hide it.
        cell.reset();
        cell.set_symbol(UNKNOWN).set_style(theme::current());
    }
}

/// Two pixels in a cell.
fn paint(cell: &mut ratatui::buffer::Cell, upper: Option<Rgb>, lower: Option<Rgb>) {
    let shown = |c: Option<Rgb>| c.map_or(Color::Reset, theme::screen);
    match (upper, lower) {
        (None, None) => {}
        (None, Some(_)) => {
            cell.set_char('▄').set_fg(shown(lower));
        }
        _ => {
            cell.set_char('▀').set_fg(shown(upper)).set_bg(shown(lower));
        }
    }
}

/// The mean brightness of two pixels as a letter.
fn letter(upper: Option<Rgb>, lower: Option<Rgb>) -> char {
    match (upper, lower) {
        (None, None) => ' ',
        (Some(one), None) | (None, Some(one)) => ramp(one),
        (Some(upper), Some(lower)) => ramp((upper + lower) * 0.5),
    }
}

/// Points at a pixel from its four sides. The pixel itself stays as it is; left and right, the
/// mark stands at exactly its half of the cell.
pub fn mark(model: &Model, placement: &Placement, at: (u32, u32), buffer: &mut Buffer) {
    let cells = placement.cells;
    let (column, half) = placement.half_of(at);
    let (x, y) = (i32::from(cells.x + column), i32::from(cells.y + half / 2));
    let [left, right] = if half % 2 == 0 {
        ['▝', '▘']
    } else {
        ['▗', '▖']
    };
    let plain = model.options.color == ColorLevel::Never;
    let mut marks = vec![(-1, 0, left), (1, 0, right), (0, -1, '╻'), (0, 1, '╹')];
    // Where pixels lie one to one there is room for a larger cross.
    if placement.scale == 1.0 {
        marks.extend([(-2, 0, '━'), (2, 0, '━'), (-3, 0, '━'), (3, 0, '━')]);
        marks.extend([(0, -2, '┃'), (0, 2, '┃')]);
    }
    for (dx, dy, mark) in marks {
        let Ok(at) = u16::try_from(x + dx).and_then(|x| Ok((x, u16::try_from(y + dy)?))) else {
            continue;
        };
        if !cells.contains(at.into()) {
            continue;
        }
        let Some(cell) = buffer.cell_mut(at) else {
            continue;
        };
        if plain {
            cell.set_char(mark).set_style(Style::new().bold());
            continue;
        }
        // The mark lies on the mean of the two pixels that it hides, black or white, whichever can be seen.
        let ground = mean(cell.fg, cell.bg);
        let ink = if ground.iter().map(|c| u32::from(*c)).sum::<u32>() > 3 * 120 {
            Color::Rgb(0, 0, 0)
        } else {
            Color::Rgb(255, 255, 255)
        };
        let [r, g, b] = ground;
        cell.set_char(mark).set_fg(ink).set_bg(Color::Rgb(r, g, b));
    }
    if plain
        && let (Ok(x), Ok(y)) = (u16::try_from(x), u16::try_from(y))
        && let Some(cell) = buffer.cell_mut((x, y))
    {
        cell.modifier.insert(Modifier::REVERSED);
    }
}

fn mean(a: Color, b: Color) -> [u8; 3] {
    let channels = |color| match color {
        Color::Rgb(r, g, b) => [r, g, b],
        _ => [0; 3],
    };
    let (a, b) = (channels(a), channels(b));
    std::array::from_fn(|i| u8::midpoint(a[i], b[i]))
}
