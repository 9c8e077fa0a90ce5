//! The coefficients of the shading equation.

use crate::math::{DVec2, Rgb};

/// How a surface answers light, by the coefficients of Whitted's model (1980, "An improved illumination model for
/// shaded display"). Coefficients are per channel, usually 0 to 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Its name in the scene.
    pub name: String,
    /// Ka: the share of the ambient light that comes back.
    pub ambient: Rgb,
    /// Kd: Lambert's share of a light.
    pub diffuse: Rgb,
    /// Ks: the strength of a light's highlight.
    pub specular: Rgb,
    /// The exponent of the highlight: the larger, the smaller and sharper it is.
    pub shininess: f64,
    /// Kr: the factor of the reflected ray.
    pub mirror: Rgb,
    /// Kt: the factor of the transmitted ray.
    pub transmission: Rgb,
    /// The index of refraction of what is inside.
    pub ior: f64,
    /// Where objects overlap, the inside is that of the highest priority.
    pub priority: i32,
    /// Radiance that the surface sends out by itself.
    pub emission: Rgb,
    /// A second diffuse colour in the squares of a chessboard.
    pub checker: Option<Checker>,
}

/// A chessboard over the surface coordinates (u, v).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Checker {
    /// Diffuse (and, scaled alike, ambient) colour of the other squares.
    pub diffuse: Rgb,
    /// Ambient colour of the other squares.
    pub ambient: Rgb,
    /// The edge of a square in units of u and v: metres on a plane.
    pub size: f64,
}

impl Material {
    /// Kd at surface coordinates `uv`.
    pub fn diffuse_at(&self, uv: DVec2) -> Rgb {
        self.checker_at(uv).map_or(self.diffuse, |c| c.diffuse)
    }

    /// Ka at surface coordinates `uv`.
    pub fn ambient_at(&self, uv: DVec2) -> Rgb {
        self.checker_at(uv).map_or(self.ambient, |c| c.ambient)
    }

    /// The checker if `uv` lies in one of its squares.
    fn checker_at(&self, uv: DVec2) -> Option<&Checker> {
        self.checker.as_ref().filter(|c| {
            let square = (uv / c.size).floor();
            // Every second square along a row and a column: where half the sum is no whole number.
            let half = 0.5 * (square.x + square.y);
            half - half.floor() == 0.5
        })
    }

    /// True if rays pass through the surface, so that it bounds a medium.
    pub fn is_transmissive(&self) -> bool {
        !self.transmission.is_black()
    }
}
