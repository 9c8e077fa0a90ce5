//! Text of a prompt: letters are typed and deleted at any place of it.

use crate::tui::model::{Model, Overlay, Prompt};

/// Letters of a text at most.
const MOST_LETTERS: usize = 200;

/// Shows a prompt with a text, at whose end letters are typed.
pub fn show(model: &mut Model, prompt: Prompt, text: String) {
    model.overlay = Some(Overlay::Prompt(prompt, text));
    model.behind = 0;
}

/// The byte of a text that so many letters stand behind.
fn place(text: &str, behind: usize) -> usize {
    let mut starts = text.char_indices().rev();
    behind
        .checked_sub(1)
        .map_or(text.len(), |n| starts.nth(n).map_or(0, |(at, _)| at))
}

/// A letter was typed.
pub fn typed(model: &mut Model, letter: char) {
    model.message = None;
    if let Some(Overlay::Prompt(_, text)) = &mut model.overlay
        && !letter.is_control()
        && text.chars().count() < MOST_LETTERS
    {
        text.insert(place(text, model.behind), letter);
    }
}

/// Deletes the letter before the place where letters are typed, or the one behind it.
pub fn erase(model: &mut Model, before: bool) {
    let Some(Overlay::Prompt(_, text)) = &mut model.overlay else {
        return;
    };
    if !before {
        let Some(behind) = model.behind.checked_sub(1) else {
            return;
        };
        model.behind = behind;
    }
    let end = place(text, model.behind);
    if let Some((start, _)) = text[..end].char_indices().next_back() {
        text.remove(start);
    }
}

/// Moves the place where letters are typed.
pub fn move_caret(model: &mut Model, by: i32) {
    if let Some(Overlay::Prompt(_, text)) = &model.overlay {
        let behind = model.behind.saturating_add_signed(-by as isize);
        model.behind = behind.min(text.chars().count());
    }
}
