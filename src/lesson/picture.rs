//! Picture of a stage, in the size that fits where it is shown.

use super::chapter::Chapter;
use super::course::Course;
use super::files::CourseError;
use super::page::PagePicture;
use super::stage::Stage;
use crate::lab::raster::raster;
use crate::lab::show::{ShownRange, show};
use crate::math::Rgb;
use crate::tracer::Film;
use crate::tracer::film::draw;

/// The colour of marks.
const MARK: Rgb = Rgb {
    r: 1.0,
    g: 0.1,
    b: 0.1,
};

/// Pixels of a picture's width from which on a mark is a cross and no single pixel.
const CROSS: u32 = 160;

/// The picture of a page, at most so wide and so high, in the shape that its scene has.
pub fn picture(
    course: &Course,
    chapter: &Chapter,
    asked: &PagePicture,
    most: (u32, u32),
) -> Result<Film, CourseError> {
    let stage = asked.stage(course, chapter)?;
    let size = fitting(stage.settings.size(), most);
    Ok(film(&stage, size, &asked.marks))
}

/// The largest size within limits that has the shape of another one.
pub fn fitting((width, height): (u32, u32), (columns, rows): (u32, u32)) -> (u32, u32) {
    let aspect = f64::from(width) / f64::from(height);
    let wide = f64::from(columns).min(f64::from(rows) * aspect).max(1.0);
    let high = (wide / aspect).round().max(1.0);
    (wide as u32, high as u32)
}

/// The picture of a stage in a size, with marks at pixels of its own size.
pub fn film(stage: &Stage, (width, height): (u32, u32), marks: &[(u32, u32)]) -> Film {
    let own = stage.settings.size();
    let settings = stage.settings.with(|s| {
        (s.image.width, s.image.height) = (width, height);
    });
    let mut film = match (stage.filling, stage.show) {
        (Some(filling), _) => raster(&stage.world.scene, &settings, filling, None).film,
        (None, None) => draw(&stage.world, &settings, 0),
        (None, Some(mode)) => {
            let values = show(&stage.world, &settings, mode, 0);
            let range = ShownRange::of(values.iter().copied()).unwrap_or(ShownRange(0.0, 1.0));
            let mut film = Film::black((width, height), &settings);
            for (pixel, value) in film.pixels.iter_mut().zip(values) {
                *pixel = range.color(value);
            }
            film
        }
    };
    for (x, y) in marks {
        let scaled = |at: u32, own: u32, new: u32| {
            ((f64::from(at) + 0.5) * f64::from(new) / f64::from(own)) as u32
        };
        mark(
            &mut film,
            (scaled(*x, own.0, width), scaled(*y, own.1, height)),
        );
    }
    film
}

/// Marks a pixel: a cross around it, so that the pixel itself stays.
fn mark(film: &mut Film, (x, y): (u32, u32)) {
    let (width, height) = (film.width, film.height);
    let mut set = |x: i64, y: i64| {
        let inside = (0..i64::from(width)).contains(&x) && (0..i64::from(height)).contains(&y);
        if inside {
            film.pixels[(y * i64::from(width) + x) as usize] = MARK;
        }
    };
    let (x, y) = (i64::from(x), i64::from(y));
    if width < CROSS {
        set(x, y);
        return;
    }
    for away in 2..=5 {
        for (dx, dy) in [(away, 0), (-away, 0), (0, away), (0, -away)] {
            set(x + dx, y + dy);
        }
    }
}
