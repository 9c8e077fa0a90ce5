//! View of the lesson screen: chapters and exercises, the text, the picture, and what lies over them.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Style, Stylize as _};
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, BorderType, Widget};

use super::attempt::AttemptPlace;
use super::help::help;
use super::keys::LESSON_KEYS;
use super::layout::LessonPanes;
use super::model::{LessonModel, LessonOverlay};
use super::page_lines::{sign, text_lines};
use crate::tui::model::inside;
use crate::tui::model::layout::covered;
use crate::tui::model::placement::Placement;
use crate::tui::panes::hints::{keys_line, told_above};
use crate::tui::panes::text::{arrows, columns, shortened, write};
use crate::tui::panes::{self, text_box, theme};

/// Columns of texts at most.
const TEXT: u16 = 100;

/// Draws the model.
pub fn draw(model: &LessonModel, screen: Rect, buffer: &mut Buffer) {
    if let Some(AttemptPlace::Debugger(program)) = model.attempt.as_ref().map(|a| &a.place) {
        panes::draw(&program.model, screen, buffer);
        return;
    }
    let panes = model.panes();
    title(model, panes.title, buffer);
    chapters(model, panes.chapters, buffer);
    exercises(model, panes.exercises, buffer);
    text(model, panes.text, buffer);
    picture(model, panes.picture, buffer);
    if let Some(AttemptPlace::Here(ask)) = model.attempt.as_ref().map(|a| &a.place) {
        panes::ask::draw(ask, panes.ask, buffer);
    }
    over(model, covered(screen), buffer);
    keys_line(model.message.as_deref(), keys(model), panes.hint, buffer);
    told_above(model.message.as_deref(), panes.hint, buffer);
    theme::quantize_colors(buffer, model.options.color);
}

fn title(model: &LessonModel, area: Rect, buffer: &mut Buffer) {
    let (done, all) = model.done_in_all();
    let (chapter, count) = (model.chapter + 1, model.course.chapters.len());
    let told = format!("{done} of {all} done, chapter {chapter} of {count} ");
    let room = usize::from(area.width).saturating_sub(columns(&told) + 2);
    let name = shortened(&model.course.title, room);
    let gap = room.saturating_sub(columns(&name));
    let line = Line::from(vec![
        Span::raw(format!(" {name}{:gap$} ", "")).bold(),
        Span::raw(told),
    ]);
    write(buffer, area.x, area.y, &line, area.width);
}

/// A frame with a title; its inside.
fn framed(area: Rect, title: &str, has_keys: bool, buffer: &mut Buffer) -> Rect {
    if area.width < 3 || area.height < 3 {
        return Rect::default();
    }
    let title = shortened(title, usize::from(area.width - 3));
    let mut block = Block::bordered().border_style(theme::dim());
    let mut title = Line::raw(title);
    if has_keys {
        block = block
            .border_type(BorderType::Double)
            .border_style(Style::new().bold());
        title = title.bold();
    }
    block.title(title).render(area, buffer);
    inside(area)
}

/// The first row of a list of which the current one stands in the middle or, at the start of the list, where it is.
pub fn first_of(current: usize, height: u16) -> usize {
    current.saturating_sub(usize::from(height) / 2)
}

/// A row of a list with what stands at its right.
fn row(is_current: bool, text: &str, end: &str, area: Rect, y: u16, buffer: &mut Buffer) {
    let pointer = if is_current { theme::POINTER } else { " " };
    let room = usize::from(area.width).saturating_sub(columns(end) + 3);
    let text = shortened(text, room);
    let gap = room.saturating_sub(columns(&text));
    let line = Line::from(vec![
        Span::raw(pointer).bold(),
        Span::raw(format!(" {text}{:gap$} ", "")),
        Span::raw(end.to_owned()).style(theme::dim()),
    ]);
    write(buffer, area.x, y, &line, area.width);
    if is_current {
        let rest = Rect::new(area.x + 1, y, area.width.saturating_sub(1), 1);
        buffer.set_style(rest.intersection(buffer.area), theme::current());
    }
}

fn chapters(model: &LessonModel, area: Rect, buffer: &mut Buffer) {
    let room = framed(area, " chapters ", false, buffer);
    let first = first_of(model.chapter, room.height);
    let all = model.course.chapters.iter().enumerate().skip(first);
    for (y, (number, chapter)) in (room.y..room.bottom()).zip(all) {
        let (done, count) = model.done_in(number);
        let name = format!("{:>2} {}", chapter.number, chapter.title);
        let end = format!("{done}/{count}");
        row(number == model.chapter, &name, &end, room, y, buffer);
    }
    let below = first + usize::from(room.height) < model.course.chapters.len();
    if !room.is_empty() {
        arrows(buffer, room, first > 0, below);
    }
}

fn exercises(model: &LessonModel, area: Rect, buffer: &mut Buffer) {
    let room = framed(area, " exercises ", false, buffer);
    let first = first_of(model.chosen, room.height);
    let exercises = &model.chapter().exercises;
    for (y, (number, exercise)) in
        (room.y..room.bottom()).zip(exercises.iter().enumerate().skip(first))
    {
        let name = format!("{} {}", sign(&model.done(&exercise.id)), exercise.id);
        row(
            number == model.chosen,
            &name,
            exercise.kind.name(),
            room,
            y,
            buffer,
        );
    }
    let below = first + usize::from(room.height) < exercises.len();
    if !room.is_empty() {
        arrows(buffer, room, first > 0, below);
    }
}

fn text(model: &LessonModel, area: Rect, buffer: &mut Buffer) {
    let chapter = model.chapter();
    let title = format!(" {} {} ", chapter.number, chapter.title);
    let room = framed(area, &title, true, buffer);
    if room.is_empty() {
        return;
    }
    let lines = model.lines();
    let first = model.scroll.min(lines.len());
    for (y, line) in (room.y..room.bottom()).zip(&lines[first..]) {
        write(
            buffer,
            room.x + 1,
            y,
            &line.line,
            room.width.saturating_sub(1),
        );
    }
    let below = first + usize::from(room.height) < lines.len();
    arrows(buffer, room, first > 0, below);
}

fn picture(model: &LessonModel, area: Rect, buffer: &mut Buffer) {
    let caption = model
        .picture
        .as_ref()
        .map_or("picture", |p| p.caption.as_str());
    let room = framed(area, &format!(" {caption} "), model.large, buffer);
    let Some(shown) = model.picture.as_ref().filter(|_| !room.is_empty()) else {
        return;
    };
    let inner = &shown.program.model;
    let placement = Placement::new(inner.picture.window, room);
    panes::picture::pixels(inner, &placement, buffer);
    for at in &shown.marks {
        panes::picture::mark(inner, &placement, *at, buffer);
    }
}

/// What lies over everything.
fn over(model: &LessonModel, screen: Rect, buffer: &mut Buffer) {
    let (title, lines, (width, scroll)) = match &model.overlay {
        None => return,
        Some(LessonOverlay::Help(scroll)) => {
            let width = text_box::room(screen, 0);
            ("keys", help(width), (width, *scroll))
        }
        Some(LessonOverlay::Text(title, text, scroll)) => {
            let width = text_box::room(screen, TEXT);
            (title.as_str(), in_lines(text, width), (width, *scroll))
        }
        Some(LessonOverlay::Chapters(chosen)) => {
            let width = text_box::room(screen, 0).min(60);
            let height = screen.height.saturating_sub(2);
            let first = (*chosen + 1).saturating_sub(usize::from(height));
            let lines = list(model, *chosen, usize::from(width));
            ("go to chapter", lines, (width, first as u16))
        }
    };
    text_box::draw(title, &lines, (width, scroll), screen, buffer);
}

fn list(model: &LessonModel, chosen: usize, width: usize) -> Vec<Line<'static>> {
    let lines = model.course.chapters.iter().enumerate();
    let lines = lines.map(|(number, chapter)| {
        let (done, all) = model.done_in(number);
        let pointer = if number == chosen {
            theme::POINTER
        } else {
            " "
        };
        let end = format!("{done}/{all}");
        let name = format!("{pointer}{:>2} {}", chapter.number, chapter.title);
        let name = shortened(&name, width.saturating_sub(8));
        let gap = width.saturating_sub(columns(&name) + columns(&end) + 1);
        let line = Line::from(format!("{name}{:gap$}{end} ", ""));
        if number == chosen {
            line.style(theme::current())
        } else {
            line
        }
    });
    lines.collect()
}

fn in_lines(text: &str, width: u16) -> Vec<Line<'static>> {
    let lines = text_lines(text, usize::from(width));
    lines.into_iter().map(|line| line.line).collect()
}

/// How far a text can be scrolled.
pub fn last_text(text: &str, screen: Rect) -> u16 {
    let screen = covered(screen);
    let width = text_box::room(screen, TEXT);
    text_box::last_scroll(screen, in_lines(text, width).len())
}

/// The keys that are worth a hint here.
fn keys(model: &LessonModel) -> Vec<(String, String)> {
    let key = |key: &str, name: &str| (key.to_owned(), name.to_owned());
    if model.overlay.is_some() {
        let is_list = matches!(model.overlay, Some(LessonOverlay::Chapters(_)));
        let mut keys = vec![
            key("q", "close"),
            key("↓ ↑", if is_list { "choose" } else { "scroll" }),
        ];
        if is_list {
            keys.push(key("Enter", "go there"));
        }
        return keys;
    }
    if let Some(attempt) = &model.attempt {
        let mut keys = attempt
            .ask()
            .map_or_else(Vec::new, panes::hints::of_question);
        keys.extend([key("↓ ↑", "scroll"), key("q", "leave")]);
        return keys;
    }
    let mut shown: Vec<_> = LESSON_KEYS.iter().filter(|b| b.hint).collect();
    // Help and the way out are always in sight.
    shown.sort_by_key(|b| !matches!(b.name, "help" | "back" | "begin"));
    let name = |name: &'static str| match name {
        "back" if !model.large => "leave",
        name => name,
    };
    shown
        .iter()
        .map(|b| key(&b.label(), name(b.name)))
        .collect()
}

/// The panes that a picture has room in, as cells.
pub fn picture_cells(panes: &LessonPanes) -> (u16, u16) {
    let room = inside(panes.picture);
    (room.width, room.height)
}
