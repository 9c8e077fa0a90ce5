//! Light whose colour is given from 0 to 255.

use super::written;
use crate::math::Rgb;
use crate::scene::Scene;
use crate::scene::read::error::FieldPath;
use crate::scene::warning::{WarningCode, Warnings};
use crate::shading::LightKind;

/// A colour that is so much brighter than white is no radiance that somebody measured.
const FAR_TOO_BRIGHT: f64 = 16.0;

/// Warns about a background, an ambient light and lights without attenuation whose colours look like 0 to 255. What is
/// weakened by distance may be as bright; so may what shines by itself.
pub fn radiances(scene: &Scene, path: &FieldPath, warnings: &mut Warnings) {
    let mut check = |color: Rgb, path: FieldPath| {
        if looks_like_255(color, scene.settings.image.exposure) {
            let what = "this looks like a colour from 0 to 255: here 1 is white";
            let meant = color.channels().map(|c| c / 255.0);
            let cure = format!("divide by 255: {}", written(meant));
            warnings.add(WarningCode::ColorTo255, path.error(what, cure));
        }
    };
    check(scene.background, path.key("background"));
    check(scene.ambient, path.key("ambient"));
    for (i, light) in scene.lights.iter().enumerate() {
        let path = path.key("lights").index(i);
        match light.kind {
            LightKind::Point {
                intensity,
                attenuation: [_, 0.0, 0.0],
                ..
            } => check(intensity, path.key("point").key("intensity")),
            LightKind::Spot {
                intensity,
                attenuation: [_, 0.0, 0.0],
                ..
            } => check(intensity, path.key("spot").key("intensity")),
            LightKind::Directional { intensity, .. } => {
                check(intensity, path.key("directional").key("intensity"));
            }
            _ => {}
        }
    }
}

/// True for whole numbers up to 255 of which one is far too bright as it is shown.
pub fn looks_like_255(color: Rgb, exposure: f64) -> bool {
    let whole = |c: f64| c <= 255.0 && c.fract() == 0.0;
    let largest = color.max_channel();
    largest.min(largest * exposure) >= FAR_TOO_BRIGHT && color.channels().into_iter().all(whole)
}
