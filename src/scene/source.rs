//! Where a scene comes from: it is read from there, as it is or changed.

use std::collections::BTreeMap;
use std::io::IsTerminal as _;
use std::path::Path;

use serde_json::Value;

use super::gallery::model_scene::model_scene;
use super::gallery::{builtin, procedural};
use super::kept::Kept;
use super::limits::{MAX_CHANGED_BYTES, MAX_CHANGED_SHAPES};
use super::part::part;
use super::read::error::{Problem, SceneError};
use super::read::file::{SceneFile, parse};
use super::read::files::{Files, SCENES, regular};
use super::read::resolve::resolve;
use super::write::scene_file;
use super::{Patch, Scene};

/// Name of standard input in messages.
pub const STANDARD_INPUT: &str = "standard input";

/// A scene that is read, and can be read again with changes.
#[derive(Clone, Debug)]
pub struct SceneSource {
    /// What the scene is called in messages.
    label: String,
    /// Its name, if it does not name itself.
    name: String,
    from: SceneOrigin,
}

/// What a scene is read from.
#[derive(Clone, Debug)]
enum SceneOrigin {
    /// The text of a scene file, and the files that it may name.
    Text(String, Files),
    /// A model, among these files.
    Model(Files),
    /// A program of the gallery.
    Computed,
}

/// Changes of a scene.
#[derive(Clone, Debug)]
pub enum Edit {
    /// A patch.
    Patch(Patch),
    /// One that is typed, such as `material.glass.ior=1.3`.
    Typed(String),
}

impl SceneSource {
    /// The scene that `spec` names: a built-in or computed one, or the path of a `.json` or `.obj` file; `None` if it ends
    /// otherwise. A scene file is read, a model is not yet.
    pub fn named(spec: &str) -> Result<Option<Self>, SceneError> {
        let of = |from| Self::of(spec, spec, from);
        if let Some(text) = builtin::scene(spec) {
            let mut files = Files::embedded(builtin::file);
            files.take(text.as_bytes());
            return Ok(Some(of(SceneOrigin::Text(text.to_owned(), files))));
        }
        if procedural::is_named(spec) {
            return Ok(Some(of(SceneOrigin::Computed)));
        }
        let path = Path::new(spec);
        if ends_in(path, "obj") {
            // A clear answer if it cannot be read, before it is looked for as a part of a scene.
            regular(path, SCENES).map_err(|p| p.in_file(spec))?;
        }
        Self::in_files(spec, Files::beside(path))
    }

    /// The scene in one of these files, by how its name ends.
    pub fn in_files(spec: &str, mut files: Files) -> Result<Option<Self>, SceneError> {
        let path = Path::new(spec);
        let stem = path.file_stem().and_then(|s| s.to_str()).unwrap_or(spec);
        Ok(if ends_in(path, "json") {
            let text = files.open(path).map_err(|p| p.in_file(spec))?;
            Some(Self::of(spec, stem, SceneOrigin::Text(text, files)))
        } else if ends_in(path, "obj") {
            Some(Self::of(spec, stem, SceneOrigin::Model(files)))
        } else {
            None
        })
    }

    /// The scene file in a text, which cannot name other files.
    pub fn text(text: &str) -> Result<Self, SceneError> {
        const NAME: &str = "scene";
        let mut files = Files::in_memory(BTreeMap::new());
        files.check_text(text).map_err(|p| p.in_file(NAME))?;
        Ok(Self::of(
            NAME,
            NAME,
            SceneOrigin::Text(text.to_owned(), files),
        ))
    }

    /// The scene file on standard input, which may name OBJ files in the current folder. An error if it is a terminal, where nobody
    /// would know what is waited for.
    pub fn stdin() -> Result<Self, SceneError> {
        let stdin = std::io::stdin();
        if stdin.is_terminal() {
            let cure = "give it a scene file, as in `raytree render - < scene.json`";
            let problem = Problem::new("this is a terminal, and a scene is wanted", cure);
            return Err(problem.in_file(STANDARD_INPUT));
        }
        let mut files = Files::beside(Path::new(STANDARD_INPUT));
        let text = files
            .read_stdin(stdin.lock())
            .map_err(|p| p.in_file(STANDARD_INPUT))?;
        let from = SceneOrigin::Text(text, files);
        Ok(Self::of(STANDARD_INPUT, STANDARD_INPUT, from))
    }

    fn of(label: &str, name: &str, from: SceneOrigin) -> Self {
        Self {
            label: label.to_owned(),
            name: name.to_owned(),
            from,
        }
    }

    /// The scene as it is.
    pub fn scene(&self) -> Result<Scene, SceneError> {
        match &self.from {
            SceneOrigin::Text(text, files) => {
                resolve(self.parsed(text)?, &self.label, files.clone())
            }
            SceneOrigin::Model(files) => model_scene(&self.label, &self.name, files.clone()),
            SceneOrigin::Computed => procedural::load(&self.label)
                .unwrap_or_else(|| Err(self.error(Problem::new("there is no such scene", "")))),
        }
    }

    /// The scene with changes, one after the other, and what they came to. It is read by the ordinary reader, with its checks, from the
    /// same folder. Where nothing is changed in the end, it is the scene as it is, to the bit.
    pub fn changed(&self, edits: &[Edit]) -> Result<(Scene, Patch), SceneError> {
        if edits.is_empty() {
            return Ok((self.scene()?, Patch::default()));
        }
        let (file, files) = self.scene_file()?;
        let before = self.json(&file)?;
        drop(file);
        let mut json = before.clone();
        for edit in edits {
            match edit {
                Edit::Patch(patch) => patch.apply(&mut json),
                Edit::Typed(text) => {
                    let patch = Patch::typed(text, &json);
                    patch.and_then(|patch| patch.apply(&mut json))
                }
            }
            .map_err(|problem| self.error(problem))?;
        }
        // In this text no line means anything to the user.
        let file = parse(&json.to_string(), &self.label).map_err(|error| SceneError {
            position: None,
            ..error
        })?;
        let after = self.json(&file)?;
        let patch = Patch::between(&before, &after).map_err(|problem| self.error(problem))?;
        if patch.is_empty() {
            return Ok((self.scene()?, patch));
        }
        let files = files.of_other_text(&after.to_string());
        let mut scene = resolve(file, &self.label, files)?;
        scene.changes = patch.flags(&before);
        Ok((scene, patch))
    }

    /// The text of the scene file, and its JSON with changes if there are any. Of a scene that is no scene file, that of one which
    /// is written.
    pub fn file_with(&self, edits: &[Edit]) -> Result<(String, Option<Value>), SceneError> {
        let (file, _) = self.scene_file()?;
        let mut full = self.json(&file)?;
        let text = match &self.from {
            SceneOrigin::Text(text, _) => text.clone(),
            _ => full.to_string(),
        };
        if edits.is_empty() {
            return Ok((text, None));
        }
        let written = serde_json::from_str(&text);
        let mut own: Value =
            written.map_err(|e: serde_json::Error| self.error(Problem::new(e.to_string(), "")))?;
        for edit in edits {
            let patch = match edit {
                Edit::Patch(patch) => Ok(patch.clone()),
                Edit::Typed(text) => Patch::typed(text, &full),
            };
            let changed = patch.and_then(|patch| {
                patch.apply(&mut full)?;
                patch.apply(&mut own)
            });
            changed.map_err(|problem| self.error(problem))?;
        }
        Ok((text, Some(own)))
    }

    /// The scene as a scene file, and the files that it may name. What is no scene file is written as one.
    fn scene_file(&self) -> Result<(SceneFile, Files), SceneError> {
        let too_large = |what: String| {
            let cure = "change the file itself, or keep its meshes in OBJ files that it names";
            self.error(Problem::new(what, cure))
        };
        if let SceneOrigin::Text(text, files) = &self.from {
            if text.len() > MAX_CHANGED_BYTES {
                let most = MAX_CHANGED_BYTES >> 20;
                return Err(too_large(format!(
                    "a scene file of more than {most} MiB cannot be changed here"
                )));
            }
            return Ok((self.parsed(text)?, files.clone()));
        }
        let scene = self.scene()?;
        if scene.shapes.len() > MAX_CHANGED_SHAPES {
            return Err(too_large(format!(
                "a scene of more than {MAX_CHANGED_SHAPES} shapes that is no scene file cannot be changed here"
            )));
        }
        // A scene file parts objects of many shapes.
        let whole = part(&scene, &Kept::all(&scene)).scene;
        let text = scene_file(&whole, "").map_err(|why| {
            let cure = "write a scene file that names the model, and change that";
            self.error(Problem::new(
                format!("this scene is no scene file, and cannot be written as one: {why}"),
                cure,
            ))
        })?;
        let mut files = Files::in_memory(BTreeMap::new());
        files.read_from = scene.files;
        Ok((self.parsed(&text)?, files))
    }

    /// The JSON of a scene file, with all of its defaults.
    fn json(&self, file: &SceneFile) -> Result<Value, SceneError> {
        // Nothing but memory could be missing for that.
        super::patch::json_of(file)
            .map_err(|error| self.error(Problem::new(error.to_string(), "change the file itself")))
    }

    fn parsed(&self, text: &str) -> Result<SceneFile, SceneError> {
        let mut file = parse(text, &self.label)?;
        file.name.get_or_insert_with(|| self.name.clone());
        Ok(file)
    }

    fn error(&self, problem: Problem) -> SceneError {
        problem.in_file(&self.label)
    }
}

fn ends_in(path: &Path, ending: &str) -> bool {
    let found = path.extension().and_then(|e| e.to_str());
    found.is_some_and(|e| e.eq_ignore_ascii_case(ending))
}
