//! The laws of a ray tree, checked on its JSON alone: this file uses nothing of the tracer but the text that
//! `raytree trace` writes. Its vectors and formulas are its own.

#![expect(
    clippy::disallowed_methods,
    reason = "an oracle uses the functions of the system, not those of the tracer"
)]

use std::collections::HashMap;
use std::process::Command;

use raytree::probe::Silent;
use raytree::scene::{self, Settings};
use raytree::trace::{View, json, trace_pixel};
use raytree::tracer::{Film, Flow, render};
use raytree::world::World;
use serde_json::Value;

type V = [f64; 3];

const TOLERANCE: f64 = 1e-12;

fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| panic!("a number, not {value}"))
}

fn vector(value: &Value) -> V {
    [0, 1, 2].map(|i| number(&value[i]))
}

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: V, b: V) -> V {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn length(a: V) -> f64 {
    dot(a, a).sqrt()
}

fn combine(a: V, b: V, f: impl Fn(f64, f64) -> f64) -> V {
    [0, 1, 2].map(|i| f(a[i], b[i]))
}

fn close(a: V, b: V, tolerance: f64) -> bool {
    length(combine(a, b, |x, y| x - y)) <= tolerance
}

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
        let spread = check_node(root, None, lights, met);
        assert!(
            close(spread, vector(&root["radiance"]), 1e-12),
            "the contributions of the tree add up to the root"
        );
        let weight = number(&sample["weight"]);
        color = combine(color, vector(&root["radiance"]), |sum, r| sum + r * weight);
    }
    assert_eq!(
        color,
        vector(&document["color"]["linear"]),
        "the samples add up to the pixel, exactly"
    );
}

/// Checks a node and all below it; returns the sum of their contributions.
fn check_node(node: &Value, parent: Option<&Value>, lights: usize, met: &mut Met) -> V {
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
    assert_eq!(own, vector(&node["contribution"]));
    let mut spread = own;
    for child in list(&node["children"]) {
        let below = check_node(child, Some(node), lights, met);
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

/// R mirrors I at N; T obeys Snell's law and stays in the plane of I and N; L starts towards its light's side.
fn check_direction(node: &Value, parent: &Value, kind: &str, direction: V, met: &mut Met) {
    let i = vector(&parent["direction"]);
    let n = vector(&parent["hit"]["normal"]);
    match kind {
        "R" => {
            let mirrored = combine(i, n, |i, n| {
                i - 2.0
                    * dot(
                        vector(&parent["direction"]),
                        vector(&parent["hit"]["normal"]),
                    )
                    * n
            });
            assert!(close(direction, mirrored, TOLERANCE), "R = I - 2 (N.I) N");
            assert_eq!(
                node["medium"], parent["medium"],
                "a reflected ray stays in its medium"
            );
        }
        "T" => {
            let boundary = &parent["boundary"];
            let (n1, n2) = (number(&boundary["n1"]), number(&boundary["n2"]));
            assert_eq!((n1, n2), (number(&parent["ior"]), number(&node["ior"])));
            let (sin_i, sin_t) = (length(cross(n, i)), length(cross(n, direction)));
            assert!(
                (n1 * sin_i - n2 * sin_t).abs() <= TOLERANCE,
                "n1 sin I = n2 sin T"
            );
            assert!(
                dot(direction, cross(n, i)).abs() <= TOLERANCE,
                "T in the plane of I and N"
            );
            assert!(dot(direction, n) < 0.0, "T goes through");
            met.one(if n1 < n2 {
                "into the denser"
            } else {
                "into the thinner"
            });
        }
        "L" => assert!(dot(direction, n) > 0.0, "the light is before the surface"),
        _ => panic!("a ray of kind {kind} has no parent"),
    }
}

fn check_hit(node: &Value, hit: &Value, direction: V) {
    let t = number(&hit["t"]);
    assert!(t > number(&node["t_min"]));
    let there = combine(vector(&node["origin"]), direction, |o, d| o + t * d);
    assert!(
        close(there, vector(&hit["point"]), 1e-11 * (1.0 + t)),
        "point = o + t d"
    );
    for normal in [&hit["normal"], &hit["geometric_normal"]] {
        assert!((length(vector(normal)) - 1.0).abs() <= TOLERANCE);
        assert!(
            dot(vector(normal), direction) <= 0.0,
            "normals face the ray"
        );
    }
    if let Some(weights) = hit.get("barycentric") {
        assert!((vector(weights).iter().sum::<f64>() - 1.0).abs() <= 1e-12);
    }
}

fn check_shadow_ray(node: &Value, met: &mut Met) {
    let outcome = node["outcome"].as_str().expect("an outcome");
    met.one(outcome);
    assert!(node["light"].is_string());
    match outcome {
        "lit" => assert!(node.get("hit").is_none()),
        "blocked" => {
            let before = node["t_max"].as_f64().unwrap_or(f64::INFINITY);
            assert!(
                number(&node["hit"]["t"]) < before,
                "the blocker stands before the light"
            );
        }
        other => panic!("an L ray is lit or blocked, not {other}"),
    }
}

/// Each term is the product of the factors that stand beside it.
fn check_term(node: &Value, term: &Value) {
    let value = vector(&term["value"]);
    let product = |colors: [&str; 2], scalar: f64| {
        combine(
            vector(&term[colors[0]]),
            vector(&term[colors[1]]),
            |a, b| a * b * scalar,
        )
    };
    let expected = match term["term"].as_str() {
        Some("ambient") => product(["ka", "ambient_light"], 1.0),
        Some("diffuse") => product(["kd", "intensity"], number(&term["n_dot_l"])),
        Some("specular") => {
            let power = number(&term["r_dot_v"]).powf(number(&term["shininess"]));
            product(["ks", "intensity"], power)
        }
        _ => return,
    };
    assert!(
        close(value, expected, 1e-12 * (1.0 + length(value))),
        "{term}"
    );
    // The cosines are those of the shadow ray to the same light.
    let Some(light) = term.get("light") else {
        return;
    };
    let shadow_ray = list(&node["children"])
        .iter()
        .find(|c| c["kind"] == "L" && &c["light"] == light && c.get("sample") == term.get("sample"))
        .expect("a lit term has its shadow ray");
    assert_eq!(shadow_ray["outcome"], "lit");
    let (l, n) = (
        vector(&shadow_ray["direction"]),
        vector(&node["hit"]["normal"]),
    );
    let v = vector(&node["direction"]).map(|x| -x);
    if let Some(n_dot_l) = term["n_dot_l"].as_f64() {
        assert!((n_dot_l - dot(n, l)).abs() <= TOLERANCE);
    }
    if let Some(r_dot_v) = term["r_dot_v"].as_f64() {
        let r = combine(n, l, |n_k, l_k| 2.0 * dot(n, l) * n_k - l_k);
        assert!((r_dot_v - dot(r, v).max(0.0)).abs() <= TOLERANCE);
    }
}

/// A bundle counts the rays to its light, and its mean is the sum of their terms.
fn check_bundles(node: &Value, met: &mut Met) {
    for bundle in node["bundles"].as_array().into_iter().flatten() {
        met.one("bundle");
        let rays = |outcome: &str| {
            let rays = list(&node["children"]).iter();
            rays.filter(|c| c["light"] == bundle["light"] && c["outcome"] == outcome)
                .count() as f64
        };
        assert_eq!(number(&bundle["lit"]), rays("lit"));
        assert_eq!(number(&bundle["blocked"]), rays("blocked"));
        assert!(rays("lit") + rays("blocked") <= number(&bundle["samples"]));
        let terms = list(&node["terms"]).iter();
        let sum = terms
            .filter(|t| t["light"] == bundle["light"])
            .fold([0.0; 3], |sum, t| {
                combine(sum, vector(&t["value"]), |a, b| a + b)
            });
        assert!(close(sum, vector(&bundle["mean"]), 1e-12));
        assert!(number(&bundle["standard_error"]) >= 0.0);
    }
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
            "total-internal-reflection" => assert!(number(&absent["k"]) < 0.0),
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
    render::<Silent>(world, settings, 2, &|_, _| Flow::Continue).0
}

fn document(world: &World, settings: &Settings, at: (u32, u32)) -> Value {
    let trace = trace_pixel(world, settings, at, false);
    let view = View {
        world,
        settings,
        trace: &trace,
    };
    let text = serde_json::to_string(&json::document(view)).expect("writable");
    serde_json::from_str(&text).expect("readable")
}

/// Checks every `step`th pixel of a built-in scene against the laws and against the rendered picture.
fn check_scene(name: &str, width: u32, height: u32, samples: u32, step: u32) -> Met {
    let base = scene::load(name).expect("a built-in scene").settings;
    let settings = Settings {
        width,
        height,
        samples,
        light_samples: 16,
        ..base
    };
    let world = world(name, &settings);
    let film = film(&world, &settings);
    let lights = world.scene.lights.iter();
    let asked = lights
        .map(|light| if light.source.is_area() { 16 } else { 1 })
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
    let settings = Settings {
        width: 64,
        height: 48,
        ..scene::load("whitted").expect("built in").settings
    };
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
    let validator = jsonschema::validator_for(&json::schema()).expect("a schema");
    for (name, _) in scene::list() {
        let settings = Settings {
            width: 16,
            height: 12,
            ..Settings::default()
        };
        let world = world(name, &settings);
        for at in [(8, 6), (8, 9), (0, 0)] {
            let trace = trace_pixel(&world, &settings, at, true);
            let view = View {
                world: &world,
                settings: &settings,
                trace: &trace,
            };
            let value = serde_json::to_value(json::document(view)).expect("writable");
            let errors: Vec<_> = validator
                .iter_errors(&value)
                .map(|e| e.to_string())
                .collect();
            assert!(errors.is_empty(), "{name} {at:?}: {errors:?}");
        }
    }
}
