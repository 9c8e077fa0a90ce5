//! Picture under construction: the rendered pixels of a window onto the image, and the pixel under the cursor.

use super::progressive::{BLOCKS, Missing};
use super::window::Window;
use crate::lab::show::{ShownRange, ShownValue, tenths};
use crate::math::Rgb;
use crate::tracer::CutShare;

/// The rendered part of an image. The cursor is always inside of the window.
#[derive(Clone, Debug, Default)]
pub struct PartialPicture {
    /// Width and height of the whole image.
    pub size: (u32, u32),
    /// The part that is kept.
    pub window: Window,
    /// The pixel under the cursor.
    pub cursor: (u32, u32),
    /// What the limits of recursion left out of what was rendered.
    pub cuts: CutShare,
    /// A pixel that is asked for: nothing of it is known until that is answered.
    pub hidden: Option<(u32, u32)>,
    pixels: Vec<Option<ShownValue>>,
    done: usize,
}

impl PartialPicture {
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
            cuts: CutShare::default(),
            hidden: None,
            pixels: Vec::new(),
            done: 0,
        };
        picture.pixels = vec![None; picture.window.area()];
        picture.follow();
        picture
    }

    /// A new picture of another size or window, with the cursor at the corresponding pixel; `None` if neither differs.
    pub fn resized(&self, size: (u32, u32), visible: (u32, u32)) -> Option<Self> {
        let fitted = Self::new(size, visible, (0, 0));
        let extent = |p: &Self| (p.size, p.window.width, p.window.height);
        if extent(&fitted) == extent(self) {
            return None;
        }
        let scaled = |at: u32, old: u32, new: u32| {
            let middle = (2 * u64::from(at) + 1) * u64::from(new) / (2 * u64::from(old.max(1)));
            middle as u32
        };
        let cursor = (
            scaled(self.cursor.0, self.size.0, fitted.size.0),
            scaled(self.cursor.1, self.size.1, fitted.size.1),
        );
        let mut resized = Self::new(size, visible, cursor);
        resized.hidden = self.hidden.filter(|_| resized.size == self.size);
        Some(resized)
    }

    /// Moves the window so that the cursor is inside, and in its middle if it was outside. True if it moved: then
    /// pixels are missing.
    pub fn follow(&mut self) -> bool {
        let old = self.window;
        if old.contains(self.cursor) {
            return false;
        }
        let start = |cursor: u32, length: u32, end: u32| {
            cursor
                .saturating_sub(length / 2)
                .min(end.saturating_sub(length))
        };
        self.window.x = start(self.cursor.0, old.width, self.size.0);
        self.window.y = start(self.cursor.1, old.height, self.size.1);
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
    pub fn set(&mut self, at: (u32, u32), value: ShownValue) {
        if self.window.contains(at)
            && let Some(pixel) = self.pixels.get_mut(self.window.index(at))
            && pixel.replace(value).is_none()
        {
            self.done += 1;
        }
    }

    /// Nothing is known any more.
    pub fn forget(&mut self) {
        self.pixels.fill(None);
        self.cuts = CutShare::default();
        self.done = 0;
    }

    /// The colour of a pixel or what is shown in its place, if it was rendered and is in the window.
    pub fn exact(&self, at: (u32, u32)) -> Option<ShownValue> {
        (self.window.contains(at) && self.hidden != Some(at))
            .then(|| self.pixels.get(self.window.index(at)).copied())??
    }

    /// The colour of a pixel, if that was rendered and is in the window.
    pub fn color(&self, at: (u32, u32)) -> Option<Rgb> {
        match self.exact(at)? {
            ShownValue::Color(color) => Some(color),
            _ => None,
        }
    }

    /// The range of the numbers that are known.
    pub fn range(&self) -> Option<ShownRange> {
        ShownRange::of(self.shown())
    }

    /// What the known pixels show.
    fn shown(&self) -> impl Iterator<Item = ShownValue> {
        let hidden = self.hidden.filter(|at| self.window.contains(*at));
        let hidden = hidden.map(|at| self.window.index(at));
        let pixels = self.pixels.iter().enumerate();
        let shown = pixels.filter(move |(at, _)| Some(*at) != hidden);
        shown.filter_map(|(_, value)| *value)
    }

    /// How far two pictures are apart at each pixel: in their numbers, or in the luminance of their colours.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        let number = |value| match value {
            ShownValue::Number(x) => Some(x),
            ShownValue::Color(color) => Some(color.luminance()),
            ShownValue::Nothing => None,
        };
        let mut apart = self.clone();
        for row in 0..self.window.height {
            for column in 0..self.window.width {
                let at = (self.window.x + column, self.window.y + row);
                let pair = self.exact(at).zip(other.exact(at));
                let pair = pair.map(|(a, b)| number(a).zip(number(b)));
                apart.pixels[self.window.index(at)] = pair.map(|pair| match pair {
                    Some((a, b)) => ShownValue::Number((a - b).abs()),
                    None => ShownValue::Nothing,
                });
            }
        }
        apart
    }

    /// Takes over what another picture knows of the pixels of this one.
    pub fn adopt(&mut self, other: &Self) {
        if self.size != other.size {
            return;
        }
        for row in 0..self.window.height {
            for column in 0..self.window.width {
                let at = (self.window.x + column, self.window.y + row);
                if let Some(value) = other.exact(at) {
                    self.set(at, value);
                }
            }
        }
        self.cuts = other.cuts;
    }

    /// How many of the numbers that are known fall into each tenth of their range.
    pub fn tenths(&self) -> Option<(ShownRange, [usize; 10])> {
        let range = self.range()?;
        let numbers = self.shown().filter_map(|value| match value {
            ShownValue::Number(x) => Some(x),
            _ => None,
        });
        Some((range, tenths(numbers, range)))
    }

    /// What a pixel shows, or the smallest block around it that is known.
    pub fn nearest(&self, (x, y): (u32, u32)) -> Option<ShownValue> {
        let Window { x: x0, y: y0, .. } = self.window;
        if !self.window.contains((x, y)) || self.hidden == Some((x, y)) {
            return None;
        }
        let corner = |block: u32| (x - (x - x0) % block, y - (y - y0) % block);
        BLOCKS
            .into_iter()
            .rev()
            .find_map(|block| self.exact(corner(block)))
    }

    /// What is still to be rendered.
    pub fn missing(&self) -> Missing {
        Missing {
            window: self.window,
            known: self.pixels.iter().map(Option::is_some).collect(),
        }
    }

    /// The fraction of the window that is known, 0 to 1.
    pub fn progress(&self) -> f64 {
        self.done as f64 / self.window.area().max(1) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WHITE: ShownValue = ShownValue::Color(Rgb::WHITE);
    const BLACK: ShownValue = ShownValue::Color(Rgb::BLACK);

    #[test]
    fn blocks_stand_for_pixels_that_are_not_known() {
        let mut picture = PartialPicture::new((40, 40), (40, 40), (0, 0));
        assert_eq!(picture.nearest((17, 17)), None);
        picture.set((16, 16), WHITE);
        assert_eq!(picture.nearest((17, 17)), Some(WHITE));
        assert_eq!(picture.exact((17, 17)), None);
        picture.set((17, 17), BLACK);
        assert_eq!(picture.nearest((17, 17)), Some(BLACK));
        assert_eq!(picture.nearest((18, 17)), Some(WHITE));
    }

    #[test]
    fn the_window_follows_the_cursor_and_keeps_what_it_knows() {
        let mut picture = PartialPicture::new((100, 80), (20, 10), (5, 5));
        picture.set((19, 5), WHITE);
        picture.move_by(15, 0);
        assert!(picture.follow());
        assert_eq!(picture.window.x, 10);
        assert_eq!(picture.exact((19, 5)), Some(WHITE));
        assert_eq!(picture.missing().known.iter().filter(|k| **k).count(), 1);
        picture.move_by(1000, 1000);
        assert!(picture.follow());
        assert_eq!(picture.cursor, (99, 79));
        assert_eq!((picture.window.x, picture.window.y), (80, 70));
        assert_eq!(picture.progress(), 0.0);
    }
}
