//! Events of the terminal, as messages.

use std::io;
use std::time::Duration;

use crossterm::event::{self, Event, KeyEventKind, MouseButton, MouseEventKind};
use ratatui::layout::Rect;

use crate::tui::model::{Message, Mouse};

/// Events that are taken in at once.
const MANY: usize = 256;

/// How long the next event is waited for. (With no time at all, crossterm looks for none.)
const SHORT: Duration = Duration::from_micros(200);

/// Rows that a notch of the wheel scrolls.
const NOTCH: i32 = 3;

/// All events that have come by now; of a run of mouse moves only the last.
pub fn pending() -> io::Result<Vec<Event>> {
    let mut events: Vec<Event> = Vec::new();
    while events.len() < MANY && event::poll(SHORT)? {
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

/// The message of an event; `None` if it means nothing.
pub fn message(event: &Event) -> Option<Message> {
    match event {
        // Some terminals tell of keys that are let go as well.
        Event::Key(key) if key.kind != KeyEventKind::Release => Some(Message::Key(*key)),
        Event::Mouse(mouse) => {
            let what = match mouse.kind {
                MouseEventKind::Down(MouseButton::Left) => Mouse::Press,
                MouseEventKind::Drag(MouseButton::Left) => Mouse::Drag,
                MouseEventKind::ScrollDown => Mouse::Wheel(NOTCH),
                MouseEventKind::ScrollUp => Mouse::Wheel(-NOTCH),
                _ => return None,
            };
            Some(Message::Mouse(what, (mouse.column, mouse.row).into()))
        }
        Event::Paste(text) => Some(Message::Paste(text.clone())),
        Event::Resize(width, height) => Some(Message::Resize(Rect::new(0, 0, *width, *height))),
        _ => None,
    }
}
