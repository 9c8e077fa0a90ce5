//! Keys: what the table says, or a letter where a text is asked for.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use super::action::act;
use super::{ask, caret};
use crate::tui::model::bindings::lookup;
use crate::tui::model::{Context, Model};

/// A text was pasted: into the prompt, or nowhere.
pub fn paste(model: &mut Model, text: &str) {
    if model.context() == Context::Prompt {
        for letter in text.trim().chars() {
            caret::typed(model, letter);
        }
    } else {
        let told = "pasted text goes into prompts only: : goes to an address, / finds";
        model.message = Some(told.to_owned());
    }
}

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
    // What moves by itself stops; q and Esc do no more than that.
    if model.is_moving() && matches!(key.code, KeyCode::Char('q') | KeyCode::Esc) {
        (model.play, model.running) = (None, None);
        model.message = Some("stopped".to_owned());
        return true;
    }
    // Where a text is typed, letters are letters.
    let is_text = !key
        .modifiers
        .intersects(KeyModifiers::CONTROL | KeyModifiers::ALT);
    if let (Context::Prompt, KeyCode::Char(letter), true) = (model.context(), key.code, is_text) {
        caret::typed(model, letter);
        return true;
    }
    if ask::press(model, key) {
        return true;
    }
    let action = lookup(model.context(), key);
    if action.is_none() {
        (model.play, model.running) = (None, None);
        if model.context() == Context::Text {
            model.overlay = None;
            return true;
        }
    }
    action.inspect(|action| act(model, *action)).is_some()
}
