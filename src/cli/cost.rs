//! `raytree cost`: what accuracy costs in time.

mod chart;
mod record;
mod reference;
mod table;

use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};

use super::output::{self, Destination, Target};
use super::settings::SceneArgs;
use super::settings::check::{self, parse_count};
use super::{Completion, Failure};
use crate::accel::fastest;
use crate::lab::{
    CostModel, Effort, EqualTime, Lab, Parameter, Reference, Sweep, affordable, equal_time,
    parameters, plot,
};
use crate::sampling::Sampler;
use crate::scene::limits::MAX_SECONDS;
use crate::scene::printable::{printable, shell_word};
use crate::scene::settings::Image;
use crate::scene::{Sampling, Scene, Settings, flags};
use crate::world::World;
use reference::GivenPicture;

/// The size of the pictures if none is asked for: small, since many are rendered.
const SIZE: (u32, u32) = (120, 90);

/// Timed renders for which there is to be time.
const PLANNED: usize = 3;

/// The part of the budget that measuring may use; the rest is for writing.
const MEASURING: f64 = 0.95;

/// The part that measuring may use if a strip is to be rendered after it.
const BEFORE_STRIP: f64 = 0.75;

#[derive(Args)]
pub struct Cost {
    /// Seconds that it may take: decides how many samples are tried
    #[arg(long, value_name = "SECONDS", default_value_t = 20.0, value_parser = parse_budget)]
    budget: f64,
    /// Timed renders of each setting, after one that counts
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = parse_count(99))]
    runs: u32,
    /// Measure these only, such as light-samples, pixel-samples-jittered, depth, min-weight, accelerator,
    /// triangle, offset, quadratic, precision
    #[arg(long = "knob", value_name = "NAME", value_delimiter = ',')]
    only: Vec<String>,
    /// The most samples that are tried, and 16 times as many in references [default: as the budget allows]
    #[arg(long, value_name = "N", value_parser = parse_count(4096))]
    most: Option<u32>,
    /// Samples of references [default: 16 times --most]
    #[arg(long, value_name = "N", requires = "most", value_parser = parse_count(65536))]
    reference_samples: Option<u32>,
    /// As JSON
    #[arg(long, conflicts_with = "csv")]
    json: bool,
    /// As CSV
    #[arg(long)]
    csv: bool,
    /// Also draw error over time to an SVG file
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
    /// Also put crops side by side into a PNG file: what each way of sampling makes of the same time
    #[arg(long, value_name = "FILE.png")]
    strip: Option<PathBuf>,
    /// Measure against this PFM or PNG file instead of references that are rendered; the pictures have its size
    #[arg(long, value_name = "FILE")]
    reference: Option<PathBuf>,
    #[command(flatten)]
    scene: SceneArgs,
}

/// What was measured.
struct Found {
    sweeps: Vec<Sweep>,
    comparisons: Vec<EqualTime>,
}

impl Cost {
    pub fn run(&self) -> Result<Completion, Failure> {
        let start = Instant::now();
        let mut scene = self.scene.read()?;
        let given = self.reference.as_deref();
        let given = given.map(GivenPicture::read).transpose()?;
        scene
            .files
            .extend(given.iter().filter_map(GivenPicture::id));
        let files = output::open(&scene.files, self.targets())?;
        let size = given.as_ref().map(|p| p.size(self.scene.settings.size()));
        let size = size.transpose()?.unwrap_or(SIZE);
        let (world, asked) = self.scene.build(scene, fastest)?;
        let base = self.base(asked, size);
        check::rays(&base)?;
        let threads = self.scene.settings.threads;
        let is_asked = |parameter: &Parameter| {
            self.only.is_empty() || self.only.iter().any(|name| parameter.is_called(name))
        };
        self.check_names(&world, &base)?;
        let model = CostModel::of(&world, &base, threads);
        self.check_budget(model.picture(&base), base.size())?;
        let given = given.map(|p| p.film(asked.image.exposure)).transpose()?;
        let runs = self.runs as usize;
        let effort = if let Some(most) = self.most {
            Effort {
                most,
                reference: self.reference_samples.unwrap_or(most.saturating_mul(16)),
            }
        } else {
            // The rest of the runs if there is time left for them.
            let planned = runs.min(PLANNED);
            affordable(&world, &base, model, (self.budget, planned), &is_asked)
        };
        let parameters: Vec<Parameter> = parameters(&world, &base, effort)
            .into_iter()
            .filter(is_asked)
            .collect();
        let wanted: usize = parameters.iter().map(|k| k.steps.len()).sum();
        let bar = progress_bar(wanted * (runs + 1), self.scene.notices.quiet);
        let mut lab = Lab {
            world,
            accel: base.accel,
            arithmetic: base.arithmetic,
            runs,
            threads,
            given: given.map(|film| Reference::new(film, base.image.exposure)),
            reference: None,
        };
        let measuring = if self.strip.is_some() {
            BEFORE_STRIP
        } else {
            MEASURING
        };
        let ends =
            [measuring, MEASURING].map(|part| start + Duration::from_secs_f64(self.budget * part));
        let found = self.measure_all(&mut lab, &parameters, model, ends, &bar);
        bar.finish_and_clear();
        let again = self.again(&base, &lab.world, effort);
        self.write(&found, files, (&lab.world.scene, &base.image), &again)?;
        let done: usize = found.sweeps.iter().map(|s| s.steps.len()).sum();
        if done < wanted {
            self.scene.notices.warn(format!(
                "the budget of {} s ended before {} of {wanted} settings (raise --budget, or lower --size or --most)",
                self.budget,
                wanted - done
            ));
            return Ok(Completion::Cut);
        }
        Ok(Completion::Whole)
    }

    /// The files that it writes.
    fn targets(&self) -> [Target<'_>; 2] {
        let target = |flag, path, endings| Target {
            flag,
            path,
            endings,
        };
        [
            target("--plot", self.plot.as_deref(), &["svg"]),
            target("--strip", self.strip.as_deref(), &["png"]),
        ]
    }

    /// An error if there is no time for even one picture.
    fn check_budget(&self, seconds: f64, (width, height): (u32, u32)) -> Result<(), Failure> {
        if seconds <= self.budget {
            return Ok(());
        }
        let cure = match self.reference {
            Some(_) => "a smaller --reference",
            None => "a smaller --size",
        };
        Err(Failure::Usage(format!(
            "--budget {}: one picture of {width}x{height} takes about {seconds:.1} s; allow more, or take {cure}",
            self.budget
        )))
    }

    /// Writes what was found, in the form that was asked for.
    fn write(
        &self,
        found: &Found,
        [svg, strip]: [Option<Destination>; 2],
        (scene, image): (&Scene, &Image),
        again: &str,
    ) -> Result<(), Failure> {
        let Found {
            sweeps,
            comparisons,
        } = found;
        let name = printable(&scene.name);
        let title = format!("{name}, {}x{}", image.width, image.height);
        if let Some(file) = svg {
            let svg = plot::svg(&title, sweeps);
            file.write(|out| out.write_all(svg.as_bytes()))?;
        }
        let mut crops = String::new();
        if let Some(file) = strip {
            if comparisons.is_empty() {
                let notices = self.scene.notices;
                notices.warn("no strip: nothing that it could show was measured");
            } else {
                crops = table::comparisons(comparisons, file.path());
                output::write_png(file, &equal_time::picture(comparisons), image.exposure)?;
            }
        }
        let text = if self.json {
            format!("{:#}\n", record::json(sweeps, again, &scene.warnings))
        } else if self.csv {
            record::csv(sweeps)
        } else {
            format!(
                "{title}; * nothing in its table is both cheaper (in rays) and nearer\n{}\n{}\n{crops}again: {again}\n",
                table::text(sweeps),
                chart::lines(sweeps)
            )
        };
        output::to_stdout(text.as_bytes())?;
        if self.json || self.csv {
            eprint!("{crops}");
        }
        Ok(())
    }

    /// Measures group after group until the first of two ends, and renders strips until the second. Each group may take its
    /// share of the time that is left, as its price is to that of all that are still to come.
    fn measure_all(
        &self,
        lab: &mut Lab,
        parameters: &[Parameter],
        model: CostModel,
        [measuring, end]: [Instant; 2],
        bar: &ProgressBar,
    ) -> Found {
        let groups: Vec<Vec<Parameter>> = parameters
            .chunk_by(|a, b| a.group == b.group)
            .map(<[Parameter]>::to_vec)
            .collect();
        let costs: Vec<f64> = groups.iter().map(|g| model.group(g, lab.runs)).collect();
        let (mut sweeps, mut compared) = (Vec::new(), Vec::new());
        for (i, group) in groups.into_iter().enumerate() {
            let left = measuring.saturating_duration_since(Instant::now());
            let share = costs[i] / costs[i..].iter().sum::<f64>();
            let name = group[0].group;
            let told = |step: &str| {
                bar.set_message(format!("{name}: {step}"));
                bar.inc(1);
            };
            let first = sweeps.len();
            sweeps.extend(lab.measure(group, Instant::now() + left.mul_f64(share), &told));
            compared.extend(lab.reference.take().map(|r| (first..sweeps.len(), r)));
        }
        bar.set_message("crops");
        let wanted = if self.strip.is_some() {
            compared
        } else {
            vec![]
        };
        let comparisons = wanted
            .into_iter()
            .filter_map(|(of, reference)| lab.equal_time(&sweeps[of], &reference, end))
            .collect();
        Found {
            sweeps,
            comparisons,
        }
    }

    /// What all knobs have in common: small pictures, one sample of everything, if nothing else is asked for.
    fn base(&self, asked: Settings, size: (u32, u32)) -> Settings {
        let args = &self.scene.settings;
        asked.with(|s| {
            (s.image.width, s.image.height) = args.size().unwrap_or(size);
            if !args.gives("samples") {
                s.pixel.samples = 1;
            }
            if !args.gives("sampling") {
                s.pixel.sampler = Sampler::Grid;
            }
            if !args.gives("light-samples") {
                s.light.samples = 1;
            }
        })
    }

    /// An error if a name is that of no knob of this scene.
    fn check_names(&self, world: &World, base: &Settings) -> Result<(), Failure> {
        let all = parameters(world, base, Effort::LEAST);
        let unknown = self
            .only
            .iter()
            .find(|name| !all.iter().any(|parameter| parameter.is_called(name)));
        let Some(unknown) = unknown else {
            return Ok(());
        };
        let mut names: Vec<String> = all.iter().map(|k| k.group.replace(' ', "-")).collect();
        names.dedup();
        Err(Failure::Usage(format!(
            "--knob {unknown}: the scene `{}` has no such knob; it has {}",
            world.scene.name,
            names.join(", ")
        )))
    }

    /// The command that measures the same again: errors and counters to the last bit, times as they are then.
    fn again(&self, base: &Settings, world: &World, effort: Effort) -> String {
        let (width, height) = base.size();
        let mut line = format!(
            "raytree cost {} --size {width}x{height} --most {} --reference-samples {}",
            shell_word(&self.scene.scene),
            effort.most,
            effort.reference
        );
        let mut said = flags(base, &world.scene);
        // Where these are not given, they are not the scene's: see `base`.
        for (flag, value) in [
            ("samples", base.pixel.samples.to_string()),
            ("light-samples", base.light.samples.to_string()),
            (
                "sampling",
                Sampling::of(base.pixel.sampler).name().to_owned(),
            ),
        ] {
            if said.iter().all(|(name, _)| *name != flag) {
                said.push((flag, value));
            }
        }
        for (flag, value) in said {
            line.extend([" --", flag, " ", &value]);
        }
        for name in &self.only {
            line.extend([
                " --knob ",
                &shell_word(&name.replace(", ", "-").replace(' ', "-")),
            ]);
        }
        // The strip takes its share of the budget.
        for (flag, path) in [
            (" --reference ", &self.reference),
            (" --plot ", &self.plot),
            (" --strip ", &self.strip),
        ] {
            let word = path.as_ref().map(|p| shell_word(&p.to_string_lossy()));
            line.extend(word.iter().flat_map(|word| [flag, word]));
        }
        let threads = self.scene.settings.threads;
        if threads != 0 {
            // Writing to a string cannot fail.
            let _ = write!(line, " --threads {threads}");
        }
        line + &format!(" --runs {} --budget {}", self.runs, self.budget)
    }
}

fn progress_bar(steps: usize, quiet: bool) -> ProgressBar {
    if quiet {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(steps as u64);
    // The style is a constant that is known to be right.
    if let Ok(style) = ProgressStyle::with_template("{bar:30} {elapsed} {wide_msg}") {
        bar.set_style(style);
    }
    bar
}

fn parse_budget(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(x) if x > 0.0 && x <= MAX_SECONDS => Ok(x),
        _ => Err(format!(
            "must be a number of seconds above 0, {MAX_SECONDS:e} at most"
        )),
    }
}
