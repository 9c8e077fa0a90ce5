//! Materials of a scene file.

use super::checks::{self, color, number};
use crate::math::Rgb;
use crate::scene::limits::{IOR, MAX_EXPONENT, MAX_RADIANCE};
use crate::scene::read::error::{FieldPath, SceneError};
use crate::scene::read::file::MaterialFile;
use crate::shading::Material;
use crate::shading::material::Checker;

/// Material `name`, its coefficients checked.
pub fn material(name: &str, file: &MaterialFile, path: &FieldPath) -> Result<Material, SceneError> {
    let factor = |value: Rgb, key: &str| color(value, MAX_RADIANCE, &path.key(key));
    // More than all of the light cannot go on: rays that bounce would gather strength without end.
    let share = |value: Rgb, key: &str| color(value, 1.0, &path.key(key));
    let checker = match &file.checker {
        None => None,
        Some(checker) => {
            let path = path.key("checker");
            let ambient = checker.ambient.unwrap_or(checker.diffuse);
            Some(Checker {
                diffuse: color(checker.diffuse, MAX_RADIANCE, &path.key("diffuse"))?,
                ambient: color(ambient, MAX_RADIANCE, &path.key("ambient"))?,
                size: checks::positive(checker.size, &path.key("size"))?,
            })
        }
    };
    Ok(Material {
        name: name.to_string(),
        diffuse: factor(file.diffuse, "diffuse")?,
        ambient: factor(file.ambient.unwrap_or(file.diffuse), "ambient")?,
        specular: factor(file.specular, "specular")?,
        shininess: number(file.shininess, [0.0, MAX_EXPONENT], &path.key("shininess"))?,
        mirror: share(file.mirror, "mirror")?,
        transmission: share(file.transmission, "transmission")?,
        ior: number(file.ior, IOR, &path.key("ior"))?,
        priority: file.priority,
        emission: factor(file.emission, "emission")?,
        checker,
    })
}
