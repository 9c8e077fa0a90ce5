//! The lesson screen: every exercise of the course is played from Enter to done with the answers that the tracer gives.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::support::text_of;
use crate::lesson::answer::{first_wrong, is_right, parts};
use crate::lesson::exercise::{ExerciseKind, Wanted};
use crate::lesson::progress::ProgressFile;
use crate::lesson::question::Question;
use crate::lesson::{Chapter, Course, Exercise, Stage};
use crate::scene::Bend;
use crate::trace::Address;
use crate::trace::format::num;
use crate::tracer::image::ColorLevel;
use crate::tui::lesson::{LessonOptions, LessonOverlay, LessonProgram};
use crate::tui::model::ask::AskKind;
use crate::tui::model::{Message, Model, Pane, Request};
use crate::tui::terminal::main_loop::Interactive as _;

pub fn course() -> Course {
    Course::embedded().expect("the course is whole")
}

pub fn started(course: Course, (width, height): (u16, u16), color: ColorLevel) -> LessonProgram {
    let progress = ProgressFile::open(None, &course.id);
    let options = LessonOptions {
        color,
        mouse: false,
        threads: 2,
        run: None,
    };
    let mut program = LessonProgram::new(course, progress, options, Rect::new(0, 0, width, height));
    settle(&mut program);
    program
}

/// Waits until the background has done all its work.
pub fn settle(program: &mut LessonProgram) {
    let start = Instant::now();
    while program.is_busy() {
        program.receive();
        assert!(start.elapsed() < Duration::from_secs(120), "it never ends");
        std::thread::sleep(Duration::from_millis(1));
    }
    program.receive();
}

pub fn buffer(program: &LessonProgram) -> Buffer {
    let mut buffer = Buffer::empty(program.model.screen);
    program.draw(program.model.screen, &mut buffer);
    buffer
}

pub fn screen(program: &LessonProgram) -> String {
    text_of(&buffer(program))
}

pub fn key(program: &mut LessonProgram, code: KeyCode) {
    program.send(Message::Key(KeyEvent::new(code, KeyModifiers::NONE)));
    settle(program);
}

pub fn keys(program: &mut LessonProgram, letters: &str) {
    for letter in letters.chars() {
        key(program, KeyCode::Char(letter));
    }
}

/// Opens a chapter and chooses an exercise, by keys.
pub fn choose(program: &mut LessonProgram, chapter: usize, exercise: usize) {
    while program.model.chapter != chapter {
        let forward = program.model.chapter < chapter;
        keys(program, if forward { ">" } else { "<" });
    }
    while program.model.chosen != exercise {
        let forward = program.model.chosen < exercise;
        key(
            program,
            if forward {
                KeyCode::Tab
            } else {
                KeyCode::BackTab
            },
        );
    }
}

pub fn inner(program: &mut LessonProgram) -> &mut Model {
    program.debugger_mut().expect("the debugger has the keys")
}

/// A pixel for which something holds: coarse first, then all.
fn pixel(stage: &Stage, holds: impl Fn((u32, u32)) -> bool) -> (u32, u32) {
    let (width, height) = stage.settings.size();
    for step in [16, 4, 1] {
        for y in (step / 2..height).step_by(step as usize) {
            for x in (step / 2..width).step_by(step as usize) {
                if holds((x, y)) {
                    return (x, y);
                }
            }
        }
    }
    panic!("there is no such pixel");
}

fn found(stage: &Stage, wanted: &Wanted) -> (u32, u32) {
    pixel(stage, |at| {
        let parts = parts(stage, wanted, at).expect("a pixel of the picture");
        parts.iter().all(|part| part.holds)
    })
}

fn wrong_in(stage: &Stage, bend: Bend) -> (u32, u32) {
    pixel(stage, |at| first_wrong(stage, bend, at).is_ok())
}

/// Puts the cursor of the picture on a pixel and answers with it.
fn answer_pixel(program: &mut LessonProgram, at: (u32, u32)) {
    let model = inner(program);
    model.picture.cursor = at;
    model.picture.follow();
    key(program, KeyCode::Enter);
}

/// Before the answer no known event in any pane tells its digits.
fn tells_nothing(program: &mut LessonProgram, id: &str, secrets: &[String]) {
    let end = inner(program).session.as_ref().and_then(|s| s.horizon());
    let end = end.unwrap_or_else(|| panic!("{id}: nothing is hidden"));
    for event in (0..end).step_by(1 + end / 12).chain([end - 1]) {
        for pane in Pane::FOCUS {
            let model = inner(program);
            model.layout.focus = pane;
            if let Some(session) = &mut model.session {
                session.go_to_event(event);
            }
            let shown = screen(program);
            // The question itself, and what is typed, may have numbers.
            let above: Vec<&str> = shown.split("before the answer").collect();
            for secret in secrets {
                assert!(
                    !above[0].contains(secret),
                    "{id}: {secret} at event {event}:\n{shown}"
                );
            }
        }
    }
    inner(program).layout.focus = Pane::Tree;
}

/// The text of an answer that is looked for, as it is printed: of a vector all of it, since a part of it may be known; of a
/// number at least five digits.
fn secrets(question: &Question) -> Vec<String> {
    let numbers = question.answer.numbers();
    let text = match numbers {
        [number] => num(number.abs()),
        numbers => {
            let parts: Vec<String> = numbers.iter().map(|x| num(*x)).collect();
            parts.join(", ")
        }
    };
    let digits = text.chars().filter(char::is_ascii_digit).count();
    Vec::from_iter((digits > 5).then_some(text))
}

fn predict(program: &mut LessonProgram, stage: &Stage, exercise: &Exercise) {
    let ExerciseKind::Predict { asked, .. } = &exercise.kind else {
        panic!("no value is asked");
    };
    let question = Question::new(stage, asked, 0).expect("a question");
    let ask = program
        .model
        .attempt
        .as_ref()
        .and_then(|a| a.ask())
        .expect("it is asked");
    let kind = ask.kind.clone();
    if question.ray.is_some() {
        tells_nothing(program, &exercise.id, &secrets(&question));
    }
    let answer = question.answer.text(None);
    if let AskKind::Word(words) = kind {
        let number = words.iter().position(|word| *word == answer);
        let number = number.expect("among them") + 1;
        keys(program, &number.to_string());
        if words.len() > 9 {
            key(program, KeyCode::Enter);
        }
    } else {
        keys(program, &answer);
        key(program, KeyCode::Enter);
    }
}

fn bug(program: &mut LessonProgram, stage: &Stage, exercise: &Exercise) {
    let ExerciseKind::Bug { bend, among, at } = &exercise.kind else {
        panic!("no bug");
    };
    let shown = screen(program);
    assert!(
        shown.contains("a broken tracer"),
        "{}:\n{shown}",
        exercise.id
    );
    names_no_bend(&shown, *bend);
    let (path, _) = first_wrong(stage, *bend, *at).expect("it shows");
    let address = Address {
        scene: None,
        pixel: *at,
        path,
        part: None,
    };
    // The pixel beside it may be looked at.
    for (code, x) in [(KeyCode::Right, at.0 + 1), (KeyCode::Left, at.0)] {
        program.send(Message::Key(KeyEvent::new(code, KeyModifiers::SHIFT)));
        settle(program);
        let trace = &inner(program).session.as_ref().expect("a tree").trace;
        assert_eq!((trace.x, trace.y), (x, at.1), "{}", exercise.id);
    }
    let session = inner(program).session.as_mut().expect("a tree");
    session.go_to_address(&address).expect("the ray is there");
    keys(program, "b");
    let place = among
        .iter()
        .position(|other| other == bend)
        .expect("among them");
    for _ in 0..place {
        key(program, KeyCode::Down);
    }
    key(program, KeyCode::Enter);
}

fn names_no_bend(shown: &str, bend: Bend) {
    // A name of one word may be a word of the text.
    let is_name = bend.name().contains('-');
    assert!(
        !is_name || !shown.contains(bend.name()),
        "{}:\n{shown}",
        bend.name()
    );
}

fn choice(
    program: &mut LessonProgram,
    course: &Course,
    chapter: &Chapter,
    stage: &Stage,
    exercise: &Exercise,
) {
    let ExerciseKind::Choose { bend, options, .. } = &exercise.kind else {
        panic!("no choice");
    };
    if let Some(bend) = bend {
        answer_pixel(program, wrong_in(stage, *bend));
    }
    let right = options.iter().position(|option| {
        is_right(course, chapter, stage, &option.right).expect("it can be told")
    });
    keys(program, &(right.expect("one is right") + 1).to_string());
}

/// Plays an exercise from Enter to the text again.
fn play(program: &mut LessonProgram, course: &Course, chapter: usize, number: usize) {
    choose(program, chapter, number);
    let (chapter, scroll) = (&course.chapters[chapter], program.model.scroll);
    let exercise = &chapter.exercises[number];
    let id = &exercise.id;
    key(program, KeyCode::Enter);
    if matches!(
        exercise.kind,
        ExerciseKind::Change(_) | ExerciseKind::Write { .. }
    ) {
        let told = format!("raytree lesson answer {id} DIR/");
        let text = match &program.model.overlay {
            Some(LessonOverlay::Text(_, text, _)) => text,
            other => panic!("{id}: {other:?}"),
        };
        assert!(text.contains(&told), "{id}: {text}");
        drop(screen(program));
        keys(program, "q");
        return;
    }
    assert!(
        program.model.attempt.is_some(),
        "{id}: {:?}",
        program.model.message
    );
    let stage = course.stage_of(chapter, exercise).expect("a stage");
    match &exercise.kind {
        ExerciseKind::Predict { .. } => predict(program, &stage, exercise),
        ExerciseKind::Find(wanted) => answer_pixel(program, found(&stage, wanted)),
        ExerciseKind::Bug { .. } => bug(program, &stage, exercise),
        _ => choice(program, course, chapter, &stage, exercise),
    }
    let ask = program
        .model
        .attempt
        .as_ref()
        .and_then(|a| a.ask())
        .expect("still there");
    let told = ask
        .told
        .clone()
        .unwrap_or_else(|| panic!("{id} is not answered:\n{}", screen(program)));
    assert!(told.is_right, "{id}: {}\n{}", told.text, screen(program));
    assert!(
        program.model.progress.progress().is_over(id),
        "{id} is kept"
    );
    if let Some(model) = program.debugger_mut() {
        model.overlay = None;
    }
    key(program, KeyCode::Enter);
    assert!(program.model.attempt.is_none(), "{id} leads back");
    assert_eq!(
        (program.model.scroll, program.model.chosen),
        (scroll, number),
        "{id}"
    );
    assert_eq!(program.model.request, Request::Stay);
}

/// Every exercise, at 80x24 and larger, with and without colours, without a mouse.
#[test]
fn every_exercise_is_played_from_enter_to_done() {
    let course = course();
    let sizes = [
        ((80, 24), ColorLevel::Never),
        ((160, 50), ColorLevel::True),
        ((80, 24), ColorLevel::Palette),
    ];
    let (mut played, mut broken) = (0, Vec::new());
    for (number, chapter) in course.chapters.iter().enumerate() {
        let (size, color) = sizes[number % sizes.len()];
        let mut program = started(course.clone(), size, color);
        let mut is_whole = true;
        for exercise in 0..chapter.exercises.len() {
            let one = AssertUnwindSafe(|| play(&mut program, &course, number, exercise));
            if catch_unwind(one).is_err() {
                broken.push(chapter.exercises[exercise].id.clone());
                program = started(course.clone(), size, color);
                is_whole = false;
            }
            played += 1;
        }
        if !is_whole {
            continue;
        }
        let (done, all) = program.model.done_in(number);
        let outside = chapter.exercises.iter().filter(|e| {
            !e.optional && matches!(e.kind, ExerciseKind::Change(_) | ExerciseKind::Write { .. })
        });
        let skipped = program.model.progress.progress();
        let open = outside.filter(|e| !skipped.is_over(&e.id)).count();
        assert_eq!(done + open, all, "{}", chapter.title);
    }
    assert!(played >= course.chapters.len(), "{played}");
    // Each was told above.
    assert!(broken.is_empty(), "{broken:?}");
}
