//! The gap between the end of a shadow ray and its light.

use crate::geometry::{Arithmetic, Offset, Precision};
use crate::math::DVec3;

impl Arithmetic {
    /// Length in metres by which a shadow ray ends before its light, so that the light does not occlude itself. The light is
    /// `distance` metres from `point` and met at an angle of this cosine; the ray starts `moved` metres from there. With our
    /// arithmetic the end of the ray is clear of the light by the errors there; it is the start that may be moved by more,
    /// off a surface that is larger than all else.
    #[inline]
    pub fn short_of_light(&self, point: DVec3, moved: f64, (distance, cos): (f64, f64)) -> f64 {
        let by_offset = match self.offset {
            Offset::Fixed(_) => moved / cos.max(0.01),
            Offset::Bounded => moved / cos.max(1e-6),
            Offset::None => 0.0,
        };
        let by_rounding = match self.precision {
            Precision::Single if distance.is_finite() => {
                64.0 * f64::from(f32::EPSILON) * (point.abs().max_element() + distance)
            }
            _ => 0.0,
        };
        by_offset + by_rounding
    }
}
