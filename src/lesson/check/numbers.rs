//! Numbers that give an answer away: in hints, and answers that anybody would guess.

use crate::lesson::chapter::Chapter;
use crate::lesson::course::Course;
use crate::lesson::exercise::{Exercise, ExerciseKind};
use crate::lesson::question::Question;
use crate::trace::field::FieldValue;

/// Hints that an exercise has.
const HINTS: usize = 3;

/// What is wrong with the hints of an exercise. Programs need none.
pub fn hints(course: &Course, chapter: &Chapter, exercise: &Exercise) -> Vec<String> {
    let mut wrong = Vec::new();
    if matches!(exercise.kind, ExerciseKind::Write { .. }) {
        return wrong;
    }
    if exercise.hints.len() != HINTS {
        wrong.push(format!(
            "it has {} hints; write three: where to look, which law, almost the answer",
            exercise.hints.len()
        ));
    }
    let ExerciseKind::Predict { asked, tolerance } = &exercise.kind else {
        return wrong;
    };
    let Ok(stage) = course.stage_of(chapter, exercise) else {
        return wrong;
    };
    let Ok(question) = Question::new(&stage, asked, 0) else {
        return wrong;
    };
    for hint in &exercise.hints {
        let told = numbers(hint).into_iter().find(|number| {
            let given = FieldValue::Number(*number);
            digits(hint, *number)
                && crate::lesson::near::is_near(&given, &question.answer, *tolerance)
        });
        if let Some(number) = told {
            wrong.push(format!("a hint tells the answer: {number}"));
        }
    }
    wrong
}

/// Numbers that stand in a text.
fn numbers(text: &str) -> Vec<f64> {
    let parts = text.split(|c: char| !c.is_ascii_digit() && !matches!(c, '.' | '-'));
    parts
        .filter_map(|part| part.trim_end_matches('.').parse().ok())
        .collect()
}

/// True if a number is written with so many digits that it is no count or exponent by chance.
fn digits(text: &str, number: f64) -> bool {
    let written = text.split(|c: char| !c.is_ascii_digit() && !matches!(c, '.' | '-'));
    let of_it = |part: &&str| part.trim_end_matches('.').parse() == Ok(number);
    written
        .filter(of_it)
        .any(|part| part.bytes().filter(u8::is_ascii_digit).count() >= 3)
}
