//! From a scene file to a scene: names are looked up, numbers checked, shapes placed in the world.
//!
//! What passes here cannot make the tracer panic, and every refusal tells the field and the cure.

mod camera;
mod checks;
mod lights;
mod material;
mod meshes;
mod models;
mod objects;
mod placement;
mod settings;
mod shapes;

use std::collections::HashMap;

use super::error::{Place, SceneError};
use super::file::SceneFile;
use super::files::Files;
use super::warnings::Warnings;
use crate::scene::Scene;
use crate::scene::limits::MAX_RADIANCE;
use crate::shading::Material;
use camera::camera;
use checks::color;
use material::material;
use settings::settings;

/// Makes a scene of a scene file. `label` is the file's name in messages, `files` reads the files that it names.
pub fn resolve(mut file: SceneFile, label: &str, files: Files) -> Result<Scene, SceneError> {
    let place = Place::root(label);
    let camera = camera(&file.camera, &place.key("camera"))?;
    let mut builder = Builder {
        scene: Scene {
            name: file.name.clone().unwrap_or_else(|| label.to_string()),
            hash: String::new(),
            camera,
            background: color(file.background, MAX_RADIANCE, &place.key("background"))?,
            ambient: color(file.ambient, MAX_RADIANCE, &place.key("ambient"))?,
            materials: Vec::with_capacity(file.materials.len()),
            lights: Vec::with_capacity(file.lights.len()),
            objects: Vec::new(),
            shapes: Vec::new(),
            owners: Vec::new(),
            settings: settings(&file.settings, &place.key("settings"))?,
            warnings: Vec::new(),
        },
        names: HashMap::new(),
        known_materials: HashMap::new(),
        files,
        warnings: Warnings::default(),
    };
    checks::name(&builder.scene.name, &place.key("name"))?;
    // Each is given back as soon as it is read: a file of nothing but materials is kept once, not twice.
    for (name, file) in std::mem::take(&mut file.materials) {
        let place = place.key("materials").key(&name);
        checks::name(&name, &place)?;
        builder.add_material(material(&name, &file, &place)?);
    }
    builder.objects(&file.objects, &place.key("objects"))?;
    builder.lights(&file.lights, &place.key("lights"))?;
    Ok(builder.finish())
}

/// A scene in the making.
struct Builder {
    scene: Scene,
    /// Objects so far, by name.
    names: HashMap<String, u32>,
    /// Materials so far, by name.
    known_materials: HashMap<String, u32>,
    files: Files,
    warnings: Warnings,
}

impl Builder {
    /// Puts in a material with a name that none has yet; tells its number.
    fn add_material(&mut self, material: Material) -> u32 {
        let number = self.scene.materials.len() as u32;
        self.known_materials.insert(material.name.clone(), number);
        self.scene.materials.push(material);
        number
    }

    fn finish(mut self) -> Scene {
        if self.scene.objects.is_empty() {
            self.warnings.add(|| {
                "the scene has no objects: the picture shows the background alone".to_string()
            });
        }
        self.scene.warnings = self.warnings.into_lines();
        self.scene.hash = self.files.hash();
        self.scene
    }
}
