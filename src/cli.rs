//! The command line: one file a command.

mod address;
mod advice;
mod build_progress;
mod changes;
mod color;
mod command_line;
mod cost;
mod diff;
mod effects;
mod end_signals;
mod find;
mod grade;
mod lesson;
mod new_file;
mod notices;
mod output;
mod raster;
mod reduce;
mod render;
mod run_programs;
mod scenes;
mod schema;
mod settings;
mod stability;
mod trace;
mod trees;
mod view;

use std::ffi::OsString;
use std::io::{self, Write as _};
use std::process::ExitCode;

use clap::{Parser, Subcommand};

use crate::scene::printable::{is_printable, printable_lines};
use color::ColorArg;
pub use output::Failure;

/// What a command came to, if nothing was wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Completion {
    /// All of it.
    Whole,
    /// Stopped at a limit; what was made is kept.
    Cut,
    /// Done, and the answer is no.
    No,
}

/// A ray tracer that keeps the answer to "why does this pixel have this colour?"
///
/// Without a command it opens the debugger on a built-in scene. SCENE is the name of a built-in scene (see `raytree
/// scenes`), a .json scene file, an .obj file, or - for a scene file on standard input.
#[derive(Parser)]
#[command(version, max_term_width = 100, arg_required_else_help = false)]
#[command(
    after_help = "Exit status: 0 done, 1 the input is wrong, 2 the command line is wrong, \
3 stopped at a limit (what was made is kept), 4 the answer is no (nothing was found, trees differ)."
)]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Subcommand)]
enum Command {
    /// Open the debugger: pick a pixel, step through its ray tree
    View(view::View),
    /// Render a scene to a PNG file, or as text on the terminal
    Render(render::Render),
    /// Draw a scene's triangles row by row: flat, Gouraud or Phong shading
    #[command(after_help = raster::HELP)]
    Raster(raster::Raster),
    /// Write the ray tree of one pixel
    Trace(trace::Trace),
    /// Tell which effects a scene calls for, and why
    Effects(effects::Effects),
    /// Find the pixels whose ray trees satisfy a query
    #[command(after_help = find::HELP)]
    Find(find::Find),
    /// Find the smallest scene in which a pixel has the same ray tree
    #[command(after_help = reduce::HELP)]
    Reduce(reduce::Reduce),
    /// Tell where two ray trees of a pixel differ, and which law is broken
    Diff(diff::Diff),
    /// Mark what students hand in, and name the law that their tracers break
    Grade(grade::Grade),
    /// Learn ray tracing: chapters with exercises, from the first ray to soft shadows
    Lesson(lesson::Lesson),
    /// Measure what accuracy costs in time
    Cost(cost::Cost),
    /// Look at hard cases: what common arithmetic makes of them, and what raytree does
    Stability(stability::Stability),
    /// List the built-in scenes, or print one for the ray tracer that you write
    Scenes(scenes::Scenes),
    /// Print the JSON Schema of scene files, of flat scenes or of ray trees
    Schema(schema::Schema),
    /// Print a completion script for your shell
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
}

/// Runs the command line of this process; prints what went wrong.
pub fn main() -> ExitCode {
    match advice::parse().map_or_else(|error| tell(&error), run) {
        Ok(Completion::Whole) => ExitCode::SUCCESS,
        Ok(Completion::Cut) => ExitCode::from(3),
        Ok(Completion::No) => ExitCode::from(4),
        // A reader that has seen enough is no error.
        Err(failure @ Failure::CommandLine) => failure.exit_code(),
        Err(Failure::Output { source, .. }) if source.kind() == io::ErrorKind::BrokenPipe => {
            ExitCode::SUCCESS
        }
        Err(failure) => {
            eprintln!("error: {}", printable_lines(&failure.to_string()));
            failure.exit_code()
        }
    }
}

/// Tells what is wrong with the command line, or the help or version that it asks for: that is a result, which may fail to
/// be written.
fn tell(error: &clap::Error) -> Result<Completion, Failure> {
    let is_plain = |word: OsString| word.to_string_lossy().chars().all(is_printable);
    if error.use_stderr() && !std::env::args_os().all(is_plain) {
        // What was typed would steer the terminal.
        eprint!("{}", printable_lines(&error.render().to_string()));
        return Err(Failure::CommandLine);
    }
    let written = error.print().and_then(|()| io::stdout().flush());
    if error.use_stderr() {
        return Err(Failure::CommandLine);
    }
    written.map_err(|source| Failure::Output { path: None, source })?;
    Ok(Completion::Whole)
}

fn run(cli: Cli) -> Result<Completion, Failure> {
    match cli.command {
        None => view::View::default().run(),
        Some(Command::View(command)) => command.run(),
        Some(Command::Render(command)) => command.run(),
        Some(Command::Raster(command)) => command.run(),
        Some(Command::Trace(command)) => command.run(),
        Some(Command::Effects(command)) => command.run(),
        Some(Command::Find(command)) => command.run(),
        Some(Command::Reduce(command)) => command.run(),
        Some(Command::Diff(command)) => command.run(),
        Some(Command::Grade(command)) => command.run(),
        Some(Command::Lesson(command)) => command.run(),
        Some(Command::Cost(command)) => command.run(),
        Some(Command::Stability(command)) => command.run(),
        Some(Command::Scenes(command)) => command.run(),
        Some(Command::Schema(command)) => command.run(),
        Some(Command::Completions { shell }) => {
            let mut script = Vec::new();
            clap_complete::generate(shell, &mut advice::command(), "raytree", &mut script);
            output::to_stdout(&script)
        }
    }
}
