//! `raytree effects`: what a scene needs, and why.

use clap::Args;
use serde_json::json;

use super::{Completion, Failure, output};
use crate::scene::effects::findings;

#[derive(Args)]
pub struct Effects {
    /// A built-in scene, a .json scene file or an .obj file
    scene: String,
    /// As JSON
    #[arg(long)]
    json: bool,
}

impl Effects {
    pub fn run(&self) -> Result<Completion, Failure> {
        let findings = findings(&crate::scene::load(&self.scene)?);
        if self.json {
            let list: Vec<_> = findings
                .iter()
                .map(|f| json!({ "effect": f.effect.name(), "on": f.on, "reason": f.reason }))
                .collect();
            return output::to_stdout(format!("{:#}\n", serde_json::Value::from(list)).as_bytes());
        }
        let mut text = String::new();
        for finding in &findings {
            let state = if finding.on { "on" } else { "off" };
            let line = format!(
                "{:13} {state:4} {}\n",
                finding.effect.name(),
                finding.reason
            );
            text.push_str(&line);
        }
        output::to_stdout(text.as_bytes())
    }
}
