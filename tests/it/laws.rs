//! The laws of a ray tree, checked on its JSON alone: this file uses nothing of the tracer but the text that
//! `raytree trace` writes. Its vectors and formulas are its own.

#![expect(
    clippy::disallowed_methods,
    reason = "an oracle uses the functions of the system, not those of the tracer"
)]

mod rays;
mod terms;
mod vectors;

use std::collections::HashMap;
use std::process::Command;

use raytree::scene::{self, Settings};
use raytree::trace::{View, document, trace_pixel};
use raytree::tracer::{Film, draw};
use raytree::world::World;
use serde_json::Value;

use rays::{check_direction, check_hit, check_shadow_ray};
use terms::{check_bundles, check_term};
use vectors::{TOLERANCE, V, close, combine, length, list, number, vector};

/// What the laws met, so that a test can see that they were not empty.
#[derive(Debug, Default)]
struct Met(HashMap<String, usize>);

impl Met {
    fn one(&mut self, what: impl Into<String>) {
        *self.0.entry(what.into()).or_default() += 1;
    }

    fn count(&self, what: &str) -> usize {
        self.0.get(what).copied().unwrap_or(0)
    }
}

/// Checks a whole document; `lights` is the number of places on lights that a hit asks for.
fn check(document: &Value, lights: usize, met: &mut Met) {
    assert_eq!(document["format"], "raytree/1");
    let mut color = [0.0; 3];
    for sample in list(&document["samples"]) {
        let root = &sample["root"];
        assert_eq!(root["kind"], "I");
        let weight = number(&sample["weight"]);
        let spread = check_node(root, None, (lights, weight), met);
        let brought = vector(&root["radiance"]).map(|r| r * weight);
        assert!(
            close(spread, brought, 1e-12),
            "the contributions of the tree add up to what the sample brings"
        );
        color = combine(color, vector(&root["radiance"]), |sum, r| sum + r * weight);
    }
    assert_eq!(
        color,
        vector(&document["color"]["linear"]),
        "the samples add up to the pixel, exactly"
    );
    check_screen(document, color);
}

/// From the pixel's sum to the numbers on the screen, by the published curve of sRGB.
fn check_screen(document: &Value, color: V) {
    let exposure = number(&document["settings"]["exposure"]);
    let bytes = color.map(|linear| {
        let shown = (linear * exposure).clamp(0.0, 1.0);
        let curve = if shown <= 0.003_130_8 {
            12.92 * shown
        } else {
            1.055 * libm::pow(shown, 1.0 / 2.4) - 0.055
        };
        (curve * 255.0).round()
    });
    assert_eq!(bytes, vector(&document["color"]["srgb8"]), "{color:?}");
}

/// Checks a node and all below it; returns the sum of their contributions.
fn check_node(
    node: &Value,
    parent: Option<&Value>,
    (lights, weight): (usize, f64),
    met: &mut Met,
) -> V {
    let kind = node["kind"].as_str().expect("a kind");
    met.one(kind);
    let direction = vector(&node["direction"]);
    assert!(
        (length(direction) - 1.0).abs() <= TOLERANCE,
        "unit direction"
    );
    if let Some(parent) = parent {
        assert_eq!(number(&node["depth"]), number(&parent["depth"]) + 1.0);
        check_direction(node, parent, kind, direction, met);
    }
    if let Some(hit) = node.get("hit") {
        check_hit(node, hit, direction);
    }
    if kind == "L" {
        check_shadow_ray(node, met);
        return [0.0; 3];
    }
    let throughput = vector(&node["throughput"]);
    let before = parent.map_or([1.0; 3], |p| vector(&p["throughput"]));
    assert_eq!(
        throughput,
        combine(before, vector(&node["weight"]), |a, b| a * b)
    );

    // The ledger: terms, then weighted children, in order, to the last bit.
    let mut sum = [0.0; 3];
    for term in list(&node["terms"]) {
        met.one(term["term"].as_str().expect("a name"));
        sum = combine(sum, vector(&term["value"]), |a, b| a + b);
        check_term(node, term);
    }
    let own = combine(throughput, sum, |a, b| a * b);
    // Weighted as the sample is.
    let own = own.map(|c| c * weight);
    assert_eq!(own, vector(&node["contribution"]));
    let mut spread = own;
    for child in list(&node["children"]) {
        let below = check_node(child, Some(node), (lights, weight), met);
        spread = combine(spread, below, |a, b| a + b);
        if child["kind"] != "L" {
            let brought = combine(
                vector(&child["weight"]),
                vector(&child["radiance"]),
                |w, r| w * r,
            );
            sum = combine(sum, brought, |a, b| a + b);
        }
    }
    assert_eq!(
        sum,
        vector(&node["radiance"]),
        "the ledger of node {} closes",
        node["id"]
    );
    check_bundles(node, met);
    check_complete(node, lights, met);
    spread
}

/// At a hit nothing is forgotten: every light, R and T are either sent or absent with a reason.
fn check_complete(node: &Value, lights: usize, met: &mut Met) {
    let count = |what: &str, kind: &str| {
        list(&node[what])
            .iter()
            .filter(|e| e["kind"] == kind)
            .count()
    };
    if node["outcome"] == "miss" {
        assert!(list(&node["children"]).is_empty());
        assert_eq!(node["terms"][0]["term"], "background");
        return;
    }
    assert_eq!(count("children", "L") + count("absent", "L"), lights);
    for kind in ["R", "T"] {
        assert_eq!(
            count("children", kind) + count("absent", kind),
            1,
            "{kind} of node {}",
            node["id"]
        );
    }
    for absent in list(&node["absent"]) {
        let reason = absent["reason"].as_str().expect("a reason");
        met.one(reason);
        match reason {
            "total-internal-reflection" => assert!(number(&absent["k"]) <= 0.0),
            "facing-away" => assert!(number(&absent["n_dot_l"]) <= 0.0),
            _ => {}
        }
    }
}

fn world(name: &str, settings: &Settings) -> World {
    let scene = scene::load(name).expect("a built-in scene");
    World::new(scene, settings.accel)
}

fn film(world: &World, settings: &Settings) -> Film {
    draw(world, settings, 2)
}

fn document(world: &World, settings: &Settings, at: (u32, u32)) -> Value {
    let trace = trace_pixel(world, settings, at, false);
    let view = View {
        world,
        settings,
        trace: &trace,
    };
    let text = serde_json::to_string(&document::of(view)).expect("writable");
    serde_json::from_str(&text).expect("readable")
}

/// Checks every `step`th pixel of a built-in scene against the laws and against the rendered picture.
fn check_scene(name: &str, width: u32, height: u32, samples: u32, step: u32) -> Met {
    let base = scene::load(name).expect("a built-in scene").settings;
    let settings = base.with(|s| {
        s.image.width = width;
        s.image.height = height;
        s.pixel.samples = samples;
        s.light.samples = 16;
    });
    let world = world(name, &settings);
    let film = film(&world, &settings);
    let lights = world.scene.lights.iter();
    let asked = lights
        .map(|light| if light.kind.is_area() { 16 } else { 1 })
        .sum();
    let mut met = Met::default();
    for index in (0..width * height).step_by(step as usize) {
        let (x, y) = (index % width, index / width);
        let document = document(&world, &settings, (x, y));
        assert_eq!(
            vector(&document["color"]["linear"]).map(f64::to_bits),
            film.at(x, y).channels().map(f64::to_bits),
            "{name}: pixel ({x}, {y}) of the trace is that of the picture"
        );
        check(&document, asked, &mut met);
    }
    met
}

#[test]
fn every_pixel_of_whitted_obeys_the_laws() {
    let met = check_scene("whitted", 64, 48, 1, 1);
    for what in [
        "I",
        "L",
        "R",
        "T",
        "lit",
        "blocked",
        "ambient",
        "diffuse",
        "specular",
        "background",
        "into the denser",
        "into the thinner",
        "no-transmission",
        "facing-away",
    ] {
        assert!(
            met.count(what) > 20,
            "{what} was met only {} times",
            met.count(what)
        );
    }
}

#[test]
fn all_built_in_scenes_obey_the_laws() {
    let mut all = Met::default();
    for (name, _) in scene::list() {
        let met = check_scene(name, 40, 30, 1, 7);
        for (what, count) in met.0 {
            *all.0.entry(what).or_default() += count;
        }
    }
    for what in [
        "total-internal-reflection",
        "depth-limit",
        "min-weight",
        "bundle",
    ] {
        assert!(all.count(what) > 0, "no scene shows {what}");
    }
}

#[test]
fn many_samples_obey_the_laws() {
    check_scene("whitted", 32, 24, 4, 5);
}

#[test]
fn the_command_writes_what_the_library_makes() {
    let settings = scene::load("whitted")
        .expect("built in")
        .settings
        .with(|s| {
            s.image.width = 64;
            s.image.height = 48;
        });
    let output = Command::new(env!("CARGO_BIN_EXE_raytree"))
        .args(["trace", "whitted", "--size", "64x48", "--pixel", "30,20"])
        .output()
        .expect("runs");
    assert!(output.status.success());
    let written: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(
        written,
        document(&world("whitted", &settings), &settings, (30, 20))
    );
}

#[test]
fn documents_are_valid_by_the_schema() {
    let validator = jsonschema::validator_for(&document::schema()).expect("a schema");
    for (name, _) in scene::list() {
        let settings = Settings::default().with(|s| {
            s.image.width = 16;
            s.image.height = 12;
        });
        let world = world(name, &settings);
        for at in [(8, 6), (8, 9), (0, 0)] {
            let trace = trace_pixel(&world, &settings, at, true);
            let view = View {
                world: &world,
                settings: &settings,
                trace: &trace,
            };
            let value = serde_json::to_value(document::of(view)).expect("writable");
            let errors: Vec<_> = validator
                .iter_errors(&value)
                .map(|e| e.to_string())
                .collect();
            assert!(errors.is_empty(), "{name} {at:?}: {errors:?}");
        }
    }
}
