//! Program of the lesson screen without a terminal: the model, the debugger in it, the picture that is rendered.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::answering;
use super::attempt::AttemptPlace;
use super::model::LessonModel;
use super::options::LessonOptions;
use super::panes;
use super::picture::LessonPicture;
use super::update::{settle, update};
use crate::lesson::Course;
use crate::lesson::page::PagePart;
use crate::lesson::progress::ProgressFile;
use crate::tui::model::{Message, Model, Request, inside};
use crate::tui::terminal::main_loop::Interactive;
use crate::tui::terminal::program::Program;

/// The lesson screen.
pub struct LessonProgram {
    /// Its state.
    pub model: LessonModel,
}

impl LessonProgram {
    /// A course on a screen of this size.
    pub fn new(
        course: Course,
        progress: ProgressFile,
        options: LessonOptions,
        screen: Rect,
    ) -> Self {
        let mut program = Self {
            model: LessonModel::new(course, progress, options, screen),
        };
        program.run();
        settle(&mut program.model);
        program.picture();
        program
    }

    /// Begins the exercise that the command line names.
    fn run(&mut self) {
        let model = &mut self.model;
        let Some(id) = model.options.run.take() else {
            return;
        };
        let place = model
            .course
            .chapters
            .iter()
            .enumerate()
            .find_map(|(number, chapter)| {
                let exercise = chapter.exercises.iter().position(|e| e.id == id)?;
                Some((number, exercise))
            });
        if let Some((chapter, exercise)) = place {
            (model.chapter, model.chosen, model.follow) = (chapter, exercise, true);
            answering::begin(model);
        }
    }

    /// The debugger, while an exercise is answered in it.
    fn inner(&mut self) -> Option<&mut Program> {
        match &mut self.model.attempt.as_mut()?.place {
            AttemptPlace::Debugger(program) => Some(program),
            AttemptPlace::Here(_) => None,
        }
    }

    /// Begins to render the picture that belongs to what is read, unless it is there.
    fn picture(&mut self) {
        let model = &mut self.model;
        let cells = panes::picture_cells(&model.panes());
        if cells.0 == 0
            || cells.1 == 0
            || model
                .attempt
                .as_ref()
                .is_some_and(|a| matches!(a.place, AttemptPlace::Debugger(_)))
        {
            return;
        }
        let which = (model.chapter, part_in_sight(model));
        let is_there = |p: &LessonPicture| p.which == which && p.cells == cells;
        if model.picture.as_ref().is_some_and(is_there) {
            return;
        }
        let chapter = model.chapter();
        let part = which
            .1
            .and_then(|n| model.pages.get(which.0)?.as_ref().ok()?.get(n));
        let (stage, caption, marks) = match part {
            Some(PagePart::Picture(picture)) => (
                picture.stage(&model.course, chapter),
                picture.caption(),
                picture.marks.clone(),
            ),
            _ => (
                model.course.stage(chapter, None, &[]),
                "the scene".to_owned(),
                Vec::new(),
            ),
        };
        match stage {
            Ok(stage) => {
                let picture =
                    LessonPicture::new(which, caption, &marks, &stage, cells, &model.options);
                model.picture = Some(picture);
            }
            Err(error) => model.message = Some(error.to_string()),
        }
    }
}

impl Interactive for LessonProgram {
    fn send(&mut self, message: Message) -> bool {
        if let Message::Resize(screen) = message {
            if let Some(debugger) = self.inner() {
                debugger.send(Message::Resize(screen));
            }
            update(&mut self.model, &Message::Resize(screen));
            self.picture();
            return true;
        }
        let known = if let Some(debugger) = self.inner() {
            let known = debugger.send(message);
            let request = std::mem::take(&mut debugger.model.request);
            if request != Request::Stay {
                self.model.request = request;
            }
            known
        } else {
            update(&mut self.model, &message)
        };
        answering::serve(&mut self.model);
        settle(&mut self.model);
        self.picture();
        known
    }

    fn receive(&mut self) -> bool {
        let mut any = self.model.pages.receive();
        if let Some(notice) = self.model.progress.take_notices().pop() {
            self.model.message = Some(notice);
            any = true;
        }
        if any {
            settle(&mut self.model);
            self.picture();
        }
        if let Some(picture) = &mut self.model.picture {
            any |= picture.program.receive();
        }
        if let Some(debugger) = self.inner() {
            any |= debugger.receive();
        }
        any
    }

    fn is_busy(&self) -> bool {
        let model = &self.model;
        let is_rendering = model.picture.as_ref().is_some_and(|p| p.program.is_busy());
        let debugger = model.attempt.as_ref().map(|attempt| &attempt.place);
        let debugs = matches!(debugger, Some(AttemptPlace::Debugger(p)) if p.is_busy());
        model.pages.is_coming() || is_rendering || debugs
    }

    fn draw(&self, area: Rect, buffer: &mut Buffer) {
        panes::draw(&self.model, area, buffer);
    }

    fn request(&mut self) -> &mut Request {
        &mut self.model.request
    }

    fn mouse(&self) -> bool {
        self.debugger()
            .map_or(self.model.options.mouse, |model| model.mouse)
    }

    fn debugger(&self) -> Option<&Model> {
        match &self.model.attempt.as_ref()?.place {
            AttemptPlace::Debugger(program) => Some(&program.model),
            AttemptPlace::Here(_) => None,
        }
    }

    fn debugger_mut(&mut self) -> Option<&mut Model> {
        self.inner().map(|program| &mut program.model)
    }
}

/// The part of the page whose picture is the last at or above the line that is read, or else the first of the page.
fn part_in_sight(model: &LessonModel) -> Option<usize> {
    let lines = model.lines();
    let height = usize::from(inside(model.text_pane()).height);
    let seen = read_to(lines.len(), height, model.scroll);
    let before = lines[..seen].iter().rev().find_map(|line| line.picture);
    before.or_else(|| lines.iter().find_map(|line| line.picture))
}

/// How many of the lines are read, of `height` that are in sight below `scroll` others. From the first line in sight at the beginning
/// of a page to the last one at its end, so that each line has its turn.
fn read_to(lines: usize, height: usize, scroll: usize) -> usize {
    let last = lines.saturating_sub(height);
    if last == 0 {
        return lines.min(1);
    }
    1 + scroll.min(last) * (lines - 1) / last
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_has_its_turn() {
        for (lines, height) in [(100_usize, 20), (100, 21), (61, 20), (30, 20), (5, 1)] {
            let last = lines - height;
            let mut before = 0;
            for scroll in 0..=last {
                let read = read_to(lines, height, scroll);
                assert!(
                    read > before && scroll < read && read <= scroll + height,
                    "{read}"
                );
                assert!(last < height || read <= before + 2, "{read}");
                before = read;
            }
            assert_eq!((read_to(lines, height, 0), before), (1, lines));
        }
        assert_eq!([read_to(7, 20, 0), read_to(0, 20, 0)], [1, 0]);
    }
}
