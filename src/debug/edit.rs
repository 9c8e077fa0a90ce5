//! A scene that is changed while it is looked at: read and built again, with what the user chose kept.

use super::outline::{ObjectOutline, outlines};
use crate::math::Rgb;
use crate::scene::effects::{Finding, effects, findings};
use crate::scene::error::SceneError;
use crate::scene::printable::{is_printable, printable_lines};
use crate::scene::{Edit, Effects, Patch, Scene, SceneSource, Settings, flags};
use crate::shading::{Light, LightKind, Material};
use crate::world::{World, checks};

/// Materials, lights and shapes that examples are made of at most.
const MOST_EXAMPLES: usize = 3;

/// A changed scene, ready to be shown.
pub struct EditedWorld {
    /// The scene, with printable names, and its accelerator.
    pub world: World,
    /// Every effect, and whether the scene calls for it now.
    pub findings: Vec<Finding>,
    /// The objects as a drawing shows them.
    pub outlines: Vec<ObjectOutline>,
    /// What is changed, all in all.
    pub patch: Patch,
}

/// Reads the scene from its source with these changes and builds it for these settings; `label` is what the user calls the scene.
pub fn edited(
    source: &SceneSource,
    edits: &[Edit],
    settings: &Settings,
    label: &str,
) -> Result<EditedWorld, SceneError> {
    let (scene, patch) = source.changed(edits)?;
    let scene = scene.computed_with(settings.arithmetic);
    let mut world = World::new(scene, settings.accel);
    let found = checks::warnings(&world, settings, label);
    world.scene.warnings.extend(found);
    world.scene = world.scene.with_printable_names();
    Ok(EditedWorld {
        findings: findings(&world.scene),
        outlines: outlines(&world.scene),
        world,
        patch,
    })
}

/// The effects that are simulated in a changed scene: all that it calls for, without those that the user left out before.
pub fn kept_effects(settings: &Settings, before: &Scene, after: &Scene) -> Effects {
    let left_out = settings.left_out(before);
    left_out.fold(effects(after), Effects::without)
}

/// An error in one line.
pub fn in_one_line(error: &SceneError) -> String {
    let problem = &error.problem;
    format!("{}; {}", problem.what, problem.cure)
}

/// Changes to begin with: numbers of the scene's own materials, lights and camera, as they are now.
pub fn examples(scene: &Scene) -> Vec<String> {
    let mut examples = Vec::new();
    // Others could not be typed, or stand for another name.
    let is_plain = |name: &str| name.chars().all(|c| is_printable(c) && !"\"\\".contains(c));
    let lights = scene.lights.iter().filter(|light| is_plain(&light.name));
    lights
        .take(MOST_EXAMPLES)
        .for_each(|light| add_light(light, &mut examples));
    let materials = scene.materials.iter().filter(|m| is_plain(&m.name));
    materials
        .take(MOST_EXAMPLES)
        .for_each(|material| add_material(material, &mut examples));
    let eye = scene.camera.eye.to_array();
    examples.push(format!("camera.eye={}", row(eye)));
    examples.push(format!("background={}", color(scene.background)));
    examples
}

fn add_light(light: &Light, examples: &mut Vec<String>) {
    let name = &light.name;
    match &light.kind {
        LightKind::Point {
            position,
            intensity,
            ..
        }
        | LightKind::Spot {
            position,
            intensity,
            ..
        } => {
            examples.push(format!("light.{name}.intensity={}", color(*intensity)));
            let position = row(position.to_array());
            examples.push(format!("light.{name}.position={position}"));
        }
        LightKind::Directional { intensity, .. } => {
            examples.push(format!("light.{name}.intensity={}", color(*intensity)));
        }
        // What it sends out is that of a material.
        LightKind::Area(_) => {}
    }
}

fn add_material(material: &Material, examples: &mut Vec<String>) {
    let name = &material.name;
    if material.is_transmissive() {
        examples.push(format!("material.{name}.ior={}", material.ior));
    }
    let colors = [
        ("emission", material.emission),
        ("mirror", material.mirror),
        ("diffuse", material.diffuse),
    ];
    if let Some((field, value)) = colors.into_iter().find(|(_, value)| !value.is_black()) {
        examples.push(format!("material.{name}.{field}={}", color(value)));
    }
}

fn color(color: Rgb) -> String {
    row(color.channels())
}

fn row(numbers: [f64; 3]) -> String {
    format!("[{}]", numbers.map(|x| x.to_string()).join(","))
}

/// What is changed of a scene, for reading; `command` opens it again.
pub fn told(scene: &Scene, settings: &Settings, patch: &Patch, command: &str) -> String {
    let settings: Vec<String> = flags(settings, scene)
        .iter()
        .map(|(flag, value)| format!("  --{flag} {value}"))
        .collect();
    if patch.is_empty() && settings.is_empty() {
        return "nothing is changed: = changes a number of the scene, or a setting".to_owned();
    }
    let mut parts = Vec::new();
    if !patch.is_empty() {
        let changes: Vec<String> = scene.changes.iter().map(|c| format!("  {c}")).collect();
        let changes = changes.join("\n");
        parts.push(format!(
            "In the scene (U takes the last one back):\n{changes}"
        ));
    }
    if !settings.is_empty() {
        parts.push(format!("Settings:\n{}", settings.join("\n")));
    }
    parts.push(format!("All of it again:\n  {command}"));
    if !patch.is_empty() {
        let json = patch.to_json();
        parts.push(format!(
            "As a patch, which P writes into a file for --patch:\n{}",
            json.trim_end()
        ));
    }
    printable_lines(&parts.join("\n\n"))
}
