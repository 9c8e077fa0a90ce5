//! Resolving of a scene file: names are looked up, numbers checked, shapes carried into the world.
//!
//! What passes here cannot make the tracer panic, and every refusal names the field and the cure.

mod camera;
mod checks;
mod csg;
mod header;
mod instances;
mod kept_meshes;
mod light;
mod material;
mod mesh;
mod model;
mod objects;
mod part_list;
mod patches;
mod polygons;
mod resolver;
mod settings;
mod shapes;
mod solids;
mod surface;
mod transform;
mod uses;

use std::collections::HashMap;

use super::error::{FieldPath, SceneError};
use super::file::SceneFile;
use super::files::Files;
use crate::scene::limits::MAX_RADIANCE;
use crate::scene::warning::Warnings;
use crate::scene::{Scene, check};
use camera::camera;
use checks::color;
use header::Group;
use kept_meshes::KeptMeshes;
use material::material;
use part_list::PartList;
use resolver::Resolver;
use settings::settings;

/// Scene of a scene file. `label` is the file's name in messages, `files` reads the files that it names.
pub fn resolve(mut file: SceneFile, label: &str, files: Files) -> Result<Scene, SceneError> {
    let path = FieldPath::root(label);
    let camera = camera(&file.camera, &path.key("camera"))?;
    let mut resolver = Resolver {
        scene: Scene {
            name: file.name.clone().unwrap_or_else(|| label.to_string()),
            hash: String::new(),
            camera,
            background: color(file.background, MAX_RADIANCE, &path.key("background"))?,
            ambient: color(file.ambient, MAX_RADIANCE, &path.key("ambient"))?,
            materials: Vec::with_capacity(file.materials.len()),
            lights: Vec::with_capacity(file.lights.len()),
            objects: Vec::new(),
            frames: Vec::new(),
            shapes: Vec::new(),
            owners: Vec::new(),
            settings: settings(&file.settings, &path.key("settings"))?,
            warnings: Vec::new(),
            files: Vec::new(),
            changes: Vec::new(),
        },
        objects: HashMap::new(),
        materials: HashMap::new(),
        placed: 0,
        kept: KeptMeshes::default(),
        files,
        warnings: Warnings::default(),
    };
    checks::name(&resolver.scene.name, &path.key("name"))?;
    // Each is dropped as soon as it is resolved: a file of nothing but materials is in memory once, not twice.
    for (name, file) in std::mem::take(&mut file.materials) {
        let path = path.key("materials").key(&name);
        checks::name(&name, &path)?;
        let material = material(&name, &file, &path)?;
        check::material(&material, &path, &mut resolver.warnings);
        resolver.add_material(material);
    }
    let parts = PartList::new(&file.parts, path.key("parts"))?;
    resolver.add_objects(&file.objects, &Group::world(&parts), &path.key("objects"))?;
    parts.warn_of_unused(&mut resolver.warnings);
    resolver.add_lights(&file.lights, &path.key("lights"))?;
    check::scene(&resolver.scene, &path, &mut resolver.warnings);
    Ok(resolver.finish())
}
