//! Signals that end a command: nothing half done stays behind, and a picture in the making is kept.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;
#[cfg(unix)]
use std::sync::{Once, OnceLock, atomic::Ordering};

#[cfg(unix)]
use super::new_file::remove_all_then;

/// What the first Ctrl-C sets instead of ending the program.
#[cfg(unix)]
static STOP: OnceLock<Arc<AtomicBool>> = OnceLock::new();

/// Watches from now on: a signal to end removes temporary files first.
#[cfg(unix)]
pub fn watch() {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        // Without a handler a signal ends the program, as everywhere: nothing to tell.
        let Ok(mut signals) = Signals::new([SIGINT, SIGTERM, SIGHUP]) else {
            return;
        };
        std::thread::spawn(move || {
            for signal in &mut signals {
                let gently = STOP.get().filter(|_| signal == SIGINT);
                if gently.is_some_and(|stop| !stop.swap(true, Ordering::Relaxed)) {
                    continue;
                }
                remove_all_then(|| {
                    let _ = signal_hook::low_level::emulate_default_handler(signal);
                });
            }
        });
    });
}

/// From now on the first Ctrl-C sets this flag; the second ends the program.
#[cfg(unix)]
pub fn stop_gently(flag: &Arc<AtomicBool>) {
    watch();
    // There is one such flag in a run of the program.
    let _ = STOP.set(Arc::clone(flag));
}

#[cfg(not(unix))]
pub fn watch() {}

#[cfg(not(unix))]
pub fn stop_gently(_: &Arc<AtomicBool>) {}
