//! From a scene file to a scene: names are looked up, numbers checked, shapes placed in the world.
//!
//! What passes here cannot make the tracer panic, and every refusal tells the field and the cure.

mod checks;
mod meshes;
mod models;
mod objects;
mod placement;
mod shapes;

use std::collections::HashSet;

use super::error::{Place, SceneError};
use super::file::{CameraFile, LightFile, MaterialFile, SceneFile, SettingsFile};
use super::files::Files;
use super::limits::{
    IOR, MAX_COORDINATE, MAX_EXPONENT, MAX_LIGHTS, MAX_RADIANCE, MAX_SAMPLES, MAX_WARNINGS,
    size_problem,
};
use super::{Camera, Scene, Settings};
use crate::math::Rgb;
use crate::shading::material::Checker;
use crate::shading::{Light, Material, light::Source};
use checks::{color, direction, number, point};

/// Makes a scene of a scene file. `label` is the file's name in messages, `files` reads the files that it names.
pub fn resolve(file: &SceneFile, label: &str, files: Files) -> Result<Scene, SceneError> {
    let place = Place::root(label);
    let camera = camera(&file.camera, &place.key("camera"))?;
    let mut builder = Builder {
        scene: Scene {
            name: file.name.clone().unwrap_or_else(|| label.to_string()),
            hash: String::new(),
            camera,
            background: color(file.background, MAX_RADIANCE, &place.key("background"))?,
            ambient: color(file.ambient, MAX_RADIANCE, &place.key("ambient"))?,
            materials: Vec::with_capacity(file.materials.len()),
            lights: Vec::with_capacity(file.lights.len()),
            objects: Vec::new(),
            shapes: Vec::new(),
            owners: Vec::new(),
            settings: settings(&file.settings, &place.key("settings"))?,
            warnings: Vec::new(),
        },
        names: HashSet::new(),
        files,
        more_warnings: 0,
    };
    checks::name(&builder.scene.name, &place.key("name"))?;
    for (name, material) in &file.materials {
        let place = place.key("materials").key(name);
        checks::name(name, &place)?;
        let material = self::material(name, material, &place)?;
        builder.scene.materials.push(material);
    }
    builder.lights(&file.lights, &place.key("lights"))?;
    builder.objects(&file.objects, &place.key("objects"))?;
    Ok(builder.finish())
}

/// A scene in the making.
struct Builder {
    scene: Scene,
    /// Names of objects so far.
    names: HashSet<String>,
    files: Files,
    /// Warnings beyond those that are kept.
    more_warnings: usize,
}

impl Builder {
    fn warn(&mut self, warning: &str) {
        if self.scene.warnings.len() < MAX_WARNINGS {
            self.scene.warnings.push(super::error::printable(warning));
        } else {
            self.more_warnings += 1;
        }
    }

    fn finish(mut self) -> Scene {
        if self.scene.objects.is_empty() {
            self.warn("the scene has no objects: the picture shows the background alone");
        }
        if self.more_warnings > 0 {
            let more = format!("and {} more warnings", self.more_warnings);
            self.scene.warnings.push(more);
        }
        self.scene.hash = self.files.hash();
        self.scene
    }

    fn lights(&mut self, lights: &[LightFile], place: &Place) -> Result<(), SceneError> {
        if lights.len() > MAX_LIGHTS {
            return Err(place.error(
                format!("there are {} lights", lights.len()),
                format!("use {MAX_LIGHTS} at most: each costs a ray at every hit"),
            ));
        }
        let mut names = HashSet::new();
        for (i, file) in lights.iter().enumerate() {
            let (light, place) = light(file, &place.index(i))?;
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
}

fn camera(file: &CameraFile, place: &Place) -> Result<Camera, SceneError> {
    let eye = point(file.eye, &place.key("eye"))?;
    let look_at = point(file.look_at, &place.key("look_at"))?;
    let up = direction(file.up, &place.key("up"))?;
    let fov = file.vertical_fov;
    if !(fov > 0.0 && fov < 180.0) {
        return Err(place.key("vertical_fov").error(
            format!("a field of view of {fov} degrees is not possible"),
            "write an angle between 0 and 180 degrees; 45 looks natural",
        ));
    }
    if eye == look_at {
        return Err(place.error(
            "`eye` and `look_at` are the same point, so there is no direction to look in",
            "move one of them",
        ));
    }
    Camera::new(eye, look_at, up, fov.to_radians()).ok_or_else(|| {
        place.key("up").error(
            "`up` is parallel to the view direction, so nothing says which way is up in the picture",
            "choose another `up`: looking straight down, [0, 0, -1] will do",
        )
    })
}

fn settings(file: &SettingsFile, place: &Place) -> Result<Settings, SceneError> {
    let default = Settings::default();
    let [width, height] = file.size.unwrap_or([default.width, default.height]);
    if let Some(problem) = size_problem(width, height) {
        let place = place.key("size");
        return Err(place.error(problem, "write [width, height], such as [320, 240]"));
    }
    let samples = file.samples.unwrap_or(default.samples);
    if samples == 0 || samples > MAX_SAMPLES {
        return Err(place.key("samples").error(
            format!("{samples} samples a pixel are not possible"),
            format!("write a whole number from 1 to {MAX_SAMPLES}"),
        ));
    }
    let optional = |value: Option<f64>, default: f64, key: &str| {
        number(
            value.unwrap_or(default),
            [0.0, MAX_RADIANCE],
            &place.key(key),
        )
    };
    Ok(Settings {
        width,
        height,
        samples,
        sampling: file.sampling.unwrap_or(default.sampling),
        depth: file.depth.unwrap_or(default.depth),
        min_weight: optional(file.min_weight, default.min_weight, "min_weight")?,
        seed: file.seed.unwrap_or(default.seed),
        fresnel: file.fresnel.unwrap_or(default.fresnel),
        exposure: optional(file.exposure, default.exposure, "exposure")?,
        accel: default.accel,
        max_rays: default.max_rays,
    })
}

fn material(name: &str, file: &MaterialFile, place: &Place) -> Result<Material, SceneError> {
    let factor = |value: Rgb, key: &str| color(value, MAX_RADIANCE, &place.key(key));
    // More than all of the light cannot go on: rays that bounce would gather strength without end.
    let share = |value: Rgb, key: &str| color(value, 1.0, &place.key(key));
    let checker = match &file.checker {
        None => None,
        Some(checker) => {
            let place = place.key("checker");
            let ambient = checker.ambient.unwrap_or(checker.diffuse);
            Some(Checker {
                diffuse: color(checker.diffuse, MAX_RADIANCE, &place.key("diffuse"))?,
                ambient: color(ambient, MAX_RADIANCE, &place.key("ambient"))?,
                size: checks::positive(checker.size, &place.key("size"))?,
            })
        }
    };
    Ok(Material {
        name: name.to_string(),
        diffuse: factor(file.diffuse, "diffuse")?,
        ambient: factor(file.ambient.unwrap_or(file.diffuse), "ambient")?,
        specular: factor(file.specular, "specular")?,
        shininess: number(file.shininess, [0.0, MAX_EXPONENT], &place.key("shininess"))?,
        mirror: share(file.mirror, "mirror")?,
        transmission: share(file.transmission, "transmission")?,
        ior: number(file.ior, IOR, &place.key("ior"))?,
        emission: factor(file.emission, "emission")?,
        checker,
    })
}

/// A light, and its place with its kind.
fn light<'a>(file: &LightFile, place: &Place<'a>) -> Result<(Light, Place<'a>), SceneError> {
    let intensity = |value: Rgb, place: &Place| color(value, MAX_RADIANCE, &place.key("intensity"));
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
