//! The commands that trace a pixel again, and that open the debugger at it.

use super::printable::shell_word;
use super::{Scene, Settings, flags};

/// `raytree trace` with all flags that differ from the scene's own settings; `name` is the scene as the user named it.
pub fn trace_command(name: &str, scene: &Scene, settings: &Settings, (x, y): (u32, u32)) -> String {
    command(
        "trace",
        name,
        (scene, settings),
        &format!("--pixel {x},{y}"),
    )
}

/// The command that opens the debugger at an address of a scene, in a shell.
pub fn view_command(name: &str, scene: &Scene, settings: &Settings, address: &str) -> String {
    let address = format!("--at {}", shell_word(address));
    command("view", name, (scene, settings), &address)
}

fn command(verb: &str, name: &str, (scene, settings): (&Scene, &Settings), what: &str) -> String {
    let (width, height) = settings.size();
    let name = shell_word(name);
    let mut command = format!("raytree {verb} {name} --size {width}x{height} {what}");
    for (flag, value) in flags(settings, scene) {
        command.extend([" --", flag, " ", &value]);
    }
    command + &changes(scene)
}

/// The flags that change a scene as this one was changed.
pub fn changes(scene: &Scene) -> String {
    let flag = |change: &String| format!(" --change {}", shell_word(change));
    scene.changes.iter().map(flag).collect()
}
