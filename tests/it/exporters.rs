//! Models as exporters write them: what the picture does not need never keeps it from being drawn, and is told once.

mod attributes;
mod left_out;
mod libraries;
mod materials;
mod refused;
mod text;
mod transparency;

use raytree::accel::AccelKind;
use raytree::math::Rgb;
use raytree::scene::{Scene, load_from_memory};
use raytree::tracer::draw;
use raytree::world::World;

/// The corners of a rectangle that faces +z.
const CORNERS: &str = "v -2 -1 0\nv 2 -1 0\nv 2 1 0\nv -2 1 0\n";
const SQUARE: &str = "v -2 -1 0\nv 2 -1 0\nv 2 1 0\nv -2 1 0\nf 1 2 3 4\n";

/// What the middle of the rectangle sends to the eye: a model is lit by ambient light of 0.25 and a lamp of 0.9 along
/// (1, -1.5, -1), so N.L = 1 / sqrt(4.25).
fn matt(kd: [f64; 3]) -> [f64; 3] {
    kd.map(|kd| kd * (0.25 + 0.9 / 4.25_f64.sqrt()))
}

const RED: [f64; 3] = [1.0, 0.0, 0.0];
const GREY: [f64; 3] = [0.6; 3];

fn read(files: &[(&str, &[u8])]) -> Result<Scene, String> {
    let held = files
        .iter()
        .map(|(name, bytes)| ((*name).to_string(), bytes.to_vec()));
    load_from_memory(files[0].0, held.collect()).map_err(|e| e.to_string())
}

/// The radiance that comes along the middle of the picture.
fn middle(scene: &Scene) -> [f64; 3] {
    let settings = scene.settings.with(|s| {
        (s.image.width, s.image.height) = (1, 1);
    });
    let world = World::new(scene.clone(), AccelKind::List);
    draw(&world, &settings, 1).at(0, 0).channels()
}

/// The warnings: place and code of each.
fn warnings(scene: &Scene) -> Vec<String> {
    let told = |warning: &raytree::scene::Warning| {
        let text = warning.to_string();
        assert_eq!(text.lines().count(), 2, "{text}");
        let line = warning.problem.position.map_or(0, |(line, _)| line);
        let code = warning.code.name();
        let count = match warning.count {
            1 => String::new(),
            n => format!(" x{n}"),
        };
        format!("{}:{line} {code}{count}", warning.problem.file)
    };
    scene.warnings.iter().map(told).collect()
}

/// The first of the files is drawn with this radiance in its middle, and these warnings.
#[track_caller]
fn drawn(files: &[(&str, &[u8])], radiance: [f64; 3], told: &[&str]) {
    let name = String::from_utf8_lossy(files[files.len() - 1].1);
    let scene = read(files).unwrap_or_else(|said| panic!("{name}\n{said}"));
    let got = middle(&scene);
    let near = (0..3).all(|i| (got[i] - radiance[i]).abs() < 1e-9);
    assert!(near, "{name}\n{got:?} is not {radiance:?}");
    assert_eq!(warnings(&scene), told, "{name}");
}

/// A model alone.
#[track_caller]
fn obj(text: &str, radiance: [f64; 3], told: &[&str]) {
    drawn(&[("m.obj", text.as_bytes())], radiance, told);
}

/// The rectangle in the material `paint` that an MTL file describes by these lines.
#[track_caller]
fn paint(lines: &str, radiance: [f64; 3], told: &[&str]) {
    let model = format!("mtllib m.mtl\nusemtl paint\n{SQUARE}");
    let text = format!("newmtl paint\n{lines}");
    drawn(
        &[("m.obj", model.as_bytes()), ("m.mtl", text.as_bytes())],
        radiance,
        told,
    );
}

/// The material that these lines describe.
fn material(lines: &str) -> (raytree::shading::Material, Vec<String>) {
    let model = format!("mtllib m.mtl\nusemtl paint\n{SQUARE}");
    let text = format!("newmtl paint\n{lines}");
    let scene = read(&[("m.obj", model.as_bytes()), ("m.mtl", text.as_bytes())]).expect("drawn");
    let told = warnings(&scene);
    (scene.materials[0].clone(), told)
}

fn grey(value: f64) -> Rgb {
    Rgb::grey(value)
}
