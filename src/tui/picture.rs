//! The picture as far as it is known: a window onto the image, and the pixel under the cursor.

use super::renderer::BLOCKS;
use crate::math::Rgb;

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

    /// The number of a pixel in the window, row after row.
    pub fn index(self, (x, y): (u32, u32)) -> usize {
        (y - self.y) as usize * self.width as usize + (x - self.x) as usize
    }

    /// How many pixels it has.
    pub fn area(self) -> usize {
        self.width as usize * self.height as usize
    }
}

/// What is known of the image.
#[derive(Clone, Debug, Default)]
pub struct Picture {
    /// Width and height of the whole image.
    pub size: (u32, u32),
    /// The part that is kept.
    pub window: Window,
    /// The pixel under the cursor.
    pub cursor: (u32, u32),
    pixels: Vec<Option<Rgb>>,
    done: usize,
}

impl Picture {
    /// An image of which nothing is known, seen through a window of at most `visible` pixels around the cursor.
    pub fn new(size: (u32, u32), visible: (u32, u32), cursor: (u32, u32)) -> Self {
        let size = (size.0.max(1), size.1.max(1));
        let mut picture = Self {
            size,
            window: Window {
                x: 0,
                y: 0,
                width: visible.0.clamp(1, size.0),
                height: visible.1.clamp(1, size.1),
            },
            cursor: (cursor.0.min(size.0 - 1), cursor.1.min(size.1 - 1)),
            pixels: Vec::new(),
            done: 0,
        };
        picture.pixels = vec![None; picture.window.area()];
        picture.follow();
        picture
    }

    /// Moves the window so that the cursor is inside, and in its middle if it was outside. True if it moved: then
    /// pixels are missing.
    pub fn follow(&mut self) -> bool {
        let old = self.window;
        if old.contains(self.cursor) {
            return false;
        }
        let place = |cursor: u32, length: u32, end: u32| {
            cursor
                .saturating_sub(length / 2)
                .min(end.saturating_sub(length))
        };
        self.window.x = place(self.cursor.0, old.width, self.size.0);
        self.window.y = place(self.cursor.1, old.height, self.size.1);
        // What was known stays known.
        let before = std::mem::take(&mut self.pixels);
        let new = self.window;
        self.pixels = (0..new.height)
            .flat_map(|y| (0..new.width).map(move |x| (new.x + x, new.y + y)))
            .map(|at| {
                before
                    .get(old.contains(at).then(|| old.index(at))?)
                    .copied()?
            })
            .collect();
        self.done = self.pixels.iter().flatten().count();
        true
    }

    /// Moves the cursor, as far as the image goes.
    pub fn move_by(&mut self, dx: i32, dy: i32) {
        let go =
            |at: u32, by: i32, end: u32| at.saturating_add_signed(by).min(end.saturating_sub(1));
        self.cursor.0 = go(self.cursor.0, dx, self.size.0);
        self.cursor.1 = go(self.cursor.1, dy, self.size.1);
    }

    /// A pixel was rendered.
    pub fn set(&mut self, at: (u32, u32), color: Rgb) {
        if self.window.contains(at)
            && let Some(pixel) = self.pixels.get_mut(self.window.index(at))
            && pixel.replace(color).is_none()
        {
            self.done += 1;
        }
    }

    /// Nothing is known any more.
    pub fn forget(&mut self) {
        self.pixels.fill(None);
        self.done = 0;
    }

    /// The colour of a pixel, if it was rendered and is in the window.
    pub fn exact(&self, at: (u32, u32)) -> Option<Rgb> {
        self.window
            .contains(at)
            .then(|| self.pixels.get(self.window.index(at)).copied())??
    }

    /// The colour of a pixel, or of the smallest block around it that is known.
    pub fn nearest(&self, (x, y): (u32, u32)) -> Option<Rgb> {
        let Window { x: x0, y: y0, .. } = self.window;
        if !self.window.contains((x, y)) {
            return None;
        }
        let corner = |block: u32| (x - (x - x0) % block, y - (y - y0) % block);
        BLOCKS
            .into_iter()
            .rev()
            .find_map(|block| self.exact(corner(block)))
    }

    /// Which pixels of the window are known, row after row.
    pub fn known(&self) -> Vec<bool> {
        self.pixels.iter().map(Option::is_some).collect()
    }

    /// The share of the window that is known, 0 to 1.
    pub fn progress(&self) -> f64 {
        self.done as f64 / self.window.area().max(1) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_stand_for_pixels_that_are_not_known() {
        let mut picture = Picture::new((40, 40), (40, 40), (0, 0));
        assert_eq!(picture.nearest((17, 17)), None);
        picture.set((16, 16), Rgb::WHITE);
        assert_eq!(picture.nearest((17, 17)), Some(Rgb::WHITE));
        assert_eq!(picture.exact((17, 17)), None);
        picture.set((17, 17), Rgb::BLACK);
        assert_eq!(picture.nearest((17, 17)), Some(Rgb::BLACK));
        assert_eq!(picture.nearest((18, 17)), Some(Rgb::WHITE));
    }

    #[test]
    fn the_window_follows_the_cursor_and_keeps_what_it_knows() {
        let mut picture = Picture::new((100, 80), (20, 10), (5, 5));
        picture.set((19, 5), Rgb::WHITE);
        picture.move_by(15, 0);
        assert!(picture.follow());
        assert_eq!(picture.window.x, 10);
        assert_eq!(picture.exact((19, 5)), Some(Rgb::WHITE));
        assert_eq!(picture.known().iter().filter(|k| **k).count(), 1);
        picture.move_by(1000, 1000);
        assert!(picture.follow());
        assert_eq!(picture.cursor, (99, 79));
        assert_eq!((picture.window.x, picture.window.y), (80, 70));
        assert_eq!(picture.progress(), 0.0);
    }
}
