//! `raytree effects`: what a scene calls for, and why.

use clap::Args;
use clap::builder::PossibleValuesParser;
use serde_json::json;

use super::changes::ChangeArgs;
use super::notices::Notices;
use super::settings::{SceneArgs, SettingsArgs};
use super::{Completion, Failure, output};
use crate::accel::fastest;
use crate::scene::Effect;
use crate::scene::effects::{Finding, findings};
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
    /// Tell what is left out without these, with commas between
    #[arg(long, value_name = "EFFECT", value_delimiter = ',', value_parser = effect_names())]
    without: Vec<String>,
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
                .map(|f| {
                    let mut line =
                        json!({ "effect": f.effect.name(), "on": f.on, "reason": f.reason });
                    if self.leaves_out(f) {
                        line["left_out"] = f.effect.without().into();
                    }
                    line
                })
                .collect();
            let all = json!({ "effects": list, "warnings": document::list(&scene.warnings) });
            output::to_stdout_by(|out| json::write(out, &all))?;
            return Ok(Completion::Whole);
        }
        let mut text = String::new();
        for finding in &findings {
            let state = if finding.on { "on" } else { "off" };
            let left_out = match self.leaves_out(finding) {
                true if finding.on => format!("; left out: {}", finding.effect.without()),
                true => "; without it nothing changes".to_owned(),
                false => String::new(),
            };
            let line = format!(
                "{:13} {state:4} {}{left_out}\n",
                finding.effect.name(),
                printable(&finding.reason)
            );
            text.push_str(&line);
        }
        output::to_stdout(text.as_bytes())
    }

    fn leaves_out(&self, finding: &Finding) -> bool {
        self.without
            .iter()
            .any(|name| name == finding.effect.name())
    }
}

fn effect_names() -> PossibleValuesParser {
    PossibleValuesParser::new(Effect::ALL.map(Effect::name))
}
