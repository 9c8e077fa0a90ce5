//! Prompt: a text that is typed, to go somewhere, to search, to change a setting, to compare.

use super::{caret, compare, edit, history, image, marks, run, search, set};
use crate::debug::horizon::BEHIND;
use crate::debug::watch;
use crate::tui::model::examples::examples;
use crate::tui::model::{Model, Overlay, Prompt};

/// Asks for a text.
pub fn ask(model: &mut Model, prompt: Prompt) {
    caret::show(model, prompt, String::new());
}

/// Puts the next (previous) ready text into the prompt.
pub fn ready(model: &mut Model, next: bool) {
    let Some(Overlay::Prompt(prompt, text)) = &model.overlay else {
        return;
    };
    let (prompt, mut texts) = (*prompt, examples(*prompt, &model.world.scene));
    if let (Prompt::Watch, Some(session)) = (prompt, &model.session) {
        texts = watch::names(session);
    }
    let count = texts.len();
    if count == 0 {
        return;
    }
    let at = texts.iter().position(|ready| ready == text);
    let at = match (at, next) {
        (None, true) => 0,
        (None, false) => count - 1,
        (Some(at), true) => (at + 1) % count,
        (Some(at), false) => (at + count - 1) % count,
    };
    caret::show(model, prompt, texts.swap_remove(at));
}

/// Takes the text. What cannot be meant is told, and the prompt stays.
pub fn accept(model: &mut Model) {
    let Some(Overlay::Prompt(prompt, text)) = model.overlay.take() else {
        return;
    };
    let done = match prompt {
        Prompt::Note => {
            marks::mark(model, text.trim());
            Ok(())
        }
        _ if text.trim().is_empty() => Ok(()),
        Prompt::Write => marks::write(model, text.trim()),
        Prompt::WritePatch => edit::write(model, text.trim()),
        Prompt::Break => run::toggle(model, text.trim()),
        Prompt::Watch => run::watch(model, text.trim()),
        Prompt::GoTo => {
            history::leave(model);
            go_to(model, text.trim())
        }
        Prompt::Search => {
            history::leave(model);
            search::start(model, text.trim())
        }
        Prompt::Set => set::typed(model, text.trim()),
        Prompt::Compare => compare::typed(model, text.trim()),
    };
    if let Err(problem) = done {
        model.message = Some(problem);
        model.overlay = Some(Overlay::Prompt(prompt, text));
    }
}

/// Goes to an event of the open tree, or to an address.
fn go_to(model: &mut Model, text: &str) -> Result<(), String> {
    let number = text.strip_prefix('#').unwrap_or(text).parse::<usize>();
    if let (Ok(number), Some(session)) = (number, &mut model.session) {
        let count = session.tree().events.len();
        if number >= count && session.horizon().is_some() {
            return Err(BEHIND.to_owned());
        }
        if number >= count {
            return Err(format!(
                "there is no event {number}: the last one is {}",
                count.saturating_sub(1)
            ));
        }
        session.go_to_event(number);
        return Ok(());
    }
    // Without a pixel it is a place in this one.
    let (x, y) = model.picture.cursor;
    let here = text.starts_with(['/', ':', '#']);
    let address = if here {
        format!("{x},{y}{text}")
    } else {
        text.to_owned()
    };
    image::go_to(model, address.parse()?)
}

/// Copies the command that opens the debugger here.
pub fn copy(model: &mut Model) {
    let command = model.open_command();
    model.message = Some(command.clone());
    model.clipboard = Some(command);
}
