//! A scene as a scene file in world space, whose numbers have the same bits when it is read again.
//!
//! Most numbers stand in a file as they are in the scene. The others (a point to look at, an angle) are those from which the reader
//! computes what the scene has: they are searched for around the inverse (`inverse.rs`).

mod body;
mod camera;
mod csg;
mod fields;
mod inverse;
mod light;
mod material;
mod mesh;
mod object;
mod parts;
mod patches;
mod settings;
mod solid;

use crate::scene::Scene;
use fields::{Fields, quoted};
use parts::WrittenParts;

/// The text of a scene file, or what cannot be written, and why. Materials that no object has are left out.
pub fn scene_file(scene: &Scene, note: &str) -> Result<String, String> {
    let mut used = vec![false; scene.materials.len()];
    for object in &scene.objects {
        used[object.material as usize] = true;
        for leaf in &object.leaves {
            used[leaf.material as usize] = true;
        }
    }
    let materials = scene.materials.iter().zip(used);
    let materials: Vec<String> = materials
        .filter(|(_, used)| *used)
        .map(|(m, _)| format!("{}: {}", quoted(&m.name), material::material(m)))
        .collect();
    let lights = scene.lights.iter().map(|l| light::light(scene, l));
    let lights = lights.collect::<Result<Vec<String>, String>>()?;
    let mut parts = WrittenParts::default();
    let objects = (0..scene.objects.len() as u32).map(|o| match parts.use_of(scene, o) {
        Some(text) => Ok(text),
        None => object::object(scene, o),
    });
    let objects = objects.collect::<Result<Vec<String>, String>>()?;
    let mut head = Fields::default()
        .text("format", "raytree-scene/1")
        .text("name", &scene.name)
        .text("note", note)
        .raw("camera", &camera::camera(&scene.camera)?)
        .color("background", scene.background)
        .color("ambient", scene.ambient)
        .raw("materials", &list(&materials, ['{', '}']))
        .raw("lights", &list(&lights, ['[', ']']));
    if !parts.texts.is_empty() {
        head = head.raw("parts", &list(&parts.texts, ['{', '}']));
    }
    let head = head
        .raw("objects", &list(&objects, ['[', ']']))
        .raw("settings", &settings::settings(&scene.settings));
    Ok(head.lines())
}

/// Items in brackets, each on a line.
fn list(items: &[String], [open, close]: [char; 2]) -> String {
    if items.is_empty() {
        return format!("{open}{close}");
    }
    format!("{open}\n    {}\n  {close}", items.join(",\n    "))
}
