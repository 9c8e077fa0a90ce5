//! Lights of a scene file.

use std::collections::{HashMap, HashSet};

use super::checks::{self, color, direction, number, point};
use super::resolver::Resolver;
use crate::math::Rgb;
use crate::scene::check;
use crate::scene::limits::{MAX_COORDINATE, MAX_EXPONENT, MAX_LIGHTS, MAX_RADIANCE};
use crate::scene::read::did_you_mean::did_you_mean;
use crate::scene::read::error::{FieldPath, SceneError};
use crate::scene::read::file::{AreaFile, LightFile};
use crate::shading::{Area, Light, LightKind};

impl Resolver {
    /// Adds all lights of the file. Their objects are known already.
    pub fn add_lights(&mut self, lights: &[LightFile], path: &FieldPath) -> Result<(), SceneError> {
        if lights.len() > MAX_LIGHTS {
            return Err(path.error(
                format!("there are {} lights", lights.len()),
                format!("use {MAX_LIGHTS} at most: each costs a ray at every hit"),
            ));
        }
        let mut names = HashSet::new();
        // The light that names each object.
        let mut shining: HashMap<&str, &str> = HashMap::new();
        for (i, file) in lights.iter().enumerate() {
            let (kind, name) = file.kind_and_name();
            let path = path.index(i).key(kind);
            let kind = self.kind(file, &path)?;
            checks::name(name, &path.key("name"))?;
            if !names.insert(name) {
                return Err(path.key("name").error(
                    format!("there are two lights named `{name}`"),
                    "give one of them a different name",
                ));
            }
            if let LightFile::Area(area) = file
                && let Some(first) = shining.insert(&area.object, name)
            {
                return Err(path.key("object").error(
                    format!(
                        "`{}` shines as `{first}` already: it would light twice what it shows",
                        area.object
                    ),
                    "leave out one of the lights; for more light, raise the material's `emission`",
                ));
            }
            let name = name.to_string();
            self.scene.lights.push(Light { name, kind });
        }
        Ok(())
    }

    fn kind(&mut self, file: &LightFile, path: &FieldPath) -> Result<LightKind, SceneError> {
        let intensity = |value: Rgb| color(value, MAX_RADIANCE, &path.key("intensity"));
        Ok(match file {
            LightFile::Point(light) => LightKind::Point {
                position: point(light.position, &path.key("position"))?,
                intensity: intensity(light.intensity)?,
                attenuation: attenuation(light.attenuation, path)?,
            },
            LightFile::Area(light) => self.area(light, path)?,
            LightFile::Directional(light) => LightKind::Directional {
                direction: direction(light.direction, &path.key("direction"))?,
                intensity: intensity(light.intensity)?,
            },
            LightFile::Spot(light) => {
                let position = point(light.position, &path.key("position"))?;
                let look_at = point(light.look_at, &path.key("look_at"))?;
                let axis = (look_at - position).try_normalize().ok_or_else(|| {
                    path.error(
                        "`position` and `look_at` are the same point, so the cone has no axis",
                        "move one of them",
                    )
                })?;
                let angle = path.key("cone_angle");
                let degrees = number(light.cone_angle, [0.0, 180.0], &angle)?;
                check::cone(degrees, &angle, &mut self.warnings);
                LightKind::Spot {
                    position,
                    direction: axis,
                    intensity: intensity(light.intensity)?,
                    attenuation: attenuation(light.attenuation, path)?,
                    cos_cutoff: libm::cos(degrees.to_radians()),
                    exponent: number(light.exponent, [0.0, MAX_EXPONENT], &path.key("exponent"))?,
                }
            }
        })
    }

    /// Area light: the shapes of the object that shines, and the radiance that its material sends out.
    fn area(&self, file: &AreaFile, path: &FieldPath) -> Result<LightKind, SceneError> {
        let path = path.key("object");
        let Some(&index) = self.objects.get(&file.object) else {
            let names = self.scene.objects.iter().map(|o| o.name.as_str());
            return Err(path.error(
                format!("there is no object `{}`", file.object),
                did_you_mean(&file.object, names).map_or_else(
                    || "name one of the scene's objects".to_owned(),
                    |name| format!("did you mean `{name}`?"),
                ),
            ));
        };
        let object = &self.scene.objects[index as usize];
        let material = &self.scene.materials[object.material as usize];
        if !material.is_emissive() {
            return Err(path.error(
                format!(
                    "the material `{}` of `{}` does not shine",
                    material.name, file.object
                ),
                "give it an `emission`: the radiance that the light sends out",
            ));
        }
        Area::new(self.scene.shapes_of(index), material.emission)
            .map(LightKind::Area)
            .ok_or_else(|| {
                path.error(
                    format!("`{}` has no area that light could come from", file.object),
                    "let a sphere, a disc, a triangle, a quad, a box along the axes or a mesh shine; not a plane, and nothing that was stretched",
                )
            })
    }
}

fn attenuation(abc: [f64; 3], path: &FieldPath) -> Result<[f64; 3], SceneError> {
    let path = path.key("attenuation");
    for (i, c) in abc.into_iter().enumerate() {
        number(c, [0.0, MAX_COORDINATE], &path.index(i))?;
    }
    if abc == [0.0; 3] {
        return Err(path.error(
            "the attenuation 1 / (0 + 0 r + 0 r^2) is endless",
            "write [1, 0, 0] for none, or [0, 0, 1] for the inverse square law",
        ));
    }
    Ok(abc)
}
