//! Which pixel and which ray a command is about: `--at ADDRESS`, or an address in the place of the scene.

use std::path::Path;

use super::Failure;
use super::settings::SceneArgs;
use crate::trace::Address;

/// For the help of `--at`.
pub const HELP: &str =
    "The ray, as X,Y and the way from the eye: 160,120/R/L:lamp. SCENE@160,120/R does as well";

/// The scene without an address in it, and the address that is given there or by `--at`.
pub fn addressed(
    scene: &SceneArgs,
    at: Option<&Address>,
) -> Result<(SceneArgs, Option<Address>), Failure> {
    let mut scene = scene.clone();
    let in_scene = match scene.scene.rsplit_once('@') {
        // A file of this name is a scene.
        Some(_) if !Path::new(&scene.scene).exists() => {
            Some(scene.scene.parse::<Address>().map_err(Failure::Usage)?)
        }
        _ => None,
    };
    if let Some(name) = in_scene.as_ref().and_then(|address| address.scene.clone()) {
        scene.scene = name;
    }
    let twice = || {
        Failure::Usage(
            "the ray is told twice; leave out --at, or the address behind SCENE".to_owned(),
        )
    };
    match (in_scene, at) {
        (Some(_), Some(_)) => Err(twice()),
        (None, Some(at)) if at.scene.as_ref().is_some_and(|name| *name != scene.scene) => {
            let what = "--at names another scene than the command; leave it out of --at";
            Err(Failure::Usage(what.to_owned()))
        }
        (in_scene, at) => Ok((scene, in_scene.or(at.cloned()))),
    }
}
