//! Picking: the first hit of the ray through the centre of a pixel.

use crate::probe::Silent;
use crate::scene::Settings;
use crate::world::World;

/// The first hit of the ray through the centre of a pixel.
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

/// The first hit of the ray through the centre of pixel (x, y); `None` if it hits nothing.
pub fn pick<'a>(world: &'a World, settings: &Settings, (x, y): (u32, u32)) -> Option<Picked<'a>> {
    let centre = [f64::from(x) + 0.5, f64::from(y) + 0.5];
    let ray = world.scene.camera.ray(centre, settings.size());
    let hit = world.closest(&ray, 0.0, &mut Silent)?;
    Some(Picked {
        object: &world.scene.object_of(hit.primitive).name,
        shape: world.scene.shapes[hit.primitive as usize].kind(),
        material: &world.scene.material_of(hit.primitive).name,
        t: hit.t,
    })
}
