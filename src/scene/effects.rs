//! Which effects a scene calls for, and why: nobody should pay for what cannot be seen.
//!
//! Derived from the scene alone, before anything is rendered, and rather too many than too few: an effect that is off
//! could not have changed any pixel. `tests/it/effects.rs` renders with what was derived and with everything, and compares
//! the bits.

use super::Scene;
use crate::math::Rgb;
use crate::shading::Material;

/// Something that light does and that can be left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    /// Things stand between lights and surfaces.
    Shadows,
    /// Lights with an area are seen in part.
    SoftShadows,
    /// Highlights of lights: the specular term.
    Highlights,
    /// R rays.
    Reflection,
    /// T rays.
    Refraction,
}

impl Effect {
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::Shadows,
        Self::SoftShadows,
        Self::Highlights,
        Self::Reflection,
        Self::Refraction,
    ];

    /// The name that users write.
    pub fn name(self) -> &'static str {
        match self {
            Self::Shadows => "shadows",
            Self::SoftShadows => "soft-shadows",
            Self::Highlights => "highlights",
            Self::Reflection => "reflection",
            Self::Refraction => "refraction",
        }
    }

    /// What is left out without it.
    pub fn without(self) -> &'static str {
        match self {
            Self::Shadows => "no shadow rays: lights shine through everything",
            Self::SoftShadows => "one shadow ray to the middle of each area light: hard shadows",
            Self::Highlights => "no specular terms",
            Self::Reflection => "no R rays",
            Self::Refraction => "no T rays",
        }
    }
}

/// A set of effects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effects(u8);

impl Default for Effects {
    fn default() -> Self {
        Self::ALL
    }
}

impl Effects {
    /// None of them.
    pub const NONE: Self = Self(0);
    /// All of them.
    pub const ALL: Self = Self((1 << Effect::ALL.len()) - 1);

    /// True if `effect` is in the set.
    #[inline]
    pub fn has(self, effect: Effect) -> bool {
        self.0 & (1 << effect as u8) != 0
    }

    /// The set and `effect`.
    #[must_use]
    pub fn with(self, effect: Effect) -> Self {
        Self(self.0 | 1 << effect as u8)
    }

    /// The set without `effect`.
    #[must_use]
    pub fn without(self, effect: Effect) -> Self {
        Self(self.0 & !(1 << effect as u8))
    }
}

/// Whether a scene calls for an effect, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// The effect.
    pub effect: Effect,
    /// True if it could change a pixel.
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
            let used = user_of(scene, Material::is_lit).ok_or("no material shows lights")?;
            let more = match scene.lights.len() - 1 {
                0 => String::new(),
                n => format!(" and {n} more"),
            };
            Ok(format!("light `{}`{more}; {used} shows it", light.name))
        }
        Effect::SoftShadows => {
            let area = scene.lights.iter().find(|l| l.source.is_area());
            let light = area.ok_or("no light has an area")?;
            user_of(scene, Material::is_lit).ok_or("no material shows lights")?;
            Ok(format!("light `{}` has an area", light.name))
        }
        Effect::Highlights => {
            if scene.lights.is_empty() {
                return Err("there are no lights");
            }
            user_of(scene, |m| !m.specular.is_black())
                .ok_or("no material has a specular coefficient")
        }
        Effect::Reflection => user_of(scene, |m| !m.mirror.is_black() || m.is_transmissive())
            .ok_or("no material has a mirror or a transmission coefficient"),
        Effect::Refraction => user_of(scene, Material::is_transmissive)
            .ok_or("no material has a transmission coefficient"),
    }
}

/// The first object whose material is such, in words.
fn user_of(scene: &Scene, such: impl Fn(&Material) -> bool) -> Option<String> {
    let object = scene
        .objects
        .iter()
        .find(|o| such(&scene.materials[o.material as usize]))?;
    let material = &scene.materials[object.material as usize];
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

impl Material {
    /// True if lights can be seen on it.
    fn is_lit(&self) -> bool {
        let checker = self.checker.as_ref().map_or(Rgb::BLACK, |c| c.diffuse);
        !(self.diffuse.is_black() && self.specular.is_black() && checker.is_black())
    }
}
