//! The ways to a scene: by the name of a built-in or computed one, from a scene file, from an OBJ file.

use std::collections::BTreeMap;
use std::path::Path;

use super::error::{Problem, SceneError};
use super::file::{
    CameraFile, DirectionalFile, Format, LightFile, ObjFile, ObjectFile, SceneFile, SettingsFile,
    parse,
};
use super::files::{Files, regular};
use super::nearest::nearest;
use super::resolve::resolve;
use super::{Camera, Scene, builtin, generated};
use crate::geometry::Aabb;
use crate::math::{DVec3, Rgb};

/// The scene that `spec` stands for: the name of a built-in scene or of one that is computed, or the path of a `.json` or `.obj` file.
pub fn load(spec: &str) -> Result<Scene, SceneError> {
    if let Some(text) = builtin::scene(spec) {
        let mut files = Files::embedded();
        files.take(text.as_bytes());
        return resolve(parse(text, spec)?, spec, files);
    }
    if let Some(scene) = generated::load(spec) {
        return scene;
    }
    let path = Path::new(spec);
    if ends_in(path, "obj") {
        // A clear answer if it cannot be read, before it is looked for as a part of a scene.
        regular(path).map_err(|p| p.in_file(spec))?;
    }
    read(spec, Files::beside(path))
}

/// The scene in the file `name`, which ends in `.json` or `.obj`. It and all files that it names are looked for in
/// `held`, by their paths, and on no disk; paths and sizes are bounded as there.
pub fn load_held(name: &str, held: BTreeMap<String, Vec<u8>>) -> Result<Scene, SceneError> {
    read(name, Files::held(held))
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
        return model(path, spec, stem, files);
    }
    Err(unknown(spec).in_file(spec))
}

fn ends_in(path: &Path, ending: &str) -> bool {
    let found = path.extension().and_then(|e| e.to_str());
    found.is_some_and(|e| e.eq_ignore_ascii_case(ending))
}

/// The built-in scenes: name, and what each shows.
pub fn list() -> Vec<(&'static str, String)> {
    let note = |name: &str| {
        let file = builtin::scene(name).and_then(|text| parse(text, name).ok());
        file.and_then(|f| f.note).unwrap_or_default()
    };
    builtin::names().map(|name| (name, note(name))).collect()
}

fn unknown(spec: &str) -> Problem {
    let names: Vec<&str> = builtin::names().chain(generated::names()).collect();
    let listed = names.join(", ");
    if Path::new(spec).exists() {
        return Problem::new(
            "the name of a scene file ends in .json, that of a model in .obj",
            "rename the file if it is one of these",
        );
    }
    let guess =
        nearest(spec, names).map_or(String::new(), |near| format!("did you mean `{near}`? "));
    Problem::new(
        "there is no built-in scene of this name",
        format!("{guess}Built in: {listed}; or give a file that ends in .json or .obj"),
    )
}

/// A scene around a bare model: the camera sees all of it, a light shines over the viewer's left shoulder.
fn model(path: &Path, spec: &str, stem: &str, files: Files) -> Result<Scene, SceneError> {
    let name = path.file_name().and_then(|n| n.to_str());
    let file = SceneFile {
        format: Format::V1,
        name: Some(stem.to_string()),
        note: None,
        camera: CameraFile::new([0.0, 0.0, 1.0], [0.0; 3]),
        background: Rgb::new(0.35, 0.45, 0.6),
        ambient: Rgb::grey(0.25),
        materials: BTreeMap::new(),
        lights: vec![LightFile::Directional(DirectionalFile {
            name: "key".to_string(),
            note: None,
            direction: [1.0, -1.5, -1.0],
            intensity: Rgb::grey(0.9),
        })],
        objects: vec![ObjectFile::Obj(ObjFile {
            name: stem.to_string(),
            note: None,
            material: None,
            transform: Vec::new(),
            file: name.unwrap_or(spec).to_string(),
        })],
        settings: SettingsFile::default(),
    };
    // The user has no scene file whose fields could be named.
    let mut scene = resolve(file, spec, files).map_err(|error| SceneError {
        field: String::new(),
        ..error
    })?;
    let bounds = scene
        .shapes
        .iter()
        .filter_map(crate::geometry::Shape::bounds)
        .fold(Aabb::EMPTY, Aabb::union);
    let framed = framing(bounds).ok_or_else(|| {
        Problem::new(
            "all of its triangles are without area",
            "check the model in the program that made it",
        )
        .in_file(spec)
    })?;
    scene.camera = framed;
    Ok(scene)
}

/// A camera that has all of the box in its picture, seen from the front, a little from the right and from above.
/// `None` for an empty box.
fn framing(bounds: Aabb) -> Option<Camera> {
    const FOV: f64 = 40.0;
    if bounds.is_empty() {
        return None;
    }
    let center = bounds.center();
    // The ball around the box touches the cone of view at distance radius / sin(fov / 2).
    let radius = bounds.size().length() / 2.0;
    let distance = radius / libm::sin(FOV.to_radians() / 2.0);
    let towards = DVec3::new(0.4, 0.35, 1.0).normalize();
    let eye = center + distance * towards;
    Camera::new(eye, center, DVec3::Y, FOV.to_radians())
}
