//! Which effects a scene calls for, and why: nobody should pay for what cannot be seen.
//!
//! Derived from the scene alone, before anything is rendered, and rather too many than too few: an effect that is off
//! could not have changed any pixel. `tests/it/effects.rs` renders with what was derived and with everything, and compares
//! the bits.

use super::Scene;
use crate::shading::{Effect, Effects, Material};

/// Whether a scene calls for an effect, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// The effect.
    pub effect: Effect,
    /// True if it could change a pixel, or the tree of one.
    pub on: bool,
    /// What in the scene calls for it, or what is not there.
    pub reason: String,
}

/// What the scene calls for.
pub fn effects(scene: &Scene) -> Effects {
    findings(scene)
        .iter()
        .filter(|finding| finding.on)
        .fold(Effects::NONE, |set, finding| set.with(finding.effect))
}

/// Every effect, on or off, with its reason.
pub fn findings(scene: &Scene) -> Vec<Finding> {
    Effect::ALL
        .into_iter()
        .map(|effect| {
            let (on, reason) = match called_for(scene, effect) {
                Ok(reason) => (true, reason),
                Err(reason) => (false, reason.to_owned()),
            };
            Finding { effect, on, reason }
        })
        .collect()
}

/// What calls for an effect, or what it lacks.
fn called_for(scene: &Scene, effect: Effect) -> Result<String, &'static str> {
    match effect {
        Effect::Shadows => {
            let light = scene.lights.first().ok_or("there are no lights")?;
            let used = user_of(scene, Material::shows_lights).ok_or("no material shows lights")?;
            let more = match scene.lights.len() - 1 {
                0 => String::new(),
                n => format!(" and {n} more"),
            };
            Ok(format!("light `{}`{more}; {used} shows it", light.name))
        }
        Effect::SoftShadows => {
            let area = scene.lights.iter().find(|l| l.kind.is_area());
            let light = area.ok_or("no light has an area")?;
            user_of(scene, Material::shows_lights).ok_or("no material shows lights")?;
            Ok(format!("light `{}` has an area", light.name))
        }
        Effect::Highlights => {
            if scene.lights.is_empty() {
                return Err("there are no lights");
            }
            user_of(scene, Material::has_highlights).ok_or("no material has a specular coefficient")
        }
        Effect::Reflection => user_of(scene, Material::sends_rays)
            .ok_or("no material has a mirror or a transmission coefficient"),
        Effect::Refraction => user_of(scene, Material::is_transmissive)
            .ok_or("no material has a transmission coefficient"),
        Effect::Ambient => {
            if scene.ambient.is_black() {
                return Err("there is no ambient light");
            }
            user_of(scene, |m| m.shows_ambient(scene.ambient))
                .ok_or("no material reflects the ambient light")
        }
        Effect::Diffuse => {
            if scene.lights.is_empty() {
                return Err("there are no lights");
            }
            // What shows highlights alone has diffuse terms in its tree, though they are 0: trees do not depend on other objects.
            let other = || {
                let user = user_of(scene, Material::shows_lights)?;
                Some(format!("{user} shows lights, though its Kd is 0"))
            };
            user_of(scene, Material::is_diffuse)
                .or_else(other)
                .ok_or("no material shows lights")
        }
        Effect::Smooth => {
            let smooth = scene.objects.iter().find(|o| o.is_smooth());
            let object = smooth.ok_or("no mesh has normals at its corners")?;
            Ok(format!("mesh `{}` has normals at its corners", object.name))
        }
    }
}

/// The first object whose material is such, in words.
fn user_of(scene: &Scene, such: impl Fn(&Material) -> bool) -> Option<String> {
    let of_object = |object| scene.materials_of(object).map(move |m| (object, m));
    let mut all = scene.objects.iter().flat_map(of_object);
    let (object, material) = all.find(|(_, material)| such(material))?;
    let index = if material.is_transmissive() {
        format!(" (index {})", material.ior)
    } else {
        String::new()
    };
    Some(format!(
        "material `{}`{index} on `{}`",
        material.name, object.name
    ))
}
