//! `raytree view`: the debugger.

use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::Args;

use super::address::{self, addressed};
use super::changes::ChangeArgs;
use super::notices::Notices;
use super::settings::{ReadScene, SceneArgs, SettingsArgs, check};
use super::{ColorArg, Completion, Failure};
use crate::accel::clearest;
use crate::debug::marks::{MAX_MARKS_BYTES, Marks};
use crate::scene::error::Problem;
use crate::scene::limits::size_problem;
use crate::scene::printable::excerpt;
use crate::scene::read::files::{regular, unreadable};
use crate::trace::Address;
use crate::tui::{self, Options};

/// What opens without a scene.
const DEFAULT_SCENE: &str = "whitted";

#[derive(Args)]
pub struct View {
    /// Colours
    #[arg(long, value_enum, default_value_t = ColorArg::Auto)]
    color: ColorArg,
    /// Leave the mouse to the terminal, which then selects text with it
    #[arg(long)]
    no_mouse: bool,
    #[arg(long, value_name = "ADDRESS", help = address::HELP)]
    at: Option<Address>,
    /// Compare the first tree that is opened with another, as key d does: with X,Y, FLAG=VALUE, a scene or a file of ray trees
    #[arg(long, value_name = "WHAT")]
    compare: Option<String>,
    /// Open the marks of this file, as " writes them; the picture has their size
    #[arg(long, value_name = "FILE")]
    marks: Option<PathBuf>,
    #[command(flatten)]
    scene: SceneArgs,
}

impl View {
    pub fn run(&self) -> Result<Completion, Failure> {
        let (args, at) = addressed(&self.scene, self.at.as_ref())?;
        let ReadScene {
            scene,
            source,
            patch,
        } = args.read_source()?;
        let (world, settings) = args.build(scene, clearest)?;
        if let Some(at) = at.as_ref().filter(|_| args.settings.size().is_some()) {
            check::inside(&settings, at.pixel)?;
        }
        let marks = self.marks.as_deref().map(read_marks).transpose()?;
        let size = args.settings.size();
        let size = size.or(marks.as_ref().map(|m| (m.size[0], m.size[1])));
        if let Some((width, height)) = size.filter(|_| marks.is_some())
            && let Some(problem) = size_problem(width, height)
        {
            return Err(Failure::Input(format!(
                "the marks have a size of {width}x{height}: {problem}"
            )));
        }
        let options = Options {
            scene: args.scene.clone(),
            source: Arc::new(source),
            patch,
            color: self.color.level(),
            mouse: !self.no_mouse,
            threads: args.settings.threads,
            size,
            at,
            compare: self.compare.clone(),
            marks,
            show: None,
            ask: None,
            folder: PathBuf::new(),
        };
        tui::run(world, settings, options).map_err(Failure::Terminal)?;
        Ok(Completion::Whole)
    }
}

/// The marks in a file.
fn read_marks(path: &Path) -> Result<Marks, Failure> {
    let wrong = |what: String| {
        let path = excerpt(&path.to_string_lossy());
        Failure::Input(format!("{path}: {what}"))
    };
    let unread = |problem: Problem| Failure::Scene(problem.in_file(&path.to_string_lossy()));
    let (mut file, length) = regular(path, ".json").map_err(unread)?;
    if length > MAX_MARKS_BYTES {
        return Err(wrong("is no file of at most 4 MiB: no marks".to_owned()));
    }
    let mut text = String::new();
    let read = file.read_to_string(&mut text);
    read.map_err(|error| unread(unreadable(&error)))?;
    Marks::from_json(&text).map_err(wrong)
}

impl Default for View {
    fn default() -> Self {
        Self {
            scene: SceneArgs {
                scene: DEFAULT_SCENE.to_owned(),
                changes: ChangeArgs::default(),
                notices: Notices::default(),
                settings: SettingsArgs::default(),
            },
            color: ColorArg::Auto,
            no_mouse: false,
            at: None,
            compare: None,
            marks: None,
        }
    }
}
