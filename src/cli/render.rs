//! `raytree render`: the picture.

pub mod files;
mod report;
mod show;
mod stats;

use std::io::IsTerminal;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use clap::Args;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::output::{self, Target};
use super::settings::SceneArgs;
use super::settings::check::{self, parse_positive};
use super::{ColorArg, Completion, Failure, command_line, end_signals};
use crate::accel::fastest;
use crate::lab::converge::{Convergence, StopReason, converge};
use crate::lab::show::ShowMode;
use crate::probe::Silent;
use crate::sampling::Sampler;
use crate::scene::{Scene, Settings, Warning};
use crate::trace::Counts;
use crate::tracer::image::terminal;
use crate::tracer::{Film, render};
use crate::world::World;

/// What is said when a limit cut a picture short.
pub const CUT: &str = "stopped at a limit: some rays were left out to bound the work, so the result is not all that \
was asked for (raise --max-rays or --min-weight, or lower --depth)";

#[derive(Args)]
pub struct Render {
    /// Write a PNG file, or a PFM file (linear radiance, 32-bit floats) if the name ends in .pfm; without, the picture
    /// is drawn as text
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Tell how many rays, nodes and tests it took, and how long
    #[arg(long)]
    stats: bool,
    /// With --stats: as JSON on standard output (needs -o)
    #[arg(long, requires = "stats", requires = "output")]
    json: bool,
    /// Take more and more samples until the picture's estimated error (the root of the mean square of the pixels'
    /// standard errors of linear luminance) is at most this; --max-rays bounds all tries together
    #[arg(long, value_name = "E", value_parser = parse_positive, conflicts_with_all = ["adaptive", "sets"])]
    until_error: Option<f64>,
    /// Also draw each pixel's estimated standard error: .pfm as numbers, else a PNG file, white for the largest
    #[arg(long, value_name = "FILE")]
    error_map: Option<PathBuf>,
    /// Also draw how many samples each pixel took: black for the fewest, white for the most, even steps where they double
    #[arg(long, value_name = "FILE.png", requires = "adaptive")]
    sample_map: Option<PathBuf>,
    /// Show the work of each pixel, or what its eye ray meets, in the place of its colour; .pfm has the numbers themselves
    #[arg(long, value_enum, value_name = "MODE", conflicts_with_all = ["until_error", "error_map", "sample_map", "stats"])]
    show: Option<ShowMode>,
    /// Colours of the text picture
    #[arg(long, value_enum, default_value_t = ColorArg::Auto)]
    color: ColorArg,
    #[command(flatten)]
    scene: SceneArgs,
}

/// What a render made.
struct Made {
    film: Film,
    /// With which it can be made again.
    settings: Settings,
    counts: Option<Counts>,
    /// If it was to come near enough, how it did.
    found: Option<Convergence>,
}

impl Render {
    pub fn run(&self) -> Result<Completion, Failure> {
        let scene = self.scene.read()?;
        let [picture, error_map, sample_map] = output::open(&scene.files, self.targets())?;
        let (world, settings) = self.scene.build(scene, fastest)?;
        let settings = self.wanted(settings)?;
        check::rays(&settings)?;
        if let Some(mode) = self.show {
            return self.write_shown(mode, (&world, &settings), picture);
        }
        let interrupted = Arc::new(AtomicBool::new(false));
        end_signals::stop_gently(&interrupted);
        let start = Instant::now();
        let made = self.film(&world, &settings, &interrupted);
        let seconds = start.elapsed().as_secs_f64();

        let Made { film, settings, .. } = &made;
        let name = &self.scene.scene;
        let cut = film.cuts.warning(name, &world.scene, settings);
        let mut warnings = world.scene.warnings.clone();
        warnings.extend(cut.clone());
        if let Some(file) = picture {
            files::picture(file, film, settings.image.exposure)?;
        } else {
            let level = self.color.level();
            let picture = terminal::lines(film, settings.image.exposure, level);
            output::to_stdout(picture.as_bytes())?;
        }
        if let Some(file) = error_map {
            files::errors(file, film)?;
        }
        if let Some(file) = sample_map {
            files::samples(file, film)?;
        }
        if let Some(counts) = &made.counts {
            stats::tell(
                settings,
                (counts, film),
                seconds,
                self.json.then_some(&warnings),
            )?;
        }
        if let (Some(found), Some(wanted)) = (&made.found, self.until_error) {
            eprint!("{}", report::passes(found, wanted, (name, &world.scene)));
        }
        self.completion(&made, &world.scene, (cut, warnings.len()), &interrupted)
    }

    /// Tells what was wrong with the picture, of which `cut` is a warning among so many, and what it came to.
    fn completion(
        &self,
        made: &Made,
        scene: &Scene,
        (cut, warnings): (Option<Warning>, usize),
        interrupted: &AtomicBool,
    ) -> Result<Completion, Failure> {
        let Made { film, settings, .. } = made;
        let (name, notices) = (&self.scene.scene, self.scene.notices);
        if let Some(((x, y), sample)) = film.non_finite.first {
            let count = film.non_finite.count;
            let words = command_line::words(name, settings, scene);
            notices.warn(format!(
                "samples without a finite radiance: {count}; they count as black. The first is sample {sample} \
of pixel {x},{y}: raytree trace {words} --pixel {x},{y}"
            ));
        }
        notices.tell(cut.as_slice());
        if interrupted.load(Ordering::Relaxed) {
            notices.warn("interrupted: the tiles that were not reached are black");
            return Ok(Completion::Cut);
        }
        if film.truncated {
            notices.warn(CUT);
            return Ok(Completion::Cut);
        }
        notices.deny(self.scene.label(), warnings)?;
        let missed = made
            .found
            .as_ref()
            .is_some_and(|found| found.stop != StopReason::Reached);
        Ok(if missed {
            Completion::Cut
        } else {
            Completion::Whole
        })
    }

    /// The files that it writes.
    fn targets(&self) -> [Target<'_>; 3] {
        [
            ("--output", &self.output, files::PICTURE),
            ("--error-map", &self.error_map, files::PICTURE),
            ("--sample-map", &self.sample_map, &["png"]),
        ]
        .map(|(flag, path, endings)| Target {
            flag,
            path: path.as_deref(),
            endings,
        })
    }

    /// The settings with what the flags of this command say.
    fn wanted(&self, settings: Settings) -> Result<Settings, Failure> {
        if self.until_error.is_some() && self.stats {
            let what = "--until-error makes several pictures, and --stats tells of the work of one; leave --stats out, and \
render again with the settings that are told at the end";
            return Err(Failure::Usage(what.to_owned()));
        }
        let mut wanted = settings.with(|s| s.pixel.errors = self.error_map.is_some());
        if self.until_error.is_some() && settings.pixel.sampler == Sampler::Grid {
            if self.scene.settings.gives("sampling") {
                return Err(Failure::Usage(
                    "--until-error: regular samples have no chance in them, so nothing tells how wrong they are; \
choose --sampling random, jittered or sobol"
                        .to_owned(),
                ));
            }
            wanted.pixel.sampler = Sampler::Sobol;
        }
        if self.output.is_none() && !self.scene.settings.gives("size") {
            (wanted.image.width, wanted.image.height) = size_of_terminal(&settings);
        }
        Ok(wanted)
    }

    /// Renders with a progress bar; counting costs a little, so it is done only if somebody asks.
    fn film(&self, world: &World, settings: &Settings, stop: &AtomicBool) -> Made {
        let bar = progress_bar(settings, self.scene.notices.quiet);
        let rays = std::sync::atomic::AtomicU64::new(0);
        let start = Instant::now();
        let watch = |pixels, more| {
            let sum = rays.fetch_add(more, Ordering::Relaxed) + more;
            let rate = sum as f64 / start.elapsed().as_secs_f64().max(1e-3);
            bar.set_message(format!("{:.2} million rays/s", rate / 1e6));
            bar.inc(pixels);
            if stop.load(Ordering::Relaxed) {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        };
        let threads = self.scene.settings.threads;
        let mut made = Made {
            film: Film::default(),
            settings: *settings,
            counts: None,
            found: None,
        };
        if let Some(error) = self.until_error {
            let mut found = converge(world, settings, error, threads, &watch);
            (made.film, made.settings) = (std::mem::take(&mut found.film), found.settings);
            made.found = Some(found);
        } else if self.stats {
            let (film, counts) = render::<Counts>(world, settings, threads, &watch);
            made.film = film;
            made.counts = Some(counts.iter().fold(Counts::default(), Counts::plus));
        } else {
            made.film = render::<Silent>(world, settings, threads, &watch).0;
        }
        bar.finish_and_clear();
        made
    }
}

/// The largest picture of the same shape that fits the terminal, two pixels a line; 80 columns where there is none.
pub fn size_of_terminal(settings: &Settings) -> (u32, u32) {
    let terminal = std::io::stdout().is_terminal();
    let (columns, lines) = crossterm::terminal::size()
        .ok()
        .filter(|size| terminal && size.0 > 0 && size.1 > 1)
        .unwrap_or((80, 31));
    let (columns, rows) = (f64::from(columns), 2.0 * (f64::from(lines) - 1.0));
    let aspect = f64::from(settings.image.width) / f64::from(settings.image.height);
    let width = columns.min(rows * aspect).max(1.0);
    let height = (width / aspect).round().max(1.0);
    (width as u32, height as u32)
}

/// A bar on standard error, hidden where that is no terminal, and for the first moment.
fn progress_bar(settings: &Settings, quiet: bool) -> ProgressBar {
    if quiet {
        return ProgressBar::hidden();
    }
    let pixels = u64::from(settings.image.width) * u64::from(settings.image.height);
    let bar = ProgressBar::with_draw_target(Some(pixels), ProgressDrawTarget::stderr());
    let style = ProgressStyle::with_template("{wide_bar} {percent:>3} %  {msg}  {eta} left");
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
        .with_elapsed(Duration::ZERO)
}
