//! The picture: half a cell is exactly one traced pixel, with its own colour.
//!
//! While a pixel is chosen, pixels lie one to one. The small picture beside an open tree shows every n-th one.

use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::{Color, Modifier, Style};

use super::app::App;
use super::layout::{Panes, inside};
use super::picture::Window;
use super::theme;
use crate::math::Rgb;
use crate::tracer::picture::ColorLevel;
use crate::tracer::picture::text::ramp;

/// Which pixel lies where.
#[derive(Clone, Copy, Debug)]
pub struct Placement {
    /// The cells of the picture.
    cells: Rect,
    window: Window,
    /// Pixels of the image a half cell.
    scale: f64,
}

/// Where the picture lies at present.
pub fn placement(app: &App, panes: &Panes) -> Placement {
    let place = if app.session.is_some() {
        inside(panes.picture)
    } else {
        panes.picture
    };
    Placement::new(app.picture.window, place)
}

impl Placement {
    /// The window in the middle of `place`, made smaller until it fits.
    pub fn new(window: Window, place: Rect) -> Self {
        if place.is_empty() || window.area() == 0 {
            return Self {
                cells: Rect::default(),
                window,
                scale: 1.0,
            };
        }
        let (columns, rows) = (f64::from(place.width), 2.0 * f64::from(place.height));
        let scale = (f64::from(window.width) / columns)
            .max(f64::from(window.height) / rows)
            .max(1.0);
        let width = ((f64::from(window.width) / scale).round() as u16).clamp(1, place.width);
        let height =
            ((f64::from(window.height) / scale / 2.0).ceil() as u16).clamp(1, place.height);
        Self {
            cells: Rect {
                x: place.x + (place.width - width) / 2,
                y: place.y + (place.height - height) / 2,
                width,
                height,
            },
            window,
            scale,
        }
    }

    /// The pixel of a half cell, counted from the picture's corner; `None` outside the window.
    fn half(self, column: u16, half: u16) -> Option<(u32, u32)> {
        let of = |n: u16| (f64::from(n) * self.scale + 0.5 * (self.scale - 1.0)).round() as u32;
        let (x, y) = (of(column), of(half));
        let inside = x < self.window.width && y < self.window.height;
        inside.then_some((self.window.x + x, self.window.y + y))
    }

    /// The pixel at a place of the screen: the upper one of its cell.
    pub fn pixel(self, at: Position) -> Option<(u32, u32)> {
        if !self.cells.contains(at) {
            return None;
        }
        self.half(at.x - self.cells.x, 2 * (at.y - self.cells.y))
    }

    /// The column and half row, counted from the picture's corner, where a pixel lies or would lie.
    fn place(self, (x, y): (u32, u32)) -> (u16, u16) {
        let to = |n: u32, end: u16| {
            let at = (f64::from(n) + 0.5) / self.scale;
            (at as u16).min(end.saturating_sub(1))
        };
        (
            to(x.saturating_sub(self.window.x), self.cells.width),
            to(y.saturating_sub(self.window.y), 2 * self.cells.height),
        )
    }
}

impl Placement {
    /// The cell of the screen in which a pixel lies or would lie.
    pub fn cell(self, pixel: (u32, u32)) -> (u16, u16) {
        let (column, half) = self.place(pixel);
        (self.cells.x + column, self.cells.y + half / 2)
    }
}

/// Draws the picture and the marks around the pixel under the cursor.
pub fn draw(app: &App, placement: &Placement, buffer: &mut Buffer) {
    let cells = placement.cells;
    let color = |column, half| {
        let at = placement.half(column, half)?;
        Some(app.picture.nearest(at)? * app.settings.image.exposure)
    };
    for row in 0..cells.height {
        for column in 0..cells.width {
            let (upper, lower) = (color(column, 2 * row), color(column, 2 * row + 1));
            if let Some(cell) = buffer.cell_mut((cells.x + column, cells.y + row)) {
                if app.options.color == ColorLevel::Never {
                    cell.set_char(letter(upper, lower));
                } else {
                    paint(cell, upper, lower);
                }
            }
        }
    }
    if !cells.is_empty() {
        mark(app, placement, buffer);
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

/// Points at the pixel under the cursor from its four sides. The pixel itself stays as it is; left and right, the
/// mark stands at exactly its half of the cell.
fn mark(app: &App, placement: &Placement, buffer: &mut Buffer) {
    let cells = placement.cells;
    let (column, half) = placement.place(app.picture.cursor);
    let (x, y) = (i32::from(cells.x + column), i32::from(cells.y + half / 2));
    let [left, right] = if half % 2 == 0 {
        ['▝', '▘']
    } else {
        ['▗', '▖']
    };
    let plain = app.options.color == ColorLevel::Never;
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
