//! Runs what students hand in: their own ray tracers, on the scenes and pixels that a task asks.
//!
//! Each submission is copied into a folder of its own, and every process has its limits. What a program prints, and the files that
//! it leaves in its folder for output, take the place of what was handed in and are marked as any other submission.

mod asked;
mod command;
mod place;
mod process;
mod sandbox;

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use super::submission::{HIDDEN, Submission, SubmittedFile};
use super::task::Task;
use asked::AskedScene;
use command::{Blank, CommandLine};
use place::{RunFolder, SubmissionCopy};
use process::Ended;
pub use process::ProcessLimits;
use sandbox::Sandbox;

/// Processes that may reach the time limit; then a submission is not run further.
const MOST_TIMED_OUT: u32 = 3;
/// The time that all processes of a submission may take together, in time limits.
const MOST_TIMES: u32 = 60;
/// Bytes that all processes of a submission may print together.
const MAX_PRINTED_BYTES: usize = 256 << 20;

/// How submissions are run.
#[derive(Clone, Debug, Default)]
pub struct RunOptions {
    /// The command, as a shell's user writes it, with blanks such as `{flat}`.
    pub command: String,
    /// The command that it is wrapped in; none for the best that is found.
    pub wrap: Option<String>,
    /// The limits of a process.
    pub limits: ProcessLimits,
    /// Once it is true, all processes are ended.
    pub stop: Arc<AtomicBool>,
}

/// Runs submissions.
pub struct Runner {
    command: CommandLine,
    sandbox: Sandbox,
    options: RunOptions,
    scenes: Vec<AskedScene>,
}

/// Which pixels a process is asked for. Those of hidden checks have a process of its own, whose words are not shown.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Sight {
    Visible,
    Hidden,
}

/// What a submission came to so far.
struct Progress {
    submission: Submission,
    since: Instant,
    timed_out: u32,
    printed: usize,
    /// It is not run further.
    is_over: bool,
}

impl Runner {
    /// Reads the command and finds the sandbox; the error is for the one who wrote the command.
    pub fn new(task: &Task, options: RunOptions) -> Result<Self, String> {
        let command = CommandLine::new(&options.command)?;
        Ok(Self {
            sandbox: Sandbox::new(options.wrap.as_deref())?,
            scenes: AskedScene::all(task, &command)?,
            command,
            options,
        })
    }

    /// The sandbox in a sentence, for every report.
    pub fn sandbox(&self) -> String {
        self.sandbox.to_string()
    }

    /// Runs a submission: the result holds what it printed and wrote, and what went wrong.
    pub fn run(&self, submission: Submission) -> Submission {
        let mut progress = Progress {
            submission: Submission {
                name: submission.name,
                files: Vec::new(),
                problems: submission.problems,
            },
            since: Instant::now(),
            timed_out: 0,
            printed: 0,
            is_over: false,
        };
        let copy = match SubmissionCopy::new(&submission.files) {
            Ok(copy) => copy,
            Err(e) => {
                progress.tell(format!("cannot be copied to be run: {e}"));
                return progress.submission;
            }
        };
        // What is hidden last: nothing that is shown can come from it.
        for sight in [Sight::Visible, Sight::Hidden] {
            for scene in &self.scenes {
                let pixels = match sight {
                    Sight::Visible => &scene.visible,
                    Sight::Hidden => &scene.hidden,
                };
                let draws = sight == Sight::Visible && self.command.has(Blank::Out);
                if (draws || !pixels.is_empty()) && !progress.is_over {
                    self.run_scene(&copy, scene, (sight, pixels), &mut progress);
                }
            }
        }
        progress.submission
    }

    /// Runs a submission on a scene: a process for all pixels, or one for each.
    fn run_scene(
        &self,
        copy: &SubmissionCopy,
        scene: &AskedScene,
        (sight, pixels): (Sight, &[(u32, u32)]),
        progress: &mut Progress,
    ) {
        let folder = match copy.folder(scene, pixels) {
            Ok(folder) => folder,
            Err(e) => return progress.tell(format!("{}: cannot be run: {e}", scene.name)),
        };
        let runs: Vec<Option<(u32, u32)>> = if self.command.is_for_one_pixel() {
            pixels.iter().copied().map(Some).collect()
        } else {
            vec![None]
        };
        let mut untold = 0;
        let mut has_failed = false;
        for pixel in runs {
            self.check_limits(progress);
            if progress.is_over {
                break;
            }
            let failure = self.run_process(copy, &folder, (scene, sight, pixel), progress);
            let Some(failure) = failure else {
                continue;
            };
            if has_failed {
                untold += 1;
            } else {
                let of = about(scene, sight, pixel);
                progress.tell(format!("{of}: {failure}"));
            }
            has_failed = true;
        }
        if untold > 0 {
            let of = about(scene, sight, None);
            progress.tell(format!("{of}: more processes that failed: {untold}"));
        }
        progress.take_files(folder.written(), sight);
    }

    /// Runs a process; what went wrong, if anything.
    fn run_process(
        &self,
        copy: &SubmissionCopy,
        folder: &RunFolder,
        (scene, sight, pixel): (&AskedScene, Sight, Option<(u32, u32)>),
        progress: &mut Progress,
    ) -> Option<String> {
        let words = self
            .command
            .filled(|blank| folder.value(blank, scene, pixel));
        let wrap = self.sandbox.words(copy, folder);
        let options = &self.options;
        let ran = process::run((&wrap, &words), copy.path(), options.limits, &options.stop);
        progress.printed += ran.printed.len();
        progress.timed_out += u32::from(ran.ended == Ended::OutOfTime);
        let part = match (pixel, sight) {
            (Some((x, y)), Sight::Visible) => format!("{x}-{y}.ndjson"),
            (Some((x, y)), Sight::Hidden) => format!("{x}-{y}{HIDDEN}ndjson"),
            (None, Sight::Visible) => "ndjson".to_owned(),
            (None, Sight::Hidden) => format!("{}ndjson", &HIDDEN[1..]),
        };
        if !ran.printed.is_empty() {
            progress.submission.files.push(SubmittedFile {
                name: format!("{}.{part}", scene.name),
                bytes: ran.printed,
            });
        }
        let said = if sight == Sight::Visible {
            ran.said
        } else {
            String::new()
        };
        ran.ended.failure(options.limits, &said)
    }

    /// Ends a submission that took too much.
    fn check_limits(&self, progress: &mut Progress) {
        let seconds = self.options.limits.seconds * MOST_TIMES;
        let why = if self.options.stop.load(Ordering::Relaxed) {
            "stopped".to_owned()
        } else if progress.timed_out >= MOST_TIMED_OUT {
            format!("reached the time limit {MOST_TIMED_OUT} times")
        } else if progress.since.elapsed() > Duration::from_secs(seconds.into()) {
            format!("took more than {seconds} s in all")
        } else if progress.printed > MAX_PRINTED_BYTES {
            format!("printed more than {} MiB in all", MAX_PRINTED_BYTES >> 20)
        } else {
            return;
        };
        progress.tell(format!("{why}: it is not run further"));
        progress.is_over = true;
    }
}

impl Progress {
    fn tell(&mut self, problem: String) {
        self.submission.problems.push(problem);
    }

    /// Takes what a program wrote into its folder for output.
    fn take_files(&mut self, written: Submission, sight: Sight) {
        for mut file in written.files {
            if sight == Sight::Hidden {
                file.name = file.name.replacen('.', HIDDEN, 1);
            }
            self.submission.files.push(file);
        }
        if sight == Sight::Visible {
            self.submission.problems.extend(written.problems);
        }
    }
}

/// What a process was run on, in words; hidden pixels have no address.
fn about(scene: &AskedScene, sight: Sight, pixel: Option<(u32, u32)>) -> String {
    match (sight, pixel) {
        (Sight::Hidden, _) => format!("{}, hidden pixels", scene.name),
        (Sight::Visible, Some((x, y))) => format!("{} at {x},{y}", scene.name),
        (Sight::Visible, None) => scene.name.clone(),
    }
}
