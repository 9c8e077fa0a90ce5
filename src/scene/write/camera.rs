//! Camera in a scene file.

use super::fields::Fields;
use super::inverse::{angle, point_along};
use crate::math::{DVec3, Frame};
use crate::scene::Camera;

/// Directions that are tried for what is up, beside those along the axes.
const TILTS: u32 = 4000;

/// The camera's fields, or why there are none that give its numbers.
pub fn camera(camera: &Camera) -> Result<String, String> {
    let look_at = point_along(camera.eye, -camera.frame.w);
    let look_at = look_at.ok_or("no point to look at gives the camera's direction")?;
    let up = up(camera, look_at).ok_or("no direction that is up gives the camera's axes")?;
    let mut fields = Fields::default()
        .row("eye", &camera.eye.to_array())
        .row("look_at", &look_at.to_array());
    if up.to_array().map(f64::to_bits) != DVec3::Y.to_array().map(f64::to_bits) {
        fields = fields.row("up", &up.to_array());
    }
    let half_height = |degrees: f64| libm::tan(degrees.to_radians() / 2.0);
    let near = 2.0 * libm::atan(camera.half_height).to_degrees();
    let degrees = angle(near, camera.half_height, half_height);
    // Few angles are 180 degrees, which is none.
    let fields = match degrees.filter(|degrees| *degrees < 180.0) {
        Some(45.0) => fields,
        Some(degrees) => fields.number("vertical_fov", degrees),
        None => fields.number("half_height", camera.half_height),
    };
    Ok(fields.line())
}

/// A unit vector with which the camera has its frame. The axes come first: people write them. Only where no other is found, a zero
/// may have another sign.
fn up(camera: &Camera, look_at: DVec3) -> Option<DVec3> {
    let frame = camera.frame;
    let made = |up: DVec3| Camera::new(camera.eye, look_at, up, 1.0).map(|made| made.frame);
    let axes = [DVec3::Y, DVec3::Z, DVec3::X].into_iter();
    let axes = axes.flat_map(|axis| [axis, -axis]);
    let signs = [1.0, -1.0].map(|x| [1.0, -1.0].map(|y| [1.0, -1.0].map(|z| [x, y, z])));
    let signs = signs.as_flattened().as_flattened().to_vec();
    // -0 is 0, but not to the bit.
    let axes = axes.flat_map(|axis| {
        let signed = signs.iter().map(move |s| axis * DVec3::from(*s));
        signed.filter(move |signed| *signed == axis)
    });
    let tilted = (0..TILTS).flat_map(|k| {
        let tilt = 0.001_73 * f64::from(k);
        [tilt, -tilt].map(|tilt| (frame.v + tilt * frame.w).normalize())
    });
    let all = || axes.clone().chain(tilted.clone());
    let bits = |f: Frame| [f.u, f.v, f.w].map(|axis| axis.to_array().map(f64::to_bits));
    let same_bits = |up: &DVec3| made(*up).is_some_and(|made| bits(made) == bits(frame));
    let exact = all().find(same_bits);
    exact.or_else(|| all().find(|up| made(*up) == Some(frame)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn vector() -> impl Strategy<Value = DVec3> {
        let axis = -10.0..10.0f64;
        (axis.clone(), axis.clone(), axis).prop_map(|(x, y, z)| DVec3::new(x, y, z))
    }

    fn read(fields: &str) -> Camera {
        let text = format!("{{\"format\": \"raytree-scene/1\", \"camera\": {fields}}}");
        crate::scene::from_json(&text).expect("a scene").camera
    }

    proptest! {
        #[test]
        fn a_camera_is_read_with_the_same_bits(eye in vector(), at in vector(), fov in 1.0..170.0f64) {
            let made = Camera::new(eye, at, DVec3::Y, fov.to_radians()).expect("a camera");
            prop_assert_eq!(read(&camera(&made).expect("fields")), made);
        }
    }

    #[test]
    fn a_height_that_no_angle_gives_is_written_itself() {
        let frame = Frame::from_w_up(DVec3::new(2.1, 1.7, -1.3), DVec3::Y).expect("a frame");
        for k in 1..200 {
            let made = Camera {
                eye: DVec3::new(2.1, 1.7, -1.3),
                frame,
                half_height: f64::from(k) / 77.7,
            };
            assert_eq!(read(&camera(&made).expect("fields")), made);
        }
    }
}
