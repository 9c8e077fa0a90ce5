//! Keys, sizes and files of the lesson screen.

use crossterm::event::KeyCode;
use ratatui::layout::{Position, Rect};

use super::lesson::{choose, course, inner, key, keys, screen, settle, started};
use crate::lesson::exercise::ExerciseKind;
use crate::lesson::progress::ProgressFile;
use crate::tracer::image::ColorLevel;
use crate::tui::lesson::{LESSON_KEYS, LessonOptions, LessonProgram};
use crate::tui::model::ask::{AskKind, AskState};
use crate::tui::model::{Message, Mouse, Request};
use crate::tui::terminal::main_loop::Interactive as _;

/// The number of the first exercise of a kind in the course: of its chapter, and in it.
fn first(is_it: impl Fn(&ExerciseKind) -> bool) -> (usize, usize) {
    let course = course();
    let chapters = course.chapters.iter().enumerate();
    let mut all = chapters.flat_map(|(number, chapter)| {
        let exercises = chapter.exercises.iter().enumerate();
        exercises.map(move |(place, exercise)| (number, place, exercise))
    });
    let found = all.find(|(.., exercise)| is_it(&exercise.kind));
    found
        .map(|(number, place, _)| (number, place))
        .expect("there is one")
}

fn is_asked_in_the_debugger(kind: &ExerciseKind) -> bool {
    matches!(kind, ExerciseKind::Predict { asked, .. } if matches!(asked.what, crate::lesson::value::AskedValue::Field(..)))
}

#[test]
fn every_key_of_the_lesson_screen_does_something_and_is_in_the_help() {
    let mut program = started(course(), (160, 50), ColorLevel::True);
    keys(&mut program, "?");
    let mut help = screen(&program);
    for _ in 0..30 {
        key(&mut program, KeyCode::Down);
        help += &screen(&program);
    }
    keys(&mut program, "q");
    for binding in LESSON_KEYS {
        for (key, action) in binding.keys {
            assert!(
                help.split(|c: char| c.is_whitespace() || c == '║')
                    .any(|word| word == key.label()),
                "{action:?}"
            );
            let did = ["", ">jjj", "g", "?jj"].into_iter().any(|before| {
                let mut program = started(course(), (160, 50), ColorLevel::True);
                choose(&mut program, 1, 2);
                keys(&mut program, before);
                let (shown, mouse) = (screen(&program), program.mouse());
                program.send(Message::Key(key.event()));
                settle(&mut program);
                *program.request() != Request::Stay
                    || screen(&program) != shown
                    || program.mouse() != mouse
            });
            assert!(did, "{} ({action:?}) does nothing", key.label());
        }
    }
}

#[test]
fn any_size_is_drawn_and_the_text_is_never_cut() {
    let mut program = started(course(), (160, 50), ColorLevel::Never);
    // What is told at first goes with the first key.
    keys(&mut program, "gq");
    let wide = screen(&program);
    for (width, height) in [
        (100, 30),
        (99, 30),
        (80, 24),
        (70, 20),
        (69, 20),
        (40, 12),
        (20, 8),
        (3, 3),
        (1, 1),
        (0, 0),
    ] {
        program.send(Message::Resize(Rect::new(0, 0, width, height)));
        settle(&mut program);
        for text in ["", "g", "?", "v", "j"] {
            keys(&mut program, text);
            if width > 0 {
                drop(screen(&program));
            }
            if !text.is_empty() {
                keys(&mut program, "q");
                program.model.request = Request::Stay;
            }
        }
        // All of the page can be scrolled to.
        key(&mut program, KeyCode::End);
        let room = crate::tui::model::inside(program.model.panes().text);
        let lines = program.model.lines();
        if room.height > 0 {
            assert_eq!(
                program.model.scroll,
                lines.len().saturating_sub(usize::from(room.height))
            );
        }
        for line in &lines {
            assert!(
                width < 24 || line.line.width() < usize::from(room.width),
                "{width}: {}",
                line.line
            );
        }
        key(&mut program, KeyCode::Home);
    }
    program.send(Message::Resize(Rect::new(0, 0, 160, 50)));
    settle(&mut program);
    key(&mut program, KeyCode::Home);
    assert_eq!(screen(&program), wide);
}

#[test]
fn what_is_shown_goes_with_the_width() {
    let shown = |width: u16| {
        let program = started(course(), (width, 30), ColorLevel::Never);
        let text = screen(&program);
        (
            text.contains(" chapters "),
            text.contains(" exercises "),
            program.model.picture.is_some(),
        )
    };
    assert_eq!(shown(120), (true, true, true));
    assert_eq!(shown(90), (false, true, false));
    assert_eq!(shown(60), (false, false, false));
    let mut program = started(course(), (80, 24), ColorLevel::Never);
    keys(&mut program, "v");
    assert!(program.model.picture.is_some(), "v shows it alone");
}

/// Hints are counted and kept, a solution is asked for twice, and what was done is in the file after each step.
#[test]
fn hints_and_solutions_are_kept_in_the_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("progress.json");
    let course = course();
    let open = || {
        let progress = ProgressFile::open(Some(path.clone()), &course.id);
        let options = LessonOptions {
            color: ColorLevel::Never,
            mouse: false,
            threads: 1,
            run: None,
        };
        let mut program =
            LessonProgram::new(course.clone(), progress, options, Rect::new(0, 0, 100, 40));
        settle(&mut program);
        program
    };
    let (chapter, place) = first(is_asked_in_the_debugger);
    let exercise = &course.chapters[chapter].exercises[place];
    let kept = || {
        ProgressFile::open(Some(path.clone()), &course.id)
            .progress()
            .of(&exercise.id)
    };
    let mut program = open();
    choose(&mut program, chapter, place);
    keys(&mut program, "H");
    assert!(
        screen(&program).contains("hint 1 of 3"),
        "{}",
        screen(&program)
    );
    assert_eq!(kept().hints, 1);
    // In the debugger the hint that was read is there, and the next one comes.
    key(&mut program, KeyCode::Enter);
    assert!(
        screen(&program).contains("hint 1: "),
        "{}",
        screen(&program)
    );
    keys(&mut program, "H");
    assert!(
        screen(&program).contains("hint 2: "),
        "{}",
        screen(&program)
    );
    assert_eq!(kept().hints, 2);
    keys(&mut program, "q");
    assert!(program.model.attempt.is_none());
    assert!(!kept().done);
    keys(&mut program, "s");
    assert!(!kept().done, "asked once");
    keys(&mut program, "s");
    assert!(kept().given_up && kept().done);
    assert!(
        screen(&program).contains("the solution"),
        "{}",
        screen(&program)
    );
    keys(&mut program, "qq");
    assert_eq!(*program.request(), Request::Quit);
    // Begun anew it goes on where it was left.
    let again = open();
    assert!(again.model.done(&exercise.id).given_up);
}

/// A wrong value is told with the step that shows it, and the same is asked of another pixel.
#[test]
fn a_wrong_value_is_asked_again_of_another_pixel() {
    let course = course();
    let (chapter, place) = first(|kind| {
        is_asked_in_the_debugger(kind)
            && matches!(kind, ExerciseKind::Predict { asked, .. } if matches!(&asked.what,
            crate::lesson::value::AskedValue::Field(address, _) if address.path.steps.is_empty()))
    });
    let mut program = started(course, (120, 40), ColorLevel::True);
    choose(&mut program, chapter, place);
    key(&mut program, KeyCode::Enter);
    let pixel = |program: &mut LessonProgram| {
        let session = inner(program).session.as_ref().expect("a tree");
        (session.trace.x, session.trace.y)
    };
    let before = pixel(&mut program);
    let is_number = matches!(
        inner(&mut program).ask.as_ref().map(|a| &a.kind),
        Some(AskKind::Value(_))
    );
    assert!(is_number, "the first one is a number");
    keys(&mut program, "99,99");
    key(&mut program, KeyCode::Enter);
    assert!(
        inner(&mut program).message.is_some()
            || inner(&mut program)
                .ask
                .as_ref()
                .is_some_and(|a| !a.is_open())
    );
    if inner(&mut program)
        .ask
        .as_ref()
        .is_some_and(AskState::is_open)
    {
        for _ in 0..5 {
            key(&mut program, KeyCode::Backspace);
        }
        keys(&mut program, "99");
        key(&mut program, KeyCode::Enter);
    }
    let shown = screen(&program);
    assert!(shown.contains("you said 99"), "{shown}");
    let session = inner(&mut program).session.as_ref().expect("a tree");
    assert_eq!(session.horizon(), None, "all is known now");
    key(&mut program, KeyCode::Enter);
    assert_ne!(pixel(&mut program), before);
    let session = inner(&mut program).session.as_ref().expect("a tree");
    assert!(session.horizon().is_some(), "and hidden again");
}

#[test]
fn the_mouse_scrolls_and_chooses() {
    let mut program = started(course(), (120, 40), ColorLevel::True);
    program.send(Message::Mouse(Mouse::Wheel(3), Position::new(60, 10)));
    assert_eq!(program.model.scroll, 3);
    let area = program.model.panes().exercises;
    program.send(Message::Mouse(
        Mouse::Press,
        Position::new(area.x + 4, area.y + 3),
    ));
    assert_eq!(program.model.chosen, 2);
    let area = program.model.panes().chapters;
    program.send(Message::Mouse(
        Mouse::Press,
        Position::new(area.x + 4, area.y + 4),
    ));
    assert_eq!(program.model.chapter, 3);
}

/// After a wrong pixel the next one is checked by the same key, and what did not hold is told part by part.
#[test]
fn a_wrong_pixel_is_told_and_the_next_one_tried_at_once() {
    let (chapter, place) = first(|kind| matches!(kind, ExerciseKind::Find(_)));
    let course = course();
    let exercise = course.chapters[chapter].exercises[place].clone();
    let ExerciseKind::Find(wanted) = &exercise.kind else {
        panic!("a pixel is wanted");
    };
    let stage = course
        .stage_of(&course.chapters[chapter], &exercise)
        .expect("a stage");
    let holds = |at| {
        let parts = crate::lesson::answer::parts(&stage, wanted, at).expect("a pixel");
        parts.iter().all(|part| part.holds)
    };
    let wrong = (0..240).map(|y| (160, y)).find(|at| !holds(*at));
    let wrong = wrong.expect("not all are wanted");
    let mut program = started(course, (120, 40), ColorLevel::True);
    choose(&mut program, chapter, place);
    key(&mut program, KeyCode::Enter);
    for tries in 1..3 {
        inner(&mut program).picture.cursor = wrong;
        key(&mut program, KeyCode::Enter);
        let shown = screen(&program);
        assert!(shown.contains("is none"), "{shown}");
        assert_eq!(program.model.done(&exercise.id).tries, tries);
    }
    assert!(!program.model.done(&exercise.id).done);
}
