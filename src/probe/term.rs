//! Terms of the shading equation, each with the factors that it is the product of.
//!
//! Source: Phong 1975, "Illumination for computer generated pictures", as Whitted used it in 1980. Nothing is clamped here but
//! the cosine of a highlight: a picture is clamped once, at its very end.

use std::f64::consts::PI;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use strum::IntoStaticStr;

use crate::math::Rgb;

/// Term of the shading equation: what is added to a ray's radiance, as a product of factors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Term {
    /// Radiance that the surface sends out by itself.
    Emission(Rgb),
    /// Ka Ia: ambient light, once a hit.
    Ambient {
        /// Ka at the hit point.
        ka: Rgb,
        /// Ia, the scene's ambient light.
        ia: Rgb,
    },
    /// Kd I (N.L): Lambert's cosine law, once a light sample.
    Diffuse {
        /// Kd at the hit point.
        kd: Rgb,
        /// I: what arrives from the light.
        intensity: Rgb,
        /// Positive.
        n_dot_l: f64,
    },
    /// Kd Le P / (pi samples): the diffuse term of an area light whose samples all count the same.
    Projected {
        /// Kd at the hit point.
        kd: Rgb,
        /// The share of the light.
        light: ProjectedShare,
        /// Positive.
        n_dot_l: f64,
    },
    /// Ks I (R.V)^n, once a light sample.
    Specular {
        /// Ks.
        ks: Rgb,
        /// I: what arrives from the light.
        intensity: Rgb,
        /// The cosine between R, which is L mirrored at N, and V; negative if R points away from the viewer.
        r_dot_v: f64,
        /// n, the exponent.
        shininess: f64,
    },
    /// An ambient, a diffuse or a specular term that is blended between the corners of a triangle.
    Blended {
        /// Its kind.
        kind: TermKind,
        /// The term at each corner, times the corner's weight at the hit.
        corners: [Rgb; 3],
    },
    /// Radiance of the background, for a ray that hit nothing.
    Background(Rgb),
}

/// Kind of a term, as JSON names it.
#[derive(
    Clone,
    Copy,
    Debug,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Hash,
    Serialize,
    Deserialize,
    JsonSchema,
    IntoStaticStr,
)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum TermKind {
    /// Radiance that the surface sends out by itself.
    Emission,
    /// Ambient light, once a hit.
    Ambient,
    /// Kd I (N.L), once a light sample.
    Diffuse,
    /// Ks I (R.V)^n, once a light sample.
    Specular,
    /// Radiance of the background.
    Background,
}

impl TermKind {
    /// Name in JSON.
    pub fn name(self) -> &'static str {
        self.into()
    }
}

/// Light of one sample where samples are chosen in proportion to what they bring: Le P / (pi samples).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProjectedShare {
    /// Le, the radiance of the light.
    pub radiance: Rgb,
    /// P, the light's projected solid angle: 0 to pi.
    pub solid_angle: f64,
    /// 1 / samples.
    pub share: f64,
}

/// Value of a factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Factor {
    /// One number a channel.
    Color(Rgb),
    /// One number.
    Number(f64),
}

impl ProjectedShare {
    /// I (N.L), irradiance over pi.
    #[inline]
    pub fn irradiance(&self) -> Rgb {
        self.radiance * (self.solid_angle / PI) * self.share
    }

    /// I: the irradiance without the cosine at the surface.
    #[inline]
    pub fn intensity(&self, n_dot_l: f64) -> Rgb {
        self.radiance * (self.solid_angle / (PI * n_dot_l)) * self.share
    }
}

/// (R.V)^n, and 0 where the mirrored light goes away from the viewer, whatever n is: by pow alone 0^0 would be 1.
#[inline]
pub fn highlight(r_dot_v: f64, shininess: f64) -> f64 {
    if r_dot_v > 0.0 {
        libm::pow(r_dot_v, shininess)
    } else {
        0.0
    }
}

impl Term {
    /// Product of the factors; of a blended term the sum of the corners' shares.
    #[inline]
    pub fn value(&self) -> Rgb {
        match *self {
            Self::Emission(radiance) | Self::Background(radiance) => radiance,
            Self::Ambient { ka, ia } => ka * ia,
            Self::Diffuse {
                kd,
                intensity,
                n_dot_l,
            } => kd * intensity * n_dot_l,
            Self::Projected { kd, light, .. } => kd * light.irradiance(),
            Self::Specular {
                ks,
                intensity,
                r_dot_v,
                shininess,
            } => ks * intensity * highlight(r_dot_v, shininess),
            Self::Blended {
                corners: [a, b, c], ..
            } => a + b + c,
        }
    }

    /// Kind of the term.
    pub fn kind(&self) -> TermKind {
        match self {
            Self::Emission(_) => TermKind::Emission,
            Self::Ambient { .. } => TermKind::Ambient,
            Self::Diffuse { .. } | Self::Projected { .. } => TermKind::Diffuse,
            Self::Specular { .. } => TermKind::Specular,
            Self::Blended { kind, .. } => *kind,
            Self::Background(_) => TermKind::Background,
        }
    }

    /// Name of its kind in JSON.
    pub fn name(&self) -> &'static str {
        self.kind().name()
    }

    /// Factors by their names in JSON. (A cosine that is clamped in the product is clamped here.)
    pub fn factors(&self) -> Vec<(&'static str, Factor)> {
        use Factor::{Color, Number};
        match *self {
            Self::Emission(_) | Self::Background(_) | Self::Blended { .. } => Vec::new(),
            Self::Ambient { ka, ia } => vec![("ka", Color(ka)), ("ambient_light", Color(ia))],
            Self::Diffuse {
                kd,
                intensity,
                n_dot_l,
            } => vec![
                ("kd", Color(kd)),
                ("intensity", Color(intensity)),
                ("n_dot_l", Number(n_dot_l)),
            ],
            Self::Projected { kd, light, n_dot_l } => vec![
                ("kd", Color(kd)),
                ("intensity", Color(light.intensity(n_dot_l))),
                ("n_dot_l", Number(n_dot_l)),
                ("projected_solid_angle", Number(light.solid_angle)),
            ],
            Self::Specular {
                ks,
                intensity,
                r_dot_v,
                shininess,
            } => vec![
                ("ks", Color(ks)),
                ("intensity", Color(intensity)),
                ("r_dot_v", Number(r_dot_v.max(0.0))),
                ("shininess", Number(shininess)),
            ],
        }
    }
}
