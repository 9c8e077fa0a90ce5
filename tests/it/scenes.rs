//! The built-in scenes are sound, and the format says of itself what it reads.

use std::collections::HashSet;
use std::ops::ControlFlow;

use raytree::geometry::Shape;
use raytree::probe::{Absence, Event, Probe};
use raytree::scene::{Scene, builtin, file, list, load};
use raytree::tracer::render;
use raytree::world::World;

fn each() -> impl Iterator<Item = (&'static str, Scene)> {
    builtin::names().map(|name| {
        let scene = load(name).unwrap_or_else(|e| panic!("{e}"));
        (name, scene)
    })
}

#[test]
fn every_built_in_scene_loads_without_a_warning() {
    for (name, scene) in each() {
        assert_eq!(scene.name, name);
        assert_eq!(scene.warnings, [], "{name}");
        assert_eq!(scene.shapes.len(), scene.owners.len());
        assert!(!scene.shapes.is_empty() && !scene.lights.is_empty());
        assert_eq!(scene.hash.len(), 64, "{name}");
    }
    assert!(builtin::names().any(|name| name == builtin::DEFAULT));
}

#[test]
fn names_are_unique_and_hashes_differ() {
    let mut hashes = HashSet::new();
    for (name, scene) in each() {
        let objects: HashSet<_> = scene.objects.iter().map(|o| &o.name).collect();
        assert_eq!(objects.len(), scene.objects.len(), "{name}");
        let materials: HashSet<_> = scene.materials.iter().map(|m| &m.name).collect();
        assert_eq!(materials.len(), scene.materials.len(), "{name}");
        assert!(hashes.insert(scene.hash), "{name}");
    }
}

#[test]
fn every_built_in_scene_has_a_note_of_one_sentence() {
    for (name, note) in list() {
        assert!(note.len() > 20 && note.len() < 140, "{name}: {note}");
        assert!(
            note.ends_with('.') && note.matches(". ").count() == 0,
            "{name}: {note}"
        );
    }
}

#[test]
fn every_built_in_scene_fits_the_schema() {
    let schema = file::schema();
    let validator = jsonschema::validator_for(&schema).expect("the schema is one");
    for name in builtin::names() {
        let text = builtin::scene(name).expect("built in");
        let value = serde_json::from_str(text).expect("JSON");
        let errors: Vec<String> = validator
            .iter_errors(&value)
            .map(|e| e.to_string())
            .collect();
        assert!(errors.is_empty(), "{name}: {errors:?}");
    }
    // And it refuses what the reader refuses.
    for bad in [
        r#"{"format": "raytree-scene/2", "camera": {"eye": [0, 0, 1], "look_at": [0, 0, 0]}}"#,
        r#"{"format": "raytree-scene/1"}"#,
        r#"{"format": "raytree-scene/1", "camera": {"eye": [0, 0], "look_at": [0, 0, 0]}}"#,
        r#"{"format": "raytree-scene/1", "camera": {"eye": [0, 0, 1], "look_at": [0, 0, 0], "fov": 3}}"#,
    ] {
        let value = serde_json::from_str(bad).expect("JSON");
        assert!(!validator.is_valid(&value), "{bad}");
        assert!(file::parse(bad, "bad").is_err(), "{bad}");
    }
}

#[test]
fn a_printed_scene_reads_as_the_same_scene() {
    for name in builtin::names() {
        let text = builtin::scene(name).expect("built in");
        let scene = file::parse(text, name).expect("a good file");
        let printed = serde_json::to_string_pretty(&scene).expect("plain data");
        assert_eq!(file::parse(&printed, name), Ok(scene), "{name}");
    }
}

#[test]
fn each_scene_shows_its_idea() {
    let scene = |name| load(name).expect("built in");
    let transparent = |s: &Scene| s.materials.iter().filter(|m| m.is_transmissive()).count();
    assert_eq!(scene("triangle").shapes.len(), 1);
    assert_eq!(transparent(&scene("nested-glass")), 3);
    assert_eq!(transparent(&scene("glass-block")), 1);
    assert_eq!(scene("shadows").lights.len(), 2);
    let room = scene("room");
    assert!(room.shapes.iter().all(|s| matches!(s, Shape::Triangle(_))));
    assert!(
        scene("mirrors")
            .objects
            .iter()
            .any(|o| o.name == "back/glass")
    );
    for (name, object, triangles) in [("teapot", "teapot", 992), ("bunny", "bunny", 3674)] {
        let scene = scene(name);
        let index = scene
            .objects
            .iter()
            .position(|o| o.name == object)
            .expect(object);
        let own = scene.owners.iter().filter(|o| **o == index as u32);
        assert_eq!(own.count(), triangles);
        let data = scene.objects[index].vertices.as_ref().expect("normals");
        assert_eq!(data.normal_indices.len(), triangles);
        assert!(
            data.normals
                .iter()
                .all(|n| n.is_normalized() || n.length() == 0.0)
        );
    }
}

/// Counts the rays that were not sent, by reason.
#[derive(Default)]
struct Absences {
    total_internal_reflection: usize,
    depth_limit: usize,
}

impl Probe for Absences {
    const TRAVERSAL: bool = false;

    fn event(&mut self, event: Event) {
        match event {
            Event::Absent {
                reason: Absence::TotalInternalReflection { .. },
                ..
            } => self.total_internal_reflection += 1,
            Event::Absent {
                reason: Absence::DepthLimit,
                ..
            } => self.depth_limit += 1,
            _ => {}
        }
    }
}

#[test]
fn the_block_reflects_totally_and_the_mirrors_end_at_the_depth_limit() {
    let absences = |name: &str| {
        let scene = load(name).expect("built in");
        let mut settings = scene.settings;
        (settings.image.width, settings.image.height) = (64, 48);
        let world = World::new(scene, settings.accel);
        let (_, probes) =
            render::<Absences>(&world, &settings, 2, &|_, _| ControlFlow::Continue(()));
        let sum = |part: fn(&Absences) -> usize| probes.iter().map(part).sum::<usize>();
        (sum(|a| a.total_internal_reflection), sum(|a| a.depth_limit))
    };
    assert!(absences("glass-block").0 > 20);
    assert!(absences("nested-glass").0 > 20);
    let (total, depth) = absences("mirrors");
    assert!(total == 0 && depth > 9, "{total} {depth}");
    assert_eq!(absences("triangle"), (0, 0));
}
