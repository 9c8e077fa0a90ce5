//! `raytree scenes`: what is built in; and a scene as a ray tracer of your own reads it.

use clap::{Args, ValueEnum};

use super::changes::ChangeArgs;
use super::notices::Notices;
use super::settings::{SceneArgs, SettingsArgs};
use super::{Completion, Failure, output};
use crate::scene::flat;

#[derive(Args)]
pub struct Scenes {
    /// With --flat: a built-in scene, a .json scene file, an .obj file, or - for a scene file on standard input
    #[arg(requires = "flat", conflicts_with = "json")]
    scene: Option<String>,
    /// As JSON
    #[arg(long)]
    json: bool,
    /// Print the scene in world space, without groups, transforms, quads and model files
    #[arg(long, value_name = "FORM", value_enum, requires = "scene")]
    #[arg(num_args = 0..=1, require_equals = true, default_missing_value = "json")]
    flat: Option<FlatForm>,
    #[command(flatten)]
    notices: Notices,
}

#[derive(ValueEnum, Clone, Copy)]
enum FlatForm {
    /// The format raytree-flat/1 (see `raytree schema flat`)
    Json,
    /// A line of words and numbers for each material, light and shape
    Text,
}

impl Scenes {
    pub fn run(&self) -> Result<Completion, Failure> {
        if let (Some(scene), Some(form)) = (&self.scene, self.flat) {
            return self.print_flat(scene, form);
        }
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

    fn print_flat(&self, scene: &str, form: FlatForm) -> Result<Completion, Failure> {
        let args = SceneArgs {
            scene: scene.to_owned(),
            changes: ChangeArgs::default(),
            notices: self.notices,
            settings: SettingsArgs::default(),
        };
        let scene = args.read()?;
        self.notices.deny(args.label(), scene.warnings.len())?;
        scene.check_faces()?;
        match form {
            FlatForm::Json => output::to_stdout_by(|out| flat::write_json(out, &scene))?,
            FlatForm::Text => {
                flat::check_text(&scene)?;
                output::to_stdout_by(|out| flat::write_text(out, &scene))?;
            }
        }
        Ok(Completion::Whole)
    }
}
