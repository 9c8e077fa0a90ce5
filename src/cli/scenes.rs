//! `raytree scenes`: what is built in.

use clap::Args;

use super::{Done, Failure, output};

#[derive(Args)]
pub struct Scenes {
    /// As JSON
    #[arg(long)]
    json: bool,
}

impl Scenes {
    pub fn run(&self) -> Result<Done, Failure> {
        let scenes = crate::scene::list();
        if self.json {
            let list: Vec<_> = scenes
                .iter()
                .map(|(name, note)| serde_json::json!({ "name": name, "note": note }))
                .collect();
            return output::to_stdout(format!("{:#}\n", serde_json::Value::from(list)).as_bytes());
        }
        let width = scenes.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
        let lines: String = scenes
            .iter()
            .map(|(name, note)| format!("{name:width$}  {note}\n"))
            .collect();
        output::to_stdout(lines.as_bytes())
    }
}
