//! `raytree scenes`: what is built in.

use clap::Args;

use super::{Completion, Failure, output};

#[derive(Args)]
pub struct Scenes {
    /// As JSON
    #[arg(long)]
    json: bool,
}

impl Scenes {
    pub fn run(&self) -> Result<Completion, Failure> {
        let built_in = crate::scene::list().into_iter();
        let built_in = built_in.map(|(name, note)| (name.to_owned(), note));
        let generated = crate::scene::generated().into_iter();
        let generated = generated.map(|(name, note)| (name, note.to_owned()));
        let scenes: Vec<(String, String)> = built_in.chain(generated).collect();
        if self.json {
            let list: Vec<_> = scenes
                .iter()
                .map(|(name, note)| serde_json::json!({ "name": name, "note": note }))
                .collect();
            return output::to_stdout(format!("{:#}\n", serde_json::Value::from(list)).as_bytes());
        }
        let width = scenes.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
        let lines: Vec<String> = scenes
            .iter()
            .map(|(name, note)| {
                format!(
                    "{name:width$}  {note}
"
                )
            })
            .collect();
        output::to_stdout(lines.concat().as_bytes())
    }
}
