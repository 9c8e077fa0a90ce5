//! Picture of a page, rendered in the background at the size of its pane.

use std::path::PathBuf;
use std::sync::Arc;

use ratatui::layout::Rect;

use super::options::LessonOptions;
use crate::lesson::Stage;
use crate::lesson::picture::film;
use crate::scene::Patch;
use crate::trace::Address;
use crate::tui::model::Options;
use crate::tui::model::ask::AskState;
use crate::tui::terminal::program::Program;
use crate::world::World;

/// A picture that is shown.
pub struct LessonPicture {
    /// Which one: the chapter, and the part of its page; none for the chapter's scene.
    pub which: (usize, Option<usize>),
    /// What it is of, in words.
    pub caption: String,
    /// The cells that it was made for.
    pub cells: (u16, u16),
    /// The pixels that are marked, in this picture.
    pub marks: Vec<(u32, u32)>,
    /// Its renderer.
    pub program: Program,
}

impl LessonPicture {
    /// The picture of a stage in a pane of so many cells.
    pub fn new(
        which: (usize, Option<usize>),
        caption: String,
        marks: &[(u32, u32)],
        stage: &Stage,
        cells: (u16, u16),
        options: &LessonOptions,
    ) -> Self {
        let (width, height) = stage.settings.size();
        let size = fitted((width, height), cells);
        let scaled = |(x, y): &(u32, u32)| {
            let to = |at: u32, from: u32, to: u32| (2 * at + 1) * to / (2 * from.max(1));
            (to(*x, width, size.0), to(*y, height, size.1))
        };
        let marks = marks.iter().map(scaled).collect();
        let mut small = stage.clone();
        (small.settings.image.width, small.settings.image.height) = size;
        let screen = Rect::new(0, 0, cells.0, cells.1.saturating_add(8));
        let mut program = program(&small, options, screen, None, None);
        if small.filling.is_some() {
            program.show(&film(&small, size, &[]));
        }
        Self {
            which,
            caption,
            cells,
            marks,
            program,
        }
    }
}

/// The size with the shape of a picture that fits into cells of two pixels each, and is no larger than the picture.
fn fitted((width, height): (u32, u32), (columns, rows): (u16, u16)) -> (u32, u32) {
    let room = (f64::from(columns.max(1)), 2.0 * f64::from(rows.max(1)));
    let (width, height) = (f64::from(width), f64::from(height));
    let scale = (room.0 / width).min(room.1 / height).min(1.0);
    let of = |length: f64| ((length * scale).round() as u32).max(1);
    (of(width), of(height))
}

/// A debugger of a stage.
pub fn program(
    stage: &Stage,
    options: &LessonOptions,
    screen: Rect,
    ask: Option<AskState>,
    at: Option<Address>,
) -> Program {
    let scene = stage.world.scene.clone();
    let world = World::new(scene, stage.settings.accel);
    let options = Options {
        scene: stage.scene.clone(),
        source: Arc::new(stage.source.clone()),
        patch: Patch::default(),
        color: options.color,
        mouse: options.mouse,
        threads: options.threads,
        size: Some(stage.settings.size()),
        at,
        marks: None,
        compare: None,
        show: stage.show,
        ask: ask.map(Box::new),
        folder: PathBuf::new(),
    };
    Program::new(world, stage.settings, options, screen)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::show::ShownValue;
    use crate::lesson::Course;
    use crate::tracer::image::ColorLevel;

    #[test]
    fn a_picture_keeps_its_shape() {
        assert_eq!(fitted((320, 240), (40, 40)), (40, 30));
        assert_eq!(fitted((320, 240), (200, 20)), (53, 40));
        assert_eq!(fitted((320, 240), (400, 400)), (320, 240));
        assert_eq!(fitted((320, 240), (0, 0)), (1, 1));
    }

    #[test]
    fn a_picture_shows_what_its_stage_draws() {
        let course = Course::embedded().expect("the course is whole");
        let chapter = course.chapters.last().expect("chapters");
        let options = LessonOptions {
            color: ColorLevel::True,
            mouse: false,
            threads: 1,
            run: None,
        };
        for filling in [None, Some("flat"), Some("gouraud"), Some("gouraud,affine")] {
            let mut stage = course.stage(chapter, None, &[]).expect("a stage");
            stage.filling = filling.map(|name| name.parse().expect("a filling"));
            let caption = String::new();
            let mut shown = LessonPicture::new((0, None), caption, &[], &stage, (40, 20), &options);
            while shown.program.is_busy() {
                shown.program.receive();
            }
            shown.program.receive();
            let picture = &shown.program.model.picture;
            let drawn = film(&stage, picture.size, &[]);
            for y in 0..drawn.height {
                for x in 0..drawn.width {
                    let expected = ShownValue::Color(drawn.at(x, y));
                    assert_eq!(
                        picture.nearest((x, y)),
                        Some(expected),
                        "{filling:?} {x},{y}"
                    );
                }
            }
        }
    }
}
