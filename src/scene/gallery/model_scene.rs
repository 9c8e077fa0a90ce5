//! Scene around a bare model: the camera frames all of it, and a light shines over the viewer's left shoulder.

use std::collections::BTreeMap;
use std::path::Path;

use crate::geometry::{Aabb, Shape};
use crate::math::{DVec3, Rgb};
use crate::scene::read::error::{Problem, SceneError};
use crate::scene::read::file::{
    CameraFile, DirectionalFile, LightFile, ObjFile, ObjectFile, SceneFile, SceneFormat,
    SettingsFile,
};
use crate::scene::read::files::Files;
use crate::scene::read::resolve::resolve;
use crate::scene::{Camera, Scene, Warning, WarningCode};

/// Scene around the OBJ file at the path `spec`, which `files` reads; `name` is the scene's and the object's.
pub fn model_scene(spec: &str, name: &str, files: Files) -> Result<Scene, SceneError> {
    let file = Path::new(spec).file_name().and_then(|n| n.to_str());
    let file = scene_file(name, file.unwrap_or(spec));
    // The user has no scene file whose fields could be named.
    let mut scene = resolve(file, spec, files).map_err(|error| SceneError {
        field: String::new(),
        ..error
    })?;
    // Nor did they choose the light, or write what is around the model.
    let of_model = |w: &Warning| w.code != WarningCode::LightOfNoUse;
    scene.warnings.retain(of_model);
    for warning in &mut scene.warnings {
        warning.problem.field.clear();
    }
    let bounds = scene
        .shapes
        .iter()
        .filter_map(Shape::bounds)
        .fold(Aabb::EMPTY, Aabb::union);
    scene.camera = framing(bounds).ok_or_else(|| {
        Problem::new(
            "all of its triangles are without area",
            "check the model in the program that made it",
        )
        .in_file(spec)
    })?;
    Ok(scene)
}

/// Scene file with the model alone; its camera is a stand-in until the model's size is known.
fn scene_file(name: &str, file: &str) -> SceneFile {
    SceneFile {
        format: SceneFormat::V1,
        name: Some(name.to_string()),
        note: None,
        camera: CameraFile::new([0.0, 0.0, 1.0], [0.0; 3]),
        background: Rgb::new(0.35, 0.45, 0.6),
        ambient: Rgb::grey(0.25),
        materials: BTreeMap::new(),
        parts: BTreeMap::new(),
        lights: vec![LightFile::Directional(DirectionalFile {
            name: "key".to_string(),
            note: None,
            direction: [1.0, -1.5, -1.0],
            intensity: Rgb::grey(0.9),
        })],
        objects: vec![ObjectFile::Obj(ObjFile {
            name: name.to_string(),
            note: None,
            material: None,
            transform: Vec::new(),
            file: file.to_string(),
            shading: None,
        })],
        settings: SettingsFile::default(),
    }
}

/// Camera that has all of the box in its picture, seen from the front, a little from the right and from above.
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
