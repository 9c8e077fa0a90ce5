//! Picking: the first hit of the camera ray through the centre of a pixel, without any shading.

use std::fmt;

use crate::probe::Silent;
use crate::scene::Settings;
use crate::trace::format::num;
use crate::world::World;

/// Object behind the centre of a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Picked<'a> {
    /// The object's name.
    pub object: &'a str,
    /// What kind of shape was hit.
    pub shape: &'static str,
    /// The name of its material.
    pub material: &'a str,
    /// How far away it is, in metres.
    pub t: f64,
}

impl fmt::Display for Picked<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{} ({}) at t = {}", self.object, self.shape, num(self.t))
    }
}

/// The first hit of the camera ray through the centre of pixel (x, y); `None` for the background.
pub fn pick<'a>(world: &'a World, settings: &Settings, (x, y): (u32, u32)) -> Option<Picked<'a>> {
    let middle = [f64::from(x) + 0.5, f64::from(y) + 0.5];
    let ray = world.scene.camera.ray(middle, settings.size());
    let hit = world.closest(&ray, 0.0, &mut Silent)?;
    Some(Picked {
        object: &world.scene.object_of(hit.primitive).name,
        shape: world.scene.shapes[hit.primitive as usize].kind(),
        material: &world.scene.material_at(&hit).name,
        t: hit.t,
    })
}

/// [`pick()`] in words.
pub fn description(world: &World, settings: &Settings, at: (u32, u32)) -> String {
    pick(world, settings, at).map_or_else(
        || "nothing: the background".to_owned(),
        |picked| picked.to_string(),
    )
}
