//! Angles that are given in radians where degrees are asked.

use std::f64::consts::PI;

use super::short;
use crate::geometry::{Aabb, Shape};
use crate::scene::Scene;
use crate::scene::read::error::FieldPath;
use crate::scene::read::file::TransformStep;
use crate::scene::warning::{WarningCode, Warnings};

/// No angle in radians that means half a turn or less is larger; few angles in degrees are smaller.
const LARGEST: f64 = 3.2;

/// Warns about a field of view that looks like radians, unless all that has an end is as small, as through a telescope.
pub fn field_of_view(scene: &Scene, path: &FieldPath, warnings: &mut Warnings) {
    let degrees = 2.0 * libm::atan(scene.camera.half_height).to_degrees();
    // As it was written, before it was turned into radians and back.
    let degrees = (degrees * 1e9).round() / 1e9;
    let telescope = width_of_all(scene).is_some_and(|width| width <= 2.0 * degrees);
    if degrees < LARGEST && !telescope {
        warn(degrees, &path.key("camera").key("vertical_fov"), warnings);
    }
}

/// Warns about the angle of a spot light's cone that looks like radians.
pub fn cone(degrees: f64, path: &FieldPath, warnings: &mut Warnings) {
    if degrees > 0.0 && degrees < LARGEST {
        warn(degrees, path, warnings);
    }
}

/// Warns about rotations by what looks like a fraction of pi. Small turns are common, so that being small is not enough.
pub fn rotations(steps: &[TransformStep], path: &FieldPath, warnings: &mut Warnings) {
    let path = path.key("transform");
    for (i, step) in steps.iter().enumerate() {
        if let TransformStep::Rotate(rotate) = step
            && is_fraction_of_pi(rotate.degrees.abs())
        {
            let path = path.index(i).key("rotate").key("degrees");
            warn(rotate.degrees, &path, warnings);
        }
    }
}

fn warn(degrees: f64, path: &FieldPath, warnings: &mut Warnings) {
    let meant = degrees.to_degrees();
    // Written with few digits, a right angle is none: 1.57 is 89.95 degrees.
    let meant = if is_fraction_of_pi(degrees.abs()) {
        15.0 * (meant / 15.0).round()
    } else {
        meant
    };
    let what = format!(
        "an angle of {} degrees is very small: it looks like radians",
        short(degrees)
    );
    let cure = format!(
        "write it in degrees: {} (or leave it, if so small an angle is meant)",
        short(meant)
    );
    warnings.add(WarningCode::AngleInRadians, path.error(what, cure));
}

/// True for a multiple of 15 degrees in radians, up to half a turn, with two digits or more behind the point, rounded or
/// cut.
fn is_fraction_of_pi(x: f64) -> bool {
    let text = format!("{x}");
    let digits = text.split_once('.').map_or(0, |(_, behind)| behind.len());
    let last = libm::pow(0.1, digits.min(9) as f64);
    digits >= 2 && (1..=12).any(|k| (x - f64::from(k) * PI / 12.0).abs() < last)
}

/// The angle at the eye, in degrees, of a ball around all that has an end; 180 inside of it, `None` if nothing has one.
fn width_of_all(scene: &Scene) -> Option<f64> {
    let bounds = scene.shapes.iter().filter_map(Shape::bounds);
    let all = bounds.fold(Aabb::EMPTY, Aabb::union);
    if all.is_empty() {
        return None;
    }
    let radius = 0.5 * all.size().length();
    let distance = all.center().distance(scene.camera.eye);
    let sine = (radius / distance).min(1.0);
    Some(2.0 * libm::asin(sine).to_degrees())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_of_pi_are_known_as_people_write_them() {
        let known = |list: &str| {
            let numbers = list.split(' ').map(|x| x.parse().expect("a number"));
            numbers.map(is_fraction_of_pi).collect::<Vec<_>>()
        };
        let radians =
            known("0.7854 0.785 0.79 0.78 1.57 1.5708 3.14159 3.14 0.5236 1.5707963267948966");
        assert_eq!(radians, [true; 10]);
        let degrees = known("0 0.5 1 1.5 2 3 3.1 0.8 0.75 1.25 1.6 90 45");
        assert_eq!(degrees, [false; 13]);
    }
}
