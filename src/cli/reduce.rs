//! `raytree reduce`: the smallest scene in which a pixel has the same ray tree.

use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use clap::Args;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::address::{self, addressed};
use super::output::{self, Target};
use super::settings::{SceneArgs, check};
use super::{Completion, Failure, end_signals};
use crate::accel::clearest;
use crate::reduce::{ReduceError, ReduceProgress, ReduceTask, Reduction, reduce};
use crate::scene::{Scene, Settings};
use crate::trace::address::node_at;
use crate::trace::facts::TreePath;
use crate::trace::{Address, View, trace_pixel};
use crate::world::World;

/// What is kept and what is not, for `--help`.
pub const HELP: &str = "\
The tree that stays is that of the whole pixel, with all of its samples: every number but those of
primitives, the steps through the accelerator, and what tells of the scene as a whole (its name, hash
and warnings). Settings of the command line are written into the scene where a scene file can have
them; the others are told, to be given with it.
Ctrl-C stops the search and writes what is left by then.";

#[derive(Args)]
pub struct Reduce {
    #[arg(long, value_name = "ADDRESS", help = address::HELP)]
    at: Option<Address>,
    /// Write the scene to this file instead of standard output
    #[arg(short, long, value_name = "FILE.json")]
    output: Option<PathBuf>,
    /// Keep every shape that the accelerator tested, too
    #[arg(long)]
    keep_tests: bool,
    #[command(flatten)]
    scene: SceneArgs,
}

impl Reduce {
    pub fn run(&self) -> Result<Completion, Failure> {
        let (args, at) = addressed(&self.scene, self.at.as_ref())?;
        let at = at.ok_or_else(|| {
            Failure::Usage("no pixel is told; add --at X,Y, or write SCENE@X,Y".to_owned())
        })?;
        let scene = args.read()?;
        let target = Target {
            flag: "--output",
            path: self.output.as_deref(),
            endings: &["json"],
        };
        let [file] = output::open(&scene.files, [target])?;
        let (world, settings) = args.build(scene.clone(), clearest)?;
        check::rays(&settings)?;
        check::inside(&settings, at.pixel)?;
        check_ray(&world, &settings, &at)?;
        let Some(reduction) = self.reduction(&args, &scene, &world, &settings, at.pixel)? else {
            args.notices.warn(ReduceError::Interrupted);
            return Ok(Completion::Cut);
        };
        let text = reduction.text.as_bytes();
        if let Some(file) = file {
            file.write(|out| out.write_all(text))?;
            output::to_stdout(format!("{reduction}\n").as_bytes())?;
        } else {
            output::to_stdout(text)?;
            if !args.notices.quiet {
                eprintln!("{reduction}");
            }
        }
        if !reduction.flags.is_empty() {
            let words = reduction.flags.iter().map(|(f, v)| format!("--{f} {v}"));
            let words: Vec<String> = words.collect();
            args.notices.note(format!(
                "a scene file has no field for all settings; the tree is the same with {}",
                words.join(" ")
            ));
        }
        if !reduction.complete {
            args.notices
                .warn("interrupted: more of the scene could be left out");
            return Ok(Completion::Cut);
        }
        Ok(Completion::Whole)
    }

    /// Reduces the scene; `None` if the user stopped it before anything was found.
    fn reduction(
        &self,
        args: &SceneArgs,
        scene: &Scene,
        world: &World,
        settings: &Settings,
        pixel: (u32, u32),
    ) -> Result<Option<Reduction>, Failure> {
        let stop = Arc::new(AtomicBool::new(false));
        end_signals::stop_gently(&stop);
        let bar = progress_bar(args.notices.quiet);
        let watch = |progress: ReduceProgress| {
            let ReduceProgress { trials, shapes } = progress;
            bar.set_message(format!("trial {trials}, shapes left: {shapes}"));
            bar.tick();
            if stop.load(Ordering::Relaxed) {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        };
        let result = reduce(ReduceTask {
            scene,
            world,
            settings,
            settings_of: &|part| args.settings.over(part, clearest),
            pixel,
            keep_tests: self.keep_tests,
            threads: args.settings.threads,
            watch: &watch,
        });
        bar.finish_and_clear();
        match result {
            Ok(reduction) => Ok(Some(reduction)),
            Err(ReduceError::Interrupted) => Ok(None),
            Err(error) => Err(Failure::Input(format!("{}: {error}", args.label()))),
        }
    }
}

/// An error if the address names a ray that the pixel does not have.
fn check_ray(world: &World, settings: &Settings, at: &Address) -> Result<(), Failure> {
    if at.path == TreePath::default() {
        return Ok(());
    }
    let trace = trace_pixel(world, settings, at.pixel, false);
    let view = View {
        world,
        settings,
        trace: &trace,
    };
    node_at(view, &at.path).map(drop).map_err(Failure::Usage)
}

/// A line on standard error that tells how far the search is, hidden where that is no terminal.
fn progress_bar(quiet: bool) -> ProgressBar {
    if quiet {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr());
    let style = ProgressStyle::with_template("{spinner} {elapsed}  {wide_msg}");
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_spinner()))
        .with_elapsed(Duration::ZERO)
}
