//! Flags of `raytree grade` that run what was handed in.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::Args;
use clap::value_parser;

use super::{Failure, end_signals};
use crate::grade::run::{ProcessLimits, RunOptions, Runner};
use crate::grade::task::Task;

#[derive(Args)]
#[command(next_help_heading = "Run programs")]
pub struct RunArgs {
    /// Run each submission, in a copy of its folder, and mark what it prints; the blanks {flat} {flat-text} {scene} {pixels}
    /// {x} {y} {width} {height} {out} are filled in
    #[arg(long, value_name = "COMMAND", conflicts_with_all = ["selftest", "bends"])]
    run: Option<String>,
    /// Seconds that a process may take
    #[arg(long, value_name = "SECONDS", default_value_t = 10, requires = "run")]
    #[arg(value_parser = value_parser!(u32).range(1..=3600))]
    time: u32,
    /// MiB of memory that a process may take; 0 for no limit
    #[arg(long, value_name = "MIB", default_value_t = 1024, requires = "run")]
    memory: u32,
    /// The sandbox: a command that starts the program behind it, where {folder} is its temporary folder; "" for none [default:
    /// bwrap or unshare, whichever works]
    #[arg(long, value_name = "COMMAND", requires = "run")]
    wrap: Option<String>,
    #[arg(skip)]
    stop: Arc<AtomicBool>,
}

impl RunArgs {
    /// What runs submissions, if they are to be run.
    pub fn runner(&self, tasks: &[Task]) -> Result<Option<Runner>, Failure> {
        let (Some(command), Some(task)) = (&self.run, tasks.first()) else {
            return Ok(None);
        };
        // Ctrl-C reaches no program in a session of its own: they are ended here.
        end_signals::stop_gently(&self.stop);
        let options = RunOptions {
            command: command.clone(),
            wrap: self.wrap.clone(),
            limits: ProcessLimits {
                seconds: self.time,
                mebibytes: self.memory,
            },
            stop: Arc::clone(&self.stop),
        };
        Runner::new(task, options).map(Some).map_err(Failure::Usage)
    }

    /// True after Ctrl-C.
    pub fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}
