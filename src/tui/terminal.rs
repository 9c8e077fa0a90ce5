//! The terminal: taken over at the start, given back whatever happens.

use std::io::{self, BufWriter, IsTerminal, Stdout, Write};
use std::panic;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use crossterm::cursor::{Hide, Show};
use crossterm::event::{DisableMouseCapture, EnableMouseCapture};
use crossterm::terminal::{
    BeginSynchronizedUpdate, EndSynchronizedUpdate, EnterAlternateScreen, LeaveAlternateScreen,
    disable_raw_mode, enable_raw_mode,
};
use crossterm::{execute, queue};
use ratatui::Terminal;
use ratatui::backend::CrosstermBackend;
use ratatui::layout::Rect;

use super::app::App;

/// True while the terminal is ours.
static TAKEN: Mutex<bool> = Mutex::new(false);

/// True after a panic in any thread.
static PANICKED: AtomicBool = AtomicBool::new(false);

/// How often is looked whether the terminal is still there.
#[cfg(unix)]
const HANGUP: std::time::Duration = std::time::Duration::from_millis(250);

/// The screen, as long as it lives; then everything is as before.
pub struct Screen {
    terminal: Terminal<CrosstermBackend<BufWriter<Tty>>>,
    mouse: bool,
    stop: Arc<AtomicBool>,
}

/// Standard output while the terminal is ours, nothing afterwards: when one thread has panicked and given the terminal
/// back, a frame that another one is drawing must not follow.
struct Tty(Stdout);

impl Write for Tty {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let taken = TAKEN.lock().unwrap_or_else(PoisonError::into_inner);
        if *taken {
            self.0.write(bytes)
        } else {
            Ok(bytes.len())
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

/// Gives the terminal back, at most once.
fn give_back() {
    let mut taken = TAKEN.lock().unwrap_or_else(PoisonError::into_inner);
    if std::mem::replace(&mut *taken, false) {
        let mut out = io::stdout();
        // There is nobody left to tell of errors here.
        let _ = execute!(
            out,
            EndSynchronizedUpdate,
            DisableMouseCapture,
            LeaveAlternateScreen,
            Show
        );
        let _ = disable_raw_mode();
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        // What is still in the buffer must not come after the farewell.
        let _ = self.terminal.backend_mut().flush();
        give_back();
    }
}

impl Screen {
    /// Takes the terminal over. From now on a panic gives it back before it speaks, and a signal to end is noted.
    pub fn take() -> io::Result<Self> {
        let stop = signals()?;
        watch_for_hangup();
        // Colours are our own business: see `theme`. (With NO_COLOR set, crossterm would spoil attributes as well.)
        crossterm::style::force_color_output(true);
        PANICKED.store(false, Ordering::SeqCst);
        let before = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            PANICKED.store(true, Ordering::SeqCst);
            give_back();
            before(info);
        }));
        let out = BufWriter::with_capacity(1 << 16, Tty(io::stdout()));
        let terminal = Terminal::new(CrosstermBackend::new(out))?;
        let mut screen = Self {
            terminal,
            mouse: false,
            stop,
        };
        screen.enter()?;
        Ok(screen)
    }

    fn enter(&mut self) -> io::Result<()> {
        enable_raw_mode()?;
        *TAKEN.lock().unwrap_or_else(PoisonError::into_inner) = true;
        execute!(self.terminal.backend_mut(), EnterAlternateScreen, Hide)
    }

    /// Its size.
    pub fn size(&self) -> io::Result<Rect> {
        Ok(Rect::from((
            ratatui::layout::Position::ORIGIN,
            self.terminal.size()?,
        )))
    }

    /// True if someone wants the program to end.
    pub fn is_told_to_stop(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    /// True if a thread panicked; the terminal is given back already.
    pub fn has_panicked() -> bool {
        PANICKED.load(Ordering::SeqCst)
    }

    /// Draws the state, all at once for terminals that can.
    pub fn draw(&mut self, app: &mut App) -> io::Result<()> {
        if app.mouse != self.mouse {
            self.mouse = app.mouse;
            let out = self.terminal.backend_mut();
            if self.mouse {
                queue!(out, EnableMouseCapture)?;
            } else {
                queue!(out, DisableMouseCapture)?;
            }
        }
        self.terminal.autoresize()?;
        app.resize(self.terminal.get_frame().area());
        queue!(self.terminal.backend_mut(), BeginSynchronizedUpdate)?;
        let app = &*app;
        self.terminal
            .draw(|frame| frame.render_widget(app, frame.area()))?;
        execute!(self.terminal.backend_mut(), EndSynchronizedUpdate)
    }

    /// Stops the program as a shell's Ctrl-Z does, and takes the terminal over again when it goes on.
    #[cfg(unix)]
    pub fn suspend(&mut self) -> io::Result<()> {
        give_back();
        signal_hook::low_level::emulate_default_handler(signal_hook::consts::SIGTSTP)?;
        self.enter()?;
        self.mouse = false;
        // Nothing of what was drawn is there any more.
        let size = self.size()?;
        self.terminal.resize(size)
    }

    /// There is no such thing here.
    #[cfg(not(unix))]
    pub fn suspend(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// A flag that signals to end set.
#[cfg(unix)]
fn signals() -> io::Result<Arc<AtomicBool>> {
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
fn watch_for_hangup() {
    std::thread::spawn(|| {
        while io::stdout().is_terminal() {
            std::thread::sleep(HANGUP);
        }
        // If even that fails, there is nobody left to tell.
        let _ = signal_hook::low_level::emulate_default_handler(signal_hook::consts::SIGHUP);
    });
}

/// Closing the window ends the program here.
#[cfg(not(unix))]
fn watch_for_hangup() {}

/// A flag that nothing sets.
#[cfg(not(unix))]
fn signals() -> io::Result<Arc<AtomicBool>> {
    Ok(Arc::new(AtomicBool::new(false)))
}
