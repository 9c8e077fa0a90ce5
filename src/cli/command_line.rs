//! Command lines that do the same again.

use crate::scene::printable::shell_word;
use crate::scene::{Scene, Settings, changes, flags};

/// The scene and the settings as words of a command line. The accelerator is left out: it changes no result.
pub fn words(scene_arg: &str, settings: &Settings, scene: &Scene) -> String {
    let (width, height) = settings.size();
    let mut line = format!("{} --size {width}x{height}", shell_word(scene_arg));
    for (flag, value) in flags(settings, scene) {
        if flag != "accel" {
            line.extend([" --", flag, " ", &value]);
        }
    }
    line + &changes(scene)
}
