//! Main loop: events in, frames out.

use std::io::{self, IsTerminal};
use std::time::{Duration, Instant};

use crossterm::event;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::events;
use super::program::Program;
use super::screen::Screen;
use crate::scene::Settings;
use crate::scene::printable::shell_word;
use crate::tui::model::{Message, Model, Options, Request};
use crate::tui::panes;
use crate::world::World;

/// How often the screen is drawn at most while something is going on.
const FRAME: Duration = Duration::from_millis(33);

/// How often results are taken from the worker while it works.
const TICK: Duration = Duration::from_millis(8);

/// How often signals are looked for while nothing is going on.
const IDLE: Duration = Duration::from_millis(100);

/// Shows a world until the user has seen enough. The size in `settings` does not matter: see [`Options::size`].
///
/// An error if stdout is no terminal, or if it fails. The terminal is given back in any case.
pub fn run(world: World, settings: Settings, options: Options) -> io::Result<()> {
    if !io::stdout().is_terminal() {
        return Err(io::Error::new(
            io::ErrorKind::Unsupported,
            format!(
                "the debugger needs a terminal, and stdout is none; \
                 `raytree trace {} --pixel X,Y --format text` writes the same as text",
                shell_word(&options.scene)
            ),
        ));
    }
    on_a_terminal(|size| Program::new(world, settings, options, size))
}

/// What a terminal shows, and whose keys it takes.
pub trait Interactive {
    /// Takes in a message. False if it means nothing.
    fn send(&mut self, message: Message) -> bool;
    /// Takes in what was done in the background. True if there was anything.
    fn receive(&mut self) -> bool;
    /// True while the background works.
    fn is_busy(&self) -> bool;
    /// Draws all of it.
    fn draw(&self, area: Rect, buffer: &mut Buffer);
    /// What the main loop is asked to do next.
    fn request(&mut self) -> &mut Request;
    /// True if the mouse is caught.
    fn mouse(&self) -> bool;
    /// The debugger, if one has the keys.
    fn debugger(&self) -> Option<&Model>;
    /// The debugger, to take from it what is to be copied.
    fn debugger_mut(&mut self) -> Option<&mut Model>;
}

impl Interactive for Program {
    fn send(&mut self, message: Message) -> bool {
        Self::send(self, message)
    }

    fn receive(&mut self) -> bool {
        Self::receive(self)
    }

    fn is_busy(&self) -> bool {
        Self::is_busy(self)
    }

    fn draw(&self, area: Rect, buffer: &mut Buffer) {
        panes::draw(&self.model, area, buffer);
    }

    fn request(&mut self) -> &mut Request {
        &mut self.model.request
    }

    fn mouse(&self) -> bool {
        self.model.mouse
    }

    fn debugger(&self) -> Option<&Model> {
        Some(&self.model)
    }

    fn debugger_mut(&mut self) -> Option<&mut Model> {
        Some(&mut self.model)
    }
}

/// Takes the terminal over and runs what is made for its size.
pub fn on_a_terminal<P: Interactive>(make: impl FnOnce(Rect) -> P) -> io::Result<()> {
    let mut screen = Screen::take()?;
    let size = screen.size()?;
    let mut program = make(size);
    let result = main_loop(&mut screen, &mut program);
    if Screen::has_panicked() {
        return Err(io::Error::other(
            "a part of the program failed; this is a bug",
        ));
    }
    result
}

fn main_loop(screen: &mut Screen, program: &mut impl Interactive) -> io::Result<()> {
    let (mut drawn, mut changed) = (None::<Instant>, true);
    let cursor = |model: &Model| model.session.as_ref().map(|s| s.cursor());
    while !(*program.request() == Request::Quit
        || screen.is_told_to_stop()
        || Screen::has_panicked())
    {
        // A key is answered at once; the background may wait for the next frame.
        let due = drawn.is_none_or(|drawn| drawn.elapsed() >= FRAME);
        if changed && due {
            draw(screen, program)?;
            (drawn, changed) = (Some(Instant::now()), false);
        }
        let is_moving = |program: &_| Interactive::debugger(program).is_some_and(Model::is_moving);
        let wait = if program.is_busy() || changed || is_moving(program) {
            TICK
        } else {
            IDLE
        };
        let mut answer = screen.obey_signals()?;
        if event::poll(wait)? {
            for event in events::pending()? {
                answer |= events::message(&event).is_some_and(|message| program.send(message));
            }
        }
        if *program.request() == Request::Suspend {
            *program.request() = Request::Stay;
            screen.suspend()?;
            answer = true;
        }
        if let Some(text) = program
            .debugger_mut()
            .and_then(|model| model.clipboard.take())
        {
            screen.copy(&text)?;
        }
        // What takes long goes on behind the key that it was asked for by.
        if !answer && is_moving(program) {
            let before = program.debugger().map(cursor);
            program.send(Message::Tick(Instant::now()));
            changed |= program
                .debugger()
                .is_some_and(|model| model.running.is_some());
            changed |= program.debugger().map(cursor) != before;
        }
        let is_waiting = |model: &Model| model.waiting.is_some() || model.changing.is_some();
        changed |= program.receive() | program.debugger().is_some_and(is_waiting);
        if answer && *program.request() != Request::Quit {
            draw(screen, program)?;
            (drawn, changed) = (Some(Instant::now()), false);
        }
    }
    Ok(())
}

/// Draws all in the size that the screen has by now.
fn draw(screen: &mut Screen, program: &mut impl Interactive) -> io::Result<()> {
    let area = screen.prepare(program.mouse())?;
    program.send(Message::Resize(area));
    screen.draw(|area, buffer| program.draw(area, buffer))
}
