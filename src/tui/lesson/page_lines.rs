//! Page of a chapter as lines: text, what the program printed, where exercises and pictures stand.

use ratatui::style::{Style, Stylize as _};
use ratatui::text::{Line, Span};

use super::words::styled;
use crate::lesson::markdown::{self, TextBlock};
use crate::lesson::page::PagePart;
use crate::lesson::plain;
use crate::lesson::progress::Done;
use crate::lesson::{Chapter, Exercise, ExerciseKind};
use crate::scene::printable::printable;
use crate::tui::panes::text::wrap;
use crate::tui::panes::theme;

/// A line of a page.
#[derive(Clone, Debug, Default)]
pub struct PageLine {
    /// The line.
    pub line: Line<'static>,
    /// The number of the exercise, among the chapter's, that begins here.
    pub exercise: Option<usize>,
    /// The number of the part of the page whose picture belongs to what follows.
    pub picture: Option<usize>,
}

/// The lines of a page in so many columns; `done` tells what was done of an exercise, `chosen` is the chosen one.
pub fn page_lines(
    parts: &[PagePart],
    chapter: &Chapter,
    chosen: usize,
    done: &impl Fn(&str) -> Done,
    width: usize,
) -> Vec<PageLine> {
    let mut lines: Vec<PageLine> = Vec::new();
    for (number, part) in parts.iter().enumerate() {
        match part {
            PagePart::Text(text) => lines.extend(text_lines(text, width)),
            PagePart::Block(name, text) => {
                lines.push(of(Line::from(name.clone()).style(theme::dim())));
                lines.extend(text.lines().flat_map(|line| code(line, width)));
                lines.push(PageLine::default());
            }
            PagePart::Picture(picture) => {
                let told = format!("[picture: {}]", picture.caption());
                let mut told: Vec<PageLine> = wrap(&told, width)
                    .into_iter()
                    .map(|line| of(Line::from(line).style(theme::dim())))
                    .collect();
                if let Some(first) = told.first_mut() {
                    first.picture = Some(number);
                }
                lines.extend(told);
                lines.push(PageLine::default());
            }
            PagePart::Exercise(id) => {
                let place = chapter.exercises.iter().position(|e| e.id == *id);
                if let Some(place) = place {
                    let exercise = &chapter.exercises[place];
                    let done = done(id);
                    lines.extend(offered(exercise, place, place == chosen, &done, width));
                }
            }
        }
    }
    lines
}

fn of(line: Line<'static>) -> PageLine {
    PageLine {
        line,
        ..PageLine::default()
    }
}

/// Markdown in lines. What cannot be read is shown as it is.
pub fn text_lines(text: &str, width: usize) -> Vec<PageLine> {
    match markdown::blocks(text) {
        Ok(blocks) => {
            let mut lines = Vec::new();
            for (number, block) in blocks.iter().enumerate() {
                lines.extend(block_lines(block, width));
                let is_last_item = is_item(block) && !blocks.get(number + 1).is_some_and(is_item);
                lines.extend(is_last_item.then(PageLine::default));
            }
            lines
        }
        Err(_) => text
            .lines()
            .flat_map(|line| wrap(line, width))
            .map(|l| of(Line::from(l)))
            .collect(),
    }
}

fn is_item(block: &TextBlock) -> bool {
    matches!(block, TextBlock::Item(..))
}

/// The lines of a block and a blank one; items of a list stand close together.
fn block_lines(block: &TextBlock, width: usize) -> Vec<PageLine> {
    let blank = PageLine::default();
    let mut lines: Vec<PageLine> = match block {
        TextBlock::Heading(level, words) => {
            let lines = wrap(&markdown::plain(words), width).into_iter();
            let style = match level {
                1 => Style::new().bold().underlined(),
                _ => Style::new().bold(),
            };
            lines
                .map(|line| of(Line::from(Span::styled(line, style))))
                .collect()
        }
        TextBlock::Paragraph(words) => styled(words, width, "", "").into_iter().map(of).collect(),
        TextBlock::Item(depth, mark, words) => {
            let first = format!("{}{mark} ", "  ".repeat(depth.saturating_sub(1)));
            let next = " ".repeat(first.chars().count());
            return styled(words, width, &first, &next)
                .into_iter()
                .map(of)
                .collect();
        }
        TextBlock::Quote(words) => styled(words, width, "│ ", "│ ")
            .into_iter()
            .map(of)
            .collect(),
        TextBlock::Code(code_lines) => code_lines
            .iter()
            .flat_map(|line| code(&format!("  {line}"), width))
            .collect(),
        TextBlock::Table(rows) => plain::table(rows)
            .iter()
            .flat_map(|line| code(line, width))
            .collect(),
    };
    lines.push(blank);
    lines
}

/// A line that is shown as it is; where it is too long it goes on below, one step in.
fn code(line: &str, width: usize) -> Vec<PageLine> {
    let letters: Vec<char> = printable(line).chars().collect();
    let mut parts = Vec::new();
    let mut rest = &letters[..];
    loop {
        let indent = if parts.is_empty() { "" } else { "    " };
        let room = width.saturating_sub(indent.len()).max(4).min(rest.len());
        let (part, more) = rest.split_at(place_to_break(rest, room));
        let text = format!("{indent}{}", part.iter().collect::<String>());
        parts.push(of(Line::from(Span::styled(
            text,
            Style::new().fg(theme::code()),
        ))));
        if more.is_empty() {
            return parts;
        }
        let blanks = more.iter().take_while(|c| **c == ' ').count();
        rest = &more[blanks..];
    }
}

/// Where a line of code is broken that has room for so many letters: before a remark behind it, else between two words.
fn place_to_break(letters: &[char], room: usize) -> usize {
    if room >= letters.len() {
        return room;
    }
    let start = letters.iter().take_while(|c| **c == ' ').count();
    let blank = |i: &usize| letters[*i] == ' ';
    let remark = (start + 1..room)
        .rev()
        .find(|i| blank(i) && letters.get(i + 1) == Some(&' '));
    // A remark may have many blanks before it.
    let first = remark.map(|i| (start..=i).rev().take_while(blank).last().unwrap_or(i));
    let word = || (start + 1..=room).rev().find(blank);
    first.filter(|i| *i > start).or_else(word).unwrap_or(room)
}

/// Where an exercise is offered: its state, its name, its kind, what is asked.
fn offered(
    exercise: &Exercise,
    place: usize,
    is_chosen: bool,
    done: &Done,
    width: usize,
) -> Vec<PageLine> {
    let pointer = if is_chosen { theme::POINTER } else { " " };
    let optional = if exercise.optional { ", optional" } else { "" };
    let begin = if is_chosen { "  Enter begins" } else { "" };
    let head = Line::from(vec![
        Span::raw(pointer).bold(),
        Span::raw(format!(" {} ", sign(done))),
        Span::raw(exercise.id.clone()).bold(),
        Span::raw(format!("  {}{optional}", exercise.kind.name())).style(theme::dim()),
        Span::styled(begin, theme::keycap()),
    ]);
    let mut lines = vec![PageLine {
        line: head,
        exercise: Some(place),
        picture: None,
    }];
    let says = match &exercise.kind {
        ExerciseKind::Choose { says, .. } => says.as_str(),
        _ => "",
    };
    for text in [says, exercise.text.as_str()] {
        if !text.is_empty() {
            let words = markdown::words(text);
            lines.extend(styled(&words, width, "    ", "    ").into_iter().map(of));
        }
    }
    lines.push(PageLine::default());
    lines
}

/// The sign of what was done: a tick, a skipped one, or nothing.
pub fn sign(done: &Done) -> &'static str {
    match done {
        Done { given_up: true, .. } => "-",
        Done { done: true, .. } => "✓",
        Done { skipped: true, .. } => "»",
        Done { tries: 1.., .. } => "·",
        _ => " ",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tui::panes::text::columns;

    #[test]
    fn no_line_is_wider_than_the_page() {
        let text = "# A *long* heading of many words\n\nA paragraph with `code_that_is_long`.\n\n- one item that goes on\n- two\n\n\
                    > said by somebody else\n\n    P + t L,  0 < t < |light - P|        here\n\n| a | b |\n|---|---|\n| 1 | 2 |\n";
        for width in 12..60 {
            let lines = text_lines(text, width);
            assert!(lines.len() > 8);
            for line in lines {
                let told = line.line.to_string();
                assert!(columns(&told) <= width, "{width}: {told}");
            }
        }
    }
}
