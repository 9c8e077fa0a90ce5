//! Lights: their names, and what they shine from.

use std::collections::HashSet;

use super::Builder;
use super::checks::{self, color, direction, number, point};
use crate::math::Rgb;
use crate::scene::limits::{MAX_COORDINATE, MAX_EXPONENT, MAX_LIGHTS, MAX_RADIANCE};
use crate::scene::read::did_you_mean::did_you_mean;
use crate::scene::read::error::{Place, SceneError};
use crate::scene::read::file::{AreaFile, LightFile};
use crate::shading::{Area, Light, Source};

impl Builder {
    /// All lights of the file. Their objects are known already.
    pub fn lights(&mut self, lights: &[LightFile], place: &Place) -> Result<(), SceneError> {
        if lights.len() > MAX_LIGHTS {
            return Err(place.error(
                format!("there are {} lights", lights.len()),
                format!("use {MAX_LIGHTS} at most: each costs a ray at every hit"),
            ));
        }
        let mut names = HashSet::new();
        for (i, file) in lights.iter().enumerate() {
            let (light, place) = self.light(file, &place.index(i))?;
            checks::name(&light.name, &place.key("name"))?;
            if !names.insert(light.name.clone()) {
                return Err(place.key("name").error(
                    format!("there are two lights named `{}`", light.name),
                    "give one of them a different name",
                ));
            }
            self.scene.lights.push(light);
        }
        Ok(())
    }

    /// A light, and its place with its kind.
    fn light<'a>(
        &self,
        file: &LightFile,
        place: &Place<'a>,
    ) -> Result<(Light, Place<'a>), SceneError> {
        let intensity =
            |value: Rgb, place: &Place| color(value, MAX_RADIANCE, &place.key("intensity"));
        let (name, source, place) = match file {
            LightFile::Point(light) => {
                let place = place.key("point");
                let source = Source::Point {
                    position: point(light.position, &place.key("position"))?,
                    intensity: intensity(light.intensity, &place)?,
                    attenuation: attenuation(light.attenuation, &place)?,
                };
                (&light.name, source, place)
            }
            LightFile::Area(light) => {
                let place = place.key("area");
                (&light.name, self.area(light, &place)?, place)
            }
            LightFile::Directional(light) => {
                let place = place.key("directional");
                let source = Source::Directional {
                    direction: direction(light.direction, &place.key("direction"))?,
                    intensity: intensity(light.intensity, &place)?,
                };
                (&light.name, source, place)
            }
            LightFile::Spot(light) => {
                let place = place.key("spot");
                let position = point(light.position, &place.key("position"))?;
                let look_at = point(light.look_at, &place.key("look_at"))?;
                let axis = (look_at - position).try_normalize().ok_or_else(|| {
                    place.error(
                        "`position` and `look_at` are the same point, so the cone has no axis",
                        "move one of them",
                    )
                })?;
                let angle = place.key("cone_angle");
                let degrees = number(light.cone_angle, [0.0, 180.0], &angle)?;
                let source = Source::Spot {
                    position,
                    direction: axis,
                    intensity: intensity(light.intensity, &place)?,
                    attenuation: attenuation(light.attenuation, &place)?,
                    cos_cutoff: libm::cos(degrees.to_radians()),
                    exponent: number(light.exponent, [0.0, MAX_EXPONENT], &place.key("exponent"))?,
                };
                (&light.name, source, place)
            }
        };
        let name = name.clone();
        Ok((Light { name, source }, place))
    }

    /// The shapes of the object that shines, and the radiance that its material sends out.
    fn area(&self, file: &AreaFile, place: &Place) -> Result<Source, SceneError> {
        let place = place.key("object");
        let objects = &self.scene.objects;
        let Some(&number) = self.names.get(&file.object) else {
            let names = objects.iter().map(|o| o.name.as_str());
            return Err(place.error(
                format!("there is no object `{}`", file.object),
                did_you_mean(&file.object, names).map_or_else(
                    || "name one of the scene's objects".to_owned(),
                    |name| format!("did you mean `{name}`?"),
                ),
            ));
        };
        let number = number as usize;
        let material = &self.scene.materials[objects[number].material as usize];
        if material.emission.is_black() {
            return Err(place.error(
                format!(
                    "the material `{}` of `{}` does not shine",
                    material.name, file.object
                ),
                "give it an `emission`: the radiance that the light sends out",
            ));
        }
        let start = objects[number].first_primitive as usize;
        let end = objects
            .get(number + 1)
            .map_or(self.scene.shapes.len(), |o| o.first_primitive as usize);
        Area::new(&self.scene.shapes[start..end], material.emission)
            .map(Source::Area)
            .ok_or_else(|| {
                place.error(
                    format!("`{}` has no area that light could come from", file.object),
                    "let a sphere, a disc, a triangle, a quad, a box along the axes or a mesh shine; not a plane, and nothing that was stretched",
                )
            })
    }
}

fn attenuation(abc: [f64; 3], place: &Place) -> Result<[f64; 3], SceneError> {
    let place = place.key("attenuation");
    for (i, c) in abc.into_iter().enumerate() {
        number(c, [0.0, MAX_COORDINATE], &place.index(i))?;
    }
    if abc == [0.0; 3] {
        return Err(place.error(
            "the attenuation 1 / (0 + 0 r + 0 r^2) is endless",
            "write [1, 0, 0] for none, or [0, 0, 1] for the inverse square law",
        ));
    }
    Ok(abc)
}
