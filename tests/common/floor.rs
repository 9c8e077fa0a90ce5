//! A white floor below one lamp, and what it is lit by.

#![allow(dead_code)] // Not every test that includes this file needs all of it.

use std::f64::consts::PI;

use raytree::accel::AccelKind;
use raytree::math::DVec3;
use raytree::probe::Silent;
use raytree::sampling::{LightSampling, Sampler};
use raytree::scene::{Scene, SceneError, Settings};
use raytree::tracer::pixel;
use raytree::world::World;

/// A floor y = 0 with Kd = 1, seen at (x, 0, z) from below the lights, and these lights and other objects.
pub fn floor(at: [f64; 2], lights: &str, objects: &str) -> World {
    World::new(load(at, lights, objects).expect("a scene"), AccelKind::List)
}

/// Its scene, if it is one.
pub fn load(at: [f64; 2], lights: &str, objects: &str) -> Result<Scene, SceneError> {
    let [x, z] = at;
    let text = format!(
        r#"{{
  "format": "raytree-scene/1", "name": "test", "background": [0, 0, 0], "ambient": [0, 0, 0],
  "camera": {{"eye": [{x}, 0.5, {}], "look_at": [{x}, 0, {z}], "vertical_fov": 1e-6}},
  "materials": {{
    "white": {{"diffuse": [1, 1, 1]}},
    "lamp": {{"diffuse": [0, 0, 0], "emission": [1, 1, 1]}},
    "black": {{"diffuse": [0, 0, 0]}}
  }},
  "lights": [{lights}],
  "objects": [{objects}, {{"plane": {{"name": "floor", "material": "white", "point": [0, 0, 0], "normal": [0, 1, 0]}}}}]
}}"#,
        z + 0.5
    );
    raytree::scene::from_json(&text)
}

pub const LAMP: &str = r#"{"area": {"name": "lamp", "object": "lamp"}}"#;
pub const SQUARE: &str = r#"{"quad": {"name": "lamp", "material": "lamp", "corner": [-1, 2, -1], "u": [2, 0, 0], "v": [0, 0, 2]}}"#;
/// The half-plane x < 0 at height 1, as far as anybody here sees.
pub const EDGE: &str = r#"{"quad": {"name": "edge", "material": "black", "corner": [-50, 1, -50], "u": [50, 0, 0], "v": [0, 0, 100]}}"#;

/// How a light is sampled.
pub type How = (Sampler, LightSampling);

/// One pixel with one sample in it.
pub fn settings((sampler, light_sampling): How, light_samples: u32, seed: u64) -> Settings {
    Settings::default().with(|s| {
        s.light.density = light_sampling;
        s.image.width = 1;
        s.image.height = 1;
        s.light.sampler = sampler;
        s.light.samples = light_samples;
        s.seed = seed;
    })
}

/// The irradiance of the floor by one render: its radiance is E / pi.
pub fn irradiance(world: &World, settings: &Settings) -> f64 {
    pixel(world, settings, (0, 0), &mut Silent).color.channels()[0] * PI
}

/// Mean and standard error over independent runs.
pub fn runs(world: &World, how: How, light_samples: u32, count: u64) -> (f64, f64) {
    let values: Vec<f64> = (0..count)
        .map(|seed| irradiance(world, &settings(how, light_samples, seed)))
        .collect();
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let squares: f64 = values.iter().map(|x| (x - mean) * (x - mean)).sum();
    (mean, (squares / (n * (n - 1.0))).sqrt())
}

/// E / L of a polygon: (1/2) |sum over edges angle (n . unit normal of the edge's plane)|. Source: Lambert 1760.
pub fn polygon(at: DVec3, corners: &[DVec3]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    let sum: f64 = corners
        .iter()
        .zip(next)
        .map(|(a, b)| {
            let (a, b) = (*a - at, *b - at);
            let cross = a.cross(b);
            let angle = libm::atan2(cross.length(), a.dot(b));
            angle * cross.normalize().y
        })
        .sum();
    sum.abs() / 2.0
}

/// The part x > `from` of the square lamp of half width a at height 2.
pub fn part(from: f64, a: f64) -> [DVec3; 4] {
    [[from, -a], [a, -a], [a, a], [from, a]].map(|[x, z]| DVec3::new(x, 2.0, z))
}
