//! Loading of a scene: by the name of a built-in or computed one, from a scene file, from an OBJ file.

use std::collections::BTreeMap;
use std::io::IsTerminal as _;
use std::path::Path;

use super::Scene;
use super::gallery::model_scene::model_scene;
use super::gallery::{builtin, procedural};
use super::read::did_you_mean::did_you_mean;
use super::read::error::{Problem, SceneError};
use super::read::file::parse;
use super::read::files::{Files, SCENES, regular};
use super::read::resolve::resolve;

/// Name of standard input in messages.
const STANDARD_INPUT: &str = "standard input";

/// Name of a scene in messages, whatever the user named it: `-` is standard input.
pub fn label(name: &str) -> &str {
    match name {
        "-" => STANDARD_INPUT,
        name => name,
    }
}

/// Scene by `spec`: the name of a built-in or computed scene, or the path of a `.json` or `.obj` file.
pub fn load(spec: &str) -> Result<Scene, SceneError> {
    if let Some(text) = builtin::scene(spec) {
        let mut files = Files::embedded(builtin::file);
        files.take(text.as_bytes());
        return resolve(parse(text, spec)?, spec, files);
    }
    if let Some(scene) = procedural::load(spec) {
        return scene;
    }
    let path = Path::new(spec);
    if ends_in(path, "obj") {
        // A clear answer if it cannot be read, before it is looked for as a part of a scene.
        regular(path, SCENES).map_err(|p| p.in_file(spec))?;
    }
    read(spec, Files::beside(path))
}

/// Whether a built-in or computed scene has this name, with or without a size.
pub fn is_built_in(spec: &str) -> bool {
    let kind = spec.rsplit_once(':').map_or(spec, |(kind, _)| kind);
    names().any(|name| name == spec || name == kind)
}

/// Names of the built-in and the computed scenes.
pub fn names() -> impl Iterator<Item = &'static str> {
    builtin::names().chain(procedural::names())
}

/// Scene from files in memory, by their paths: that in `name`, which ends in `.json` or `.obj`, and those that it names.
/// Nothing is read from disk; paths and sizes are bounded as there.
pub fn load_from_memory(name: &str, files: BTreeMap<String, Vec<u8>>) -> Result<Scene, SceneError> {
    read(name, Files::in_memory(files))
}

/// Scene from the text of a scene file. It cannot name other files: see [`load_from_memory`] for those that do. Limits are those
/// of files, such as 256 MiB of text and 2 million shapes: see [`super::limits`].
pub fn from_json(text: &str) -> Result<Scene, SceneError> {
    const NAME: &str = "scene";
    let mut files = Files::in_memory(BTreeMap::new());
    files.check_text(text).map_err(|p| p.in_file(NAME))?;
    scene_of(text, NAME, NAME, files)
}

/// Scene from a scene file on standard input, which may name OBJ files in the current folder. An error if it is a terminal, where
/// nobody would know what is waited for.
pub fn from_stdin() -> Result<Scene, SceneError> {
    let stdin = std::io::stdin();
    if stdin.is_terminal() {
        let cure = "give it a scene file, as in `raytree render - < scene.json`";
        return Err(
            Problem::new("this is a terminal, and a scene is wanted", cure).in_file(STANDARD_INPUT),
        );
    }
    let mut files = Files::beside(Path::new(STANDARD_INPUT));
    let text = files
        .read_stdin(stdin.lock())
        .map_err(|p| p.in_file(STANDARD_INPUT))?;
    scene_of(&text, STANDARD_INPUT, STANDARD_INPUT, files)
}

/// Names of the built-in scenes, and what each shows.
pub fn list() -> Vec<(&'static str, String)> {
    let note = |name: &str| {
        let file = builtin::scene(name).and_then(|text| parse(text, name).ok());
        file.and_then(|f| f.note).unwrap_or_default()
    };
    builtin::names().map(|name| (name, note(name))).collect()
}

/// The scene in a scene file or around a model, by how its name ends.
fn read(spec: &str, mut files: Files) -> Result<Scene, SceneError> {
    let path = Path::new(spec);
    let stem = path.file_stem().and_then(|s| s.to_str()).unwrap_or(spec);
    if ends_in(path, "json") {
        let text = files.open(path).map_err(|p| p.in_file(spec))?;
        return scene_of(&text, spec, stem, files);
    }
    if ends_in(path, "obj") {
        return model_scene(spec, stem, files);
    }
    Err(unknown(spec).in_file(spec))
}

/// The scene in the text of a scene file, which is called `label` in messages, and `name` if it names itself not.
fn scene_of(text: &str, label: &str, name: &str, files: Files) -> Result<Scene, SceneError> {
    let mut file = parse(text, label)?;
    file.name.get_or_insert_with(|| name.to_string());
    resolve(file, label, files)
}

fn ends_in(path: &Path, ending: &str) -> bool {
    let found = path.extension().and_then(|e| e.to_str());
    found.is_some_and(|e| e.eq_ignore_ascii_case(ending))
}

fn unknown(spec: &str) -> Problem {
    let names: Vec<&str> = names().collect();
    let listed = names.join(", ");
    if Path::new(spec).exists() {
        return Problem::new(
            "the name of a scene file ends in .json, that of a model in .obj",
            "rename the file if it is one of these",
        );
    }
    let guess =
        did_you_mean(spec, names).map_or(String::new(), |near| format!("did you mean `{near}`? "));
    Problem::new(
        "there is no built-in scene of this name",
        format!("{guess}Built in: {listed}; or give a file that ends in .json or .obj"),
    )
}
