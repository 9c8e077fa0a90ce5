//! Laws of ray tracing by name, and what is said of a bend: the law that it exchanges, its formula, a sentence.

use strum::{Display, EnumString, IntoStaticStr, VariantArray};

/// The laws by name, in the order in which they depend on each other.
#[derive(
    Clone,
    Copy,
    Debug,
    Display,
    EnumString,
    Eq,
    Hash,
    IntoStaticStr,
    Ord,
    PartialEq,
    PartialOrd,
    VariantArray,
)]
#[strum(serialize_all = "kebab-case")]
pub enum Law {
    /// From a pixel to its eye ray.
    EyeRay,
    /// From a ray to its closest hit.
    Closest,
    /// From a hit to its point and normals.
    Interaction,
    /// From a hit point to the origins of the rays that it sends.
    Start,
    /// The ambient term.
    Ambient,
    /// From a hit point to the direction, the distance and the intensity of a light.
    Illumination,
    /// Whether a light is seen from a hit point.
    Shadow,
    /// The diffuse term.
    Diffuse,
    /// The specular term.
    Specular,
    /// From a hit point to the direction of R.
    Reflect,
    /// From a hit point to the direction of T, and total internal reflection.
    Refract,
    /// The indices of refraction on both sides of a surface.
    Media,
    /// The weights of R and T.
    Shares,
    /// Where the recursion ends.
    Depth,
    /// The radiance of the background.
    Background,
    /// The sum of terms and weighted rays.
    Radiance,
    /// The samples of a light with an area.
    LightSamples,
    /// From the radiance of the samples to a colour on the screen.
    Color,
}

/// A bend in words.
#[derive(Clone, Copy, Debug)]
pub struct BendEntry {
    /// The law that it exchanges.
    pub law: Law,
    /// What is computed in the place of what.
    pub formula: &'static str,
    /// What is wrong, in a sentence.
    pub note: &'static str,
    /// In which quantity it first shows.
    pub tell: &'static str,
}

impl Law {
    /// Name as in `law:NAME`.
    pub fn name(self) -> &'static str {
        self.into()
    }
}
