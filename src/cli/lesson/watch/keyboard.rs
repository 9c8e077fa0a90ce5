//! The keyboard while something is watched: single keys, and a terminal that is as before whenever anything is printed.

use std::io::{self, IsTerminal as _};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use crossterm::event::{Event, KeyCode, KeyEventKind, KeyModifiers, poll, read};
use crossterm::terminal::{disable_raw_mode, enable_raw_mode};

/// Clears the screen of a terminal and goes to its top.
pub const CLEAR: &str = "\x1b[2J\x1b[H";

/// How long at most until a signal is seen.
const TICK: Duration = Duration::from_millis(50);

/// What a key asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WatchKey {
    /// `h`: the next hint.
    Hint,
    /// `n`: the next exercise.
    Next,
    /// `r`: once more.
    Again,
    /// `q`, Esc, Ctrl-C, or a signal: the end.
    Quit,
}

/// The keyboard, if there is one.
pub struct Keyboard {
    is_there: bool,
    /// The number of the signal that ends the program; 0 for none.
    signal: Arc<AtomicUsize>,
}

/// A terminal that hands on every key at once, as long as this lives.
struct Raw;

impl Drop for Raw {
    fn drop(&mut self) {
        // An error cannot be helped here.
        let _ = disable_raw_mode();
    }
}

impl Keyboard {
    /// The keyboard of a terminal that shows what is printed. From now on signals to end are noted, and set `stop`.
    pub fn new(stop: &Arc<AtomicBool>) -> io::Result<Self> {
        let signal = Arc::new(AtomicUsize::new(0));
        #[cfg(unix)]
        for number in [
            signal_hook::consts::SIGTERM,
            signal_hook::consts::SIGHUP,
            signal_hook::consts::SIGINT,
        ] {
            signal_hook::flag::register(number, Arc::clone(stop))?;
            signal_hook::flag::register_usize(number, Arc::clone(&signal), number as usize)?;
        }
        #[cfg(not(unix))]
        let _ = stop;
        Ok(Self {
            is_there: io::stdin().is_terminal() && io::stdout().is_terminal(),
            signal,
        })
    }

    /// True if keys are heard.
    pub fn is_there(&self) -> bool {
        self.is_there
    }

    /// The next key that asks for something, waited for so long at most.
    pub fn wait(&self, at_most: Duration) -> io::Result<Option<WatchKey>> {
        let end = Instant::now() + at_most;
        if self.is_there {
            enable_raw_mode()?;
        }
        let _raw = self.is_there.then_some(Raw);
        loop {
            if self.signal.load(Ordering::Relaxed) != 0 {
                return Ok(Some(WatchKey::Quit));
            }
            let left = end.saturating_duration_since(Instant::now());
            if left.is_zero() {
                return Ok(None);
            }
            let tick = left.min(TICK);
            if !self.is_there {
                std::thread::sleep(tick);
            } else if poll(tick)?
                && let Some(key) = key(&read()?)
            {
                return Ok(Some(key));
            }
        }
    }

    /// Ends the program as the signal would have, if there was one.
    pub fn end(&self) {
        #[cfg(unix)]
        if let Ok(signal @ 1..) = i32::try_from(self.signal.load(Ordering::Relaxed)) {
            let _ = signal_hook::low_level::emulate_default_handler(signal);
        }
    }
}

/// What an event asks for.
fn key(event: &Event) -> Option<WatchKey> {
    let Event::Key(key) = event else {
        return None;
    };
    if key.kind == KeyEventKind::Release {
        return None;
    }
    let ctrl = key.modifiers.contains(KeyModifiers::CONTROL);
    match key.code {
        KeyCode::Char('c') if ctrl => Some(WatchKey::Quit),
        KeyCode::Char('h') => Some(WatchKey::Hint),
        KeyCode::Char('n') => Some(WatchKey::Next),
        KeyCode::Char('r') => Some(WatchKey::Again),
        KeyCode::Char('q') | KeyCode::Esc => Some(WatchKey::Quit),
        _ => None,
    }
}
