//! Eye rays gone wrong.

use crate::math::{DVec3, Frame, Ray};
use crate::scene::{Bend, Camera};

/// Eye ray through a point of the film.
pub fn eye_ray(bend: Bend, camera: &Camera, [x, y]: [f64; 2], size: (u32, u32)) -> Ray {
    let (width, height) = (f64::from(size.0), f64::from(size.1));
    let aspect = width / height;
    let half = camera.half_height;
    let fov = 2.0 * libm::atan(half);
    let along = |right: f64, up: f64| {
        let Frame { u, v, w } = camera.frame;
        right * u + up * v - w
    };
    // On the film: -1 to 1 from left to right, and from bottom to top.
    let (fx, fy) = (2.0 * x / width - 1.0, 1.0 - 2.0 * y / height);
    let plain = |fx: f64, fy: f64, half: f64| along(fx * half * aspect, fy * half);
    let direction: DVec3 = match bend {
        Bend::FovFull => plain(fx, fy, libm::tan(fov)),
        Bend::FovDegrees => plain(fx, fy, libm::tan(fov.to_degrees() / 2.0)),
        Bend::PixelCorner => {
            let (x, y) = (x - 0.5, y - 0.5);
            plain(2.0 * x / width - 1.0, 1.0 - 2.0 * y / height, half)
        }
        Bend::RowsFromBottom => plain(fx, -fy, half),
        Bend::ColumnsMirrored => plain(-fx, fy, half),
        Bend::XySwapped => plain(2.0 * y / width - 1.0, 1.0 - 2.0 * x / height, half),
        Bend::AspectOnHeight => along(fx * half, fy * half * aspect),
        Bend::AspectForgotten => along(fx * half, fy * half),
        Bend::NotCentred => {
            let (fov_x, fov_y) = (2.0 * libm::atan(half * aspect), fov);
            let right = x * 2.0 * libm::tan(fov_x) / width;
            along(right, y * 2.0 * libm::tan(fov_y) / height)
        }
        Bend::Fisheye => {
            let (a, b) = (fx * libm::atan(half * aspect), fy * libm::atan(half));
            let Frame { u, v, w } = camera.frame;
            let ahead = libm::cos(b) * (libm::sin(a) * u - libm::cos(a) * w);
            ahead + libm::sin(b) * v
        }
        _ => plain(fx, fy, half),
    };
    if bend == Bend::DirectionNotUnit {
        return Ray::new(camera.eye, direction);
    }
    Ray::new(camera.eye, direction.normalize_or(direction))
}
