//! Signals that end the program, and a watch for terminals that are gone without a signal.

use std::io;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// How often is looked whether the terminal is still there.
#[cfg(unix)]
const HANGUP: std::time::Duration = std::time::Duration::from_millis(250);

/// A flag that signals to end set.
#[cfg(unix)]
pub fn stop_flag() -> io::Result<Arc<AtomicBool>> {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    let stop = Arc::new(AtomicBool::new(false));
    for signal in [SIGTERM, SIGHUP, SIGINT] {
        signal_hook::flag::register(signal, Arc::clone(&stop))?;
    }
    Ok(stop)
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

/// A flag that nothing sets.
#[cfg(not(unix))]
pub fn stop_flag() -> io::Result<Arc<AtomicBool>> {
    Ok(Arc::new(AtomicBool::new(false)))
}
