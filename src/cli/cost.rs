//! `raytree cost`: what accuracy costs in time.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::{Value, json};

use super::settings::SceneArgs;
use super::{Done, Failure, output};
use crate::accel::fastest;
use crate::lab::cost::{Lab, Limits, Sweep};
use crate::lab::{knobs, plot};
use crate::scene::Settings;

/// The size of the pictures if none is asked for: small, since many are rendered.
const SIZE: (u32, u32) = (120, 90);

#[derive(Args)]
pub struct Cost {
    /// Seconds that it may take; what does not fit in is left out
    #[arg(long, value_name = "SECONDS", default_value_t = 20.0, value_parser = parse_budget)]
    budget: f64,
    /// Timed renders of each setting, after one to warm up
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = clap::value_parser!(u16).range(1..=99))]
    runs: u16,
    /// As JSON
    #[arg(long, conflicts_with = "csv")]
    json: bool,
    /// As CSV
    #[arg(long)]
    csv: bool,
    /// Also draw error over time to an SVG file
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
    #[command(flatten)]
    scene: SceneArgs,
}

impl Cost {
    pub fn run(&self) -> Result<Done, Failure> {
        let start = Instant::now();
        let (world, mut settings) = self.scene.load(fastest)?;
        if self.scene.settings.size.is_none() {
            (settings.width, settings.height) = SIZE;
        }
        let knobs = knobs(&world, &settings);
        let count = knobs.iter().map(|k| k.steps.len() + 1).sum::<usize>();
        let bar = ProgressBar::new(count as u64);
        // The style is a constant that is known to be right.
        if let Ok(style) = ProgressStyle::with_template("{bar:30} {elapsed} {wide_msg}") {
            bar.set_style(style);
        }
        let limits = Limits {
            end: start + Duration::from_secs_f64(self.budget),
            runs: usize::from(self.runs),
            threads: self.scene.settings.threads,
        };
        let wanted: usize = knobs.iter().map(|k| k.steps.len()).sum();
        let mut lab = Lab::new(world, limits);
        let mut sweeps = Vec::new();
        for knob in knobs {
            let name = knob.name.clone();
            sweeps.push(lab.measure(knob, &|step| {
                bar.set_message(format!("{name}: {step}"));
                bar.inc(1);
            }));
        }
        bar.finish_and_clear();

        let title = format!(
            "{}, {}x{}",
            lab.world.scene.name, settings.width, settings.height
        );
        if let Some(path) = &self.plot {
            let svg = plot::svg(&title, &sweeps);
            output::write(Some(path), |out| out.write_all(svg.as_bytes()))?;
        }
        let again = self.again(&settings);
        let text = if self.json {
            format!("{:#}\n", as_json(&sweeps, &again))
        } else if self.csv {
            as_csv(&sweeps)
        } else {
            as_text(&sweeps, &title, &again)
        };
        output::to_stdout(text.as_bytes())?;
        let done: usize = sweeps.iter().map(|s| s.steps.len()).sum();
        if done < wanted {
            eprintln!(
                "warning: the budget of {} s ended before {} of {wanted} settings (raise --budget, or lower --size)",
                self.budget,
                wanted - done
            );
            return Ok(Done::Cut);
        }
        Ok(Done::Whole)
    }

    /// The command that measures the same again: errors and counters to the last bit, times as they are then.
    fn again(&self, settings: &Settings) -> String {
        let Settings {
            width,
            height,
            depth,
            min_weight,
            seed,
            ..
        } = settings;
        format!(
            "raytree cost {} --size {width}x{height} --depth {depth} --min-weight {min_weight} --seed {seed} --runs {} --budget {}",
            self.scene.scene, self.runs, self.budget
        )
    }
}

/// The tables. (Writing to a string cannot fail.)
fn as_text(sweeps: &[Sweep], title: &str, again: &str) -> String {
    let mut out = format!("{title}; * nothing on this knob is both cheaper and nearer\n");
    for sweep in sweeps {
        let _ = write!(
            out,
            "\n{:28} {:>9} {:>15} {:>10} {:>11} {:>11} {:>10} {:>8} {:>11}\n",
            sweep.knob.name,
            "time/ms",
            "(min..max)",
            "rays",
            "nodes",
            "tests",
            "RMSE",
            "seen/%",
            "RMSE x s"
        ); // Writing to a string cannot fail.
        for step in &sweep.steps {
            let ms = |s: f64| format!("{:.1}", s * 1e3);
            let [low, high] = step.spread;
            let errors = step.errors.map_or_else(
                || "same picture".to_owned(),
                |e| {
                    format!(
                        "{:>10.2e} {:>8.2} {:>11.2e}",
                        e.rmse,
                        e.seen * 100.0,
                        e.rmse * step.seconds
                    )
                },
            );
            let _ = writeln!(
                out,
                "{} {:26} {:>9} {:>15} {:>10} {:>11} {:>11} {errors}",
                if step.on_front { '*' } else { ' ' },
                step.step,
                ms(step.seconds),
                format!("({}..{})", ms(low), ms(high)),
                step.counts.rays(),
                step.counts.nodes,
                step.counts.tests,
            );
        }
        if let Some(sentence) = sentence(sweep) {
            let _ = writeln!(out, "  {sentence}");
        }
    }
    let _ = writeln!(out, "\nagain: {again}");
    out
}

/// What the next halving of the error costs, of knobs that are turned to have less noise.
fn sentence(sweep: &Sweep) -> Option<String> {
    let [rays, seconds] = sweep.slopes?;
    let theory = sweep.knob.theory?;
    if rays >= -0.05 {
        return Some(format!(
            "the error does not fall with more rays (slope {rays:.2}; theory, over samples: {theory})"
        ));
    }
    Some(format!(
        "the next halving of the error costs {:.1}x the rays (slope {rays:.2}; over time {seconds:.2}; theory, over samples: {theory})",
        libm::exp2(-1.0 / rays)
    ))
}

fn as_json(sweeps: &[Sweep], again: &str) -> Value {
    let step = |s: &crate::lab::Measured| {
        json!({
            "step": s.step, "seconds": s.seconds, "spread": s.spread, "runs": s.runs,
            "rays": { "I": s.counts.incident, "L": s.counts.light, "R": s.counts.reflected, "T": s.counts.transmitted },
            "nodes": s.counts.nodes, "tests": s.counts.tests, "on_front": s.on_front,
            "errors": s.errors.map(|e| json!({
                "rmse": e.rmse, "relative_mse": e.relative_mse, "max": e.max, "seen": e.seen
            })),
        })
    };
    let sweep = |s: &Sweep| {
        json!({
            "knob": s.knob.name,
            "steps": s.steps.iter().map(step).collect::<Vec<_>>(),
            "slope_over_rays": s.slopes.map(|[rays, _]| rays),
            "slope_over_time": s.slopes.map(|[_, seconds]| seconds),
        })
    };
    json!({ "again": again, "sweeps": sweeps.iter().map(sweep).collect::<Vec<_>>() })
}

/// A line a setting. (Writing to a string cannot fail.)
fn as_csv(sweeps: &[Sweep]) -> String {
    let mut out =
        "knob,step,seconds,min,max,runs,rays,nodes,tests,rmse,relative_mse,max_error,seen\n"
            .to_owned();
    for (sweep, step) in sweeps
        .iter()
        .flat_map(|s| s.steps.iter().map(move |t| (s, t)))
    {
        let errors = step.errors.map_or(",,,".to_owned(), |e| {
            format!("{},{},{},{}", e.rmse, e.relative_mse, e.max, e.seen)
        });
        let [low, high] = step.spread;
        let _ = writeln!(
            out,
            "\"{}\",{},{},{low},{high},{},{},{},{},{errors}",
            sweep.knob.name,
            step.step,
            step.seconds,
            step.runs,
            step.counts.rays(),
            step.counts.nodes,
            step.counts.tests
        );
    }
    out
}

fn parse_budget(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(x) if x > 0.0 && x <= 1e6 => Ok(x),
        _ => Err("must be a number of seconds above 0".to_owned()),
    }
}
