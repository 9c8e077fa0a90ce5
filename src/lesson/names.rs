//! Names in the files of a course: of exercises, of scenes, of settings.

use std::collections::BTreeMap;

use super::files::{CourseFiles, is_scene_file};
use crate::grade::task::SettingValue;
use crate::scene::printable::excerpt;

/// True for names of a-z, 0-9 and -.
pub fn is_id(text: &str) -> bool {
    let fits = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
    !text.is_empty() && text.len() <= 60 && text.chars().all(fits)
}

/// The path of a scene in the course, or the name of a built-in one, which has no ending.
pub fn scene_path(folder: &str, scene: &str) -> Result<String, String> {
    if is_scene_file(scene) {
        return CourseFiles::beside(folder, scene);
    }
    if scene.contains(['/', '\\', '.']) {
        return Err(format!(
            "scene `{}` is neither a .json file of the course nor the name of a built-in scene",
            excerpt(scene)
        ));
    }
    Ok(scene.to_owned())
}

/// The scene of a task by the name that the task calls it, without the effects that are left out.
pub fn scene_name(label: &str) -> &str {
    label.split(" without ").next().unwrap_or(label)
}

/// The files that a student is given of a scene of a task: as it is in the course, and flat. `label` is what the task calls it.
pub fn given_files(label: &str) -> [String; 2] {
    let name = scene_name(label);
    let short = name.rsplit('/').next().unwrap_or(name);
    let flat = format!("{}.flat.json", short.trim_end_matches(".json"));
    [short.to_owned(), flat]
}

/// Settings by the names of flags.
pub fn pairs(settings: &BTreeMap<String, SettingValue>) -> Vec<(String, String)> {
    let all = settings.iter();
    all.map(|(flag, value)| (flag.clone(), value.to_string()))
        .collect()
}
