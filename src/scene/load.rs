//! Loading of a scene: by the name of a built-in or computed one, from a scene file, from an OBJ file.

use std::collections::BTreeMap;
use std::path::Path;

use super::Scene;
use super::gallery::model_scene::model_scene;
use super::gallery::{builtin, procedural};
use super::read::did_you_mean::did_you_mean;
use super::read::error::{Problem, SceneError};
use super::read::file::parse;
use super::read::files::{Files, regular};
use super::read::resolve::resolve;

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
        regular(path).map_err(|p| p.in_file(spec))?;
    }
    read(spec, Files::beside(path))
}

/// Scene from files in memory, by their paths: that in `name`, which ends in `.json` or `.obj`, and those that it names.
/// Nothing is read from disk; paths and sizes are bounded as there.
pub fn load_from_memory(name: &str, files: BTreeMap<String, Vec<u8>>) -> Result<Scene, SceneError> {
    read(name, Files::in_memory(files))
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
        let mut file = parse(&text, spec)?;
        file.name.get_or_insert_with(|| stem.to_string());
        return resolve(file, spec, files);
    }
    if ends_in(path, "obj") {
        return model_scene(spec, stem, files);
    }
    Err(unknown(spec).in_file(spec))
}

fn ends_in(path: &Path, ending: &str) -> bool {
    let found = path.extension().and_then(|e| e.to_str());
    found.is_some_and(|e| e.eq_ignore_ascii_case(ending))
}

fn unknown(spec: &str) -> Problem {
    let names: Vec<&str> = builtin::names().chain(procedural::names()).collect();
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
