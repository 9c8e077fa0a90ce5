//! The terminal debugger: the picture, a pixel, and its ray tree to walk through.
//!
//! Model, update, draw: `app` is the state and how actions change it; `draw` paints it and cannot change it;
//! `terminal` is the one place that knows of a real terminal. All tracing is done by [`crate::tracer`] and told by
//! [`crate::trace`].

mod actions;
mod app;
mod bars;
mod details;
mod draw;
mod effects;
mod help;
mod image;
mod input;
mod layout;
mod mouse;
mod nearing;
mod outline;
mod path_pane;
mod picture;
mod picture_pane;
mod renderer;
mod rows;
mod session;
mod steps_pane;
mod terminal;
#[cfg(test)]
mod tests;
mod theme;
mod tree_pane;

use std::io::{self, IsTerminal};
use std::time::{Duration, Instant};

use crossterm::event;

use crate::scene::Settings;
use crate::tracer::picture::ColorLevel;
use crate::world::World;
use app::{App, Wish};
use terminal::Screen;

/// What the command line chooses.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// The scene as the user named it, for the command line that traces a pixel again.
    pub scene: String,
    /// How many colours the terminal has.
    pub color: ColorLevel,
    /// Whether the mouse picks pixels and scrolls; if not, the terminal selects text with it.
    pub mouse: bool,
    /// Threads that render the picture; 0: one a core.
    pub threads: usize,
    /// Width and height of the image; `None`: as many pixels as the screen shows.
    pub size: Option<(u32, u32)>,
}

/// How often the screen is drawn at most while something is going on.
const FRAME: Duration = Duration::from_millis(33);

/// How often the background is asked for news while it works.
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
                options.scene
            ),
        ));
    }
    let mut screen = Screen::take()?;
    let size = screen.size()?;
    let mut app = App::new(world, settings, options, size);
    let result = main_loop(&mut screen, &mut app);
    if Screen::has_panicked() {
        return Err(io::Error::other(
            "a part of the program failed; this is a bug",
        ));
    }
    result
}

fn main_loop(screen: &mut Screen, app: &mut App) -> io::Result<()> {
    let (mut drawn, mut changed) = (None::<Instant>, true);
    while !(app.wish == Wish::Quit || screen.is_told_to_stop() || Screen::has_panicked()) {
        // A key is answered at once; the background may wait for the next frame.
        let due = drawn.is_none_or(|drawn| drawn.elapsed() >= FRAME);
        if changed && due {
            screen.draw(app)?;
            (drawn, changed) = (Some(Instant::now()), false);
        }
        let wait = if app.is_busy() || changed { TICK } else { IDLE };
        let mut answer = false;
        if event::poll(wait)? {
            for event in input::pending()? {
                answer |= input::handle(app, &event);
            }
        }
        if app.wish == Wish::Suspend {
            app.wish = Wish::Stay;
            screen.suspend()?;
            answer = true;
        }
        changed |= app.receive() | app.waiting.is_some();
        if answer && app.wish != Wish::Quit {
            screen.draw(app)?;
            (drawn, changed) = (Some(Instant::now()), false);
        }
    }
    Ok(())
}
