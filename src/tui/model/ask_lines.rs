//! Lines of a question as text, so that the layout knows how many there are.

use ratatui::layout::Rect;

use super::ask::{AskKind, AskState, MOST_KEYS};
use crate::tui::panes::text::{columns, wrap};

/// Rows that are left to the panes at least.
const PANES: u16 = 12;

/// What a line is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AskPart {
    /// What is asked.
    Question,
    /// A hint.
    Hint,
    /// Whether the answer is right.
    Verdict,
    /// More of what is told.
    Told,
    /// Where the answer is typed.
    Typed,
    /// What can be chosen, or how to answer.
    Choice,
}

/// The lines for so many columns.
pub fn ask_lines(ask: &AskState, width: u16) -> Vec<(AskPart, String)> {
    let width = usize::from(width.max(10));
    let mut lines = Vec::new();
    let mut add = |part: AskPart, text: &str| {
        for paragraph in text.lines() {
            lines.extend(wrap(paragraph, width).into_iter().map(|line| (part, line)));
        }
    };
    add(AskPart::Question, &ask.text);
    for (number, hint) in ask.shown.iter().enumerate() {
        add(AskPart::Hint, &format!("hint {}: {hint}", number + 1));
    }
    if let Some(told) = &ask.told {
        let (first, rest) = told.text.split_once('\n').unwrap_or((&told.text, ""));
        add(AskPart::Verdict, first);
        add(AskPart::Told, rest);
        if !ask.takes_answers() {
            return lines;
        }
    }
    match &ask.kind {
        AskKind::Word(words) => {
            lines.extend(choices(words, width));
            if words.len() > MOST_KEYS {
                lines.push((AskPart::Typed, format!("its number: {}▏", ask.typed)));
            }
        }
        AskKind::Value(asks) => lines.push((AskPart::Typed, format!("{asks}: {}▏", ask.typed))),
        AskKind::Pixel => add(
            AskPart::Choice,
            "Enter checks the pixel under the cursor; Space opens its ray tree",
        ),
        AskKind::Law { .. } => add(
            AskPart::Choice,
            "go to the first wrong step, then b names the law that is broken",
        ),
    }
    lines
}

/// Words with their numbers: in a line if there is room, else one below the other.
fn choices(words: &[String], width: usize) -> Vec<(AskPart, String)> {
    let numbered = words
        .iter()
        .zip(1..)
        .map(|(word, n)| format!("{n}) {word}"));
    let numbered: Vec<String> = numbered.collect();
    let line = numbered.join("    ");
    if columns(&line) <= width {
        return vec![(AskPart::Choice, line)];
    }
    let mut lines = Vec::new();
    for word in numbered {
        for (row, part) in wrap(&word, width.saturating_sub(2).max(8))
            .into_iter()
            .enumerate()
        {
            let indent = if row == 0 { "" } else { "  " };
            lines.push((AskPart::Choice, format!("{indent}{part}")));
        }
    }
    lines
}

/// How many rows a question takes of a screen.
pub fn ask_rows(ask: &AskState, screen: Rect) -> u16 {
    let rows = ask_lines(ask, screen.width.saturating_sub(2)).len() as u16 + 2;
    let least = 3.min(screen.height / 3);
    rows.min(screen.height.saturating_sub(PANES)).max(least)
}
