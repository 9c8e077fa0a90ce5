//! Keys: what the table says, or a letter where a text is asked for.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use super::action::act;
use super::prompt;
use crate::tui::model::bindings::lookup;
use crate::tui::model::{Context, Model};

/// A key was pressed. False if it means nothing here.
pub fn press(model: &mut Model, key: KeyEvent) -> bool {
    // A shifted letter is another letter, however the terminal says it.
    let key = match key.code {
        KeyCode::Char(c) if key.modifiers.contains(KeyModifiers::SHIFT) => {
            let upper = c.to_uppercase().next().unwrap_or(c);
            KeyEvent::new(KeyCode::Char(upper), key.modifiers)
        }
        _ => key,
    };
    // Where a text is typed, letters are letters.
    let is_text = !key
        .modifiers
        .intersects(KeyModifiers::CONTROL | KeyModifiers::ALT);
    if let (Context::Prompt, KeyCode::Char(letter), true) = (model.context(), key.code, is_text) {
        prompt::typed(model, letter);
        return true;
    }
    let action = lookup(model.context(), key);
    action.inspect(|action| act(model, *action)).is_some()
}
