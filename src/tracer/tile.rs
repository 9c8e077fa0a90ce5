//! Tiles: the picture cut into squares of pixels.

use crate::scene::Settings;

/// The edge of a tile in pixels: rays that are neighbours in the picture are neighbours in the scene.
pub const TILE: u32 = 16;

/// The edge of a block of pixels in a tile: the rays of a block make one packet.
const BLOCK: u32 = 4;

/// A tile of the picture: pixels x0..x1, y0..y1.
#[derive(Clone, Copy, Debug)]
pub struct Tile {
    /// First column, and the one behind the last.
    pub x: [u32; 2],
    /// First row, and the one behind the last.
    pub y: [u32; 2],
}

/// All tiles of the picture, row after row.
pub fn tiles(settings: &Settings) -> Vec<Tile> {
    let starts = |end: u32| (0..end).step_by(TILE as usize);
    starts(settings.image.height)
        .flat_map(|y| starts(settings.image.width).map(move |x| Tile::containing(settings, (x, y))))
        .collect()
}

impl Tile {
    /// The tile that a pixel is in.
    pub fn containing(settings: &Settings, (x, y): (u32, u32)) -> Self {
        let range = |pixel: u32, end: u32| {
            let start = pixel - pixel % TILE;
            [start, (start + TILE).min(end)]
        };
        Self {
            x: range(x, settings.image.width),
            y: range(y, settings.image.height),
        }
    }

    /// The number of its columns and rows.
    pub fn size(self) -> (u32, u32) {
        (self.x[1] - self.x[0], self.y[1] - self.y[0])
    }

    /// The index of a pixel among the tile's, row after row.
    pub fn index(self, (x, y): (u32, u32)) -> usize {
        ((y - self.y[0]) * self.size().0 + (x - self.x[0])) as usize
    }

    /// Its pixels, row after row.
    pub fn pixels(self) -> impl Iterator<Item = (u32, u32)> {
        let [first, end] = self.x;
        (self.y[0]..self.y[1]).flat_map(move |y| (first..end).map(move |x| (x, y)))
    }

    /// Its pixels, block after block.
    pub fn pixels_in_blocks(self) -> Vec<(u32, u32)> {
        let ([left, right], [top, bottom]) = (self.x, self.y);
        let mut pixels = Vec::with_capacity(((right - left) * (bottom - top)) as usize);
        for y0 in (top..bottom).step_by(BLOCK as usize) {
            for x0 in (left..right).step_by(BLOCK as usize) {
                for y in y0..(y0 + BLOCK).min(bottom) {
                    pixels.extend((x0..(x0 + BLOCK).min(right)).map(|x| (x, y)));
                }
            }
        }
        pixels
    }
}
