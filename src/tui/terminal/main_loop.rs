//! Main loop: events in, frames out.

use std::io::{self, IsTerminal};
use std::time::{Duration, Instant};

use crossterm::event;

use super::events;
use super::program::Program;
use super::screen::Screen;
use crate::scene::Settings;
use crate::scene::printable::shell_word;
use crate::tui::model::{Message, Options, Request};
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
    let mut screen = Screen::take()?;
    let size = screen.size()?;
    let mut program = Program::new(world, settings, options, size);
    let result = main_loop(&mut screen, &mut program);
    if Screen::has_panicked() {
        return Err(io::Error::other(
            "a part of the program failed; this is a bug",
        ));
    }
    result
}

fn main_loop(screen: &mut Screen, program: &mut Program) -> io::Result<()> {
    let (mut drawn, mut changed) = (None::<Instant>, true);
    while !(program.model.request == Request::Quit
        || screen.is_told_to_stop()
        || Screen::has_panicked())
    {
        // A key is answered at once; the background may wait for the next frame.
        let due = drawn.is_none_or(|drawn| drawn.elapsed() >= FRAME);
        if changed && due {
            draw(screen, program)?;
            (drawn, changed) = (Some(Instant::now()), false);
        }
        let wait = if program.is_busy() || changed || program.model.is_moving() {
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
        if program.model.request == Request::Suspend {
            program.model.request = Request::Stay;
            screen.suspend()?;
            answer = true;
        }
        if let Some(text) = program.model.clipboard.take() {
            screen.copy(&text)?;
        }
        if program.model.is_moving() {
            let before = program.model.session.as_ref().map(|s| s.cursor());
            program.send(Message::Tick(Instant::now()));
            changed |= program.model.running.is_some();
            changed |= program.model.session.as_ref().map(|s| s.cursor()) != before;
        }
        let is_waiting = program.model.waiting.is_some() || program.model.changing.is_some();
        changed |= program.receive() | is_waiting;
        if answer && program.model.request != Request::Quit {
            draw(screen, program)?;
            (drawn, changed) = (Some(Instant::now()), false);
        }
    }
    Ok(())
}

/// Draws the model in the size that the screen has by now.
fn draw(screen: &mut Screen, program: &mut Program) -> io::Result<()> {
    let area = screen.prepare(program.model.mouse)?;
    program.send(Message::Resize(area));
    screen.draw(&program.model)
}
