//! `raytree effects`: what a scene calls for, and why.

use clap::Args;
use serde_json::json;

use super::changes::ChangeArgs;
use super::notices::Notices;
use super::settings::{SceneArgs, SettingsArgs};
use super::{Completion, Failure, output};
use crate::accel::fastest;
use crate::scene::effects::findings;
use crate::scene::printable::printable;
use crate::trace::document;
use crate::trace::export::json;

#[derive(Args)]
pub struct Effects {
    /// A built-in scene, a .json scene file, an .obj file, or - for a scene file on standard input
    scene: String,
    /// As JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    changes: ChangeArgs,
    #[command(flatten)]
    notices: Notices,
}

impl Effects {
    pub fn run(&self) -> Result<Completion, Failure> {
        let scene = SceneArgs {
            scene: self.scene.clone(),
            changes: self.changes.clone(),
            notices: self.notices,
            settings: SettingsArgs::default(),
        };
        // With its surfaces in space, where warnings may be.
        let scene = scene.build(scene.read()?, fastest)?.0.scene;
        let findings = findings(&scene);
        if self.json {
            let list: Vec<_> = findings
                .iter()
                .map(|f| json!({ "effect": f.effect.name(), "on": f.on, "reason": f.reason }))
                .collect();
            let all = json!({ "effects": list, "warnings": document::list(&scene.warnings) });
            output::to_stdout_by(|out| json::write(out, &all))?;
            return Ok(Completion::Whole);
        }
        let mut text = String::new();
        for finding in &findings {
            let state = if finding.on { "on" } else { "off" };
            let line = format!(
                "{:13} {state:4} {}\n",
                finding.effect.name(),
                printable(&finding.reason)
            );
            text.push_str(&line);
        }
        output::to_stdout(text.as_bytes())
    }
}
