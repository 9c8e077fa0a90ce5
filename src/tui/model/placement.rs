//! Placement of the picture on the screen: half a cell is exactly one traced pixel.
//!
//! While a pixel is chosen, pixels lie one to one. The small picture beside an open tree shows every n-th one.

use ratatui::layout::{Position, Rect};

use crate::debug::Window;

/// Mapping between the pixels of a window and half cells of the screen.
#[derive(Clone, Copy, Debug)]
pub struct Placement {
    /// The cells of the picture.
    pub cells: Rect,
    window: Window,
    /// Pixels of the image a half cell.
    pub scale: f64,
}

impl Placement {
    /// The window in the middle of `area`, made smaller until it fits.
    pub fn new(window: Window, area: Rect) -> Self {
        if area.is_empty() || window.area() == 0 {
            return Self {
                cells: Rect::default(),
                window,
                scale: 1.0,
            };
        }
        let (columns, rows) = (f64::from(area.width), 2.0 * f64::from(area.height));
        let scale = (f64::from(window.width) / columns)
            .max(f64::from(window.height) / rows)
            .max(1.0);
        let width = ((f64::from(window.width) / scale).round() as u16).clamp(1, area.width);
        let height = ((f64::from(window.height) / scale / 2.0).ceil() as u16).clamp(1, area.height);
        Self {
            cells: Rect {
                x: area.x + (area.width - width) / 2,
                y: area.y + (area.height - height) / 2,
                width,
                height,
            },
            window,
            scale,
        }
    }

    /// The pixel of a half cell, counted from the picture's corner; `None` outside the window.
    pub fn half(self, column: u16, half: u16) -> Option<(u32, u32)> {
        let of = |n: u16| (f64::from(n) * self.scale + 0.5 * (self.scale - 1.0)).round() as u32;
        let (x, y) = (of(column), of(half));
        let inside = x < self.window.width && y < self.window.height;
        inside.then_some((self.window.x + x, self.window.y + y))
    }

    /// The pixel at a cell of the screen: the upper one of its cell.
    pub fn pixel(self, at: Position) -> Option<(u32, u32)> {
        if !self.cells.contains(at) {
            return None;
        }
        self.half(at.x - self.cells.x, 2 * (at.y - self.cells.y))
    }

    /// The column and half row, counted from the picture's corner, where a pixel lies or would lie.
    pub fn half_of(self, (x, y): (u32, u32)) -> (u16, u16) {
        let to = |n: u32, end: u16| {
            let at = (f64::from(n) + 0.5) / self.scale;
            (at as u16).min(end.saturating_sub(1))
        };
        (
            to(x.saturating_sub(self.window.x), self.cells.width),
            to(y.saturating_sub(self.window.y), 2 * self.cells.height),
        )
    }

    /// The cell of the screen in which a pixel lies or would lie.
    pub fn cell(self, pixel: (u32, u32)) -> (u16, u16) {
        let (column, half) = self.half_of(pixel);
        (self.cells.x + column, self.cells.y + half / 2)
    }
}
