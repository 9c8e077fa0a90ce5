//! The tree document: written as JSON and read back it is what it was, and what is made of it does not depend on the way.

use proptest::prelude::*;
use raytree::scene::{self, Settings};
use raytree::trace::export::{Dot, Html, Svg, Text, json};
use raytree::trace::{Document, View, document, trace_pixel};
use raytree::world::World;

use super::common;

/// The document of a pixel of a built-in scene of 24x18 pixels, at a chance position.
fn document(name: &str, chance: u32, settings: &Settings, traversal: bool) -> Document {
    let scene = scene::load(name).expect("a built-in scene");
    let settings = settings.with(|s| {
        s.image.width = 24;
        s.image.height = 18;
        s.light.samples = 4;
    });
    let world = World::new(scene, settings.accel);
    let trace = trace_pixel(
        &world,
        &settings,
        (chance % 24, chance / 24 % 18),
        traversal,
    );
    document::of(View {
        world: &world,
        settings: &settings,
        trace: &trace,
    })
}

fn check(document: &Document) {
    let mut text = Vec::new();
    json::write(&mut text, document).expect("a buffer takes everything");
    let read: Document = serde_json::from_slice(&text).expect("what was written can be read");
    assert_eq!(read, *document);
    assert_eq!(Text(&read).to_string(), Text(document).to_string());
    assert_eq!(Dot(&read).to_string(), Dot(document).to_string());
    assert_eq!(Svg(&read).to_string(), Svg(document).to_string());
    let page = |document| {
        Html {
            document,
            drawing: "",
        }
        .to_string()
    };
    assert_eq!(page(&read), page(document));
    // The layout changes no value.
    let compact = serde_json::to_value(document).expect("writable");
    let pretty: serde_json::Value = serde_json::from_slice(&text).expect("JSON");
    assert_eq!(compact, pretty);
}

proptest! {
    #![proptest_config(common::config(48))]

    #[test]
    fn documents_are_read_as_they_were_written(
        scene in 0..scene::list().len(),
        chance in 0u32..24 * 18,
        samples in 1u32..4,
        seed: u64,
        exposure in 0.1..10.0f64,
        traversal: bool,
    ) {
        let name = scene::list()[scene].0;
        let base = scene::load(name).expect("a built-in scene").settings;
        let settings = base.with(|s| {
            s.pixel.samples = samples;
            s.image.exposure = exposure;
            s.seed = seed;
        });
        check(&document(name, chance, &settings, traversal));
    }
}

#[test]
fn a_document_names_lights_and_rays() {
    let settings = Settings::default();
    let document = document("whitted", 24 * 12 + 12, &settings, false);
    assert!(!document.scene.lights.is_empty());
    let rays: Vec<_> = document
        .samples
        .iter()
        .flat_map(document::SampleTree::rays)
        .collect();
    assert!(rays.len() > 1 && rays.len() as u64 <= document.rays);
    let lights = &document.scene.lights;
    for ray in &rays {
        assert!(ray.node.light.iter().all(|light| lights.contains(light)));
    }
}

#[test]
fn vectors_stand_on_one_line() {
    let mut text = Vec::new();
    let document = document("whitted", 200, &Settings::default(), true);
    json::write(&mut text, &document).expect("a buffer takes everything");
    let text = String::from_utf8(text).expect("UTF-8");
    let starts = [
        "\"origin\"",
        "\"linear\"",
        "\"radiance\"",
        "\"interval\"",
        "\"film\"",
    ];
    for start in starts {
        let mut lines = text.lines().filter(|l| l.trim_start().starts_with(start));
        assert!(
            lines
                .next()
                .is_some_and(|line| line.contains('[') && line.contains(']')),
            "{start}"
        );
    }
}
