//! `raytree view`: the debugger.

use clap::Args;

use super::notices::Notices;
use super::settings::{SceneArgs, SettingsArgs};
use super::{ColorArg, Completion, Failure};
use crate::accel::clearest;
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
    #[command(flatten)]
    scene: SceneArgs,
}

impl View {
    pub fn run(&self) -> Result<Completion, Failure> {
        let (world, settings) = self.scene.build(self.scene.read()?, clearest)?;
        let options = Options {
            scene: self.scene.scene.clone(),
            color: self.color.level(),
            mouse: !self.no_mouse,
            threads: self.scene.settings.threads,
            size: self.scene.settings.size(),
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
        }
    }
}
