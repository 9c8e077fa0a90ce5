//! Signals that end or stop the program, and a watch for terminals that are gone without a signal.

use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize};

/// How often is looked whether the terminal is still there.
#[cfg(unix)]
const HANGUP: std::time::Duration = std::time::Duration::from_millis(250);

/// What signals from outside ask for: flags that they set.
#[derive(Clone, Default)]
pub struct Signals {
    /// To end: the number of the signal, 0 for none.
    pub end: Arc<AtomicUsize>,
    /// To stop until it is told to go on.
    pub stop: Arc<AtomicBool>,
    /// To go on after a stop of which it was not told.
    pub go_on: Arc<AtomicBool>,
}

impl Signals {
    /// Looks out for them from now on.
    #[cfg(unix)]
    pub fn watch() -> io::Result<Self> {
        use signal_hook::consts::{SIGCONT, SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGTSTP};
        let signals = Self::default();
        for signal in [SIGTERM, SIGHUP, SIGINT, SIGQUIT] {
            signal_hook::flag::register_usize(signal, Arc::clone(&signals.end), signal as usize)?;
        }
        for (signal, flag) in [(SIGTSTP, &signals.stop), (SIGCONT, &signals.go_on)] {
            signal_hook::flag::register(signal, Arc::clone(flag))?;
        }
        Ok(signals)
    }

    /// Flags that nothing sets.
    #[cfg(not(unix))]
    pub fn watch() -> io::Result<Self> {
        Ok(Self::default())
    }
}

/// Ends the program when its terminal is gone, as the signal SIGHUP does where it is sent. (It is not always; and
/// crossterm 0.29 reads from a closed terminal for ever, so that the main loop would not even see a flag.)
#[cfg(unix)]
pub fn watch_for_hangup() {
    std::thread::spawn(|| {
        while io::IsTerminal::is_terminal(&io::stdout()) {
            std::thread::sleep(HANGUP);
        }
        // There is no terminal left for an error message.
        let _ = signal_hook::low_level::emulate_default_handler(signal_hook::consts::SIGHUP);
    });
}

/// Closing the window ends the program here.
#[cfg(not(unix))]
pub fn watch_for_hangup() {}
