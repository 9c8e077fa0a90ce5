//! Directions and shares of reflected and refracted light.

use serde::{Deserialize, Serialize};

use crate::math::DVec3;

/// How light is shared between the reflected and the transmitted ray of a transparent surface.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema,
)]
#[serde(rename_all = "kebab-case")]
pub enum Fresnel {
    /// Not at all: the coefficients alone, at every angle.
    None,
    /// Schlick's approximation of 1994.
    Schlick,
    /// Fresnel's equations for dielectrics, unpolarised.
    #[default]
    Exact,
}

/// R = I - 2 (N.I) N: the incident direction mirrored at a surface with unit normal N.
pub fn reflect(incident: DVec3, normal: DVec3) -> DVec3 {
    incident - 2.0 * normal.dot(incident) * normal
}

/// The refracted direction by Snell's law, n1 sin I = n2 sin T, or under total internal reflection k, which is not positive.
///
/// With eta = n1 / n2 and c = -N.I: T = eta I + (eta c - sqrt(k)) N, k = 1 - eta^2 (1 - c^2). `normal` is unit and
/// faces the incident ray. The branch comes before the root: no NaN is ever made. At the critical angle itself, k = 0, T would
/// run along the surface and never leave it: all light is reflected, as Fresnel's equations have it there.
pub fn refract(incident: DVec3, normal: DVec3, n1: f64, n2: f64) -> Result<DVec3, f64> {
    let eta = n1 / n2;
    let c = -normal.dot(incident);
    // 1 - c^2 = sin^2, by the tangential part: it does not cancel near straight incidence.
    let tangential = incident + c * normal;
    let k = 1.0 - eta * eta * tangential.length_squared();
    if k <= 0.0 {
        return Err(k);
    }
    Ok((eta * tangential - k.sqrt() * normal).normalize())
}

impl Fresnel {
    /// The reflected share at the boundary from index `n1` into `n2`, for the cosines of the angles of incidence and
    /// of refraction. In between, 1 - share is transmitted.
    pub fn reflectance(self, cos_i: f64, cos_t: f64, n1: f64, n2: f64) -> f64 {
        match self {
            Self::None => 0.0,
            Self::Schlick => schlick(cos_i, cos_t, n1, n2),
            Self::Exact => exact(cos_i, cos_t, n1, n2),
        }
    }
}

/// The mean of both polarisations: Rs = ((n1 ci - n2 ct) / (n1 ci + n2 ct))^2, Rp = ((n1 ct - n2 ci) / (n1 ct + n2
/// ci))^2.
fn exact(cos_i: f64, cos_t: f64, n1: f64, n2: f64) -> f64 {
    let s = (n1 * cos_i - n2 * cos_t) / (n1 * cos_i + n2 * cos_t);
    let p = (n1 * cos_t - n2 * cos_i) / (n1 * cos_t + n2 * cos_i);
    0.5 * (s * s + p * p)
}

/// R0 + (1 - R0) (1 - cos)^5 with R0 = ((n1 - n2) / (n1 + n2))^2; the cosine is the one in the thinner medium, so
/// that the curve reaches 1 at the critical angle.
fn schlick(cos_i: f64, cos_t: f64, n1: f64, n2: f64) -> f64 {
    let root = (n1 - n2) / (n1 + n2);
    let r0 = root * root;
    let x = 1.0 - if n1 > n2 { cos_t } else { cos_i };
    r0 + (1.0 - r0) * x * x * x * x * x
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The reflected share from air into glass of index 1.5 at an angle in degrees.
    fn glass(model: Fresnel, degrees: f64) -> f64 {
        let i = degrees.to_radians();
        let t = libm::asin(libm::sin(i) / 1.5);
        model.reflectance(libm::cos(i), libm::cos(t), 1.0, 1.5)
    }

    #[test]
    fn fresnel_has_its_values_of_paper() {
        // Computed from the closed form with 50 digits.
        for (degrees, expected) in [
            (0.0, 0.04),
            (45.0, 0.050_239_91),
            (60.0, 0.089_186_71),
            (80.0, 0.387_704_35),
            (89.0, 0.904_184_95),
        ] {
            assert!(
                (glass(Fresnel::Exact, degrees) - expected).abs() < 1e-8,
                "{degrees}"
            );
        }
        assert!((glass(Fresnel::Schlick, 60.0) - 0.07).abs() < 1e-12);
        assert!((glass(Fresnel::Schlick, 80.0) - 0.409_91).abs() < 1e-5);
        assert_eq!(glass(Fresnel::None, 80.0), 0.0);
    }

    #[test]
    fn refraction_obeys_snell_and_stops_at_the_critical_angle() {
        let toward = |degrees: f64| {
            let a = degrees.to_radians();
            DVec3::new(libm::sin(a), -libm::cos(a), 0.0)
        };
        for degrees in [0.0, 10.0, 41.8] {
            let t = refract(toward(degrees), DVec3::Y, 1.5, 1.0).expect("below the critical angle");
            assert!((1.5 * libm::sin(degrees.to_radians()) - t.x).abs() < 1e-14);
            assert!((t.length() - 1.0).abs() < 1e-15);
        }
        // asin(1 / 1.5) = 41.8103 degrees.
        assert!(refract(toward(41.82), DVec3::Y, 1.5, 1.0).is_err_and(|k| k < 0.0));
        assert!(refract(toward(89.999_999), DVec3::Y, 1.0, 1.5).is_ok());
        // The sine is 2/3 to the last bit, so that k is 0.
        let (sine, cosine) = (1.0 / 1.5, (5.0f64 / 9.0).sqrt());
        let critical = DVec3::new(sine, -cosine, 0.0);
        assert_eq!(refract(critical, DVec3::Y, 1.5, 1.0), Err(0.0));
    }

    #[test]
    fn equal_media_change_nothing() {
        let d = DVec3::new(0.6, -0.8, 0.0);
        let t = refract(d, DVec3::Y, 1.33, 1.33).expect("no reflection");
        assert!((t - d).length() < 1e-16);
        assert_eq!(Fresnel::Exact.reflectance(0.8, 0.8, 1.33, 1.33), 0.0);
    }
}
