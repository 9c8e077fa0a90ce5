//! Eye and lamps that are shut in by something opaque.

use std::collections::BTreeMap;

use super::{Checked, bounds};
use crate::geometry::Shear;
use crate::math::{DVec3, Interval, Ray};
use crate::scene::warning::{WarningCode, Warnings};
use crate::world::World;
use crate::world::closed::is_closed;

/// Lamps that are looked at: each costs three rays that find all surfaces on their way.
const MOST_LAMPS: usize = 64;

/// Along no axis and no diagonal, so that they run along no face and through no corner of what people build.
const DIRECTIONS: [DVec3; 3] = [
    DVec3::new(0.36, 0.48, 0.8),
    DVec3::new(-0.808, 0.147, 0.570_4),
    DVec3::new(0.282, -0.859, -0.427_5),
];

/// Warns if the eye is inside of something opaque and all light is outside. A room with a lamp in it is no mistake, nor is
/// a room that shines.
pub fn eye(checked: &Checked, warnings: &mut Warnings) {
    let (world, scene) = (checked.world, &checked.world.scene);
    if scene.lights.is_empty() {
        return;
    }
    for around in opaque_around(world, scene.camera.eye) {
        let lamps = scene
            .lights
            .iter()
            .filter_map(|light| light.kind.position());
        let shines = |o: u32| {
            let object = &scene.objects[o as usize];
            scene.materials[object.material as usize].is_emissive()
        };
        let is_around = |point: DVec3| opaque_around(world, point).contains(&around);
        // What shines may reach into it, unless all of it is far away.
        let room = bounds(scene.shapes_of(around));
        let reaches_in = |o: u32| {
            let near = room.zip(bounds(scene.shapes_of(o)));
            near.is_none_or(|(a, b)| a.min.cmple(b.max).all() && b.min.cmple(a.max).all())
        };
        let mut glowing = (0..scene.objects.len() as u32).filter(|o| shines(*o));
        if glowing.any(reaches_in) || lamps.take(MOST_LAMPS).any(is_around) {
            continue;
        }
        let what = format!(
            "the eye is inside of `{}`, which is opaque, and all light is outside",
            scene.objects[around as usize].name
        );
        let path = checked.path.key("camera").key("eye");
        let cure = "move the eye out of it, or put a light into it";
        warnings.add(WarningCode::EyeInside, path.error(what, cure));
    }
}

/// Warns about lamps inside of something opaque that the eye is outside of.
pub fn lamps(checked: &Checked, warnings: &mut Warnings) {
    let (world, scene) = (checked.world, &checked.world.scene);
    let around_eye = opaque_around(world, scene.camera.eye);
    for (i, light) in scene.lights.iter().enumerate().take(MOST_LAMPS) {
        let Some(position) = light.kind.position() else {
            continue;
        };
        let around = opaque_around(world, position);
        let Some(around) = around.into_iter().find(|o| !around_eye.contains(o)) else {
            continue;
        };
        let what = format!(
            "light `{}` is inside of `{}`, which is opaque: it lights nothing that is seen",
            light.name, scene.objects[around as usize].name
        );
        let cure = "move it out; for a lamp that can be seen, let the object shine: an area light";
        let path = checked.path.key("lights").index(i);
        warnings.add(WarningCode::LampInside, path.error(what, cure));
    }
}

/// The opaque objects that bound a part of space and have the point in it: those that three rays leave more often than they
/// enter them.
fn opaque_around(world: &World, point: DVec3) -> Vec<u32> {
    let scene = &world.scene;
    let mut left = BTreeMap::<u32, usize>::new();
    for direction in DIRECTIONS {
        let ray = Ray::new(point, direction.normalize());
        let shear = Shear::new(&ray);
        let mut depths = BTreeMap::<u32, i32>::new();
        for crossing in world.crossings(&ray, Interval::FORWARD) {
            let shape = &scene.shapes[crossing.hit.primitive as usize];
            match shape.enters(&ray, &shear, crossing.hit.t) {
                Some(true) => *depths.entry(crossing.object).or_default() -= 1,
                Some(false) => *depths.entry(crossing.object).or_default() += 1,
                None => {}
            }
        }
        for (object, _) in depths.into_iter().filter(|(_, depth)| *depth > 0) {
            *left.entry(object).or_default() += 1;
        }
    }
    let opaque = |object: &u32| {
        let material = scene.objects[*object as usize].material;
        !scene.materials[material as usize].is_transmissive()
    };
    let always = left
        .into_iter()
        .filter(|(_, rays)| *rays == DIRECTIONS.len());
    always
        .map(|(object, _)| object)
        .filter(|object| opaque(object) && is_closed(scene.shapes_of(*object)))
        .collect()
}
