//! Screen: the terminal taken over at the start, and given back whatever happens.

use std::io::{self, BufWriter, Stdout, Write};
use std::panic;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

use crossterm::clipboard::CopyToClipboard;
use crossterm::cursor::{Hide, Show};
use crossterm::event::{
    DisableBracketedPaste, DisableMouseCapture, EnableBracketedPaste, EnableMouseCapture,
};
use crossterm::terminal::{
    BeginSynchronizedUpdate, EndSynchronizedUpdate, EnterAlternateScreen, LeaveAlternateScreen,
    disable_raw_mode, enable_raw_mode,
};
use crossterm::{execute, queue};
use ratatui::Terminal;
use ratatui::backend::CrosstermBackend;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::signals::{self, Signals};

/// True while the terminal is ours.
static TAKEN: Mutex<bool> = Mutex::new(false);

/// True after a panic in any thread.
static PANICKED: AtomicBool = AtomicBool::new(false);

/// The screen, as long as it lives; then everything is as before.
pub struct Screen {
    terminal: Terminal<CrosstermBackend<BufWriter<Tty>>>,
    mouse: bool,
    signals: Signals,
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
        // Errors cannot be shown any more.
        let _ = execute!(
            out,
            EndSynchronizedUpdate,
            DisableMouseCapture,
            DisableBracketedPaste,
            LeaveAlternateScreen,
            Show
        );
        let _ = disable_raw_mode();
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        // What is still buffered must not be written after the terminal is given back.
        let _ = self.terminal.backend_mut().flush();
        give_back();
        #[cfg(unix)]
        match self.signals.end.load(Ordering::Relaxed) {
            0 => {}
            // Whoever sent the signal sees that it ended the program.
            signal => {
                let number = i32::try_from(signal).unwrap_or(signal_hook::consts::SIGTERM);
                let _ = signal_hook::low_level::emulate_default_handler(number);
            }
        }
    }
}

impl Screen {
    /// Takes the terminal over. From now on a panic gives it back before it speaks, and a signal to end is noted.
    pub fn take() -> io::Result<Self> {
        let signals = Signals::watch()?;
        signals::watch_for_hangup();
        // Colours are quantized by `panes::theme`. (With NO_COLOR set, crossterm would spoil attributes as well.)
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
            signals,
        };
        screen.enter()?;
        Ok(screen)
    }

    /// Takes the terminal over again: nothing of what was drawn is there any more.
    fn take_again(&mut self) -> io::Result<()> {
        self.enter()?;
        self.mouse = false;
        let size = self.size()?;
        self.terminal.resize(size)
    }

    fn enter(&mut self) -> io::Result<()> {
        enable_raw_mode()?;
        *TAKEN.lock().unwrap_or_else(PoisonError::into_inner) = true;
        execute!(
            self.terminal.backend_mut(),
            EnterAlternateScreen,
            EnableBracketedPaste,
            Hide
        )
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
        self.signals.end.load(Ordering::Relaxed) != 0
    }

    /// Does what signals to stop and to go on ask for. True if the screen must be drawn anew.
    pub fn obey_signals(&mut self) -> io::Result<bool> {
        if self.signals.stop.swap(false, Ordering::Relaxed) {
            self.suspend()?;
            return Ok(true);
        }
        let went_on = self.signals.go_on.swap(false, Ordering::Relaxed);
        if went_on {
            // It was stopped without being asked, and a shell has changed the terminal meanwhile.
            give_back();
            self.take_again()?;
        }
        Ok(went_on)
    }

    /// True if a thread panicked; the terminal is given back already.
    pub fn has_panicked() -> bool {
        PANICKED.load(Ordering::SeqCst)
    }

    /// Catches the mouse or leaves it to the terminal, and gives the size that a frame will have.
    pub fn prepare(&mut self, mouse: bool) -> io::Result<Rect> {
        if mouse != self.mouse {
            self.mouse = mouse;
            let out = self.terminal.backend_mut();
            if self.mouse {
                queue!(out, EnableMouseCapture)?;
            } else {
                queue!(out, DisableMouseCapture)?;
            }
        }
        self.terminal.autoresize()?;
        Ok(self.terminal.get_frame().area())
    }

    /// Draws what is painted, all at once for terminals that can.
    pub fn draw(&mut self, paint: impl FnOnce(Rect, &mut Buffer)) -> io::Result<()> {
        queue!(self.terminal.backend_mut(), BeginSynchronizedUpdate)?;
        self.terminal
            .draw(|frame| paint(frame.area(), frame.buffer_mut()))?;
        execute!(self.terminal.backend_mut(), EndSynchronizedUpdate)
    }

    /// Asks the terminal to copy a text (OSC 52); some do, some ask their user, some do not.
    pub fn copy(&mut self, text: &str) -> io::Result<()> {
        let copy = CopyToClipboard::to_clipboard_from(text);
        execute!(self.terminal.backend_mut(), copy)
    }

    /// Stops the program as a shell's Ctrl-Z does, and takes the terminal over again when it goes on.
    #[cfg(unix)]
    pub fn suspend(&mut self) -> io::Result<()> {
        give_back();
        signal_hook::low_level::emulate_default_handler(signal_hook::consts::SIGTSTP)?;
        self.signals.go_on.store(false, Ordering::Relaxed);
        self.take_again()
    }

    /// There is no such thing here.
    #[cfg(not(unix))]
    pub fn suspend(&mut self) -> io::Result<()> {
        Ok(())
    }
}
