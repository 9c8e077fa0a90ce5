//! Material: the coefficients of the shading equation.
//!
//! They are read in this layer only: [`super::ShadingPoint`] is a material at a hit point.

use crate::math::{DVec2, Rgb};

/// Coefficients of Whitted's model (1980, "An improved illumination model for shaded display"), per channel, usually 0 to 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Name in the scene.
    pub name: String,
    /// Ka: share of the ambient light that is reflected.
    pub ambient: Rgb,
    /// Kd: diffuse reflection of a light (Lambert).
    pub diffuse: Rgb,
    /// Ks: strength of a light's highlight.
    pub specular: Rgb,
    /// Exponent of the highlight: the larger, the smaller and sharper it is.
    pub shininess: f64,
    /// Kr: factor of the reflected ray.
    pub mirror: Rgb,
    /// Kt: factor of the transmitted ray.
    pub transmission: Rgb,
    /// Index of refraction of the medium inside.
    pub ior: f64,
    /// Priority of the medium inside: where objects overlap, the highest decides.
    pub priority: i32,
    /// Radiance that the surface sends out by itself.
    pub emission: Rgb,
    /// Second pair of colours in the squares of a chessboard.
    pub checker: Option<Checker>,
}

/// Chessboard over the surface coordinates (u, v).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Checker {
    /// Kd of the other squares.
    pub diffuse: Rgb,
    /// Ka of the other squares.
    pub ambient: Rgb,
    /// Edge of a square in units of u and v: metres on a plane.
    pub size: f64,
}

impl Material {
    /// Ka and Kd at surface coordinates `uv`.
    #[inline]
    pub(super) fn colors_at(&self, uv: DVec2) -> [Rgb; 2] {
        match &self.checker {
            Some(checker) if checker.covers(uv) => [checker.ambient, checker.diffuse],
            _ => [self.ambient, self.diffuse],
        }
    }

    /// Wr = Kr + F Kt and Wt = (1 - F) Kt, where the share F of what would be let through is reflected.
    #[inline]
    pub fn fresnel_weights(&self, f: f64) -> [Rgb; 2] {
        let Self {
            mirror,
            transmission,
            ..
        } = self;
        [*mirror + *transmission * f, *transmission * (1.0 - f)]
    }

    /// True if rays pass through the surface, so that it bounds a medium.
    pub fn is_transmissive(&self) -> bool {
        !self.transmission.is_black()
    }

    /// True if secondary rays leave the surface.
    pub fn sends_rays(&self) -> bool {
        self.is_transmissive() || !self.mirror.is_black()
    }

    /// True if the surface sends out light by itself.
    pub fn is_emissive(&self) -> bool {
        !self.emission.is_black()
    }

    /// True if lights have highlights on it.
    pub fn has_highlights(&self) -> bool {
        !self.specular.is_black()
    }

    /// True if a part of it has a diffuse coefficient.
    pub fn is_diffuse(&self) -> bool {
        let checker = self.checker.as_ref().map_or(Rgb::BLACK, |c| c.diffuse);
        !(self.diffuse.is_black() && checker.is_black())
    }

    /// True if a part of it reflects ambient light `ia`.
    pub fn shows_ambient(&self, ia: Rgb) -> bool {
        let checker = self.checker.as_ref().map_or(Rgb::BLACK, |c| c.ambient);
        !((self.ambient * ia).is_black() && (checker * ia).is_black())
    }

    /// True if lights can be seen on it.
    pub fn shows_lights(&self) -> bool {
        self.has_highlights() || self.is_diffuse()
    }
}

impl Checker {
    /// True if `uv` lies in one of the other squares: every second one along a row and a column, where half the sum of the
    /// square's numbers is no whole number.
    fn covers(&self, uv: DVec2) -> bool {
        let square = (uv / self.size).floor();
        let half = 0.5 * (square.x + square.y);
        half - half.floor() == 0.5
    }
}
