//! Attempt at an exercise: in the debugger, or in a question on the lesson screen.

use ratatui::layout::Rect;

use super::options::LessonOptions;
use super::picture::program;
use crate::lesson::answer::{StudentAnswer, letter};
use crate::lesson::exercise::{Choices, ExerciseKind};
use crate::lesson::markdown::{plain, words};
use crate::lesson::off::off;
use crate::lesson::question::{AnswerForm, Question};
use crate::lesson::value::{AskedValue, LessonValue};
use crate::lesson::{Chapter, Course, Exercise, Stage};
use crate::scene::Bend;
use crate::scene::printable::printable;
use crate::trace::Address;
use crate::trace::address::path_of;
use crate::trace::facts::TreePath;
use crate::tui::model::ask::{AskKind, AskReply, AskState};
use crate::tui::terminal::program::Program;

/// An exercise that is being answered.
pub struct Attempt {
    /// Its number in the chapter.
    pub exercise: usize,
    /// Answers before this one.
    pub tries: u32,
    /// Of a slide, the pixel where it fails.
    pub slide: Option<(u32, u32)>,
    /// Where it is answered.
    pub place: AttemptPlace,
}

/// Where an exercise is answered.
pub enum AttemptPlace {
    /// In the debugger.
    Debugger(Box<Program>),
    /// On the lesson screen.
    Here(Box<AskState>),
}

/// Where exercises are asked.
pub struct AttemptMaker<'a> {
    /// The course.
    pub course: &'a Course,
    /// The chapter.
    pub chapter: &'a Chapter,
    /// The number of the exercise in it.
    pub exercise: usize,
    /// Answers before this one.
    pub tries: u32,
    /// Hints that were read.
    pub hints: u32,
    /// The screen.
    pub screen: Rect,
    /// What the command line chose.
    pub options: &'a LessonOptions,
}

impl AttemptMaker<'_> {
    /// The attempt; none for exercises that are done outside of this program.
    pub fn make(&self) -> Result<Option<Attempt>, String> {
        let exercise = self.exercise();
        let place = match &exercise.kind {
            ExerciseKind::Predict { asked, .. } => self.predict(asked)?,
            ExerciseKind::Find(wanted) if exercise.text.is_empty() => {
                self.pixel(&format!("Find a pixel: {}", wanted.text))?
            }
            ExerciseKind::Find(_) => self.pixel(&text(&exercise.text))?,
            ExerciseKind::Bug {
                bend, among, at, ..
            } => self.bug(*bend, among, *at)?,
            ExerciseKind::Choose {
                says,
                bend: Some(_),
                ..
            } => {
                let asked = match text(&exercise.text) {
                    asked if asked.is_empty() => "Find a pixel where that is wrong.".to_owned(),
                    asked => asked,
                };
                self.pixel(&format!("A slide says: {}\n{asked}", text(says)))?
            }
            ExerciseKind::Choose { options, .. } => {
                let asked = match text(&exercise.text) {
                    asked if asked.is_empty() => "What is right?".to_owned(),
                    asked => asked,
                };
                self.choice(&asked, options)
            }
            ExerciseKind::Change(_) | ExerciseKind::Write { .. } => return Ok(None),
        };
        Ok(Some(Attempt {
            exercise: self.exercise,
            tries: self.tries,
            slide: None,
            place,
        }))
    }

    fn exercise(&self) -> &Exercise {
        &self.chapter.exercises[self.exercise]
    }

    fn stage(&self) -> Result<Stage, String> {
        let stage = self.course.stage_of(self.chapter, self.exercise());
        stage.map_err(|error| error.to_string())
    }

    /// A question with all that is told of every exercise.
    fn ask(&self, told: &str, kind: AskKind, stage: Option<&Stage>) -> AskState {
        let (chapter, exercise) = (self.chapter, self.exercise());
        let title = format!(
            "{} {}: {}, {}",
            chapter.number,
            chapter.title,
            exercise.id,
            exercise.kind.name()
        );
        let mut ask = AskState::new(title, told, kind);
        ask.hints = exercise.hints.len();
        let shown = exercise.hints.iter().take(self.hints as usize);
        ask.shown = shown.map(|hint| text(hint)).collect();
        if let Some(stage) = stage {
            ask.remark = self.remark(stage);
        }
        ask
    }

    /// What is off, and until when.
    fn remark(&self, stage: &Stage) -> String {
        let off = off(self.course, self.chapter, &stage.world.scene);
        let told = off.iter().map(|off| match off.until {
            Some(until) => format!("{} (until chapter {until})", off.feature.name()),
            None => off.feature.name().to_owned(),
        });
        let told: Vec<String> = told.collect();
        if told.is_empty() {
            return String::new();
        }
        format!("off: {}", told.join(", "))
    }

    fn in_debugger(&self, stage: &Stage, ask: AskState, at: Option<Address>) -> AttemptPlace {
        let program = program(stage, self.options, self.screen, Some(ask), at);
        AttemptPlace::Debugger(Box::new(program))
    }

    /// A value: asked in the debugger if it is one of a ray.
    fn predict(&self, asked: &LessonValue) -> Result<AttemptPlace, String> {
        let stage = self.stage()?;
        let question = Question::new(&stage, asked, self.tries)?;
        let told = text(&self.exercise().text);
        let kind = match &question.form {
            AnswerForm::Word(words) => AskKind::Word(words.clone()),
            form => AskKind::Value(form.asks()),
        };
        let Some(ray) = question.ray else {
            return Ok(AttemptPlace::Here(Box::new(self.ask(&told, kind, None))));
        };
        let stage = stage.with(&asked.settings)?;
        let told = again(asked, ray.pixel) + &told;
        let mut ask = self.ask(&told, kind, Some(&stage));
        let at = ray.address();
        let open = Address {
            part: None,
            ..at.clone()
        };
        ask.at = Some(at);
        Ok(self.in_debugger(&stage, ask, Some(open)))
    }

    /// A pixel of the picture.
    fn pixel(&self, told: &str) -> Result<AttemptPlace, String> {
        let stage = self.stage()?;
        let ask = self.ask(told, AskKind::Pixel, Some(&stage));
        Ok(self.in_debugger(&stage, ask, None))
    }

    /// A broken tracer. Laws are told by what is wrong; the name of the right one stands nowhere.
    fn bug(&self, bend: Bend, among: &[Bend], at: (u32, u32)) -> Result<AttemptPlace, String> {
        let stage = self.stage()?;
        let bent = stage.with(&[("bend".to_owned(), bend.name().to_owned())])?;
        let notes = among.iter().map(|bend| bend.entry().note.to_owned());
        let kind = AskKind::Law {
            among: notes.collect(),
            ours: Box::new(stage.settings),
        };
        let told = match text(&self.exercise().text) {
            told if told.is_empty() => {
                "Which law is broken, and on which ray does it first show?".to_owned()
            }
            told => told,
        };
        let mut ask = self.ask(&told, kind, None);
        "a broken tracer: all numbers are its own".clone_into(&mut ask.remark);
        let at = Address {
            scene: None,
            pixel: at,
            path: TreePath::default(),
            part: None,
        };
        Ok(self.in_debugger(&bent, ask, Some(at)))
    }

    /// Answers to choose among.
    pub fn choice(&self, asked: &str, options: &[Choices]) -> AttemptPlace {
        let words = options.iter().map(|option| text(&option.text)).collect();
        AttemptPlace::Here(Box::new(self.ask(asked, AskKind::Word(words), None)))
    }
}

impl Attempt {
    /// The question.
    pub fn ask(&self) -> Option<&AskState> {
        match &self.place {
            AttemptPlace::Debugger(program) => program.model.ask.as_ref(),
            AttemptPlace::Here(ask) => Some(ask),
        }
    }

    /// The question, to be changed.
    pub fn ask_mut(&mut self) -> Option<&mut AskState> {
        match &mut self.place {
            AttemptPlace::Debugger(program) => program.model.ask.as_mut(),
            AttemptPlace::Here(ask) => Some(ask),
        }
    }

    /// The answer as it is judged.
    pub fn given(&self, exercise: &Exercise, reply: AskReply) -> Option<StudentAnswer> {
        Some(match (reply, &exercise.kind) {
            (AskReply::Value(text), _) => StudentAnswer::Value(text),
            (AskReply::Word(n), ExerciseKind::Choose { .. }) => {
                StudentAnswer::Choice(self.slide, letter(n))
            }
            (AskReply::Word(n), _) => match &self.ask()?.kind {
                AskKind::Word(words) => StudentAnswer::Value(words.get(n)?.clone()),
                _ => return None,
            },
            (AskReply::Pixel(at), _) => StudentAnswer::Pixel(at),
            (AskReply::Law(n, event), ExerciseKind::Bug { among, .. }) => {
                StudentAnswer::Bug(among.get(n)?.name().to_owned(), self.path(event)?)
            }
            (AskReply::Law(..), _) => return None,
        })
    }

    /// The ray of an event of the open tree; the eye ray before the first one is sent.
    fn path(&self, event: usize) -> Option<TreePath> {
        let AttemptPlace::Debugger(program) = &self.place else {
            return None;
        };
        let session = program.model.session.as_ref()?;
        let node = session.tree().node_of_event(event);
        Some(node.map_or_else(TreePath::default, |node| path_of(session.view(), node)))
    }
}

/// What stands before a question that is asked again, about another pixel than its text names.
fn again(asked: &LessonValue, (x, y): (u32, u32)) -> String {
    match &asked.what {
        AskedValue::Field(first, _) if first.pixel != (x, y) => {
            let (a, b) = first.pixel;
            format!("This time pixel {x},{y}, not {a},{b}: take its numbers from the tree. ")
        }
        _ => String::new(),
    }
}

/// A short Markdown text without its signs.
pub fn text(markdown: &str) -> String {
    printable(&plain(&words(markdown))).into_owned()
}
