//! From what the terminal reports to what the debugger does.

use std::io;
use std::time::Duration;

use crossterm::event::{
    self, Event, KeyCode, KeyEvent, KeyEventKind, KeyModifiers, MouseButton, MouseEventKind,
};
use ratatui::layout::Rect;

use super::actions::{Context, lookup};
use super::app::App;
use super::mouse::Mouse;

/// Events that are taken in at once.
const MANY: usize = 256;

/// Rows that a notch of the wheel scrolls.
const NOTCH: i32 = 3;

/// All events that have come by now; of a run of mouse moves only the last.
pub fn pending() -> io::Result<Vec<Event>> {
    let mut events: Vec<Event> = Vec::new();
    while events.len() < MANY && event::poll(Duration::ZERO)? {
        let event = event::read()?;
        if is_move(&event)
            && let Some(last) = events.last_mut()
            && is_move(last)
        {
            *last = event;
        } else {
            events.push(event);
        }
    }
    Ok(events)
}

fn is_move(event: &Event) -> bool {
    use MouseEventKind::{Drag, Moved};
    matches!(event, Event::Mouse(mouse) if matches!(mouse.kind, Drag(_) | Moved))
}

/// Does what an event asks for. False if it asks for nothing.
pub fn handle(app: &mut App, event: &Event) -> bool {
    match event {
        // Some terminals tell of keys that are let go as well.
        Event::Key(key) if key.kind != KeyEventKind::Release => press(app, *key),
        Event::Mouse(mouse) => {
            let what = match mouse.kind {
                MouseEventKind::Down(MouseButton::Left) => Mouse::Press,
                MouseEventKind::Drag(MouseButton::Left) => Mouse::Drag,
                MouseEventKind::ScrollDown => Mouse::Wheel(NOTCH),
                MouseEventKind::ScrollUp => Mouse::Wheel(-NOTCH),
                _ => return false,
            };
            app.point(what, (mouse.column, mouse.row).into());
            true
        }
        Event::Resize(width, height) => {
            app.resize(Rect::new(0, 0, *width, *height));
            true
        }
        _ => false,
    }
}

/// A key: what the table says, or a digit where a number is asked for.
pub fn press(app: &mut App, key: KeyEvent) -> bool {
    // A shifted letter is another letter, however the terminal says it.
    let key = match key.code {
        KeyCode::Char(c) if key.modifiers.contains(KeyModifiers::SHIFT) => {
            let upper = c.to_uppercase().next().unwrap_or(c);
            KeyEvent::new(KeyCode::Char(upper), key.modifiers)
        }
        _ => key,
    };
    match (lookup(app.context(), key), key.code) {
        (None, KeyCode::Char(letter)) if app.context() == Context::Prompt => app.typed(letter),
        (Some(action), _) => app.handle(action),
        (None, _) => return false,
    }
    true
}
