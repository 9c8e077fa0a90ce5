//! Exercises that are done outside of this program: which file, which command.

use std::fmt::Write as _;

use super::model::LessonModel;
use crate::lesson::reader::asked;
use crate::lesson::workspace::work_path;

/// Columns of what is asked.
const ASKED: usize = 80;

/// What is to be done outside of this program: a title and a text.
pub fn outside(model: &LessonModel) -> Option<(String, String)> {
    let (chapter, exercise) = (model.chapter(), model.exercise()?);
    let id = &exercise.id;
    let file = work_path(chapter, id, &exercise.kind)?;
    let mut told = asked(&model.course, chapter, exercise, 0, ASKED);
    let _ = write!(
        told,
        "In a shell:\n\n    raytree lesson start DIR\n    raytree lesson answer {id} DIR/{file}\n\n\
         The first puts the files of all exercises into a folder and never replaces one; yours is then `DIR/{file}`. The second \
         checks it as often as you like. What was done is kept: n goes on here.\n"
    );
    Some((format!("{id}: {}", exercise.kind.name()), told))
}
