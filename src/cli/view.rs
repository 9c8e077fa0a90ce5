//! `raytree view`: the debugger.

use clap::Args;

use super::address::{self, addressed};
use super::notices::Notices;
use super::settings::{SceneArgs, SettingsArgs, check};
use super::{ColorArg, Completion, Failure};
use crate::accel::clearest;
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
    #[command(flatten)]
    scene: SceneArgs,
}

impl View {
    pub fn run(&self) -> Result<Completion, Failure> {
        let (args, at) = addressed(&self.scene, self.at.as_ref())?;
        let (world, settings) = args.build(args.read()?, clearest)?;
        if let Some(at) = at.as_ref().filter(|_| args.settings.size().is_some()) {
            check::inside(&settings, at.pixel)?;
        }
        let options = Options {
            scene: args.scene.clone(),
            color: self.color.level(),
            mouse: !self.no_mouse,
            threads: args.settings.threads,
            size: args.settings.size(),
            at,
        };
        tui::run(world, settings, options).map_err(Failure::Terminal)?;
        Ok(Completion::Whole)
    }
}

impl Default for View {
    fn default() -> Self {
        Self {
            scene: SceneArgs {
                scene: DEFAULT_SCENE.to_owned(),
                notices: Notices::default(),
                settings: SettingsArgs::default(),
            },
            color: ColorArg::Auto,
            no_mouse: false,
            at: None,
        }
    }
}
