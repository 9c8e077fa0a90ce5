//! Pinhole camera.

use crate::math::{DVec3, Frame, Ray};

/// Pinhole camera at `eye` with a film before it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Where all camera rays start.
    pub eye: DVec3,
    /// u to the right of the picture, v up, w from the scene to the eye (gluLookAt's frame).
    pub frame: Frame,
    /// tan(vertical field of view / 2): half the film's height at distance 1.
    pub half_height: f64,
}

impl Camera {
    /// A camera at `eye` that looks at `look_at`; `vertical_fov` in radians, between 0 and pi. `None` if there is no
    /// view direction or `up` is parallel to it.
    pub fn new(eye: DVec3, look_at: DVec3, up: DVec3, vertical_fov: f64) -> Option<Self> {
        Some(Self {
            eye,
            frame: Frame::from_w_up(eye - look_at, up)?,
            half_height: libm::tan(vertical_fov / 2.0),
        })
    }

    /// The ray through the point `(x, y)` of a film of `width` x `height` pixels, counted from the top left corner.
    ///
    /// x' = (2x / width - 1) tan(fov / 2) aspect, y' = (1 - 2y / height) tan(fov / 2), both from the *middle* of the
    /// film and with *half* the field of view, which some lecture slides forget.
    pub fn ray(&self, [x, y]: [f64; 2], (width, height): (u32, u32)) -> Ray {
        let (width, height) = (f64::from(width), f64::from(height));
        let right = (2.0 * x / width - 1.0) * self.half_height * (width / height);
        let up = (1.0 - 2.0 * y / height) * self.half_height;
        let Frame { u, v, w } = self.frame;
        Ray::new(self.eye, (right * u + up * v - w).normalize())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_looks_ahead_and_the_edges_are_half_the_field_away() {
        let fov = std::f64::consts::FRAC_PI_2;
        let camera = Camera::new(DVec3::Z, DVec3::ZERO, DVec3::Y, fov).expect("up is not along z");
        let size = (200, 100);
        assert_eq!(camera.ray([100.0, 50.0], size).direction, DVec3::NEG_Z);
        // 90 degrees high: the upper edge is 45 degrees up; twice as wide: right is at tan = 2.
        let top = camera.ray([100.0, 0.0], size).direction;
        assert!((top.y / -top.z - 1.0).abs() < 1e-15);
        let right = camera.ray([200.0, 50.0], size).direction;
        assert!((right.x / -right.z - 2.0).abs() < 1e-15);
    }
}
