//! The command line as clap reads it, with what clap does not know: which numbers may be negative, which size a command takes if
//! none is given, and what to do about an unknown command.

use std::path::Path;

use clap::builder::StyledStr;
use clap::error::{ContextKind, ContextValue, Error, ErrorKind};
use clap::{Arg, Command, CommandFactory as _, FromArgMatches as _};

use super::Cli;
use crate::scene::printable::{excerpt, shell_word};
use crate::scene::read::did_you_mean::did_you_mean;
use crate::scene::{is_built_in, names};

/// Size of the pictures of a command that has a default of its own.
const SIZES: [(&str, &str); 4] = [
    ("view", "[default: that of the window, or of the marks]"),
    (
        "render",
        "[default: 320x240; as text, what fits the terminal]",
    ),
    ("cost", "[default: 120x90, or that of --reference]"),
    ("find", "[default: 320x240]"),
];

/// Flags whose values are several numbers in one text.
const NUMBERS: [&str; 3] = ["pixel", "at", "size"];

/// The command line of this process.
pub fn parse() -> Result<Cli, Error> {
    let mut command = command();
    let parsed = command
        .try_get_matches_from_mut(std::env::args_os())
        .and_then(|matches| Cli::from_arg_matches(&matches));
    parsed.map_err(|error| advised(error.format(&mut command), &command))
}

/// The commands with their flags.
pub fn command() -> Command {
    Cli::command().mut_subcommands(|command| {
        let size = SIZES.iter().find(|(name, _)| *name == command.get_name());
        let command = match size {
            Some((_, default)) => command.mut_arg("size", |arg| {
                arg.help(format!("Size of the picture in pixels {default}"))
            }),
            None => command,
        };
        command.mut_args(with_negative_numbers)
    })
}

/// A flag takes `-1` for its value, so that it can say itself which numbers are possible.
fn with_negative_numbers(arg: Arg) -> Arg {
    let takes_one = arg.get_long().is_some() && arg.get_action().takes_values();
    match (takes_one, NUMBERS.contains(&arg.get_id().as_str())) {
        (true, true) => arg.allow_hyphen_values(true),
        (true, false) => arg.allow_negative_numbers(true),
        (false, _) => arg,
    }
}

/// The error with advice that fits.
fn advised(mut error: Error, all: &Command) -> Error {
    match error.kind() {
        // "Write -- before it" is no cure for a flag that does not exist.
        ErrorKind::UnknownArgument => {
            error.remove(ContextKind::Suggested);
        }
        ErrorKind::InvalidSubcommand => {
            if let Some(ContextValue::String(word)) = error.get(ContextKind::InvalidSubcommand) {
                let tip = StyledStr::from(about_command(word, all));
                error.remove(ContextKind::SuggestedSubcommand);
                error.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![tip]));
            }
        }
        _ => {}
    }
    error
}

/// What to do about a word that is no command.
fn about_command(word: &str, all: &Command) -> String {
    let view = |scene: &str| format!("`raytree view {}`", shell_word(scene));
    let before_at = word.rsplit_once('@').map_or(word, |(scene, _)| scene);
    if is_built_in(before_at) {
        return format!("a scene stands behind a command, as in {}", view(word));
    }
    if Path::new(before_at).is_file() {
        return format!("a file stands behind a command, as in {}", view(word));
    }
    let commands: Vec<&str> = all.get_subcommands().map(Command::get_name).collect();
    if let Some(near) = did_you_mean(word, commands.iter().copied()) {
        return format!("did you mean `raytree {near}`?");
    }
    if let Some(near) = did_you_mean(before_at, names()) {
        return format!("did you mean {}?", view(near));
    }
    format!(
        "`{}` is none of the commands: {}",
        excerpt(word),
        commands.join(", ")
    )
}
