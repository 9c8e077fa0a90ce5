//! Features: what a chapter enables. The tracer runs with what is enabled up to there, and says what is off.

use std::str::FromStr as _;

use strum::{EnumString, IntoStaticStr, VariantArray};

use crate::accel::AccelKind;
use crate::lab::show::ShowMode;
use crate::sampling::Sampler;
use crate::scene::Settings;
use crate::scene::printable::excerpt;
use crate::scene::read::did_you_mean::did_you_mean;
use crate::shading::{Effect, Fresnel};

/// A feature of the tracer, by the name that chapters write.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, EnumString, IntoStaticStr, VariantArray,
)]
#[strum(serialize_all = "kebab-case")]
pub enum Feature {
    /// Directions of eye rays.
    Rays,
    /// Whether and where a ray hits.
    Hits,
    /// The closest of several hits.
    Closest,
    /// The normal at a hit point.
    Normals,
    /// Normals blended over a mesh.
    Smooth,
    /// The ambient term.
    Ambient,
    /// The diffuse term.
    Diffuse,
    /// The specular term.
    Highlights,
    /// Shadow rays.
    Shadows,
    /// R rays.
    Reflection,
    /// Recursion beyond the first bounce.
    Tree,
    /// T rays.
    Refraction,
    /// Fresnel's share of R and T.
    Fresnel,
    /// Media inside of each other.
    Media,
    /// Objects in spaces of their own.
    Transforms,
    /// Trees of boxes.
    Boxes,
    /// BSP trees.
    Bsp,
    /// Several eye rays a pixel.
    Samples,
    /// Lights with an area.
    SoftShadows,
    /// A regular grid of points on such a light.
    LightGrid,
    /// Random points on such a light.
    LightRandom,
}

impl Feature {
    /// Its name.
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// The feature of this name; if there is none, in words which there are.
    pub fn named(name: &str) -> Result<Self, String> {
        Self::from_str(name).map_err(|_| {
            let names: Vec<&str> = Self::VARIANTS.iter().map(|f| f.name()).collect();
            match did_you_mean(name, names.iter().copied()) {
                Some(near) => format!(
                    "there is no feature `{}`; did you mean `{near}`?",
                    excerpt(name)
                ),
                None => format!(
                    "there is no feature `{}`; there are {}",
                    excerpt(name),
                    names.join(", ")
                ),
            }
        })
    }

    /// The effect of the tracer that it is, if it is one.
    pub fn effect(self) -> Option<Effect> {
        Some(match self {
            Self::Smooth => Effect::Smooth,
            Self::Ambient => Effect::Ambient,
            Self::Diffuse => Effect::Diffuse,
            Self::Highlights => Effect::Highlights,
            Self::Shadows => Effect::Shadows,
            Self::Reflection => Effect::Reflection,
            Self::Refraction => Effect::Refraction,
            Self::SoftShadows => Effect::SoftShadows,
            _ => return None,
        })
    }
}

/// A set of features.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Features(u32);

impl Features {
    /// All of them.
    pub fn all() -> Self {
        Feature::VARIANTS
            .iter()
            .fold(Self(0), |all, f| all.with(*f))
    }

    /// The set and one more.
    #[must_use]
    pub fn with(self, feature: Feature) -> Self {
        Self(self.0 | 1 << feature as u32)
    }

    /// True if it is in the set.
    pub fn has(self, feature: Feature) -> bool {
        self.0 & (1 << feature as u32) != 0
    }

    /// The features in the set.
    pub fn iter(self) -> impl Iterator<Item = Feature> {
        let all = Feature::VARIANTS.iter().copied();
        all.filter(move |feature| self.has(*feature))
    }

    /// The settings with what is not enabled left out, so that nothing is paid for it.
    pub fn limit(self, settings: &mut Settings) {
        for feature in Feature::VARIANTS.iter().filter(|f| !self.has(**f)) {
            if let Some(effect) = feature.effect() {
                settings.effects = settings.effects.without(effect);
            }
        }
        if !self.has(Feature::Tree) {
            settings.recursion.depth = settings.recursion.depth.min(1);
        }
        if !self.has(Feature::Fresnel) {
            settings.fresnel = Fresnel::None;
        }
        if !self.has(Feature::Samples) {
            settings.pixel.samples = 1;
        }
        if self.has(Feature::LightGrid) && !self.has(Feature::LightRandom) {
            settings.light.sampler = Sampler::Grid;
        }
        settings.accel = match (self.has(Feature::Bsp), self.has(Feature::Boxes)) {
            (true, _) => AccelKind::Bsp,
            (false, true) => AccelKind::Bvh,
            (false, false) => AccelKind::List,
        };
    }

    /// What the picture shows in the place of colours, before there are any.
    pub fn show(self) -> Option<ShowMode> {
        if self.has(Feature::Ambient) || self.has(Feature::Diffuse) {
            None
        } else if self.has(Feature::Normals) {
            Some(ShowMode::Normal)
        } else if self.has(Feature::Hits) || self.has(Feature::Closest) {
            Some(ShowMode::Hit)
        } else if self.has(Feature::Rays) {
            Some(ShowMode::Direction)
        } else {
            None
        }
    }
}
