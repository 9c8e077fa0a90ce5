//! Keys: what the table says, or a digit where a number is asked for.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use super::action::act;
use crate::tui::model::bindings::lookup;
use crate::tui::model::{Context, Model, Overlay};

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
    match (lookup(model.context(), key), key.code) {
        (None, KeyCode::Char(letter)) if model.context() == Context::Prompt => {
            typed(model, letter);
        }
        (Some(action), _) => act(model, action),
        (None, _) => return false,
    }
    true
}

/// A letter was typed where a number is asked for.
fn typed(model: &mut Model, letter: char) {
    if let Some(Overlay::GoTo(digits)) = &mut model.overlay
        && letter.is_ascii_digit()
        && digits.len() < 9
    {
        digits.push(letter);
    }
}
