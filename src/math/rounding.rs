//! Bounds for rounding errors, and what follows from them.
//!
//! Each operation rounds: fl(a op b) = (a op b)(1 + e), |e| <= u. After n of them the factor lies within 1 +- gamma_n.
//! Source: Higham, "Accuracy and Stability of Numerical Algorithms", section 3.1; Pharr, Jakob and Humphreys,
//! "Physically Based Rendering", 4th edition, section 6.8.

use super::DVec3;

/// The unit roundoff of `f64`, 2^-53.
pub const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// gamma_n = n u / (1 - n u): n chained roundings change a value by this relative amount at most.
pub const fn gamma(n: u32) -> f64 {
    let nu = n as f64 * UNIT_ROUNDOFF;
    nu / (1.0 - nu)
}

/// The origin for a ray that leaves a surface along `direction`.
///
/// The computed hit point lies within `error` (absolute, per axis) of the true surface, whose unit normal is
/// `normal`. The box of that error extends d = sum |n_k| error_k along the normal; stepping that far, to the side
/// that the ray goes to, and then one float further on each axis, leaves the surface for certain. No epsilon is
/// chosen by hand, so the step is right at every scale.
#[inline]
pub fn offset_origin(point: DVec3, error: DVec3, normal: DVec3, direction: DVec3) -> DVec3 {
    let normal_error = normal.abs().dot(error);
    let offset = if direction.dot(normal) < 0.0 {
        -normal_error * normal
    } else {
        normal_error * normal
    };
    let moved = point + offset;
    DVec3::new(
        away(moved.x, offset.x),
        away(moved.y, offset.y),
        away(moved.z, offset.z),
    )
}

/// The next float from `value` in the direction of `offset`; `value` itself if there was no offset.
#[inline]
fn away(value: f64, offset: f64) -> f64 {
    if offset > 0.0 {
        value.next_up()
    } else if offset < 0.0 {
        value.next_down()
    } else {
        value
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_offset_goes_to_the_side_of_the_ray() {
        let (p, e) = (DVec3::new(1.0, 2.0, 3.0), DVec3::splat(1e-15));
        let up = offset_origin(p, e, DVec3::Y, DVec3::new(1.0, 0.1, 0.0));
        let down = offset_origin(p, e, DVec3::Y, DVec3::new(1.0, -0.1, 0.0));
        assert!(up.y > p.y + 1e-15 && down.y < p.y - 1e-15);
        assert_eq!((up.x, up.z), (p.x, p.z));
    }
}
