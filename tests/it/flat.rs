//! Flat scenes: what stands in them is the scene, found by rays that share no code with the tracer.

pub mod closest;
mod text;

use std::path::{Path, PathBuf};

use raytree::scene::flat::{self, FlatLight, FlatObject, FlatScene};
use raytree::scene::{self, Scene, builtin};
use raytree::trace::{Document, View, document, trace_pixel};
use raytree::world::World;

use super::from_text;
use closest::{closest, eye_ray};

/// The flat scene as other programs read it.
pub fn read(scene: &Scene) -> FlatScene {
    let mut json = Vec::new();
    flat::write_json(&mut json, scene).expect("a buffer takes everything");
    serde_json::from_slice(&json).expect("a flat scene")
}

/// A file of the folder `lessons`.
pub fn lesson(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("lessons")
        .join(path)
}

/// The scene of a task.
pub fn task(name: &str) -> Scene {
    let path = lesson(&format!("tasks/{name}.json"));
    scene::load(path.to_str().expect("UTF-8")).unwrap_or_else(|error| panic!("{error}"))
}

/// What the tracer says of a pixel of a picture of 64x48 pixels.
pub fn traced(world: &World, pixel: (u32, u32), size: (u32, u32)) -> Document {
    let settings = world.scene.settings.with(|s| {
        (s.image.width, s.image.height) = size;
        s.recursion.depth = 0;
        s.pixel = scene::PixelSampling::default();
    });
    let trace = trace_pixel(world, &settings, pixel, false);
    document::of(View {
        world,
        settings: &settings,
        trace: &trace,
    })
}

/// Every third pixel meets the same object at the same t; fewer are asked where each ray asks thousands of shapes. Gives the kinds of
/// shapes that were met.
#[track_caller]
fn check(scene: Scene) -> Vec<&'static str> {
    let size = (64, 48);
    let (name, flat) = (scene.name.clone(), read(&scene));
    let world = World::new(scene, raytree::accel::AccelKind::default());
    let mut kinds = Vec::new();
    let step = (flat.objects.len() / 200).max(3);
    for pixel in (0..48)
        .flat_map(|y| (0..64).map(move |x| (x, y)))
        .step_by(step)
    {
        let document = traced(&world, pixel, size);
        let root = document.samples[0].root.as_ref().expect("a tree");
        let ray = eye_ray(&flat.camera, pixel, size);
        let found = closest(&flat.objects, ray);
        let same = match (&root.hit, found) {
            (None, None) => true,
            (Some(hit), Some((t, object))) => {
                kinds.push(closest::kind(object));
                let is_its = match object {
                    // On an edge, which of two is met is a matter of rounding.
                    FlatObject::Triangle { primitive, .. } => {
                        let weights = hit.barycentric.expect("a triangle");
                        *primitive == hit.primitive || weights.iter().any(|w| *w < 1e-9)
                    }
                    _ => true,
                };
                is_its && object.name() == hit.object && (t - hit.t).abs() < 1e-10 * (1.0 + t)
            }
            _ => false,
        };
        assert!(same, "{name} at {pixel:?}: {found:?}, {:?}", root.hit);
    }
    kinds
}

#[test]
fn a_loop_over_the_shapes_finds_what_the_tracer_finds() {
    for name in builtin::names() {
        check(scene::load(name).expect("built in"));
    }
    for name in ["hits", "light", "glass"] {
        let kinds = check(task(name));
        for kind in ["triangle", "sphere", "plane"] {
            assert!(kinds.contains(&kind), "{name}: {kind}");
        }
    }
}

/// Shapes that transforms carry, stretch, turn and mirror, in groups.
const MOVED: &str = r#"{
  "format": "raytree-scene/1",
  "camera": {"eye": [0, 1, 7], "look_at": [0, 0, 0]},
  "materials": {"m": {"diffuse": [0.5, 0.5, 0.5]}, "lamp": {"emission": [2, 2, 2]}},
  "lights": [
    {"area": {"name": "lamp", "object": "all/lamp"}},
    {"spot": {"name": "spot", "position": [0, 5, 0], "look_at": [0, 0, 0], "intensity": [1, 1, 1], "cone_angle": 60}}
  ],
  "objects": [
    {"group": {
      "name": "all", "transform": [{"rotate": {"axis": [0, 1, 1], "degrees": 25}}],
      "objects": [
        {"sphere": {"name": "egg", "material": "m", "center": [-1.5, 0, 0], "radius": 0.5, "transform": [{"scale": [1, 2, 1]}]}},
        {"box": {"name": "block", "material": "m", "min": [1, -0.5, -0.5], "max": [2, 0.5, 0.5]}},
        {"disc": {"name": "plate", "material": "m", "center": [0, 1.3, 0], "normal": [0, 0.3, 1], "radius": 0.6, "transform": [{"scale": [1.5, 1, 1]}]}},
        {"plane": {"name": "floor", "material": "m", "point": [0, -1, 0], "normal": [0, 1, 0]}},
        {"quad": {"name": "lamp", "material": "lamp", "corner": [0, 2.5, 0], "u": [0.5, 0, 0], "v": [0, 0.1, 0.5]}},
        {"mesh": {
          "name": "tent", "material": "m", "transform": [{"scale": [-1, 1, 1]}],
          "vertices": [[-0.6, -0.6, 0], [0.6, -0.6, 0], [0, 0.6, 0.3]], "triangles": [[0, 1, 2]],
          "normals": [[-1, 0, 2], [1, 0, 2], [0, 1, 2]]
        }}
      ]
    }}
  ]
}"#;

#[test]
fn what_was_moved_is_where_it_was_moved_to() {
    let scene = from_text::scene(MOVED);
    let kinds = check(scene.clone());
    for kind in ["triangle", "sphere", "plane", "box", "disc"] {
        assert!(kinds.contains(&kind), "{kind}");
    }
    let flat = read(&scene);
    let FlatLight::Area { object, .. } = &flat.lights[0] else {
        panic!("{:?}", flat.lights)
    };
    assert_eq!(object, "all/lamp");
    // The normals at the corners turn with the mesh: between them they give the normal that shading uses.
    let world = World::new(scene, raytree::accel::AccelKind::default());
    let document = traced(&world, (32, 25), (64, 48));
    let root = document.samples[0].root.as_ref().expect("a tree");
    let hit = root.hit.as_ref().expect("the tent");
    assert_eq!(hit.object, "all/tent");
    let tent = flat.objects.iter().find(|o| o.name() == hit.object);
    let Some(FlatObject::Triangle {
        normals: Some(normals),
        corners,
        ..
    }) = tent
    else {
        panic!("{tent:?}")
    };
    // The document has the weights as the file has the corners; a mirrored mesh has b and c swapped.
    let [a, b, c] = hit.barycentric.expect("a triangle");
    let sum =
        |rows: &[[f64; 3]; 3]| [0, 1, 2].map(|i| a * rows[0][i] + c * rows[1][i] + b * rows[2][i]);
    let point = sum(corners);
    assert!((0..3).all(|i| (point[i] - hit.point[i]).abs() < 1e-12));
    let blend = sum(normals);
    let length = blend.iter().map(|x| x * x).sum::<f64>().sqrt();
    assert!((0..3).all(|i| (blend[i] / length - hit.normal[i]).abs() < 1e-12));
}

#[test]
fn a_flat_scene_has_all_values_of_its_scene() {
    for name in builtin::names() {
        let scene = scene::load(name).expect("built in");
        let flat = read(&scene);
        assert_eq!(
            (&flat.name, flat.background),
            (&scene.name, scene.background)
        );
        assert_eq!(flat.ambient, scene.ambient);
        assert_eq!(flat.settings.depth, scene.settings.recursion.depth);
        assert_eq!(flat.objects.len(), scene.shapes.len());
        assert_eq!(flat.lights.len(), scene.lights.len());
        assert_eq!(flat.materials.len(), scene.materials.len());
        for (flat, material) in flat.materials.iter().zip(&scene.materials) {
            assert_eq!(flat.name, material.name);
            assert_eq!(flat.ambient, material.ambient);
            assert_eq!(flat.diffuse, material.diffuse);
            assert_eq!(flat.specular, material.specular);
            assert_eq!(flat.shininess, material.shininess);
            assert_eq!(flat.mirror, material.mirror);
            assert_eq!(flat.transmission, material.transmission);
            assert_eq!((flat.ior, flat.priority), (material.ior, material.priority));
            assert_eq!(flat.emission, material.emission);
            assert_eq!(flat.checker.is_some(), material.checker.is_some());
        }
    }
}

#[test]
fn a_flat_scene_fits_its_schema() {
    let validator = jsonschema::validator_for(&flat::schema()).expect("a schema");
    let scenes = builtin::names().map(|name| scene::load(name).expect("built in"));
    for scene in scenes.chain([from_text::scene(MOVED)]) {
        let mut json = Vec::new();
        flat::write_json(&mut json, &scene).expect("a buffer takes everything");
        let value = serde_json::from_slice(&json).expect("JSON");
        let errors: Vec<String> = validator
            .iter_errors(&value)
            .map(|e| e.to_string())
            .collect();
        assert!(errors.is_empty(), "{}: {errors:?}", scene.name);
    }
    let wrong = serde_json::json!({ "format": "raytree-flat/1", "name": "no camera" });
    assert!(!validator.is_valid(&wrong));
}
