//! Effects that can be simulated or left out.

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
    /// The ambient term.
    Ambient,
    /// Diffuse terms of lights.
    Diffuse,
    /// Normals that are blended between the corners of a mesh.
    Smooth,
}

impl Effect {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::Shadows,
        Self::SoftShadows,
        Self::Highlights,
        Self::Reflection,
        Self::Refraction,
        Self::Ambient,
        Self::Diffuse,
        Self::Smooth,
    ];

    /// The name that users write.
    pub fn name(self) -> &'static str {
        match self {
            Self::Shadows => "shadows",
            Self::SoftShadows => "soft-shadows",
            Self::Highlights => "highlights",
            Self::Reflection => "reflection",
            Self::Refraction => "refraction",
            Self::Ambient => "ambient",
            Self::Diffuse => "diffuse",
            Self::Smooth => "smooth",
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
            Self::Ambient => "no ambient terms",
            Self::Diffuse => "no diffuse terms",
            Self::Smooth => "flat triangles: N is the geometric normal",
        }
    }
}

/// A set of effects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effects(u32);

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
