//! Lights: point, directional and spot lights, whose shadows are hard, and area lights.

use super::area::Area;
use super::light_sample::{LightSample, MAX_ATTENUATION};
use crate::math::{DVec3, Rgb};
use crate::probe::counting;

/// A light and its name in the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// Its name.
    pub name: String,
    /// What it is.
    pub kind: LightKind,
}

/// The kinds of light.
#[derive(Clone, Debug, PartialEq)]
pub enum LightKind {
    /// Shines from one point in all directions.
    Point {
        /// Where.
        position: DVec3,
        /// I, before attenuation.
        intensity: Rgb,
        /// a, b, c of the attenuation 1 / (a + b r + c r^2) at distance r.
        attenuation: [f64; 3],
    },
    /// Shines along one direction everywhere, from endlessly far away.
    Directional {
        /// Where the light goes (unit).
        direction: DVec3,
        /// I.
        intensity: Rgb,
    },
    /// Shines from one point into a cone.
    Spot {
        /// Where.
        position: DVec3,
        /// The axis of the cone (unit).
        direction: DVec3,
        /// I on the axis, before attenuation.
        intensity: Rgb,
        /// As for a point light.
        attenuation: [f64; 3],
        /// The cosine of the angle between axis and edge of the cone.
        cos_cutoff: f64,
        /// The light falls off from the axis as cos^exponent.
        exponent: f64,
    },
    /// Shines from every point of an object.
    Area(Area),
}

impl LightKind {
    /// Light that arrives at `point`. `None` at the light's own position, where it has no direction, and for area lights,
    /// of which a point must be chosen first ([`Area::sample`]).
    #[inline]
    pub fn sample(&self, point: DVec3) -> Option<LightSample> {
        match *self {
            Self::Area(_) => None,
            Self::Point {
                position,
                intensity,
                attenuation,
            } => Self::from_point(position, intensity, attenuation, point),
            Self::Directional {
                direction,
                intensity,
            } => Some(LightSample {
                direction: -direction,
                distance: f64::INFINITY,
                attenuation: 1.0,
                cos_angle: 1.0,
                intensity,
                projected: None,
            }),
            Self::Spot {
                position,
                direction,
                intensity,
                attenuation,
                cos_cutoff,
                exponent,
            } => {
                let light = Self::from_point(position, intensity, attenuation, point)?;
                let cos_angle = direction.dot(-light.direction);
                let falloff = if cos_angle < cos_cutoff {
                    0.0
                } else {
                    libm::pow(cos_angle.max(0.0), exponent)
                };
                Some(LightSample {
                    cos_angle,
                    intensity: light.intensity * falloff,
                    ..light
                })
            }
        }
    }

    /// True if it shines from more than one point.
    pub fn is_area(&self) -> bool {
        self.area().is_some()
    }

    /// Area of an area light.
    #[inline]
    pub fn area(&self) -> Option<&Area> {
        match self {
            Self::Area(area) if counting::AREAS => Some(area),
            _ => None,
        }
    }

    fn from_point(
        position: DVec3,
        intensity: Rgb,
        [a, b, c]: [f64; 3],
        point: DVec3,
    ) -> Option<LightSample> {
        let to_light = position - point;
        let distance = to_light.length();
        let direction = to_light.try_normalize()?;
        let attenuation = 1.0 / (a + b * distance + c * distance * distance);
        // As near as that, light has no end.
        (attenuation <= MAX_ATTENUATION).then_some(LightSample {
            direction,
            distance,
            attenuation,
            cos_angle: 1.0,
            intensity: intensity * attenuation,
            projected: None,
        })
    }

    /// Where it stands, if it stands anywhere.
    pub fn position(&self) -> Option<DVec3> {
        match *self {
            Self::Point { position, .. } | Self::Spot { position, .. } => Some(position),
            Self::Directional { .. } | Self::Area(_) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spot_shines_into_its_cone_only() {
        let spot = LightKind::Spot {
            position: DVec3::new(0.0, 2.0, 0.0),
            direction: DVec3::NEG_Y,
            intensity: Rgb::WHITE,
            attenuation: [0.0, 0.0, 1.0],
            cos_cutoff: 0.5,
            exponent: 1.0,
        };
        let below = spot.sample(DVec3::ZERO).expect("not at the light");
        assert_eq!((below.distance, below.intensity), (2.0, Rgb::grey(0.25)));
        // 60 degrees and a little more from the axis.
        let outside = spot
            .sample(DVec3::new(3.5, 0.0, 0.0))
            .expect("not at the light");
        assert!(outside.intensity.is_black());
        assert_eq!(spot.sample(DVec3::new(0.0, 2.0, 0.0)), None);
    }
}
