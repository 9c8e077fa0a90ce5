//! From a scene file to a scene: names are looked up, numbers checked, shapes placed in the world.
//!
//! What passes here cannot make the tracer panic, and every refusal tells the field and the cure.

mod checks;
mod lights;
mod meshes;
mod models;
mod objects;
mod placement;
mod shapes;

use std::collections::HashMap;

use super::error::{Place, SceneError};
use super::file::{CameraFile, MaterialFile, SceneFile, SettingsFile};
use super::files::Files;
use super::limits::{
    IOR, MAX_EXPONENT, MAX_LIGHT_SAMPLES, MAX_RADIANCE, MAX_SAMPLES, size_problem,
};
use super::warnings::Warnings;
use super::{
    AreaLightSampling, Camera, Image, PixelSampling, Recursion, Sampling, Scene, Settings,
};
use crate::math::Rgb;
use crate::shading::Material;
use crate::shading::material::Checker;
use checks::{color, direction, number, point};

/// Makes a scene of a scene file. `label` is the file's name in messages, `files` reads the files that it names.
pub fn resolve(mut file: SceneFile, label: &str, files: Files) -> Result<Scene, SceneError> {
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
        names: HashMap::new(),
        known_materials: HashMap::new(),
        files,
        warnings: Warnings::default(),
    };
    checks::name(&builder.scene.name, &place.key("name"))?;
    // Each is given back as soon as it is read: a file of nothing but materials is kept once, not twice.
    for (name, material) in std::mem::take(&mut file.materials) {
        let place = place.key("materials").key(&name);
        checks::name(&name, &place)?;
        builder.add_material(self::material(&name, &material, &place)?);
    }
    builder.objects(&file.objects, &place.key("objects"))?;
    builder.lights(&file.lights, &place.key("lights"))?;
    Ok(builder.finish())
}

/// A scene in the making.
struct Builder {
    scene: Scene,
    /// Objects so far, by name.
    names: HashMap<String, u32>,
    /// Materials so far, by name.
    known_materials: HashMap<String, u32>,
    files: Files,
    warnings: Warnings,
}

impl Builder {
    /// Puts in a material with a name that none has yet; tells its number.
    fn add_material(&mut self, material: Material) -> u32 {
        let number = self.scene.materials.len() as u32;
        self.known_materials.insert(material.name.clone(), number);
        self.scene.materials.push(material);
        number
    }

    fn finish(mut self) -> Scene {
        if self.scene.objects.is_empty() {
            self.warnings.add(|| {
                "the scene has no objects: the picture shows the background alone".to_string()
            });
        }
        self.scene.warnings = self.warnings.into_lines();
        self.scene.hash = self.files.hash();
        self.scene
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
    let [width, height] = file
        .size
        .unwrap_or([default.image.width, default.image.height]);
    if let Some(problem) = size_problem(width, height) {
        let place = place.key("size");
        return Err(place.error(problem, "write [width, height], such as [320, 240]"));
    }
    let samples = file.samples.unwrap_or(default.pixel.samples);
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
    let light_samples = file.light_samples.unwrap_or(default.light.samples);
    if light_samples == 0 || light_samples > MAX_LIGHT_SAMPLES {
        return Err(place.key("light_samples").error(
            format!("{light_samples} shadow rays to a light are not possible"),
            format!("write a whole number from 1 to {MAX_LIGHT_SAMPLES}"),
        ));
    }
    Ok(Settings {
        image: Image {
            width,
            height,
            exposure: optional(file.exposure, default.image.exposure, "exposure")?,
        },
        pixel: PixelSampling {
            samples,
            sampler: file
                .sampling
                .map_or(default.pixel.sampler, Sampling::sampler),
            ..default.pixel
        },
        light: AreaLightSampling {
            samples: light_samples,
            sampler: file.sampler.unwrap_or(default.light.sampler),
            density: file.light_sampling.unwrap_or(default.light.density),
        },
        recursion: Recursion {
            depth: file.depth.unwrap_or(default.recursion.depth),
            min_weight: optional(file.min_weight, default.recursion.min_weight, "min_weight")?,
            ..default.recursion
        },
        seed: file.seed.unwrap_or(default.seed),
        fresnel: file.fresnel.unwrap_or(default.fresnel),
        ..default
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
        priority: file.priority,
        emission: factor(file.emission, "emission")?,
        checker,
    })
}
