//! Phong's reflection model as Whitted used it: what a surface sends back of the light that reaches it.
//!
//! Source: Phong 1975, "Illumination for computer generated pictures". Nothing is clamped here but the cosines: a
//! picture is clamped once, at its very end.

use crate::math::Rgb;

/// Ka Ia: ambient light, once a hit and not once a light.
pub fn ambient(ka: Rgb, ambient_light: Rgb) -> Rgb {
    ka * ambient_light
}

/// Kd I (N.L): Lambert's cosine law. `n_dot_l` is positive.
pub fn diffuse(kd: Rgb, intensity: Rgb, n_dot_l: f64) -> Rgb {
    kd * intensity * n_dot_l
}

/// Ks I (R.V)^n, where R is L mirrored at N and V points to the viewer; black when R points away from the viewer.
pub fn specular(ks: Rgb, intensity: Rgb, r_dot_v: f64, shininess: f64) -> Rgb {
    ks * intensity * libm::pow(r_dot_v.max(0.0), shininess)
}
