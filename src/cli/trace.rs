//! `raytree trace`: the ray tree of one pixel.

use std::io::Write;
use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::output::{self, Target};
use super::settings::{SceneArgs, check};
use super::{Completion, Failure};
use crate::accel::clearest;
use crate::trace::export::{Dot, Svg, Text, json};
use crate::trace::{View, document, trace_pixel};

#[derive(Args)]
pub struct Trace {
    /// The pixel; 0,0 is the top left corner
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel)]
    pixel: (u32, u32),
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// How to write the tree
    #[arg(long, value_enum, default_value_t = Format::Json)]
    format: Format,
    /// Add every node visited and every shape tested
    #[arg(long)]
    traversal: bool,
    #[command(flatten)]
    scene: SceneArgs,
}

#[derive(ValueEnum, Clone, Copy)]
enum Format {
    /// For programs: the format raytree/1 (see `raytree schema tree`)
    Json,
    /// For reading
    Text,
    /// A Graphviz diagram
    Dot,
    /// A picture of the tree
    Svg,
}

impl Format {
    /// Endings of the names of such files.
    fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Json => &["json"],
            Self::Text => &["txt"],
            Self::Dot => &["dot", "gv"],
            Self::Svg => &["svg"],
        }
    }
}

impl Trace {
    pub fn run(&self) -> Result<Completion, Failure> {
        let scene = self.scene.read()?;
        let target = Target {
            flag: "--output",
            path: self.output.as_deref(),
            endings: self.format.endings(),
        };
        let [file] = output::open(&scene.files, [target])?;
        let (mut world, settings) = self.scene.build(scene, clearest)?;
        check::rays(&settings)?;
        let (x, y) = self.pixel;
        let (width, height) = settings.size();
        if x >= width || y >= height {
            return Err(Failure::Usage(format!(
                "pixel {x},{y} is outside the picture of {width}x{height}; the last one is {},{} (see --size)",
                width - 1,
                height - 1
            )));
        }
        let trace = trace_pixel(&world, &settings, self.pixel, self.traversal);
        let cut = trace.pixel.cut_warning(&settings, self.scene.label());
        self.scene.notices.tell(cut.as_slice());
        world.scene.warnings.extend(cut);
        let document = document::of(View {
            world: &world,
            settings: &settings,
            trace: &trace,
        });
        let produce = |out: &mut dyn Write| match self.format {
            Format::Json => json::write(out, &document),
            Format::Text => write!(out, "{}", Text(&document)),
            Format::Dot => write!(out, "{}", Dot(&document)),
            Format::Svg => write!(out, "{}", Svg(&document)),
        };
        match file {
            Some(file) => file.write(produce)?,
            None => output::to_stdout_by(produce)?,
        }
        if trace.tree.dropped > 0 {
            let dropped = trace.tree.dropped;
            self.scene.notices.warn(format!(
                "the log is full; {dropped} events were not kept (try a smaller --depth)"
            ));
            return Ok(Completion::Cut);
        }
        if trace.pixel.truncated {
            self.scene.notices.warn(super::render::CUT);
            return Ok(Completion::Cut);
        }
        let warnings = world.scene.warnings.len();
        self.scene.notices.deny(self.scene.label(), warnings)?;
        Ok(Completion::Whole)
    }
}

fn parse_pixel(text: &str) -> Result<(u32, u32), String> {
    let wrong = || format!("`{text}` is no pixel; write X,Y, such as 160,120");
    let (x, y) = text.split_once(',').ok_or_else(wrong)?;
    let number = |digits: &str| digits.trim().parse::<u32>().map_err(|_| wrong());
    Ok((number(x)?, number(y)?))
}
