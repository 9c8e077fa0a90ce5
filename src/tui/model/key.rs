//! Key of the table, with its label and the terminal's events that match it.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

/// A key with its modifiers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Key {
    code: KeyCode,
    shift: bool,
    control: bool,
}

/// A key alone.
pub const fn key(code: KeyCode) -> Key {
    Key {
        code,
        shift: false,
        control: false,
    }
}

/// A character; a capital letter carries its shift in itself.
pub const fn ch(letter: char) -> Key {
    key(KeyCode::Char(letter))
}

/// A key with Shift.
pub const fn shift(code: KeyCode) -> Key {
    Key {
        shift: true,
        ..key(code)
    }
}

/// A letter with Control.
pub const fn control(letter: char) -> Key {
    Key {
        control: true,
        ..ch(letter)
    }
}

impl Key {
    /// True if the event is this key, pressed.
    pub fn matches(self, event: KeyEvent) -> bool {
        let letter = matches!(self.code, KeyCode::Char(_) | KeyCode::BackTab);
        self.code == event.code
            && self.control == event.modifiers.contains(KeyModifiers::CONTROL)
            && (letter || self.shift == event.modifiers.contains(KeyModifiers::SHIFT))
            && !event.modifiers.contains(KeyModifiers::ALT)
    }

    /// The event of this key being pressed.
    #[cfg(test)]
    pub fn event(self) -> KeyEvent {
        let mut modifiers = KeyModifiers::NONE;
        modifiers.set(KeyModifiers::CONTROL, self.control);
        modifiers.set(KeyModifiers::SHIFT, self.shift);
        KeyEvent::new(self.code, modifiers)
    }

    /// The name on the keyboard.
    pub fn label(self) -> String {
        let name = match self.code {
            KeyCode::Char(' ') => "Space".to_owned(),
            KeyCode::Char(c) if self.control => format!("Ctrl-{}", c.to_uppercase()),
            KeyCode::Char(c) => c.to_string(),
            KeyCode::Left => "←".to_owned(),
            KeyCode::Right => "→".to_owned(),
            KeyCode::Up => "↑".to_owned(),
            KeyCode::Down => "↓".to_owned(),
            KeyCode::PageDown => "PgDn".to_owned(),
            KeyCode::PageUp => "PgUp".to_owned(),
            KeyCode::BackTab => "Shift-Tab".to_owned(),
            other => format!("{other:?}"),
        };
        if self.shift {
            format!("Shift-{name}")
        } else {
            name
        }
    }
}
