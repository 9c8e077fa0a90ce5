//! Loading of a scene: by the name of a built-in or computed one, from a scene file, from an OBJ file.

use std::collections::BTreeMap;
use std::path::Path;

use super::Scene;
use super::gallery::{builtin, procedural};
use super::read::did_you_mean::did_you_mean;
use super::read::error::{Problem, SceneError};
use super::read::file::parse;
use super::read::files::Files;
use super::source::{STANDARD_INPUT, SceneSource};

/// Name of a scene in messages, whatever the user named it: `-` is standard input.
pub fn label(name: &str) -> &str {
    match name {
        "-" => STANDARD_INPUT,
        name => name,
    }
}

/// Scene by `spec`: the name of a built-in or computed scene, or the path of a `.json` or `.obj` file.
pub fn load(spec: &str) -> Result<Scene, SceneError> {
    source(spec)?.scene()
}

/// Where the scene comes from that `spec` names.
pub fn source(spec: &str) -> Result<SceneSource, SceneError> {
    SceneSource::named(spec)?.ok_or_else(|| unknown(spec).in_file(spec))
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
    source_in_memory(name, files)?.scene()
}

/// Where the scene comes from that [`load_from_memory`] loads.
pub fn source_in_memory(
    name: &str,
    files: BTreeMap<String, Vec<u8>>,
) -> Result<SceneSource, SceneError> {
    SceneSource::in_files(name, Files::in_memory(files))?.ok_or_else(|| unknown(name).in_file(name))
}

/// Scene from the text of a scene file. It cannot name other files: see [`load_from_memory`] for those that do. Limits are those
/// of files, such as 256 MiB of text and 2 million shapes: see [`super::limits`].
pub fn from_json(text: &str) -> Result<Scene, SceneError> {
    SceneSource::text(text)?.scene()
}

/// Scene from a scene file on standard input, which may name OBJ files in the current folder. An error if it is a terminal, where
/// nobody would know what is waited for.
pub fn from_stdin() -> Result<Scene, SceneError> {
    SceneSource::stdin()?.scene()
}

/// Names of the built-in scenes, and what each shows.
pub fn list() -> Vec<(&'static str, String)> {
    let note = |name: &str| {
        let file = builtin::scene(name).and_then(|text| parse(text, name).ok());
        file.and_then(|f| f.note).unwrap_or_default()
    };
    builtin::names().map(|name| (name, note(name))).collect()
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
