//! `raytree render`: the picture.

use std::io::IsTerminal;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use clap::Args;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::settings::SceneArgs;
use super::{ColorArg, Done, Failure, output};
use crate::accel::fastest;
use crate::probe::Silent;
use crate::scene::{Settings, World};
use crate::trace::Counts;
use crate::tracer::picture::{pfm, png, text};
use crate::tracer::{Film, Flow, render};

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
    /// Colours of the text picture
    #[arg(long, value_enum, default_value_t = ColorArg::Auto)]
    color: ColorArg,
    #[command(flatten)]
    scene: SceneArgs,
}

impl Render {
    pub fn run(&self) -> Result<Done, Failure> {
        let (world, mut settings) = self.scene.load(fastest)?;
        if self.output.is_none() && self.scene.settings.size.is_none() {
            (settings.width, settings.height) = size_of_terminal(&settings);
        }
        let interrupted = Arc::new(AtomicBool::new(false));
        on_interrupt(&interrupted);
        let start = Instant::now();
        let (film, counts) = self.film(&world, &settings, &interrupted);
        let seconds = start.elapsed().as_secs_f64();

        if let Some(path) = &self.output {
            let is_pfm = path
                .extension()
                .is_some_and(|e| e.eq_ignore_ascii_case("pfm"));
            let bytes = if is_pfm {
                Ok(pfm::encode(&film))
            } else {
                png::encode(&film, settings.exposure).map_err(std::io::Error::other)
            };
            output::write(Some(path), |out| out.write_all(&bytes?))?;
        } else {
            let level = self.color.level();
            let picture = text::lines(&film, settings.exposure, level);
            output::to_stdout(picture.as_bytes())?;
        }
        if let Some(counts) = counts {
            self.tell(&settings, &counts, seconds)?;
        }
        if interrupted.load(Ordering::Relaxed) {
            eprintln!("warning: interrupted: the tiles that were not reached are black");
            return Ok(Done::Cut);
        }
        if film.cut {
            eprintln!("warning: {CUT}");
            return Ok(Done::Cut);
        }
        Ok(Done::Whole)
    }

    /// Renders with a progress bar; counting costs a little, so it is done only if somebody asks.
    fn film(
        &self,
        world: &World,
        settings: &Settings,
        stop: &AtomicBool,
    ) -> (Film, Option<Counts>) {
        let bar = progress_bar(settings);
        let rays = std::sync::atomic::AtomicU64::new(0);
        let start = Instant::now();
        let watch = |pixels, more| {
            let sum = rays.fetch_add(more, Ordering::Relaxed) + more;
            let rate = sum as f64 / start.elapsed().as_secs_f64().max(1e-3);
            bar.set_message(format!("{:.2} million rays/s", rate / 1e6));
            bar.inc(pixels);
            if stop.load(Ordering::Relaxed) {
                Flow::Stop
            } else {
                Flow::Continue
            }
        };
        let threads = self.scene.settings.threads;
        let done = if self.stats {
            let (film, counts) = render::<Counts>(world, settings, threads, &watch);
            let sum = counts.iter().fold(Counts::default(), Counts::plus);
            (film, Some(sum))
        } else {
            (render::<Silent>(world, settings, threads, &watch).0, None)
        };
        bar.finish_and_clear();
        done
    }

    /// The counters and times.
    fn tell(&self, settings: &Settings, counts: &Counts, seconds: f64) -> Result<Done, Failure> {
        let Counts {
            incident,
            light,
            reflected,
            transmitted,
            passed,
            nodes,
            tests,
            hits,
        } = *counts;
        if self.json {
            let stats = serde_json::json!({
                "image": { "width": settings.width, "height": settings.height },
                "accel": settings.accel.name(),
                "rays": { "I": incident, "L": light, "R": reflected, "T": transmitted, "passed": passed },
                "nodes": nodes, "tests": tests, "hits": hits, "seconds": seconds,
            });
            return output::to_stdout(format!("{stats:#}\n").as_bytes());
        }
        let rays = counts.rays();
        let per_ray = |n: u64| n as f64 / rays.max(1) as f64;
        let straight_on = match passed {
            0 => String::new(),
            n => format!(", {n} straight on"),
        };
        eprintln!(
            "rays    {rays} (I {incident}, L {light}, R {reflected}, T {transmitted}{straight_on})"
        );
        eprintln!("nodes   {nodes} ({:.1} a ray)", per_ray(nodes));
        eprintln!("tests   {tests} ({:.1} a ray, {hits} hits)", per_ray(tests));
        eprintln!(
            "time    {seconds:.3} s ({:.2} million rays/s)",
            rays as f64 / seconds / 1e6
        );
        Ok(Done::Whole)
    }
}

/// The largest picture of the same shape that fits the terminal, two pixels a line; 80 columns where there is none.
fn size_of_terminal(settings: &Settings) -> (u32, u32) {
    let terminal = std::io::stdout().is_terminal();
    let (columns, lines) = crossterm::terminal::size()
        .ok()
        .filter(|size| terminal && size.0 > 0 && size.1 > 1)
        .unwrap_or((80, 31));
    let (columns, rows) = (f64::from(columns), 2.0 * (f64::from(lines) - 1.0));
    let aspect = f64::from(settings.width) / f64::from(settings.height);
    let width = columns.min(rows * aspect).max(1.0);
    let height = (width / aspect).round().max(1.0);
    (width as u32, height as u32)
}

/// A bar on standard error, hidden where that is no terminal, and for the first moment.
fn progress_bar(settings: &Settings) -> ProgressBar {
    let pixels = u64::from(settings.width) * u64::from(settings.height);
    let bar = ProgressBar::with_draw_target(Some(pixels), ProgressDrawTarget::stderr());
    let style = ProgressStyle::with_template("{wide_bar} {percent:>3} %  {msg}  {eta} left");
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
        .with_elapsed(Duration::ZERO)
}

/// Ctrl-C once: stop, and keep what was made. Twice: stop at once.
#[cfg(unix)]
fn on_interrupt(flag: &Arc<AtomicBool>) {
    use signal_hook::consts::SIGINT;
    // Without a handler Ctrl-C ends the program, as everywhere: nothing to tell.
    let _ = signal_hook::flag::register_conditional_shutdown(SIGINT, 130, Arc::clone(flag));
    let _ = signal_hook::flag::register(SIGINT, Arc::clone(flag));
}

#[cfg(not(unix))]
fn on_interrupt(_: &Arc<AtomicBool>) {}
