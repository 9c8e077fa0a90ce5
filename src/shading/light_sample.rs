//! What arrives from a point of a light.

use crate::math::{DVec3, Rgb};
use crate::probe::ProjectedShare;

/// The largest factor on a light's intensity: the inverse square law at the width of an atom is far below, and the sums that
/// are made of what is above have no end.
pub const MAX_ATTENUATION: f64 = 1e100;

/// Sample of a light at a point: what arrives there if nothing is in the way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightSample {
    /// L: the unit vector from the point to the light.
    pub direction: DVec3,
    /// How far the light is; infinite for directional ones.
    pub distance: f64,
    /// 1 / (a + b r + c r^2); 1 for directional lights; A cos' / (pi r^2) for the point of an area.
    pub attenuation: f64,
    /// For spots the cosine between axis and the way to the point; for areas cos', that at the light; else 1.
    pub cos_angle: f64,
    /// What arrives if nothing stands in between: I x attenuation x fall-off, or Le x attenuation for an area; black
    /// outside a spot's cone.
    pub intensity: Rgb,
    /// Of an area light whose samples are chosen in proportion to what they bring, its share.
    pub projected: Option<ProjectedShare>,
}
