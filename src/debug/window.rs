//! Rectangle of pixels of the image.

/// A part of the image, in pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Window {
    /// Its first column.
    pub x: u32,
    /// Its first row.
    pub y: u32,
    /// Its columns.
    pub width: u32,
    /// Its rows.
    pub height: u32,
}

impl Window {
    /// True if the pixel is inside.
    pub fn contains(self, (x, y): (u32, u32)) -> bool {
        (self.x..self.x + self.width).contains(&x) && (self.y..self.y + self.height).contains(&y)
    }

    /// The index of a pixel in the window, row after row.
    pub fn index(self, (x, y): (u32, u32)) -> usize {
        (y - self.y) as usize * self.width as usize + (x - self.x) as usize
    }

    /// How many pixels it has.
    pub fn area(self) -> usize {
        self.width as usize * self.height as usize
    }
}
