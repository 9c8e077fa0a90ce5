//! An exercise as data: what is asked, in which scene, with which hints. The answers are computed ([`super::answer`]).

mod file;

use super::value::LessonValue;
use crate::lab::show::ShowMode;
use crate::scene::Bend;
use crate::trace::TreeQuery;

pub use file::{ExerciseFile, shown};

/// An exercise.
#[derive(Clone, Debug)]
pub struct Exercise {
    /// Unique in the course.
    pub id: String,
    /// What is asked, in Markdown; may be empty for a slide.
    pub text: String,
    /// Three hints; none for programs.
    pub hints: Vec<String>,
    /// Done without a hint, it shows that the chapter is known.
    pub gate: bool,
    /// Not counted.
    pub optional: bool,
    /// Its scene, if it is not that of the chapter.
    pub scene: Option<String>,
    /// Settings on top of the chapter's, by the names of flags.
    pub settings: Vec<(String, String)>,
    /// What is to be done.
    pub kind: ExerciseKind,
}

/// What is to be done in an exercise.
#[derive(Clone, Debug)]
pub enum ExerciseKind {
    /// Tell a value before it is shown.
    Predict {
        /// The value.
        asked: LessonValue,
        /// How far off the answer may be, if not by the rule.
        tolerance: Option<f64>,
    },
    /// Find a pixel.
    Find(Wanted),
    /// Change a copy of the scene until all goals hold.
    Change(ChangeTask),
    /// Find the law that is broken, and the first wrong step.
    Bug {
        /// The mistake.
        bend: Bend,
        /// The mistakes that are offered.
        among: Vec<Bend>,
        /// The pixel that is opened.
        at: (u32, u32),
    },
    /// Choose among answers; of a slide first find a pixel where it fails.
    Choose {
        /// What the slide says, in Markdown; empty for a plain choice.
        says: String,
        /// What the slide does.
        bend: Option<Bend>,
        /// The answers.
        options: Vec<Choices>,
    },
    /// Write a program for a task.
    Write {
        /// The task file, in the course.
        task: String,
    },
}

/// Which pixels are wanted: all that is given must hold.
#[derive(Clone, Debug, Default)]
pub struct Wanted {
    /// Its tree satisfies a query.
    pub query: Option<TreeQuery>,
    /// The text of the query.
    pub text: String,
    /// Its colour on the screen changes with these settings.
    pub differs: Vec<(String, String)>,
    /// What is shown of it lies in this range.
    pub shown: Option<(ShowMode, [f64; 2])>,
}

/// A scene to be changed.
#[derive(Clone, Debug)]
pub struct ChangeTask {
    /// Parts that stay as they are, by their names in the scene file.
    pub keep: Vec<String>,
    /// What must hold.
    pub goals: Vec<Goal>,
    /// Changes that make what the student gets.
    pub start: Vec<String>,
    /// A solution.
    pub solution: Solution,
}

/// A goal of a change.
#[derive(Clone, Debug)]
pub struct Goal {
    /// What is looked at.
    pub asked: LessonValue,
    /// What it must be.
    pub must: Must,
}

/// What a value must be.
#[derive(Clone, Debug, PartialEq)]
pub enum Must {
    /// This word.
    Word(String),
    /// This number, within a tolerance.
    Near(f64, f64),
    /// In this range.
    Between([f64; 2]),
    /// As in the scene that the student gets.
    Same,
}

/// A solution of a change.
#[derive(Clone, Debug)]
pub enum Solution {
    /// Changes, as `--change` takes them.
    Changes(Vec<String>),
    /// A scene file in the course.
    File(String),
}

/// An answer to choose.
#[derive(Clone, Debug)]
pub struct Choices {
    /// The answer, in Markdown.
    pub text: String,
    /// When it is right.
    pub right: Rightness,
    /// What is said if it is chosen and wrong.
    pub say: String,
}

/// When an answer is right.
#[derive(Clone, Debug)]
pub enum Rightness {
    /// Always or never.
    Fixed(bool),
    /// As the tracer finds: one value compared with another.
    When(Box<LessonValue>, std::cmp::Ordering, Box<LessonValue>),
}

impl ExerciseKind {
    /// Its name.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Predict { .. } => "predict",
            Self::Find(_) => "find",
            Self::Change(_) => "change",
            Self::Bug { .. } => "find the bug",
            Self::Choose { says, .. } if says.is_empty() => "choose",
            Self::Choose { .. } => "slide",
            Self::Write { .. } => "write",
        }
    }
}
