//! `raytree reduce`: the tree stays, nothing is left that could go, and what is written has the same bits.

mod commands;
mod written;

use std::ops::ControlFlow;

use raytree::accel::{AccelKind, clearest};
use raytree::probe::Event;
use raytree::reduce::{Kept, ReduceTask, Reduction, part, reduce};
use raytree::scene::effects::effects;
use raytree::scene::{self, Scene, Settings};
use raytree::trace::{PixelTrace, View, document, trace_pixel};
use raytree::world::World;
use serde_json::Value;

/// A scene, and a small picture of it.
pub struct Whole {
    scene: Scene,
    world: World,
    settings: Settings,
}

impl Whole {
    pub fn new(scene: Scene, change: impl Fn(&mut Settings)) -> Self {
        let settings = settings_of(&scene).with(|s| {
            (s.image.width, s.image.height) = (32, 24);
            change(s);
        });
        Self {
            world: World::new(scene.clone(), settings.accel),
            scene,
            settings,
        }
    }

    pub fn of(name: &str) -> Self {
        Self::new(scene::load(name).expect("a scene"), |s| {
            s.light.samples = 3;
            s.recursion.depth = s.recursion.depth.min(4);
        })
    }

    pub fn reduced(&self, pixel: (u32, u32), keep_tests: bool) -> Reduction {
        reduce(ReduceTask {
            scene: &self.scene,
            world: &self.world,
            settings: &self.settings,
            settings_of: &settings_of,
            pixel,
            keep_tests,
            threads: 1,
            watch: &|_| ControlFlow::Continue(()),
        })
        .unwrap_or_else(|error| panic!("{}: {error}", self.scene.name))
    }

    pub fn trace(&self, pixel: (u32, u32), traversal: bool) -> PixelTrace {
        trace_pixel(&self.world, &self.settings, pixel, traversal)
    }
}

/// The settings of a part as the program derives them.
fn settings_of(scene: &Scene) -> Settings {
    scene.settings.with(|s| {
        s.effects = effects(scene);
        s.accel = clearest(&scene.shapes);
    })
}

/// A tree as JSON, without what tells of the scene as a whole, of primitives by number, and of groups; with the names that objects had.
pub fn plain_tree(world: &World, settings: &Settings, pixel: (u32, u32)) -> Value {
    let trace = trace_pixel(world, settings, pixel, false);
    let document = document::of(View {
        world,
        settings,
        trace: &trace,
    });
    let mut json = serde_json::to_value(&document).expect("JSON");
    for key in ["scene", "warnings"] {
        json.as_object_mut().expect("an object").remove(key);
    }
    let settings = json["settings"].as_object_mut().expect("settings");
    settings.remove("accel");
    settings.remove("without");
    strip(&mut json);
    json
}

fn strip(json: &mut Value) {
    match json {
        Value::Object(fields) => {
            fields.remove("primitive");
            fields.remove("frames");
            if let Some(Value::String(name)) = fields.get_mut("object") {
                *name = name.split('#').next().unwrap_or_default().to_owned();
            }
            fields.values_mut().for_each(strip);
        }
        Value::Array(items) => items.iter_mut().for_each(strip),
        _ => {}
    }
}

/// Scenes of many kinds, and some of their pixels: bodies of glass, mirrors, area lights, meshes, stretched and mirrored shapes,
/// computed scenes.
const PIXELS: [(&str, [(u32, u32); 3]); 9] = [
    ("whitted", [(14, 13), (9, 17), (2, 2)]),
    ("nested-glass", [(15, 10), (20, 15), (3, 20)]),
    ("glass-block", [(15, 12), (18, 10), (4, 20)]),
    ("room", [(12, 12), (20, 17), (5, 5)]),
    ("mirrors", [(16, 12), (8, 14), (25, 10)]),
    ("soft-shadow", [(16, 18), (14, 10), (4, 16)]),
    ("spd:balls:2", [(16, 12), (10, 15), (20, 8)]),
    ("slanted", [(16, 14), (10, 12), (22, 16)]),
    ("lamps", [(16, 16), (9, 12), (24, 14)]),
];

#[test]
fn the_tree_stays_and_nothing_more_can_go() {
    for (name, pixels) in PIXELS {
        let whole = Whole::of(name);
        for pixel in pixels {
            let found = whole.reduced(pixel, false);
            assert!(found.complete);
            check_tree(&whole, &found, pixel);
            check_minimal(&whole, &found, pixel);
        }
    }
}

/// What was written has the tree that was there before, by code that the reduction does not use.
#[track_caller]
fn check_tree(whole: &Whole, found: &Reduction, pixel: (u32, u32)) {
    let name = &whole.scene.name;
    let scene = scene::from_json(&found.text).unwrap_or_else(|e| panic!("{name}: {e}"));
    let settings = settings_of(&scene);
    let world = World::new(scene, settings.accel);
    let before = plain_tree(&whole.world, &whole.settings, pixel);
    let after = plain_tree(&world, &settings, pixel);
    assert_eq!(after, before, "{name} at {pixel:?}:\n{}", found.text);
}

/// Without any one further object, shape or light the tree is another one, or there is none.
fn check_minimal(whole: &Whole, found: &Reduction, pixel: (u32, u32)) {
    let before = plain_tree(&whole.world, &whole.settings, pixel);
    let shines = |shape: &u32| {
        let object = whole.scene.object_of(*shape);
        let shining = found
            .kept
            .lights
            .iter()
            .map(|l| &whole.scene.lights[*l as usize]);
        shining.into_iter().any(|light| {
            let area = light.kind.area();
            area.and_then(|area| scene::flat::shining(&whole.scene, area))
                .is_some_and(|o| whole.scene.objects[o as usize].name == object.name)
        })
    };
    let mut fewer = Vec::new();
    for shape in found.kept.shapes.iter().filter(|shape| !shines(shape)) {
        let others = found.kept.shapes.iter().filter(|s| *s != shape);
        fewer.push(found.kept.with_shapes(others.copied()));
        let owner = |s: &u32| whole.scene.owners[*s as usize];
        let others = found
            .kept
            .shapes
            .iter()
            .filter(|s| owner(s) != owner(shape));
        fewer.push(found.kept.with_shapes(others.copied()));
    }
    for light in &found.kept.lights {
        let lights = found.kept.lights.iter().filter(|l| *l != light);
        fewer.push(Kept {
            lights: lights.copied().collect(),
            ..found.kept.clone()
        });
    }
    for kept in fewer {
        let mut scene = part(&whole.scene, &kept).scene;
        scene.settings = found.scene.settings;
        let settings = settings_of(&scene);
        let world = World::new(scene, settings.accel);
        let after = plain_tree(&world, &settings, pixel);
        assert_ne!(after, before, "{} at {pixel:?}: {kept:?}", whole.scene.name);
    }
}

#[test]
fn of_a_model_little_is_left() {
    for (name, pixel) in [("bunny", (16, 12)), ("teapot", (15, 13))] {
        let whole = Whole::of(name);
        let found = whole.reduced(pixel, false);
        check_tree(&whole, &found, pixel);
        let [_, [left, of], _] = found.counts;
        assert!(left <= 6 && of > 900, "{found}");
        assert_eq!(found.shapes_are, "triangles");
        assert!(found.text.len() < 4000, "{}", found.text);
    }
}

#[test]
fn no_more_is_left_than_rays_met_but_for_media() {
    for (name, pixels) in PIXELS {
        let whole = Whole::of(name);
        for pixel in pixels {
            let trace = whole.trace(pixel, true);
            let met = |event: &Event| match *event {
                Event::Hit(hit) | Event::Blocked(hit) | Event::Passed { hit, .. } => {
                    Some(hit.primitive)
                }
                _ => None,
            };
            let met: Vec<u32> = trace.tree.events.iter().filter_map(met).collect();
            let found = whole.reduced(pixel, false);
            for shape in &found.kept.shapes {
                let is_medium = whole.scene.material_of(*shape).is_transmissive();
                let shines = whole.scene.material_of(*shape).is_emissive();
                assert!(
                    met.contains(shape) || is_medium || shines,
                    "{name} at {pixel:?}: {shape}, {met:?}"
                );
            }
            let tests = |event: &Event| match *event {
                Event::Test { primitive, .. } => Some(primitive),
                _ => None,
            };
            let kept = whole.reduced(pixel, true).kept.shapes;
            for tested in trace.tree.events.iter().filter_map(tests) {
                assert!(kept.contains(&tested), "{name} at {pixel:?}: {tested}");
            }
        }
    }
}

/// The eye in a room that is in water: no ray gets as far as the end of the water, and all are in it.
const POOL: &str = r#"{
  "format": "raytree-scene/1",
  "camera": {"eye": [0, 0, 3], "look_at": [0, 0, 0]},
  "background": [0.1, 0.2, 0.3], "ambient": [0.2, 0.2, 0.2],
  "materials": {
    "water": {"transmission": [1, 1, 1], "ior": 1.33},
    "glass": {"transmission": [0.9, 0.9, 0.9], "ior": 1.5},
    "chalk": {"diffuse": [0.5, 0.5, 0.5]}
  },
  "lights": [{"point": {"name": "lamp", "position": [0, 3, 3], "intensity": [1, 1, 1]}}],
  "objects": [
    {"box": {"name": "pool", "material": "water", "min": [-8, -8, -8], "max": [8, 8, 8]}},
    {"sphere": {"name": "room", "material": "chalk", "center": [0, 0, 0], "radius": 7}},
    {"sphere": {"name": "ball", "material": "glass", "center": [0, 0, 0], "radius": 0.5}},
    {"sphere": {"name": "stone", "material": "chalk", "center": [0, 0, -2], "radius": 0.5}},
    {"sphere": {"name": "aside", "material": "chalk", "center": [5, 0, 0], "radius": 0.5}}
  ],
  "settings": {"depth": 2}
}"#;

#[test]
fn a_body_that_decides_a_medium_stays_though_no_ray_meets_it() {
    let whole = Whole::new(scene::from_json(POOL).expect("a scene"), |_| ());
    let tree = whole.trace((16, 12), false).tree;
    let meets_pool = |event: &Event| matches!(event, Event::Hit(hit) | Event::Blocked(hit) if hit.primitive == 0);
    assert!(!tree.events.iter().any(meets_pool));
    let found = whole.reduced((16, 12), false);
    check_tree(&whole, &found, (16, 12));
    check_minimal(&whole, &found, (16, 12));
    let names: Vec<&str> = found
        .scene
        .objects
        .iter()
        .map(|o| o.name.as_str())
        .collect();
    assert!(
        names.contains(&"pool") && names.contains(&"ball"),
        "{names:?}"
    );
    assert!(!names.contains(&"aside"), "{names:?}");
}

#[test]
fn what_no_ray_asks_for_goes() {
    // Nothing is in view: only the background stays.
    let nothing = POOL
        .replace(
            "\"look_at\": [0, 0, 0]",
            "\"look_at\": [0, 9, 3], \"up\": [1, 0, 0]",
        )
        .replace("\"radius\": 7", "\"radius\": 0.1")
        .replace("\"max\": [8, 8, 8]", "\"max\": [-7, 8, 8]");
    let whole = Whole::new(scene::from_json(&nothing).expect("a scene"), |_| ());
    let found = whole.reduced((16, 12), false);
    check_tree(&whole, &found, (16, 12));
    assert_eq!(found.counts.map(|[left, _]| left), [0, 0, 0]);
    assert!(found.text.contains("background") && !found.text.contains("ambient"));
    let line = "0 of 5 objects, 0 of 5 shapes, 0 of 1 lights; the tree of 16,12 is the same: 1 ray";
    assert_eq!(found.to_string(), line);
}

#[test]
fn a_search_that_is_stopped_keeps_the_tree() {
    let whole = Whole::of("glass-block");
    let task = |watch| ReduceTask {
        scene: &whole.scene,
        world: &whole.world,
        settings: &whole.settings,
        settings_of: &settings_of,
        pixel: (15, 12),
        keep_tests: false,
        threads: 1,
        watch,
    };
    let stop = |at: u64| {
        move |progress: raytree::reduce::ReduceProgress| {
            if progress.trials >= at {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        }
    };
    let (at_once, later) = (stop(1), stop(4));
    let none = reduce(task(&at_once)).expect_err("nothing is found yet");
    assert_eq!(none, raytree::reduce::ReduceError::Interrupted);
    let some = reduce(task(&later)).expect("a part");
    assert!(!some.complete);
    check_tree(&whole, &some, (15, 12));
}

#[test]
fn any_arithmetic_and_any_accelerator_will_do() {
    let scene = scene::load("whitted").expect("built in");
    for accel in [AccelKind::List, AccelKind::Wide] {
        let settings = settings_of(&scene).with(|s| {
            (s.image.width, s.image.height) = (32, 24);
            s.accel = accel;
            s.pixel.samples = 4;
            s.arithmetic.triangle = raytree::geometry::TriangleTest::MollerTrumbore;
        });
        let world = World::new(scene.clone().computed_with(settings.arithmetic), accel);
        let settings_of = |scene: &Scene| {
            scene.settings.with(|s| {
                s.effects = effects(scene);
                s.accel = accel;
                s.arithmetic = settings.arithmetic;
            })
        };
        let found = reduce(ReduceTask {
            scene: &scene,
            world: &world,
            settings: &settings,
            settings_of: &settings_of,
            pixel: (12, 16),
            keep_tests: false,
            threads: 1,
            watch: &|_| ControlFlow::Continue(()),
        })
        .expect("a part");
        let flags: Vec<&str> = found.flags.iter().map(|(flag, _)| *flag).collect();
        assert_eq!(flags, ["triangle"]);
        assert!(found.text.contains("\"samples\": 4"), "{}", found.text);
    }
}
