//! Words with styles in lines of a width.

use ratatui::style::{Modifier, Style};
use ratatui::text::{Line, Span};

use crate::lesson::markdown::{WordStyle, Words};
use crate::scene::printable::printable;
use crate::tui::panes::text::columns;
use crate::tui::panes::theme;

/// Lines of words: the first one begins with `first`, the others with `next`. Words that are longer than a line are cut.
pub fn styled(words: &Words, width: usize, first: &str, next: &str) -> Vec<Line<'static>> {
    let mut lines = Vec::new();
    let start = |text: &str| vec![Span::raw(text.to_owned())];
    let (mut line, mut used) = (start(first), columns(first));
    let mut is_new = true;
    for token in tokens(words) {
        let length: usize = token.iter().map(|(text, _)| columns(text)).sum();
        if !is_new && used + 1 + length > width {
            lines.push(Line::from(std::mem::replace(&mut line, start(next))));
            (used, is_new) = (columns(next), true);
        }
        if !is_new {
            line.push(Span::raw(" "));
            used += 1;
        }
        for (text, style) in token {
            for letter in text.chars() {
                let letter = letter.to_string();
                let wide = columns(&letter);
                if used + wide > width && used > columns(next) {
                    lines.push(Line::from(std::mem::replace(&mut line, start(next))));
                    used = columns(next);
                }
                used += wide;
                push(&mut line, &letter, look(style));
            }
        }
        is_new = false;
    }
    lines.push(Line::from(line));
    lines
}

/// Adds a letter to the last run if that looks alike.
fn push(line: &mut Vec<Span<'static>>, letter: &str, style: Style) {
    match line.last_mut() {
        Some(last) if last.style == style && last.content != " " => {
            last.content.to_mut().push_str(letter);
        }
        _ => line.push(Span::styled(letter.to_owned(), style)),
    }
}

/// What stands between blanks, in runs of one style.
fn tokens(words: &Words) -> Vec<Vec<(String, WordStyle)>> {
    let mut tokens: Vec<Vec<(String, WordStyle)>> = vec![Vec::new()];
    for (text, style) in words {
        let text = printable(text);
        let mut parts = text.split(char::is_whitespace);
        if let (Some(part), Some(last)) =
            (parts.next().filter(|p| !p.is_empty()), tokens.last_mut())
        {
            last.push((part.to_owned(), *style));
        }
        for part in parts {
            tokens.push(Vec::new());
            if let (false, Some(last)) = (part.is_empty(), tokens.last_mut()) {
                last.push((part.to_owned(), *style));
            }
        }
    }
    tokens.retain(|token| !token.is_empty());
    tokens
}

/// How words of a style look; none is told by colour alone.
fn look(style: WordStyle) -> Style {
    match style {
        WordStyle::Plain => Style::new(),
        WordStyle::Emphasis => Style::new().add_modifier(Modifier::ITALIC),
        WordStyle::Strong => Style::new().add_modifier(Modifier::BOLD),
        WordStyle::Code => Style::new().fg(theme::code()),
        WordStyle::Link => Style::new().add_modifier(Modifier::UNDERLINED),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(words: &Words, width: usize, first: &str, next: &str) -> Vec<String> {
        let lines = styled(words, width, first, next);
        lines.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn words_are_wrapped_at_blanks_whatever_their_style() {
        let words = vec![
            ("a light counts if ".to_owned(), WordStyle::Plain),
            ("nothing".to_owned(), WordStyle::Strong),
            (", not even ".to_owned(), WordStyle::Plain),
            ("glass".to_owned(), WordStyle::Code),
            (", stands between".to_owned(), WordStyle::Plain),
        ];
        let lines = told(&words, 20, "- ", "  ");
        assert_eq!(
            lines,
            [
                "- a light counts if",
                "  nothing, not even",
                "  glass, stands",
                "  between"
            ]
        );
        for width in 4..40 {
            for line in told(&words, width, "", "") {
                assert!(columns(&line) <= width, "{width}: {line}");
            }
        }
    }
}
