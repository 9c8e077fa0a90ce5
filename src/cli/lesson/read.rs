//! `raytree lesson read`: a chapter as text.

use clap::Args;

use super::wrong;
use crate::cli::output::to_stdout;
use crate::cli::{Completion, Failure};
use crate::lesson::Course;
use crate::lesson::page::PagePicture;
use crate::lesson::picture::picture;
use crate::lesson::progress::ProgressFile;
use crate::lesson::reader;
use crate::tracer::image::{ColorLevel, terminal};

/// Columns of the text, and the most that a picture has of columns and pixel rows.
const WIDTH: usize = 80;
const PICTURE: (u32, u32) = (72, 54);

#[derive(Args)]
pub struct Read {
    /// The chapter: its number, or a word of its title
    chapter: String,
    /// Leave the pictures out: their captions tell what they are of
    #[arg(long)]
    no_pictures: bool,
}

impl Read {
    pub fn run(
        &self,
        course: &Course,
        state: &ProgressFile,
        level: ColorLevel,
    ) -> Result<Completion, Failure> {
        let chapter = course.chapter(&self.chapter).map_err(Failure::Usage)?;
        let draw = |asked: &PagePicture| {
            if self.no_pictures {
                return Ok(String::new());
            }
            let film = picture(course, chapter, asked, PICTURE)?;
            let exposure = 1.0;
            Ok(terminal::lines(&film, exposure, level))
        };
        let text = reader::read(course, chapter, state.progress(), WIDTH, &draw);
        to_stdout(text.map_err(|e| wrong(&e))?.as_bytes())
    }
}

/// An exercise as text.
pub fn exercise(course: &Course, state: &ProgressFile, id: &str) -> Result<Completion, Failure> {
    let (chapter, exercise) = super::exercise(course, id)?;
    let tries = state.progress().of(id).asked_before();
    let text = reader::asked(course, chapter, exercise, tries, WIDTH);
    to_stdout(text.as_bytes())
}
