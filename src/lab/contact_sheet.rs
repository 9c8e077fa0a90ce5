//! Small pictures on one sheet, side by side and below each other, each pixel as a square.

use crate::math::Rgb;
use crate::tracer::Film;

/// Rows and columns between pictures.
const GAP: u32 = 4;

/// Rows of pictures on grey, each pixel `zoom` times as large. All have the room of the largest.
pub fn contact_sheet(rows: &[Vec<Film>], zoom: u32) -> Film {
    let all = || rows.iter().flatten();
    let size = |n: u32, edge: u32| n * (edge * zoom + GAP) + GAP;
    let wide = all().map(|film| film.width).max().unwrap_or(0);
    let high = all().map(|film| film.height).max().unwrap_or(0);
    let most = rows.iter().map(Vec::len).max().unwrap_or(0);
    let (width, height) = (size(most as u32, wide), size(rows.len() as u32, high));
    let mut contact_sheet = Film {
        width,
        height,
        pixels: vec![Rgb::grey(0.5); width as usize * height as usize],
        ..Film::default()
    };
    for (row, films) in (0..).zip(rows) {
        for (column, film) in (0..).zip(films) {
            let (left, top) = (size(column, wide), size(row, high));
            for y in 0..film.height * zoom {
                for x in 0..film.width * zoom {
                    let to = (top + y) as usize * width as usize + (left + x) as usize;
                    contact_sheet.pixels[to] = film.at(x / zoom, y / zoom);
                }
            }
        }
    }
    contact_sheet
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_stand_side_by_side_and_enlarged() {
        let film = |width, color| Film {
            width,
            height: 1,
            pixels: vec![color; width as usize],
            ..Film::default()
        };
        let rows = [vec![film(2, Rgb::WHITE), film(1, Rgb::BLACK)]];
        let contact_sheet = contact_sheet(&rows, 3);
        assert_eq!(
            (contact_sheet.width, contact_sheet.height),
            (2 * (2 * 3 + 4) + 4, 3 + 2 * 4)
        );
        assert_eq!(contact_sheet.at(4, 4), Rgb::WHITE);
        assert_eq!(contact_sheet.at(9, 6), Rgb::WHITE);
        assert_eq!(contact_sheet.at(10, 6), Rgb::grey(0.5));
        assert_eq!(contact_sheet.at(14, 4), Rgb::BLACK);
        // The second is smaller: grey fills its room.
        assert_eq!(contact_sheet.at(17, 4), Rgb::grey(0.5));
    }
}
