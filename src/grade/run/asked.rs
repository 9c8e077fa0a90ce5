//! The scenes of a task as programs get them, and the pixels that are asked of each.

use std::collections::BTreeSet;
use std::path::Path;

use super::command::{Blank, CommandLine};
use crate::grade::task::{Check, CheckKind, Task, TaskScene};
use crate::scene::{Scene, builtin, flat};

/// A scene as programs get it: only the forms that the command names.
pub struct AskedScene {
    /// As files are named after it.
    pub name: String,
    /// Columns and rows of its picture.
    pub size: (u32, u32),
    /// Pixels whose trees visible checks ask.
    pub visible: Vec<(u32, u32)>,
    /// Pixels that only hidden checks ask.
    pub hidden: Vec<(u32, u32)>,
    /// Names and bytes of files by their blanks.
    pub files: Vec<(Blank, String, Vec<u8>)>,
}

impl AskedScene {
    /// The scenes of a task. Those that differ in nothing but what is left out of our reference are one to a program.
    pub fn all(task: &Task, command: &CommandLine) -> Result<Vec<Self>, String> {
        let mut all: Vec<Self> = Vec::new();
        for (index, scene) in task.scenes.iter().enumerate() {
            if task.scenes[..index]
                .iter()
                .any(|before| before.path == scene.path)
            {
                continue;
            }
            let asked = |is_visible: bool| -> BTreeSet<(u32, u32)> {
                let of_scene = |check: &&Check| {
                    task.scenes[check.scene].path == scene.path && check.visible == is_visible
                };
                // By rows, as pictures are read.
                let pixels = task.checks.iter().filter(of_scene).flat_map(pixels);
                pixels.map(|(x, y)| (y, x)).collect()
            };
            let (visible, hidden) = (asked(true), asked(false));
            let by_columns = |rows: Vec<&(u32, u32)>| rows.iter().map(|(y, x)| (*x, *y)).collect();
            all.push(Self {
                name: name(&scene.path),
                size: scene.settings.size(),
                hidden: by_columns(hidden.difference(&visible).collect()),
                visible: by_columns(visible.iter().collect()),
                files: files(scene, command)?,
            });
        }
        Ok(all)
    }
}

/// The pixels whose trees a check asks.
fn pixels(check: &Check) -> Vec<(u32, u32)> {
    match &check.kind {
        CheckKind::Trees { pixels, .. } => pixels.iter().filter_map(|p| p.pixel).collect(),
        CheckKind::Estimate { references, .. } => references.iter().map(|r| r.pixel).collect(),
        CheckKind::Picture { .. } => Vec::new(),
    }
}

/// The name of a file without folder and endings.
fn name(path: &str) -> String {
    let base = path.rsplit(['/', '\\']).next().unwrap_or(path);
    base.split('.').next().unwrap_or(base).to_owned()
}

/// The forms of a scene that the command names.
fn files(
    scene: &TaskScene,
    command: &CommandLine,
) -> Result<Vec<(Blank, String, Vec<u8>)>, String> {
    let cannot = |what: String| format!("scene {}: {what}", scene.label);
    let mut files = Vec::new();
    if command.has(Blank::Flat) || command.has(Blank::FlatText) {
        scene.world.scene.check_faces().map_err(|e| e.to_string())?;
    }
    if command.has(Blank::Scene) {
        let (name, bytes) = scene_file(&scene.path).map_err(cannot)?;
        files.push((Blank::Scene, name, bytes));
    }
    // With the settings that the task tells.
    let with_settings = || Scene {
        settings: scene.settings,
        ..scene.world.scene.clone()
    };
    if command.has(Blank::Flat) {
        let mut bytes = Vec::new();
        flat::write_json(&mut bytes, &with_settings()).map_err(|e| cannot(e.to_string()))?;
        files.push((
            Blank::Flat,
            format!("{}.flat.json", name(&scene.path)),
            bytes,
        ));
    }
    if command.has(Blank::FlatText) {
        let mut bytes = Vec::new();
        let flat_scene = with_settings();
        flat::check_text(&flat_scene).map_err(|e| e.to_string())?;
        flat::write_text(&mut bytes, &flat_scene).map_err(|e| cannot(e.to_string()))?;
        files.push((
            Blank::FlatText,
            format!("{}.flat.txt", name(&scene.path)),
            bytes,
        ));
    }
    Ok(files)
}

/// The name and the bytes of a scene's own file.
fn scene_file(path: &str) -> Result<(String, Vec<u8>), String> {
    if let Some(text) = builtin::scene(path) {
        return Ok((format!("{path}.json"), text.into()));
    }
    let file = Path::new(path);
    if !file.is_file() {
        return Err("is computed and has no file; write {flat} in the place of {scene}".to_owned());
    }
    let bytes = std::fs::read(file).map_err(|e| format!("cannot be read: {e}"))?;
    let base = file.file_name().unwrap_or_default();
    Ok((base.to_string_lossy().into_owned(), bytes))
}
