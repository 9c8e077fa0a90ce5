//! Clipping of a polygon at the horizon of a surface.

use crate::math::{DVec3, Frame};

/// The largest number of corners: four, and one more where the horizon cuts the polygon.
pub const MAX_CORNERS: usize = 5;

/// The corners relative to the point, in its frame, with what lies below the horizon cut off.
/// Source: Sutherland and Hodgman 1974, "Reentrant polygon clipping".
pub fn above_horizon(
    frame: &Frame,
    point: DVec3,
    polygon: &[DVec3],
) -> ([DVec3; MAX_CORNERS], usize) {
    let local = |corner: &DVec3| {
        let to_corner = *corner - point;
        DVec3::new(
            to_corner.dot(frame.u),
            to_corner.dot(frame.v),
            to_corner.dot(frame.w),
        )
    };
    let (mut out, mut count) = ([DVec3::ZERO; MAX_CORNERS], 0);
    let mut push = |corner: DVec3| {
        if count < MAX_CORNERS {
            out[count] = corner;
            count += 1;
        }
    };
    let next = polygon.iter().cycle().skip(1);
    for (a, b) in polygon.iter().map(local).zip(next.map(local)) {
        if a.z > 0.0 {
            push(a);
        }
        if (a.z > 0.0) != (b.z > 0.0) {
            let crossing = a + (b - a) * (a.z / (a.z - b.z));
            push(DVec3::new(crossing.x, crossing.y, 0.0));
        }
    }
    (out, count)
}
