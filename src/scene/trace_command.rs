//! The command that traces a pixel again.

use super::printable::shell_word;
use super::{Scene, Settings, flags};

/// `raytree trace` with all flags that differ from the scene's own settings; `name` is the scene as the user named it.
pub fn trace_command(name: &str, scene: &Scene, settings: &Settings, (x, y): (u32, u32)) -> String {
    let (width, height) = settings.size();
    let name = shell_word(name);
    let mut command = format!("raytree trace {name} --size {width}x{height} --pixel {x},{y}");
    for (flag, value) in flags(settings, scene) {
        command.extend([" --", flag, " ", &value]);
    }
    command
}
