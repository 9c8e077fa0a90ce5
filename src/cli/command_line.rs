//! Command lines that do the same again.

use crate::scene::{Scene, Settings, flags};

/// The scene and the settings as words of a command line. The accelerator is left out: it changes no result.
pub fn words(scene_arg: &str, settings: &Settings, scene: &Scene) -> String {
    let (width, height) = settings.size();
    let mut line = format!("{} --size {width}x{height}", quoted(scene_arg));
    for (flag, value) in flags(settings, scene) {
        if flag != "accel" {
            line.extend([" --", flag, " ", &value]);
        }
    }
    line
}

/// As a shell takes it for one word.
pub fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "-_./:,+=@%".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        return word.to_owned();
    }
    format!("'{}'", word.replace('\'', "'\\''"))
}
