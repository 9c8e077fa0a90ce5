//! The line of keys at the bottom, with the prompt and the message.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Stylize as _;
use ratatui::text::{Line, Span};
use ratatui::widgets::{Clear, Widget as _};

use super::text::{columns, wrap, write};
use super::theme;
use crate::tui::model::bindings::ACTIONS;
use crate::tui::model::examples::has_any;
use crate::tui::model::{Context, Model, Overlay, Panes, Prompt};

/// What stands at the end of the hints if there are more.
const MORE: &str = " ... ?";

/// What a prompt asks for.
fn label(model: &Model, prompt: Prompt) -> String {
    match (prompt, &model.session) {
        (Prompt::Search, _) => "find".to_owned(),
        (Prompt::GoTo, Some(session)) => {
            let last = session.tree().events.len().saturating_sub(1);
            format!("event (0 to {last}) or address")
        }
        (Prompt::GoTo, None) => "pixel or address".to_owned(),
        (Prompt::Set, _) => "set (flag=value or kind.name.field=value)".to_owned(),
        (Prompt::Note, _) => "note".to_owned(),
        (Prompt::WritePatch, _) => "new file for the patch".to_owned(),
        (Prompt::Write, _) => "new file for the marks".to_owned(),
        (Prompt::Break, _) => "break at".to_owned(),
        (Prompt::Compare, _) => "compare with X,Y, flag=value or a file".to_owned(),
    }
}

/// A prompt with what was typed: of a long text the end.
fn asked(model: &Model, prompt: Prompt, text: &str, width: usize) -> String {
    let mut label = label(model, prompt);
    if columns(&label) > width / 2 {
        label = label.split(' ').next().unwrap_or_default().to_owned();
    }
    let room = width.saturating_sub(columns(&label) + 6).max(4);
    let mut end = text;
    while columns(end) > room {
        let first = end.chars().next().map_or(1, char::len_utf8);
        end = &end[first..];
    }
    let cut = if end.len() < text.len() { "…" } else { "" };
    format!(" {label}: {cut}{end}▏ ")
}

/// The message where it does not fit into the line of hints: above it, as many lines as it takes.
pub fn message(model: &Model, panes: &Panes, buffer: &mut Buffer) {
    let (Some(message), hint) = (&model.message, panes.hint) else {
        return;
    };
    if fits(message, hint) || hint.is_empty() {
        return;
    }
    let lines = wrap(message, usize::from(hint.width.saturating_sub(2)));
    let count = (lines.len() as u16).min(hint.y.saturating_sub(1));
    let area = Rect::new(hint.x, hint.y - count, hint.width, count);
    Clear.render(area, buffer);
    for (y, line) in (area.y..area.bottom()).zip(lines) {
        write(
            buffer,
            area.x + 1,
            y,
            &Line::from(line).bold(),
            area.width - 1,
        );
    }
}

/// True if a message leaves room for some hints, or for a prompt.
fn fits(message: &str, hint: Rect) -> bool {
    columns(message) + 2 <= usize::from(hint.width) * 5 / 8
}

/// What the keys do here, as many as there is room for.
pub fn hint(model: &Model, area: Rect, buffer: &mut Buffer) {
    if area.is_empty() {
        return;
    }
    let width = usize::from(area.width);
    let mut line = Line::default();
    let mut has_examples = true;
    if let Some(Overlay::Prompt(prompt, text)) = &model.overlay {
        let told = model.message.as_ref().filter(|m| fits(m, area));
        let room = width.saturating_sub(told.map_or(0, |m| columns(m) + 2));
        line.push_span(Span::raw(asked(model, *prompt, text, room)).bold());
        has_examples = has_any(*prompt);
    }
    if let Some(message) = model.message.as_ref().filter(|m| fits(m, area)) {
        line.push_span(Span::raw(format!(" {message} ")).bold());
    }
    for (key, name) in hints(model, has_examples) {
        let key = Span::styled(format!(" {key}"), theme::keycap());
        let name = Span::raw(format!(" {name} "));
        // Where keys are left out, that is said.
        let room = width.saturating_sub(columns(MORE));
        if line.width() + key.width() + name.width() > room {
            line.push_span(Span::raw(MORE).style(theme::dim()));
            break;
        }
        line.push_span(key);
        line.push_span(name);
    }
    write(buffer, area.x, area.y, &line, area.width);
}

/// The keys that are worth a hint here, the way out first, and what they do.
fn hints(model: &Model, has_examples: bool) -> Vec<(String, &'static str)> {
    let context = model.context();
    // Over the panes only its own keys are meant; where a text is typed, letters are letters.
    let is_alone = matches!(
        context,
        Context::Prompt | Context::Places | Context::Text | Context::Effects
    );
    let here = |c: Context| c == context || c == Context::Always && !is_alone;
    let mut bindings: Vec<_> = ACTIONS
        .iter()
        .filter(|b| b.hint && here(b.context))
        .collect();
    bindings.retain(|b| b.name != "examples" || has_examples);
    // Help and back are always in sight.
    bindings.sort_by_key(|b| !matches!(b.name, "help" | "back"));
    let name = |name: &'static str| match name {
        "back" if model.overlay.is_some() => "close",
        "back" if context == Context::Picture => "quit",
        name => name,
    };
    let mut hints: Vec<_> = bindings
        .iter()
        .map(|b| (b.short_label(), name(b.name)))
        .collect();
    if is_alone {
        hints.insert(0, ("Esc".to_owned(), "close"));
    }
    hints
}
