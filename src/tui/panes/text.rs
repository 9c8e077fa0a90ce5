//! Text in cells: lines cut at a width, and wrapping by display columns.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::text::{Line, Span};
use textwrap::{Options, WordSeparator, WordSplitter, WrapAlgorithm};

/// Writes a line at a cell of the screen; one that is wider than `width` ends in `…`.
pub fn write(buffer: &mut Buffer, x: u16, y: u16, line: &Line, width: u16) {
    if !buffer.area.contains((x, y).into()) {
        return;
    }
    let width = width.min(buffer.area.right() - x);
    buffer.set_line(x, y, line, width);
    // Blanks at its end say nothing.
    let is_cut = line.width() > usize::from(width) && {
        let text = line.to_string();
        columns(text.trim_end()) > usize::from(width)
    };
    if let Some(last) = width.checked_sub(1).filter(|_| is_cut)
        && let Some(cell) = buffer.cell_mut((x + last, y))
    {
        cell.set_symbol("…");
    }
}

/// Arrows at the right of a frame around `area`: there is more above, there is more below.
pub fn arrows(buffer: &mut Buffer, area: Rect, above: bool, below: bool) {
    let x = area.right().saturating_sub(2);
    for (is_more, y, arrow) in [
        (above, area.y.saturating_sub(1), "▲"),
        (below, area.bottom(), "▼"),
    ] {
        if is_more && let Some(cell) = buffer.cell_mut((x, y)) {
            cell.set_symbol(arrow);
        }
    }
}

/// Breaks a text at its spaces into lines of at most `width` columns; longer words are cut.
pub fn wrap(text: &str, width: usize) -> Vec<String> {
    let options = Options::new(width.max(1))
        .word_separator(WordSeparator::AsciiSpace)
        .word_splitter(WordSplitter::NoHyphenation)
        .wrap_algorithm(WrapAlgorithm::FirstFit);
    let lines = textwrap::wrap(text, options).into_iter();
    lines.map(std::borrow::Cow::into_owned).collect()
}

/// How many columns a text takes.
pub fn columns(text: &str) -> usize {
    Span::raw(text).width()
}

/// A text with blanks behind it, so many columns wide.
pub fn padded(text: &str, width: usize) -> String {
    let blanks = width.saturating_sub(columns(text));
    format!("{text}{:blanks$}", "")
}

/// A text of at most `width` columns: its beginning and `…` if it is longer.
pub fn shortened(text: &str, width: usize) -> String {
    if columns(text) <= width {
        return text.to_owned();
    }
    let mut short = String::new();
    for letter in text.chars() {
        short.push(letter);
        if columns(&short) >= width {
            short.pop();
            break;
        }
    }
    short + "…"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrapped_lines_fit() {
        assert_eq!(wrap("one two three", 7), ["one two", "three"]);
        assert_eq!(wrap("abcdefgh ij", 3), ["abc", "def", "gh", "ij"]);
        assert_eq!(wrap("", 5), [""]);
        for width in 1..20 {
            let lines = wrap("the plane is crossed behind the interval", width);
            assert!(
                lines.iter().all(|l| l.chars().count() <= width),
                "{lines:?}"
            );
        }
    }

    #[test]
    fn wide_letters_take_two_columns() {
        assert_eq!(wrap("球球球 a", 4), ["球球", "球 a"]);
        assert_eq!(padded("球", 4), "球  ");
        assert_eq!(padded("long", 2), "long");
        assert_eq!(shortened("球球球", 6), "球球球");
        assert_eq!(shortened("球球球", 5), "球球…");
        assert_eq!(shortened("球球球", 4), "球…");
        assert_eq!(shortened("long", 1), "…");
    }
}
