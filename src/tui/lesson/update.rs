//! Update of the lesson screen by keys and clicks.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use ratatui::layout::Position;

use super::answering;
use super::attempt::AttemptPlace;
use super::keys::{LessonAction, lesson_action};
use super::model::{LessonModel, LessonOverlay};
use super::{help, panes};
use crate::tui::model::ask::AskKey;
use crate::tui::model::{Message, Mouse, Request, inside};

/// Takes in a message. False if it means nothing.
pub fn update(model: &mut LessonModel, message: &Message) -> bool {
    match message {
        Message::Key(key) => return press(model, *key),
        Message::Mouse(mouse, at) => point(model, *mouse, *at),
        Message::Resize(screen) => {
            if *screen != model.screen {
                model.screen = *screen;
                model.follow = true;
            }
        }
        _ => return false,
    }
    settle(model);
    true
}

/// Keeps the text within its ends, and the chosen exercise in sight if that is wanted.
pub fn settle(model: &mut LessonModel) {
    let course = model.course.clone();
    model.pages.ask(&course, model.chapter);
    let lines = model.lines();
    let height = usize::from(inside(model.panes().text).height).max(1);
    if model.follow && model.pages.get(model.chapter).is_some() {
        let chosen = model.chosen;
        let place = lines.iter().position(|line| line.exercise == Some(chosen));
        if let Some(place) = place {
            model.scroll = place.saturating_sub(height / 3);
        }
        model.follow = false;
    }
    model.scroll = model.scroll.min(lines.len().saturating_sub(height));
}

fn press(model: &mut LessonModel, key: KeyEvent) -> bool {
    let special = KeyModifiers::CONTROL | KeyModifiers::ALT;
    if model.overlay.is_none()
        && !key.modifiers.intersects(special)
        && let Some(attempt) = &mut model.attempt
        && let AttemptPlace::Here(ask) = &mut attempt.place
    {
        let told = match ask.press(key.code) {
            AskKey::Other => None,
            AskKey::Taken => Some(None),
            AskKey::Wrong(told) => Some(Some(told)),
        };
        if let Some(told) = told {
            model.message = told;
            return true;
        }
        if key.code == KeyCode::Enter && !ask.is_open() {
            answering::go_on(model);
            settle(model);
            return true;
        }
    }
    let Some(action) = lesson_action(key) else {
        return false;
    };
    act(model, action);
    settle(model);
    true
}

/// Does what a reader asks for.
pub fn act(model: &mut LessonModel, action: LessonAction) {
    model.message = None;
    if action != LessonAction::Solution {
        model.gives_up = None;
    }
    match action {
        LessonAction::Quit => model.request = Request::Quit,
        LessonAction::Suspend => model.request = Request::Suspend,
        LessonAction::Back => back(model),
        LessonAction::Help => {
            let is_there = matches!(model.overlay, Some(LessonOverlay::Help(_)));
            model.overlay = (!is_there).then_some(LessonOverlay::Help(0));
        }
        LessonAction::Mouse => {
            model.options.mouse = !model.options.mouse;
            let told = if model.options.mouse {
                "the mouse scrolls and chooses"
            } else {
                "the mouse is the terminal's: select text with it; m takes it back"
            };
            model.message = Some(told.to_owned());
        }
        LessonAction::Scroll(by) => scroll(model, by),
        LessonAction::Page(by) => {
            let page = i32::from(inside(model.panes().text).height.max(2)) - 1;
            scroll(model, by * page);
        }
        LessonAction::Begin => match model.overlay.take() {
            Some(LessonOverlay::Chapters(chosen)) => open(model, chosen),
            Some(_) => {}
            None => answering::begin(model),
        },
        // Any other key closes what lies on top.
        _ if model.overlay.is_some() => model.overlay = None,
        LessonAction::Chapters => model.overlay = Some(LessonOverlay::Chapters(model.chapter)),
        LessonAction::Picture => model.large = !model.large,
        LessonAction::Hint => answering::hint(model),
        LessonAction::Solution => answering::solution(model),
        // What is asked here is answered or left first.
        _ if model.attempt.is_some() => {
            model.message = Some("answer the question, or leave it by q".to_owned());
        }
        LessonAction::NextOpen => next_open(model),
        LessonAction::Exercise(by) => choose(model, by),
        LessonAction::Chapter(by) => {
            let last = model.course.chapters.len().saturating_sub(1);
            let to = model.chapter.saturating_add_signed(by as isize).min(last);
            if to == model.chapter {
                let end = if by > 0 { "last" } else { "first" };
                model.message = Some(format!("this is the {end} chapter"));
            } else {
                open(model, to);
            }
        }
    }
}

/// Opens a chapter at its start, with its first open exercise chosen.
pub fn open(model: &mut LessonModel, chapter: usize) {
    if model.attempt.is_some() {
        model.message = Some("answer the question, or leave it by q".to_owned());
        return;
    }
    model.chapter = chapter.min(model.course.chapters.len().saturating_sub(1));
    let progress = model.progress.progress();
    let exercises = &model.chapter().exercises;
    let first = exercises.iter().position(|e| !progress.is_over(&e.id));
    model.chosen = first.unwrap_or(0);
    (model.scroll, model.follow) = (0, false);
    let folder = model.chapter().folder.clone();
    model.progress.change(|progress| progress.chapter = folder);
}

/// To the next exercise that is open, behind the chosen one.
fn next_open(model: &mut LessonModel) {
    let progress = model.progress.progress();
    let is_open = |id: &str| !progress.is_over(id);
    let here = model.exercise().map(|exercise| exercise.id.clone());
    let all: Vec<(usize, usize, String)> = model
        .course
        .chapters
        .iter()
        .enumerate()
        .flat_map(|(c, chapter)| {
            let exercises = chapter.exercises.iter().enumerate();
            exercises.map(move |(e, exercise)| (c, e, exercise.id.clone()))
        })
        .collect();
    let here = all.iter().position(|(c, e, id)| {
        (*c, *e) == (model.chapter, model.chosen) && Some(id) == here.as_ref()
    });
    let behind = here.map_or(0, |here| here + 1);
    let order = all[behind..].iter().chain(&all[..behind]);
    let mut open_ones = order.filter(|(c, e, id)| {
        let optional = model.course.chapters[*c].exercises[*e].optional;
        is_open(id) && !optional
    });
    let Some((chapter, exercise, _)) = open_ones.next().cloned() else {
        model.message = Some("all exercises are done".to_owned());
        return;
    };
    if chapter != model.chapter {
        open(model, chapter);
    }
    (model.chosen, model.follow) = (exercise, true);
}

fn choose(model: &mut LessonModel, by: i32) {
    let last = model.chapter().exercises.len().saturating_sub(1);
    model.chosen = model.chosen.saturating_add_signed(by as isize).min(last);
    model.follow = true;
}

fn scroll(model: &mut LessonModel, by: i32) {
    let screen = model.screen;
    let chapters = model.course.chapters.len();
    match &mut model.overlay {
        Some(LessonOverlay::Chapters(chosen)) => {
            *chosen = chosen
                .saturating_add_signed(by as isize)
                .min(chapters.saturating_sub(1));
        }
        Some(LessonOverlay::Help(scroll)) => {
            let last = help::last_help(screen);
            *scroll = scroll.saturating_add_signed(by as i16).min(last);
        }
        Some(LessonOverlay::Text(_, text, scroll)) => {
            let last = panes::last_text(text, screen);
            *scroll = scroll.saturating_add_signed(by as i16).min(last);
        }
        None => {
            model.scroll = model.scroll.saturating_add_signed(by as isize);
            model.follow = false;
        }
    }
}

/// Closes what lies on top; at the bottom, leaves.
fn back(model: &mut LessonModel) {
    if model.overlay.take().is_some() {
        return;
    }
    if std::mem::take(&mut model.large) {
        return;
    }
    if model.attempt.take().is_none() {
        model.request = Request::Quit;
    }
}

fn point(model: &mut LessonModel, mouse: Mouse, at: Position) {
    model.message = None;
    if let Mouse::Wheel(by) = mouse {
        scroll(model, by);
        return;
    }
    let panes = model.panes();
    if mouse != Mouse::Press || model.overlay.is_some() || model.attempt.is_some() {
        return;
    }
    let row = |area: ratatui::layout::Rect| {
        let room = inside(area);
        room.contains(at).then(|| usize::from(at.y - room.y))
    };
    if let Some(row) = row(panes.chapters) {
        let first = panes::first_of(model.chapter, inside(panes.chapters).height);
        if first + row < model.course.chapters.len() {
            open(model, first + row);
        }
    } else if let Some(row) = row(panes.exercises) {
        let first = panes::first_of(model.chosen, inside(panes.exercises).height);
        if first + row < model.chapter().exercises.len() {
            (model.chosen, model.follow) = (first + row, true);
        }
    } else if let Some(row) = row(panes.text) {
        let line = model.lines().into_iter().nth(model.scroll + row);
        if let Some(exercise) = line.and_then(|line| line.exercise) {
            model.chosen = exercise;
        }
    }
}
