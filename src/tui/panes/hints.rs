//! The line of keys at the bottom, with the prompt and the message.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Stylize as _;
use ratatui::text::{Line, Span};
use ratatui::widgets::{Clear, Widget as _};

use super::text::{columns, wrap, write};
use super::theme;
use crate::tui::model::ask::{AskKind, AskState, HINTS_BEFORE_DIFFERENCE, MOST_KEYS};
use crate::tui::model::bindings::{ACTIONS, Binding};
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
        (Prompt::Watch, _) => "watch".to_owned(),
        (Prompt::Compare, _) => "compare with X,Y, flag=value, a scene or a file".to_owned(),
    }
}

/// A prompt with what was typed: of a long text what is around the place where letters are typed.
fn asked(model: &Model, prompt: Prompt, text: &str, width: usize) -> String {
    let mut label = label(model, prompt);
    if columns(&label) > width / 2 {
        label = label.split(' ').next().unwrap_or_default().to_owned();
    }
    let room = width.saturating_sub(columns(&label) + 7).max(4);
    let before = text.chars().count().saturating_sub(model.behind);
    let at = text
        .char_indices()
        .nth(before)
        .map_or(text.len(), |(at, _)| at);
    let (mut before, mut behind) = text.split_at(at);
    // What stands behind the bar takes half of the room at most, and more only where it is free.
    let least = (room / 2).max(room.saturating_sub(columns(before)));
    while columns(behind) > least {
        behind = &behind[..behind.char_indices().next_back().map_or(0, |(at, _)| at)];
    }
    while columns(before) + columns(behind) > room {
        let first = before.chars().next().map_or(1, char::len_utf8);
        before = &before[first..];
    }
    let sign = |is_cut: bool| if is_cut { "…" } else { "" };
    let (start, end) = (
        sign(before.len() < at),
        sign(at + behind.len() < text.len()),
    );
    format!(" {label}: {start}{before}▏{behind}{end} ")
}

/// The message where it does not fit into the line of hints: above it, as many lines as it takes.
pub fn message(model: &Model, panes: &Panes, buffer: &mut Buffer) {
    told_above(model.message.as_deref(), panes.hint, buffer);
}

/// A message above a line of hints in which it has no room.
pub fn told_above(message: Option<&str>, hint: Rect, buffer: &mut Buffer) {
    let Some(message) = message else {
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
    keys_behind(
        line,
        model.message.as_deref(),
        hints(model, has_examples),
        area,
        buffer,
    );
}

/// A line of keys with a message before them, if it has room there.
pub fn keys_line(
    message: Option<&str>,
    keys: Vec<(String, String)>,
    area: Rect,
    buffer: &mut Buffer,
) {
    if !area.is_empty() {
        keys_behind(Line::default(), message, keys, area, buffer);
    }
}

fn keys_behind(
    mut line: Line<'static>,
    message: Option<&str>,
    keys: Vec<(String, String)>,
    area: Rect,
    buffer: &mut Buffer,
) {
    let width = usize::from(area.width);
    if let Some(message) = message.as_ref().filter(|m| fits(m, area)) {
        line.push_span(Span::raw(format!(" {message} ")).bold());
    }
    for (key, name) in keys {
        let key = Span::styled(format!(" {key}"), theme::keycap());
        let name = Span::raw(format!(" {name} "));
        // Where keys are left out, that is said.
        let room = width.saturating_sub(columns(MORE));
        if line.width() + key.width() + name.width() > room {
            // A long text in a prompt leaves no room for that either.
            if line.width() <= room {
                line.push_span(Span::raw(MORE).style(theme::dim()));
            }
            break;
        }
        line.push_span(key);
        line.push_span(name);
    }
    write(buffer, area.x, area.y, &line, area.width);
}

/// The keys of a question, and what they do.
pub fn of_question(ask: &AskState) -> Vec<(String, String)> {
    let key = |key: &str, name: &str| (key.to_owned(), name.to_owned());
    if !ask.takes_answers() {
        return vec![key("Enter", "go on")];
    }
    let mut keys = match &ask.kind {
        AskKind::Word(words) => {
            let keys: Vec<String> = (1..=words.len().min(MOST_KEYS))
                .map(|n| n.to_string())
                .collect();
            vec![(keys.join(" "), "answer".to_owned())]
        }
        AskKind::Pixel => vec![key("Enter", "answer")],
        AskKind::Value(_) => vec![key("0-9 Enter", "answer")],
        AskKind::Law { .. } => vec![key("b", "name the law")],
    };
    if ask.is_of_a_bug() && ask.shown.len() >= HINTS_BEFORE_DIFFERENCE {
        keys.push(key("d", "difference"));
    }
    if ask.hints > 0 {
        let name = format!("hint ({} of {})", ask.shown.len(), ask.hints);
        keys.push(("H".to_owned(), name));
    }
    keys
}

/// The keys that are worth a hint here, the way out first, and what they do.
fn hints(model: &Model, has_examples: bool) -> Vec<(String, String)> {
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
        "back" if model.ask.is_some() => "leave",
        "back" if context == Context::Picture => "quit",
        name => name,
    };
    // While a pixel is asked for, Enter answers with it.
    let answers = model.ask.as_ref().is_some_and(|a| a.kind == AskKind::Pixel);
    let label = |b: &Binding| match b.keys {
        [_, (second, _)] if answers && b.name == "open its ray tree" => second.label(),
        _ => b.short_label(),
    };
    let mut hints: Vec<_> = bindings
        .iter()
        .map(|b| (label(b), name(b.name).to_owned()))
        .collect();
    if is_alone {
        hints.insert(0, ("Esc".to_owned(), "close".to_owned()));
    } else if let Some(ask) = &model.ask {
        hints.splice(0..0, of_question(ask));
    }
    hints
}
