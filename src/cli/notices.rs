//! What is told on standard error besides errors: warnings, notes and progress.

use clap::Args;

use super::Failure;
use crate::scene::Warning;
use crate::scene::error::Problem;

/// How much of it is told, and whether warnings stop the command.
#[derive(Args, Clone, Copy, Debug, Default)]
pub struct Notices {
    /// Tell no warnings, notes and progress on standard error
    #[arg(short, long)]
    pub quiet: bool,
    /// Exit with status 1 if there is a warning: before the work, if it is known by then
    #[arg(long)]
    pub deny_warnings: bool,
}

impl Notices {
    /// Tells a warning.
    pub fn warn(self, text: impl std::fmt::Display) {
        if !self.quiet {
            eprintln!("warning: {text}");
        }
    }

    /// Tells a note.
    pub fn note(self, text: impl std::fmt::Display) {
        if !self.quiet {
            eprintln!("note: {text}");
        }
    }

    /// Tells warnings.
    pub fn tell(self, warnings: &[Warning]) {
        for warning in warnings {
            self.warn(warning);
        }
    }

    /// An error if there are warnings about a scene, all of which were told, and none is allowed.
    pub fn deny(self, scene: &str, warnings: usize) -> Result<(), Failure> {
        if warnings == 0 || !self.deny_warnings {
            return Ok(());
        }
        let count = match warnings {
            1 => "there is a warning".to_owned(),
            n => format!("there are {n} warnings"),
        };
        let problem = Problem::new(
            format!("{count}, and --deny-warnings allows none"),
            "mend the scene, or leave the flag out",
        );
        Err(problem.in_file(scene).into())
    }
}
