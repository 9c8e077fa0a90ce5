//! `raytree trace`: the ray tree of one pixel.

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use super::address::{self, addressed};
use super::output::{self, Destination, Target};
use super::settings::{SceneArgs, check};
use super::{Completion, Failure};
use crate::accel::clearest;
use crate::debug::drawing;
use crate::scene::printable::excerpt;
use crate::scene::{FileId, Scene, Settings};
use crate::trace::address::{AddressPart, subtree};
use crate::trace::document::foresee;
use crate::trace::export::{Dot, Html, RayLines, Svg, Text, json};
use crate::trace::facts::TreePath;
use crate::trace::field::field;
use crate::trace::{Address, Document, PixelTrace, View, document, trace_pixel};
use crate::world::World;

/// Rays from which on it is told how large a tree is before it is written.
const LARGE: u64 = 100_000;

#[derive(Args)]
pub struct Trace {
    /// The pixel; 0,0 is the top left corner
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel, conflicts_with = "at")]
    pixel: Option<(u32, u32)>,
    #[arg(long, value_name = "ADDRESS", help = address::HELP)]
    at: Option<Address>,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// How to write the tree
    #[arg(long, value_enum, default_value_t = Format::Json)]
    format: Format,
    /// Write JSON in one line without blanks
    #[arg(long)]
    compact: bool,
    /// Add every node visited and every shape tested (not to dot, svg and obj)
    #[arg(long)]
    traversal: bool,
    /// Do not say which laws --bend exchanges, for exam sheets
    #[arg(long)]
    anonymous: bool,
    #[command(flatten)]
    scene: SceneArgs,
}

#[derive(ValueEnum, Clone, Copy)]
enum Format {
    /// For programs: the format raytree/1 (see `raytree schema tree`)
    Json,
    /// For reading
    Text,
    /// A page for a browser, where rays are unfolded
    Html,
    /// A Graphviz diagram
    Dot,
    /// A picture of the tree
    Svg,
    /// The rays as lines, for a viewer of models
    Obj,
}

impl Format {
    /// Endings of the names of such files.
    fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Json => &["json"],
            Self::Text => &["txt"],
            Self::Html => &["html", "htm"],
            Self::Dot => &["dot", "gv"],
            Self::Svg => &["svg"],
            Self::Obj => &["obj"],
        }
    }

    /// A warning if it has no room for the steps through the accelerator.
    fn without_traversal(self) -> Option<&'static str> {
        match self {
            Self::Json | Self::Text | Self::Html | Self::Dot => None,
            Self::Svg => {
                Some("--traversal adds nothing to the format svg; json, text, html and dot have it")
            }
            Self::Obj => {
                Some("--traversal adds nothing to the format obj; json, text, html and dot have it")
            }
        }
    }
}

impl Trace {
    pub fn run(&self) -> Result<Completion, Failure> {
        let (args, at) = addressed(&self.scene, self.at.as_ref())?;
        let part = at.as_ref().and_then(|at| at.part.clone());
        let (pixel, path) = self.ray(at)?;
        let scene = args.read()?;
        self.check_format(&scene)?;
        if self.compact && !matches!(self.format, Format::Json) {
            let what = "--compact is for the format json; leave it out, or --format";
            return Err(Failure::Usage(what.to_owned()));
        }
        let target = Target {
            flag: "--output",
            path: self.output.as_deref(),
            endings: self.format.endings(),
        };
        let [file] = output::open(&scene.files, [target])?;
        let (mut world, settings) = args.build(scene, clearest)?;
        check::rays(&settings)?;
        check::inside(&settings, pixel)?;
        let unheard = self.format.without_traversal().filter(|_| self.traversal);
        if let Some(text) = unheard {
            args.notices.warn(text);
        }
        let unheard = usize::from(unheard.is_some());
        if let (Format::Json, None, None) = (self.format, &part, &path) {
            return self.stream(&args, (world, settings, pixel), file);
        }
        let is_field = matches!(part, Some(AddressPart::Field(_)));
        let trace = trace_pixel(&world, &settings, pixel, self.traversal || is_field);
        if let Some(AddressPart::Event(event)) = part {
            inside_log(event, &trace)?;
        }
        if let Some(AddressPart::Field(name)) = &part {
            let view = View {
                world: &world,
                settings: &settings,
                trace: &trace,
            };
            return self.print_field(view, &path.unwrap_or_default(), name);
        }
        let cut = trace.pixel.cut_warning(&settings, args.label());
        args.notices.tell(cut.as_slice());
        world.scene.warnings.extend(cut);
        let document = document::of(View {
            world: &world,
            settings: &settings,
            trace: &trace,
        });
        let mut document = match path {
            Some(path) => subtree(document, &path).map_err(Failure::Usage)?,
            None => document,
        };
        if self.anonymous {
            document.settings.bent = None;
        }
        let produce = |out: &mut dyn Write| self.write(out, &world.scene, &document);
        to(file, produce)?;
        let warnings = world.scene.warnings.len() + unheard;
        completion(&args, (trace.tree.dropped, trace.pixel.truncated), warnings)
    }

    /// Writes the whole document as JSON while the pixel is traced: it may be large.
    fn stream(
        &self,
        args: &SceneArgs,
        (mut world, settings, pixel): (World, Settings, (u32, u32)),
        file: Option<Destination>,
    ) -> Result<Completion, Failure> {
        let foreseen = foresee(&world, &settings, pixel, self.traversal);
        let pixel = &foreseen.trace.pixel;
        let cut = pixel.cut_warning(&settings, args.label());
        args.notices.tell(cut.as_slice());
        world.scene.warnings.extend(cut);
        if foreseen.nodes >= LARGE {
            let each = if self.compact { 900 } else { 1500 };
            args.notices.note(format!(
                "the tree has {} rays: about {} MB of JSON",
                foreseen.nodes,
                foreseen.nodes * each / 1_000_000
            ));
        }
        let mut document = document::stream(&world, &settings, &foreseen);
        if self.anonymous {
            document.settings.bent = None;
        }
        to(file, |out: &mut dyn Write| {
            if self.compact {
                json::write_compact(out, &document)
            } else {
                json::write(out, &document)
            }
        })?;
        let warnings = world.scene.warnings.len();
        completion(args, (foreseen.dropped, pixel.truncated), warnings)
    }

    /// Prints one field of a ray.
    fn print_field(&self, view: View, path: &TreePath, name: &str) -> Result<Completion, Failure> {
        if self.output.is_some() {
            let what =
                "a field is printed, and not written to a file; leave --output out, or the field";
            return Err(Failure::Usage(what.to_owned()));
        }
        let value = field(view, path, name).map_err(Failure::Usage)?;
        output::to_stdout((value.text(None) + "\n").as_bytes())
    }

    /// An error if the name of the file is that of another format than is written. (That a file is read is told elsewhere.)
    fn check_format(&self, scene: &Scene) -> Result<(), Failure> {
        let path = self.output.as_deref().unwrap_or(Path::new(""));
        let is_read = FileId::at(path).is_ok_and(|id| scene.files.contains(&id));
        let Some(ending) = path.extension().and_then(|e| e.to_str()) else {
            return Ok(());
        };
        let ending = ending.to_ascii_lowercase();
        let has = |format: &&Format| format.endings().contains(&ending.as_str());
        let Some(meant) = Format::value_variants().iter().find(has) else {
            return Ok(());
        };
        if is_read || meant.endings() == self.format.endings() {
            return Ok(());
        }
        let name = |format: Format| {
            let value = format.to_possible_value();
            value.map_or(String::new(), |value| value.get_name().to_owned())
        };
        let path = excerpt(&path.to_string_lossy());
        Err(Failure::Usage(format!(
            "--output {path}: what is written there is {}, and no .{ending} file; add --format {}, or give a name that ends in .{}",
            name(self.format),
            name(*meant),
            self.format.endings().join(" or .")
        )))
    }

    /// The pixel, and the ray whose tree is written if it is not all of them.
    fn ray(&self, at: Option<Address>) -> Result<((u32, u32), Option<TreePath>), Failure> {
        let usage = |what: &str| Err(Failure::Usage(what.to_owned()));
        match (self.pixel, at) {
            (Some(pixel), None) => Ok((pixel, None)),
            // The address of a pixel alone means all samples.
            (None, Some(at)) if at.path == TreePath::default() => Ok((at.pixel, None)),
            (None, Some(at)) => Ok((at.pixel, Some(at.path))),
            (Some(_), Some(_)) => {
                usage("the pixel is told twice; leave out --pixel, or the address behind SCENE")
            }
            (None, None) => usage("no pixel is told; add --pixel X,Y, or write SCENE@X,Y"),
        }
    }

    fn write(
        &self,
        out: &mut dyn Write,
        scene: &Scene,
        document: &Document,
    ) -> std::io::Result<()> {
        match self.format {
            Format::Json if self.compact => json::write_compact(out, document),
            Format::Json => json::write(out, document),
            Format::Text => write!(out, "{}", Text(document)),
            Format::Html => {
                let drawing = &drawing(scene, document);
                write!(out, "{}", Html { document, drawing })
            }
            Format::Dot => write!(out, "{}", Dot(document)),
            Format::Svg => write!(out, "{}", Svg(document)),
            Format::Obj => write!(out, "{}", RayLines(document)),
        }
    }
}

/// Writes to a file, or to standard output if there is none.
fn to(
    file: Option<Destination>,
    produce: impl FnOnce(&mut dyn Write) -> std::io::Result<()>,
) -> Result<(), Failure> {
    match file {
        Some(file) => file.write(produce),
        None => output::to_stdout_by(produce),
    }
}

/// How it ended, given the events that were not kept, and whether rays were not sent for want of budget.
fn completion(
    args: &SceneArgs,
    (dropped, truncated): (u64, bool),
    warnings: usize,
) -> Result<Completion, Failure> {
    if dropped > 0 {
        args.notices.warn(format!(
            "the log is full; events that were not kept: {dropped} (try a smaller --depth)"
        ));
        return Ok(Completion::Cut);
    }
    if truncated {
        args.notices.warn(super::render::CUT);
        return Ok(Completion::Cut);
    }
    args.notices.deny(args.label(), warnings)?;
    Ok(Completion::Whole)
}

/// An error if a pixel's log has no such event.
fn inside_log(event: usize, trace: &PixelTrace) -> Result<(), Failure> {
    let count = trace.tree.events.len();
    if event < count {
        return Ok(());
    }
    Err(Failure::Usage(format!(
        "there is no event #{event} of pixel {},{}; the last one is #{}",
        trace.x,
        trace.y,
        count.saturating_sub(1)
    )))
}

fn parse_pixel(text: &str) -> Result<(u32, u32), String> {
    let wrong = || format!("`{text}` is no pixel; write X,Y, such as 160,120");
    let (x, y) = text.split_once(',').ok_or_else(wrong)?;
    let number = |digits: &str| digits.trim().parse::<u32>().map_err(|_| wrong());
    Ok((number(x)?, number(y)?))
}
