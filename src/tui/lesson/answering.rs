//! Answers: exercises begun, judged, told, with their hints and solutions.

use super::attempt::{Attempt, AttemptMaker, AttemptPlace, text};
use super::model::{LessonModel, LessonOverlay};
use super::outside::outside;
use crate::lesson;
use crate::lesson::answer::{AnswerVerdict, first_wrong, judge};
use crate::lesson::exercise::ExerciseKind;
use crate::tui::model::ask::{AskReply, AskRequest, AskTold};
use crate::tui::update::ask;

/// Lines of a verdict that are told beside the debugger at most.
const TOLD: usize = 6;

/// Begins the chosen exercise.
pub fn begin(model: &mut LessonModel) {
    let Some(exercise) = model.exercise() else {
        model.message = Some("this chapter has no exercises".to_owned());
        return;
    };
    let done = model.done(&exercise.id);
    let maker = AttemptMaker {
        course: &model.course,
        chapter: model.chapter(),
        exercise: model.chosen,
        tries: done.asked_before(),
        hints: done.hints,
        screen: model.screen,
        options: &model.options,
    };
    match maker.make() {
        Ok(Some(attempt)) => model.attempt = Some(attempt),
        Ok(None) => {
            if let Some((title, text)) = outside(model) {
                model.overlay = Some(LessonOverlay::Text(title, text, 0));
            }
        }
        Err(error) => model.message = Some(error),
    }
}

/// Does what the question asks for, if it does.
pub fn serve(model: &mut LessonModel) {
    let request = model
        .attempt
        .as_mut()
        .and_then(|a| a.ask_mut()?.request.take());
    match request {
        None => {}
        Some(AskRequest::Leave) => leave(model),
        Some(AskRequest::GoOn) => go_on(model),
        Some(AskRequest::Hint) => hint(model),
        Some(AskRequest::Check(reply)) => check(model, reply),
    }
}

fn leave(model: &mut LessonModel) {
    model.attempt = None;
}

/// Judges an answer, keeps that, and tells it.
fn check(model: &mut LessonModel, reply: AskReply) {
    let Some(attempt) = &mut model.attempt else {
        return;
    };
    let Some(exercise) = model.course.chapters[model.chapter]
        .exercises
        .get(attempt.exercise)
    else {
        return;
    };
    let exercise = exercise.clone();
    if let (AskReply::Pixel(at), ExerciseKind::Choose { .. }) = (&reply, &exercise.kind) {
        return slide_fails(model, *at);
    }
    let Some(given) = attempt.given(&exercise, reply) else {
        return;
    };
    let (course, tries) = (model.course.clone(), attempt.tries);
    let chapter = &course.chapters[model.chapter];
    match judge(&course, chapter, &exercise, &given, tries) {
        Ok(verdict) => {
            attempt.tries += 1;
            let right = verdict.right;
            tell(attempt, &exercise.kind, &verdict);
            let skipped = model
                .progress
                .change(|progress| progress.answered(&course, &exercise.id, right));
            if let Some(skipped) = skipped {
                say(model, skipped);
            }
        }
        // What cannot be read is no answer.
        Err(error) => say(model, error),
    }
}

/// The pixel where a slide fails was chosen: if it is one, what is right is asked next.
fn slide_fails(model: &mut LessonModel, at: (u32, u32)) {
    let (course, chapter) = (model.course.clone(), model.chapter);
    let chapter = &course.chapters[chapter];
    let Some(attempt) = &model.attempt else {
        return;
    };
    let exercise = &chapter.exercises[attempt.exercise];
    let ExerciseKind::Choose {
        bend: Some(bend),
        options,
        ..
    } = &exercise.kind
    else {
        return;
    };
    let stage = match course.stage_of(chapter, exercise) {
        Ok(stage) => stage,
        Err(error) => return say(model, error.to_string()),
    };
    if first_wrong(&stage, *bend, at).is_err() {
        let told = "at this pixel the slide is right by chance: ours is the same; find another one";
        return say(model, told.to_owned());
    }
    let maker = AttemptMaker {
        course: &course,
        chapter,
        exercise: attempt.exercise,
        tries: attempt.tries,
        hints: model.done(&exercise.id).hints,
        screen: model.screen,
        options: &model.options,
    };
    let (x, y) = at;
    let asked = format!("At pixel {x},{y} the slide is wrong. What is right?");
    let place = maker.choice(&asked, options);
    if let Some(attempt) = &mut model.attempt {
        (attempt.slide, attempt.place) = (Some(at), place);
    }
}

/// Tells a verdict beside the question.
fn tell(attempt: &mut Attempt, kind: &ExerciseKind, verdict: &AnswerVerdict) {
    let lines = match (kind, &attempt.place) {
        // The step itself is shown, with its equation.
        (ExerciseKind::Predict { .. }, AttemptPlace::Debugger(_)) => 1,
        (ExerciseKind::Bug { .. }, _) => 3,
        _ => TOLD,
    };
    let lines: Vec<&str> = verdict
        .lines
        .iter()
        .take(lines)
        .map(String::as_str)
        .collect();
    let told = AskTold {
        is_right: verdict.right,
        text: lines.join("\n"),
    };
    match &mut attempt.place {
        AttemptPlace::Debugger(program) => ask::tell(&mut program.model, told),
        AttemptPlace::Here(ask) => ask.told = Some(told),
    }
}

/// A sentence where the reader looks: in the debugger, or on the lesson screen.
fn say(model: &mut LessonModel, told: String) {
    match model.attempt.as_mut().map(|attempt| &mut attempt.place) {
        Some(AttemptPlace::Debugger(program)) => program.model.message = Some(told),
        _ => model.message = Some(told),
    }
}

/// After a verdict: back to the text if it is right, else once more. A value is asked of another pixel then.
pub fn go_on(model: &mut LessonModel) {
    let Some(attempt) = &mut model.attempt else {
        return;
    };
    let is_right = attempt
        .ask()
        .and_then(|ask| ask.told.as_ref())
        .is_none_or(|t| t.is_right);
    let chapter = &model.course.chapters[model.chapter];
    let kind = chapter.exercises.get(attempt.exercise).map(|e| &e.kind);
    match kind {
        _ if is_right => {
            leave(model);
            model.follow = false;
        }
        Some(ExerciseKind::Predict { .. }) => begin(model),
        _ => {
            if let Some(ask) = attempt.ask_mut() {
                ask.told = None;
            }
        }
    }
}

/// Shows the next hint to the exercise that is answered, or else to the chosen one.
pub fn hint(model: &mut LessonModel) {
    let place = model
        .attempt
        .as_ref()
        .map_or(model.chosen, |attempt| attempt.exercise);
    let Some(exercise) = model.chapter().exercises.get(place).cloned() else {
        return;
    };
    let next = model.progress.change(|progress| {
        let (number, hint) = progress.hint(&exercise)?;
        Some((number, text(hint)))
    });
    let is_other = model.attempt.as_ref().is_some_and(|a| a.tries > 0)
        && matches!(exercise.kind, ExerciseKind::Predict { .. });
    let next = next.map(|(number, hint)| {
        let of = if is_other {
            " (The numbers are those of the first pixel.)"
        } else {
            ""
        };
        (number, hint + of)
    });
    let Some((number, hint)) = next else {
        let told = if exercise.hints.is_empty() {
            "this exercise has no hints"
        } else {
            "there are no more hints"
        };
        return say(model, told.to_owned());
    };
    match model.attempt.as_mut().map(|attempt| &mut attempt.place) {
        Some(AttemptPlace::Debugger(program)) => ask::hint(&mut program.model, hint),
        Some(AttemptPlace::Here(ask)) => ask.shown.push(hint),
        None => {
            let count = exercise.hints.len();
            model.message = Some(format!("hint {number} of {count}: {hint}"));
        }
    }
}

/// Shows the solution of the chosen exercise: at once if it is done; else it is given up, if that is asked for twice.
pub fn solution(model: &mut LessonModel) {
    let course = model.course.clone();
    let chapter = &course.chapters[model.chapter];
    let Some(exercise) = chapter.exercises.get(model.chosen) else {
        return;
    };
    let done = model.done(&exercise.id);
    if !done.done && model.gives_up.as_ref() != Some(&exercise.id) {
        model.gives_up = Some(exercise.id.clone());
        let told = "this gives the exercise up; s once more shows its solution";
        model.message = Some(told.to_owned());
        return;
    }
    model.gives_up = None;
    match lesson::solution::solution(&course, chapter, exercise, done.asked_before()) {
        Ok(lines) => {
            model.attempt = None;
            model
                .progress
                .change(|progress| progress.give_up(&exercise.id));
            let title = format!("{}: the solution", exercise.id);
            let text = format!("    {}\n", lines.join("\n    "));
            model.overlay = Some(LessonOverlay::Text(title, text, 0));
        }
        Err(error) => model.message = Some(error),
    }
}
