//! Materials that send out more than comes in.

use super::{short, written};
use crate::math::Rgb;
use crate::scene::read::error::FieldPath;
use crate::scene::warning::{WarningCode, Warnings};
use crate::shading::Material;

/// What rounding may add to a sum of shares that people wrote with few digits.
const ROUNDING: f64 = 1e-6;

/// Warns about the coefficients of a material; `path` is its own.
pub fn material(material: &Material, path: &FieldPath, warnings: &mut Warnings) {
    let checker = material.checker.as_ref();
    let shares = [
        ("diffuse", Some(material.diffuse)),
        ("ambient", own_ambient(material)),
        ("specular", Some(material.specular)),
        ("checker.diffuse", checker.map(|c| c.diffuse)),
    ];
    let above: Vec<(&str, Rgb)> = shares
        .into_iter()
        .filter_map(|(key, color)| Some((key, color?)))
        .filter(|(_, color)| color.max_channel() > 1.0 + ROUNDING)
        .collect();
    for (key, color) in &above {
        share_above_one(&material.name, (*color, &path.key(key)), warnings);
    }
    if above.is_empty() {
        sum_above_one(material, path, warnings);
    }
}

/// The ambient coefficient, unless it only repeats the diffuse one.
fn own_ambient(material: &Material) -> Option<Rgb> {
    (material.ambient != material.diffuse).then_some(material.ambient)
}

/// A coefficient is the share of the light that comes back: more than all of it cannot.
fn share_above_one(material: &str, (color, path): (Rgb, &FieldPath), warnings: &mut Warnings) {
    let largest = color.max_channel();
    let what = format!(
        "material `{material}` sends back {} times the light that falls on it",
        short(largest)
    );
    // 2 or 3 in a channel may be a try at more light; what is larger, up to 255, is a colour of a painting program.
    let cure = if largest > 3.0 && largest <= 255.0 {
        let meant = color.channels().map(|c| c / 255.0);
        format!(
            "if it is a colour from 0 to 255, divide by 255: {}",
            written(meant)
        )
    } else {
        "write shares from 0 to 1; for more light make a light stronger".to_owned()
    };
    warnings.add(WarningCode::ShareAboveOne, path.error(what, cure));
}

/// Diffuse + mirror + transmission: what a surface shares out of the light that comes in. At a boundary R weighs Kr + F Kt
/// and T (1 - F) Kt, whose sum is Kr + Kt for every F. A highlight does not count: of (R.V)^n only 2 / (n + 2) goes out in
/// all directions together (Lewis 1994, "Making shaders more physically plausible"), and it stands for the mirror image of
/// a light that the mirror ray cannot meet.
fn sum_above_one(material: &Material, path: &FieldPath, warnings: &mut Warnings) {
    let checker = material.checker.as_ref().map_or(Rgb::BLACK, |c| c.diffuse);
    let largest = |i: usize| material.diffuse.channels()[i].max(checker.channels()[i]);
    let sums: [f64; 3] = std::array::from_fn(|i| {
        largest(i) + material.mirror.channels()[i] + material.transmission.channels()[i]
    });
    let (channel, sum) =
        ["red", "green", "blue"]
            .into_iter()
            .zip(sums)
            .fold(
                ("", 0.0),
                |most, next| if next.1 > most.1 { next } else { most },
            );
    if sum <= 1.0 + ROUNDING {
        return;
    }
    let what = format!(
        "material `{}` sends out more than comes in: diffuse + mirror + transmission is {} in {channel}",
        material.name,
        short(sum)
    );
    let cure = if material.is_transmissive() && !material.mirror.is_black() {
        "lower them until the sum is at most 1; glass needs no `mirror`: Fresnel's share of `transmission` is reflected"
    } else {
        "lower them until the sum is at most 1 in each channel"
    };
    warnings.add(WarningCode::SumAboveOne, path.error(what, cure));
}
