//! State of the lesson screen.

use std::sync::Arc;

use ratatui::layout::Rect;

use super::attempt::{Attempt, AttemptPlace};
use super::layout::LessonPanes;
use super::options::LessonOptions;
use super::page_lines::{PageLine, page_lines};
use super::pages::Pages;
use super::picture::LessonPicture;
use crate::lesson::progress::{Done, ProgressFile};
use crate::lesson::{Chapter, Course, Exercise};
use crate::tui::model::ask_lines::ask_rows;
use crate::tui::model::{Request, inside};

/// What lies over the lesson screen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LessonOverlay {
    /// The keys, from this line on.
    Help(u16),
    /// The chapters, with this one chosen.
    Chapters(usize),
    /// A text with its title, from this line on.
    Text(String, String, u16),
}

/// The state.
pub struct LessonModel {
    /// The course.
    pub course: Arc<Course>,
    /// What was done.
    pub progress: ProgressFile,
    /// What the command line chose.
    pub options: LessonOptions,
    /// The screen.
    pub screen: Rect,
    /// The number of the open chapter, from 0.
    pub chapter: usize,
    /// The number of the chosen exercise in it.
    pub chosen: usize,
    /// The pages.
    pub pages: Pages,
    /// The first line of the page that is shown.
    pub scroll: usize,
    /// True if the chosen exercise is to be scrolled into sight as soon as its page is there.
    pub follow: bool,
    /// True if the picture stands alone.
    pub large: bool,
    /// What lies over everything.
    pub overlay: Option<LessonOverlay>,
    /// The exercise that is answered.
    pub attempt: Option<Attempt>,
    /// The picture beside the text.
    pub picture: Option<LessonPicture>,
    /// The exercise whose solution was asked for once.
    pub gives_up: Option<String>,
    /// One sentence for the reader, until the next key.
    pub message: Option<String>,
    /// What the main loop is asked to do next.
    pub request: Request,
}

impl LessonModel {
    /// The course at the next open exercise.
    pub fn new(
        course: Course,
        progress: ProgressFile,
        options: LessonOptions,
        screen: Rect,
    ) -> Self {
        let mut model = Self {
            course: Arc::new(course),
            progress,
            options,
            screen,
            chapter: 0,
            chosen: 0,
            pages: Pages::default(),
            scroll: 0,
            follow: true,
            large: false,
            overlay: None,
            attempt: None,
            picture: None,
            gives_up: None,
            message: None,
            request: Request::Stay,
        };
        let next = model.progress.progress().next(&model.course);
        let next = next.map(|(chapter, exercise)| (chapter.number - 1, exercise.id.clone()));
        if let Some((chapter, id)) = next {
            model.chapter = chapter;
            let place = model.chapter().exercises.iter().position(|e| e.id == id);
            model.chosen = place.unwrap_or(0);
            // A chapter of which nothing is done is read from its start.
            model.follow = model.done_in(chapter).0 > 0;
        }
        model
    }

    /// The open chapter.
    pub fn chapter(&self) -> &Chapter {
        &self.course.chapters[self.chapter.min(self.course.chapters.len() - 1)]
    }

    /// The chosen exercise; none in a chapter without any.
    pub fn exercise(&self) -> Option<&Exercise> {
        self.chapter().exercises.get(self.chosen)
    }

    /// What was done of an exercise.
    pub fn done(&self, id: &str) -> Done {
        self.progress.progress().of(id)
    }

    /// How many exercises of a chapter are done, of how many that count.
    pub fn done_in(&self, chapter: usize) -> (usize, usize) {
        let chapter = self.course.chapters.get(chapter);
        let exercises = chapter.map_or(&[][..], |chapter| &chapter.exercises);
        self.progress.progress().count(exercises)
    }

    /// How many exercises of the course are done, of how many.
    pub fn done_in_all(&self) -> (usize, usize) {
        let all = self.course.exercises().map(|(_, exercise)| exercise);
        self.progress.progress().count(all)
    }

    /// The layout.
    pub fn panes(&self) -> LessonPanes {
        let ask = match self.attempt.as_ref().map(|attempt| &attempt.place) {
            Some(AttemptPlace::Here(ask)) => ask_rows(ask, self.screen),
            _ => 0,
        };
        LessonPanes::new(self.screen, ask, self.large)
    }

    /// The pane of the text, also while the picture stands in its place.
    pub fn text_pane(&self) -> Rect {
        if self.large {
            return LessonPanes::new(self.screen, 0, false).text;
        }
        self.panes().text
    }

    /// The lines of the page in the text pane; what is said while there are none.
    pub fn lines(&self) -> Vec<PageLine> {
        let width = usize::from(inside(self.text_pane()).width.max(10)) - 1;
        let told = |text: &str| {
            let line = PageLine {
                line: text.to_owned().into(),
                ..PageLine::default()
            };
            vec![line]
        };
        match self.pages.get(self.chapter) {
            None => told("the numbers of this chapter are being computed ..."),
            Some(Err(error)) => told(error),
            Some(Ok(parts)) => {
                let done = |id: &str| self.done(id);
                page_lines(parts, self.chapter(), self.chosen, &done, width)
            }
        }
    }
}
